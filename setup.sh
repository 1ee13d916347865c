#!/usr/bin/env bash
# Installs what is missing from Debian's packages, builds, and runs:
#   ./setup.sh run      build, then intersect the patches of examples/chapter9-first.json
#   ./setup.sh test     build with all tests, then run them
#   ./setup.sh asan     the same under AddressSanitizer and UndefinedBehaviorSanitizer
#   ./setup.sh docs     make the documentation, build/docs/html/index.html
#   ./setup.sh documents  run the install commands of docs/*.md as they are written; changes this machine
#   ./setup.sh cluster  run batches by Slurm, GNU parallel and Snakemake on this machine (docs/batch.md)
#   ./setup.sh ssi      build SSI-Bench 1, build/ssi-bench-1.tar (docs/ssi-bench.md)
#   ./setup.sh peers    build the comparison with SISL and Open CASCADE, then run it (bench/README.md)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

packages=(cmake ninja-build g++ catch2 libboost-dev libcli11-dev libeigen3-dev libflint-dev libfmt-dev libgmp-dev
          libmpfr-dev libtbb-dev nlohmann-json3-dev)
packages_if_known=(libflint-arb-dev)  # from version 3 FLINT contains Arb
module_packages=(pybind11-dev python3-dev)
test_packages=(dpkg-dev file groff-base mypy pkg-config python3-jsonschema python3-matplotlib python3-nbformat python3-numpy
               python3-pip python3-pytest python3-setuptools python3-venv python3-wheel
               python3-yaml)  # file: CPack asks it what is a program
docs_packages=(doxygen python3-myst-parser python3-sphinx)
test_packages_if_known=(clang-format-14)
peer_packages=(libsisl-dev libocct-foundation-dev libocct-modeling-data-dev libocct-modeling-algorithms-dev
               libocct-visualization-dev python3-matplotlib)  # visualization: a header of the others
cluster_packages=(munge parallel slurm-wlm snakemake)
declare -A browser_packages=([chromium]=chromium [node]=nodejs [npm]=npm)  # by command, which may come from elsewhere

die() {
  echo "setup.sh: $*" >&2
  exit 1
}

# Those of the given packages that are not installed.
missing() {
  local package
  for package in "$@"; do
    if [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) != installed ]]; then
      echo "$package"
    fi
  done
}

# Those of the given packages that this release has.
known() {
  local package
  for package in "$@"; do
    if [[ -n $(apt-cache madison "$package" 2>/dev/null) ]]; then
      echo "$package"
    fi
  done
}

# What apt-get would download for the given packages and add to the disk, in its own words.
size_of() {
  LC_ALL=C apt-get install --assume-no --no-install-recommends "$@" 2>/dev/null |
    sed -nE -e 's|^Need to get ([^/]*)(/.*)? of archives.*|\1 to download|p' \
      -e 's|^After this operation, (.*) of additional disk.*|, \1 on the disk|p' | tr -d '\n'
}

# What apt-get says, shortened to one line for each tenth of the packages that it sets up: they are named already.
tenths_of() {
  awk -v count="$1" '/^Setting up / { done += 1; if (int(10 * done / count) > tenth) {
    tenth = int(10 * done / count); print "  " done " of " count " packages"; fflush() } }'
}

# Installs all of `packages` and, where the release has them, of `packages_if_known`. The argument says what the work
# after that takes; both are told before anything is installed.
install_packages() {
  local required optional
  command -v apt-get >/dev/null || die "no apt-get here; install cmake, ninja, g++, Boost, CLI11, Eigen, FLINT, fmt," \
    "GMP, MPFR, nlohmann-json, oneTBB and Catch2, then: cmake --preset release && cmake --build --preset release"
  mapfile -t required < <(missing "${packages[@]}")
  mapfile -t optional < <(missing "${packages_if_known[@]}")
  if ((EUID != 0)); then
    ((${#required[@]} == 0)) || die "missing packages; as root: apt-get install ${required[*]}"
    optional=()
  elif ((${#required[@]} > 0)); then
    echo "Reading the list of Debian's packages"
    apt-get update -qq
  fi
  mapfile -t optional < <(known "${optional[@]}")
  required+=("${optional[@]}")
  if ((${#required[@]} > 0)); then
    echo "First packages of Debian are installed ($(size_of "${required[@]}"), with what they need): ${required[*]}"
  fi
  echo "$1"
  if ((${#required[@]} > 0)); then
    local count
    count=$(LC_ALL=C apt-get install --simulate --no-install-recommends "${required[@]}" | grep -c '^Inst ' || true)
    echo "Downloading and installing $count packages"
    LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${required[@]}" |
      tenths_of "$count"
  fi
}

# The packages of those commands that the tests of the report pages need and that are missing.
missing_browser_packages() {
  local command
  for command in "${!browser_packages[@]}"; do
    command -v "$command" >/dev/null || echo "${browser_packages[$command]}"
  done
}

# What drives the browser, as tests/browser/package-lock.json says, unless it is there already.
install_browser_driver() {
  if [[ ! tests/browser/node_modules/.package-lock.json -nt tests/browser/package-lock.json ]]; then
    npm ci --prefix tests/browser --no-audit --no-fund --loglevel=error
  fi
}

# build PRESET CMAKE-BUILD-ARGUMENTS...: under continuous integration (CI is set) a warning is an error.
build() {
  local preset=$1
  shift
  cmake --preset "$preset" ${CI:+-DEXSECT_WERROR=ON} >/dev/null
  cmake --build --preset "$preset" "$@"
}

case "${1:-}" in
  run)
    install_packages "The build takes about 4 minutes on two cores, and build/release 300 MB."
    build release --target exsect
    echo
    build/release/cli/exsect intersect examples/chapter9-first.json --svg build/chapter9-first.svg \
      --report build/chapter9-first.html
    echo "Picture: build/chapter9-first.svg, web page: build/chapter9-first.html"
    ;;
  test | asan)
    packages+=("${module_packages[@]}" "${test_packages[@]}")
    if [[ $1 == test ]]; then
      packages+=("${docs_packages[@]}")
    fi
    packages_if_known+=("${test_packages_if_known[@]}")
    browser=${EXSECT_BROWSER:-required}  # none: without the tests in a browser, which Ubuntu has as a snap only
    if [[ $browser == required ]]; then
      mapfile -t -O "${#packages[@]}" packages < <(missing_browser_packages)
    fi
    if [[ $1 == test ]]; then
      install_packages "Build and tests take about 15 minutes on two cores, and build/release 1 GB."
    else
      install_packages "Build and tests take about an hour on two cores, and build/asan 4 GB."
    fi
    if [[ $browser == required ]]; then
      install_browser_driver
    fi
    preset=${1/test/release}
    build "$preset"
    EXSECT_BROWSER=$browser ctest --preset "$preset" --parallel "$(nproc)"
    ;;
  docs)
    packages+=("${module_packages[@]}" "${docs_packages[@]}")
    install_packages "The build takes about 4 minutes on two cores, and build/release 500 MB."
    build release --target docs
    echo "Documentation: build/docs/html/index.html"
    ;;
  documents)
    ((EUID == 0)) || die "installs packages and into /usr/local, which only root may"
    packages+=(python3)
    install_packages "Three builds take about 25 minutes on two cores, and 1 GB in the temporary folder."
    tests/install/documented
    ;;
  cluster)
    packages+=("${cluster_packages[@]}")
    install_packages "The build takes about 4 minutes on two cores, the runs 2 minutes."
    build release --target exsect
    tests/cluster/run build/release/cli/exsect
    ;;
  peers)
    packages+=("${peer_packages[@]}")
    install_packages "The build takes about 4 minutes on two cores, the comparison an hour."
    bench/peers/run
    ;;
  ssi)
    packages+=(python3)
    install_packages "The build takes about 4 minutes on two cores, the 1000 pairs 3 more, and build/ 700 MB."
    build release --target exsect exsect_peer_pairs
    bench/ssi/build.py
    ;;
  *)
    sed -n '2,10s/^# \{0,1\}//p' setup.sh >&2
    exit 2
    ;;
esac
