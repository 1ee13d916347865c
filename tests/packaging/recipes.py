"""The recipes of packaging/ and the workflow, as their commands."""

import json
import re
import subprocess
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[2]
CMAKE = (ROOT / "CMakeLists.txt").read_text()
VERSION = re.search(r"project\(exsect VERSION ([0-9.]+)", CMAKE)[1]
RECIPE = ROOT / "packaging/conda/recipe.yaml"
EXPRESSION = ROOT / "packaging/nix/default.nix"
WORKFLOW = ROOT / ".github/workflows/ci.yml"

# What the expression asks of nixpkgs; a package is its own name, and mkDerivation gives its argument back.
NIXPKGS = """rec {
  python3 = { sitePackages = "lib/python3/site-packages"; withPackages = ask: { outPath = "/usr"; asked = ask { pybind11 = "pybind11"; }; }; };
  stdenv.mkDerivation = attributes: attributes;
  lib = { cleanSource = path: toString path; licenses.asl20 = "Apache-2.0"; };
  cmake = "cmake"; ninja = "ninja"; cli11 = "cli11"; fmt = "fmt"; gmp = "gmp"; mpfr = "mpfr"; nlohmann_json = "nlohmann_json";
  onetbb = "onetbb"; boost = "boost"; eigen = "eigen"; flint = "flint";
}"""


def recipe():
    return yaml.safe_load(RECIPE.read_text())


def expression():
    """The argument of mkDerivation, without nixpkgs."""
    evaluated = subprocess.run(
        ["nix-instantiate", "--eval", "--strict", "--json", "--readonly-mode", "--store", "dummy://", "--expr",
         f"removeAttrs (import {EXPRESSION} {{ pkgs = {NIXPKGS}; }}) [ \"nativeBuildInputs\" ]"],
        check=True, capture_output=True, text=True)
    return json.loads(evaluated.stdout)


def workflow():
    return yaml.safe_load(WORKFLOW.read_text())


def commands(job):
    """What the steps of a job run, a line each."""
    return [step["run"].strip() for step in workflow()["jobs"][job]["steps"] if "run" in step]
