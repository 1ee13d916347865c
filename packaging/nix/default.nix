# The program, the library and the Python module with packages of nixpkgs: nix-build packaging/nix
# See packaging/README.md for what of it is tried without nixpkgs.
{ pkgs ? import <nixpkgs> { } }:

let
  python = pkgs.python3.withPackages (packages: [ packages.pybind11 ]);
in
pkgs.stdenv.mkDerivation {
  pname = "exsect";
  version = "0.1.0";
  src = pkgs.lib.cleanSource ../..;

  nativeBuildInputs = [ pkgs.cmake pkgs.ninja python ];
  buildInputs = [
    pkgs.cli11
    pkgs.fmt
    pkgs.gmp
    pkgs.mpfr
    pkgs.nlohmann_json
    (pkgs.onetbb or pkgs.tbb_2021_11)
  ];
  # Headers of the installed library include these.
  propagatedBuildInputs = [ pkgs.boost pkgs.eigen pkgs.flint ];

  cmakeFlags = [
    "-DCMAKE_BUILD_TYPE=Release"
    "-DEXSECT_BUILD_TESTS=OFF"
    "-DEXSECT_BUILD_PYTHON=ON"
    "-DPython_EXECUTABLE=${python}/bin/python3"
  ];
  postInstall = ''
    mkdir -p "$out/${pkgs.python3.sitePackages}"
    cp -r python/exsect "$out/${pkgs.python3.sitePackages}/"
  '';
  doInstallCheck = true;
  installCheckPhase = ''
    "$out/bin/exsect" intersect "$src/examples/chapter9-first.json"
    PYTHONPATH="$out/${pkgs.python3.sitePackages}" ${python}/bin/python3 -c "import exsect"
  '';

  meta = {
    description = "Exact, certified intersection of biquadratic Bézier surface patches";
    license = pkgs.lib.licenses.asl20;
    mainProgram = "exsect";
  };
}
