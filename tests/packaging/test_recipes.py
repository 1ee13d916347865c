"""packaging/conda, packaging/nix and .github/workflows fit the tree: versions, dependencies, options, commands.

Nothing is downloaded or built: tests/packaging/run_commands does that.
"""

import json
import re
import shutil
import subprocess

import pytest
import yaml
from recipes import CMAKE, EXPRESSION, RECIPE, ROOT, VERSION, WORKFLOW, commands, expression, recipe, workflow

SETUP = (ROOT / "setup.sh").read_text()
PRESETS = json.loads((ROOT / "CMakePresets.json").read_text())
# What CMake looks for, by its names at conda-forge and in nixpkgs.
DEPENDENCIES = {"Boost": ("libboost-headers", "boost"), "GMP": ("gmp", "gmp"), "FLINT": ("libflint", "flint"),
                "nlohmann_json": ("nlohmann_json", "nlohmann_json"), "Eigen3": ("eigen", "eigen"),
                "TBB": ("tbb-devel", "onetbb"), "fmt": ("fmt", "fmt"), "CLI11": ("cli11", "cli11"),
                "MPFR": ("mpfr", "mpfr"), "pybind11": ("pybind11", None)}
CONSTANTS = dict(re.findall(r"set\((EXSECT_\w+_VERSION) ([0-9.]+)\)", CMAKE))
needs_nix = pytest.mark.skipif(not shutil.which("nix-instantiate"), reason="it needs the package nix-bin")


def found_by_cmake():
    """{package: least version or None} of every find_package that a build without tests and benchmarks comes to."""
    files = [ROOT / "CMakeLists.txt", ROOT / "cmake/FindFLINT.cmake",
             *(ROOT / folder / "CMakeLists.txt" for folder in ("cli", "output", "python"))]
    text = "\n".join(file.read_text() for file in files)
    found = re.findall(r"^\s*find_package\((\w+)(?: \$\{(\w+)\}| ([0-9.]+))?", text, re.M)
    return {name: CONSTANTS.get(constant) or literal or None for name, constant, literal in found}


def options_of(text):
    return set(re.findall(r"-D(EXSECT_\w+)=", text))


def known_to_setup():
    return set(re.findall(r"[\w.+-]+", " ".join(re.findall(r"packages\w*=\(([^)]*)\)", SETUP))))


class DuplicateFree(yaml.SafeLoader):
    def construct_mapping(self, node, deep=False):
        keys = [key.value for key, _ in node.value]
        assert len(keys) == len(set(keys)), f"twice in one mapping: {keys}"
        return super().construct_mapping(node, deep)


@pytest.mark.parametrize("path", [RECIPE, WORKFLOW], ids=lambda path: path.name)
def test_yaml_is_read_and_no_key_occurs_twice(path):
    assert isinstance(yaml.load(path.read_text(), DuplicateFree), dict)


def test_recipe_is_of_this_version_and_finds_every_dependency():
    document = recipe()
    assert document["context"]["version"] == VERSION and document["source"]["path"] == "../.."
    assert (RECIPE.parent / document["source"]["path"]).resolve() == ROOT
    host = dict((entry.split(" >=") + [None])[:2] for entry in document["requirements"]["host"])
    for name, least in found_by_cmake().items():
        if name == "Python":
            continue
        own, _ = DEPENDENCIES[name]
        assert own in host, name
        if least and name != "pybind11":
            assert host[own] == least, name
    build = document["requirements"]["build"]
    assert f"cmake >={re.search('cmake_minimum_required.VERSION ([0-9.]+)', CMAKE)[1]}" in build and "ninja" in build


def test_recipe_runs_what_exists():
    document = recipe()
    script = "\n".join(document["build"]["script"]["content"])
    assert options_of(script) <= set(re.findall(r"(?:option|set)\((EXSECT_\w+)", CMAKE)) and options_of(script)
    assert document["build"]["script"]["env"]["EXSECT_BUILD_DIR"] in script
    tested = [line for test in document["tests"] for line in test.get("script", [])]
    for path in re.findall(r"examples/\S+", " ".join(tested)):
        assert (ROOT / path).is_file(), path
    assert len(tested) == 2 and (ROOT / document["about"]["license_file"]).is_file()


@needs_nix
def test_expression_is_parsed():
    parsed = subprocess.run(["nix-instantiate", "--parse", EXPRESSION], capture_output=True, text=True)
    assert parsed.returncode == 0, parsed.stderr


@needs_nix
def test_expression_is_of_this_version_and_finds_every_dependency():
    attributes = expression()
    assert attributes["version"] == VERSION and attributes["src"] == str(ROOT)
    given = {*attributes["buildInputs"], *attributes["propagatedBuildInputs"]}
    for name in found_by_cmake():
        own = DEPENDENCIES.get(name, (None, None))[1]
        assert own is None or own in given, name
    flags = " ".join(attributes["cmakeFlags"])
    assert options_of(flags) <= set(re.findall(r"(?:option|set)\((EXSECT_\w+)", CMAKE)) and options_of(flags)
    for path in re.findall(r"\$src/([\w./-]+)", attributes["installCheckPhase"]):
        assert (ROOT / path).is_file(), path


def test_workflow_tests_both_systems_by_the_commands_of_the_readme():
    test = workflow()["jobs"]["test"]
    assert {row["image"] for row in test["strategy"]["matrix"]["include"]} == {"debian:12", "ubuntu:24.04"}
    documented = re.findall(r"^\./setup\.sh .*", (ROOT / ".ci/run").read_text(), re.M)
    assert commands("test") == ["apt-get update", *documented] and test["env"]["CI"] == "true"


def test_workflow_runs_only_on_tags_what_makes_packages():
    document = workflow()
    assert document["on"]["push"]["tags"] == ["v*"]
    packages = document["jobs"]["packages"]
    assert packages["if"] == "startsWith(github.ref, 'refs/tags/v')" and packages["needs"] == "test"
    kept = [step["with"]["path"] for step in packages["steps"] if "upload-artifact" in step.get("uses", "")]
    assert kept == ["build/exsect-*.tar"]


def explained(command):
    """Whether the tree documents or defines what a command of the workflow names."""
    if command.startswith("./setup.sh "):
        return f"#   {command} " in SETUP
    if command.startswith("apt-get install") and "./" not in command:
        return set(command.split()[2:]) - {"-y", "--no-install-recommends"} <= known_to_setup()
    if command.startswith("cmake --preset"):
        names = {preset["name"] for kind in PRESETS if kind.endswith("Presets") for preset in PRESETS[kind]}
        return command in (ROOT / "docs/cpp.md").read_text() and set(re.findall(r"--preset (\w+)", command)) <= names
    if command.startswith("/usr/bin/exsect "):
        return (ROOT / command.split()[-1]).is_file()
    return command in ("apt-get update", "apt-get install -y ./build/package/*.deb") or command.startswith(
        ("python3 -m pip wheel ", "tar --create "))


@pytest.mark.parametrize("job", workflow()["jobs"])
def test_every_command_of_the_workflow_is_explained(job):
    assert all(explained(command) for command in commands(job)), [c for c in commands(job) if not explained(c)]
    assert not explained("./setup.sh everything") and not explained("apt-get install -y no-such-package")
    uses = [step["uses"] for step in workflow()["jobs"][job]["steps"] if "uses" in step]
    assert uses and all(re.fullmatch(r"actions/[\w-]+@v\d+", action) for action in uses)


def test_commands_of_the_shell_are_well_formed():
    scripts = [*recipe()["build"]["script"]["content"], *commands("test"), *commands("packages")]
    for script in scripts:
        assert subprocess.run(["bash", "-n", "-c", script], capture_output=True).returncode == 0, script
