"""The Dockerfile, which no test builds: what it runs, what it copies, and the packages of the second stage."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ["EXSECT_PROGRAM"])
BUILD = Path(os.environ["EXSECT_BUILD"])
STEPS = [
    line.split(" ", 1)
    for line in re.sub(r" \\\n *", " ", (ROOT / "Dockerfile").read_text()).splitlines()
    if line and not line.startswith("#")
]
BASE = [i for i, (word, _) in enumerate(STEPS) if word == "FROM"]


def steps(stage, word):
    stages = {"build": STEPS[: BASE[1]], "last": STEPS[BASE[1] :]}
    return [rest for instruction, rest in stages[stage] if instruction == word]


def test_both_stages_are_of_one_release():
    assert [STEPS[i][1].split()[0] for i in BASE] == ["debian:12-slim"] * 2


def test_the_last_stage_has_no_compiler_and_no_root():
    assert steps("last", "USER") == ["exsect"] and "useradd --system" in steps("last", "RUN")[0]
    assert not re.search(r"g\+\+|-dev|cmake|setup.sh", " ".join(steps("last", "RUN")))
    assert "rm -rf /var/lib/apt/lists/*" in steps("last", "RUN")[0]
    # nothing is changed after the rights are given up
    words = [word for word, _ in STEPS[BASE[1] :]]
    assert not {"RUN", "COPY", "ADD"} & set(words[words.index("USER") :])


def test_the_first_stage_runs_the_first_command_of_the_readme():
    assert steps("build", "RUN")[0] == "./setup.sh run"
    assert "./setup.sh run\n" in (ROOT / "README.md").read_text()


def test_what_is_copied_is_a_program_that_runs(tmp_path):
    install = next(step for step in steps("build", "RUN") if step.startswith("cmake --install build/release"))
    command = install.replace("build/release", str(BUILD)).replace("/opt/exsect", str(tmp_path))
    subprocess.run(command, shell=True, check=True, capture_output=True, cwd=ROOT)
    assert steps("last", "COPY") == ["--from=build /opt/exsect /usr/local"]
    model = (ROOT / "examples/bump.json").read_bytes()
    ended = subprocess.run([tmp_path / "bin/exsect", "intersect", "-"], input=model, capture_output=True)
    assert ended.returncode == 0 and b"1 closed" in ended.stdout
    assert (tmp_path / "share/man/man1/exsect.1").exists()


@pytest.mark.skipif(
    not shutil.which("dpkg") or 'VERSION_ID="12"' not in Path("/etc/os-release").read_text(), reason="it needs Debian 12"
)
def test_the_packages_are_those_of_the_libraries_that_the_program_loads():
    named = re.search(r"--no-install-recommends (.*?) &&", steps("last", "RUN")[0])[1].split()
    dynamic = subprocess.run(["objdump", "-p", PROGRAM], capture_output=True, text=True, check=True).stdout
    wanted = set(re.findall(r"NEEDED +(\S+)", dynamic))
    paths = dict(re.findall(r"(\S+) => (\S+)", subprocess.run(["ldd", PROGRAM], capture_output=True, text=True, check=True).stdout))
    owners = set()
    for library in wanted - {name for name in wanted if name.startswith("ld-linux")}:
        path = os.path.realpath(paths.get(library, library))
        found = subprocess.run(["dpkg", "-S", path], capture_output=True, text=True)
        if found.returncode:  # merged /usr: the package may list the path without it
            found = subprocess.run(["dpkg", "-S", path.removeprefix("/usr")], capture_output=True, text=True, check=True)
        owners.add(found.stdout.split(":")[0])
    assert owners - {"libc6", "libgcc-s1"} == set(named)
