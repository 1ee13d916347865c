"""Every output of every command, and every input file of the tree, satisfies its schema in docs/schemas."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import jsonschema
import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["EXSECT_PROGRAM"]
SCHEMAS = {path.name.split(".")[0]: json.loads(path.read_text()) for path in (ROOT / "docs/schemas").glob("*.json")}

FIRST = "examples/chapter9-first.json"
SECOND = "examples/chapter9-second.json"
PROFILE = "examples/profile.json"
SPACE = "examples/space-cubic.json"
CANDIDATES = "examples/candidates"

CERTIFICATE = str(Path(tempfile.mkdtemp()) / "proof.json")
subprocess.run([PROGRAM, "intersect", "tests/cases/cap.json", "--certificate", CERTIFICATE, "--quiet"], cwd=ROOT, check=True)

LINE_CERTIFICATE = CERTIFICATE.replace("proof", "line")
subprocess.run([PROGRAM, "line", FIRST, "--u", "1/3", "--certificate", LINE_CERTIFICATE, "--quiet"], cwd=ROOT, check=True)

# A Whitney umbrella, which meets itself in a curve from a cuspidal point on.
UMBRELLA = CERTIFICATE.replace("proof", "umbrella")
SELF_CERTIFICATE = CERTIFICATE.replace("proof", "self")
NET = [[["25/96", "-5/8", "25/144"], ["-5/48", "-1/2", "-35/144"], ["-7/32", "-3/8", "49/144"]],
       [["5/384", "-1/8", "35/288"], ["-3/32", "0", "-67/288"], ["19/384", "1/8", "119/288"]],
       [["-7/64", "3/8", "49/576"], ["1/24", "1/2", "-119/576"], ["85/192", "5/8", "289/576"]]]
Path(UMBRELLA).write_text(json.dumps({"exsect": "patches/1", "patches": [{"name": "x", "degree": [2, 2], "points": NET}]}))
subprocess.run([PROGRAM, "self", UMBRELLA, "--tolerance", "1e-3", "--certificate", SELF_CERTIFICATE, "--quiet"], cwd=ROOT, check=True)

# The same with weights: a curve of another kind of patch.
WEIGHTED_UMBRELLA = CERTIFICATE.replace("proof", "weighted-umbrella")
WEIGHTED_SELF_CERTIFICATE = CERTIFICATE.replace("proof", "weighted-self")
WEIGHTS = [["1", "3/2", "1"], ["4/3", "1", "1"], ["1", "1", "5/4"]]
Path(WEIGHTED_UMBRELLA).write_text(json.dumps({"exsect": "patches/1", "patches": [{"name": "x", "degree": [2, 2], "points": NET, "weights": WEIGHTS}]}))
subprocess.run([PROGRAM, "self", WEIGHTED_UMBRELLA, "--tolerance", "1e-1", "--certificate", WEIGHTED_SELF_CERTIFICATE, "--quiet"], cwd=ROOT, check=True)

SIDE_CERTIFICATE = CERTIFICATE.replace("proof", "side")
subprocess.run([PROGRAM, "intersect", "tests/cases/part-of-a-side.json", "--tolerance", "1e-3", "--certificate", SIDE_CERTIFICATE, "--quiet"], cwd=ROOT, check=True)

# Bicubic patches with a common side.
CUBIC_CERTIFICATE = CERTIFICATE.replace("proof", "cubic")
subprocess.run([PROGRAM, "intersect", "examples/teapot.bpt", "--first", "1", "--second", "5", "--tolerance", "1e-2", "--certificate", CUBIC_CERTIFICATE, "--quiet"], cwd=ROOT, check=True)

# A patch with weights and a plane.
BENT = CERTIFICATE.replace("proof", "bent")
WEIGHTED_CERTIFICATE = CERTIFICATE.replace("proof", "weighted")
Path(BENT).write_text(json.dumps({"exsect": "patches/1", "patches": [
    {"name": "bent", "degree": [2, 1], "points": [[[0, 0, 0], [0, 1, "1/8"]], [["1/2", 0, "1/5"], ["1/2", 1, 0]], [[1, 0, 0], [1, 1, "1/7"]]], "weights": [[1, 1], ["3/2", "4/3"], [1, 1]]},
    {"name": "plane", "degree": [1, 1], "points": [[["-1/10", "1/3", -1], ["-1/10", "2/3", 1]], [["11/10", "1/2", -1], ["11/10", "3/7", 1]]]}]}))
subprocess.run([PROGRAM, "intersect", BENT, "--tolerance", "1e-2", "--certificate", WEIGHTED_CERTIFICATE, "--quiet"], cwd=ROOT, check=True)

EQUATION_CERTIFICATE = CERTIFICATE.replace("proof", "equation")
subprocess.run([PROGRAM, "intersect", "examples/surfaces.json", "--first", "saddle", "--second", "ball", "--tolerance", "1e-1", "--certificate", EQUATION_CERTIFICATE, "--quiet"], cwd=ROOT, check=True)

# Pairs in special position, each with a kind of claim of its own.
SPECIAL_CASES = ["tangent-curve", "tangent-and-transversal", "overlap", "two-branches-tangent-to-each-other", "irrational-crossing", "curved-touching"]
SPECIAL = [CERTIFICATE.replace("proof", case) for case in SPECIAL_CASES]
for case, certificate in zip(SPECIAL_CASES, SPECIAL):
    directory = "project" if case in ("irrational-crossing", "curved-touching") else "cases"
    subprocess.run([PROGRAM, "intersect", f"tests/{directory}/{case}.json", "--tolerance", "1e-2", "--certificate", certificate, "--quiet"], cwd=ROOT, check=True)

COMMANDS = [
    ["intersect", FIRST],
    ["intersect", SECOND, "--turning", "none"],
    ["intersect", FIRST, "--max-seconds", "1e-9"],
    ["intersect", "tests/cases/overlap.json"],
    ["intersect", "tests/cases/cap.json"],
    ["intersect", "tests/cases/nearly-crossing.json"],
    ["self", SECOND, "--patch", "x"],
    ["self", SECOND, "--patch", "y"],
    ["self", FIRST, "--patch", "x"],
    ["line", FIRST, "--u", "1/2"],
    ["intersect", "examples/surfaces.json", "--first", "oblique", "--second", "ball"],
    ["intersect", "examples/surfaces.json", "--first", "torus", "--second", "quartic"],
    ["intersect", "examples/faces.json", "--first", "roof", "--second", "groove"],
    ["ray", "examples/surfaces.json", "--origin=-5,0,0", "--direction", "1,0,0"],
    ["ray", "examples/surfaces.json", "--origin", "1/3,1e-1,-5", "--direction", "0,0,1"],
    ["ray", "examples/weighted.json", "--origin", "0,0,0", "--direction", "1,1,1"],
    ["line", FIRST, "--s", "0"],
    ["line", "tests/cases/overlap.json", "--u", "1/2"],
    ["line", "tests/cases/cap.json", "--v", "0"],
    ["implicitize", PROFILE],
    ["implicitize", PROFILE, "--degree", "2"],
    ["implicitize", PROFILE, "--degree", "2", "--space", "b-spline"],
    ["implicitize", PROFILE, "--degree", "2", "--method", "legendre"],
    ["implicitize", "examples/rational-circle.json"],
    ["implicitize", SPACE],
    ["implicitize", SPACE, "--method", "orthogonal", "--degree", "2"],
    ["implicitize", FIRST, "--patch", "x"],
    ["implicitize", FIRST, "--patch", "y", "--degree", "4", "--method", "conics"],
    ["revolve", PROFILE, "--method", "elimination"],
    ["revolve", PROFILE, "--method", "product", "--degree", "3", "--region", "2,0,2"],
    ["revolve", PROFILE, "--method", "substitution", "--degree", "3"],
    ["revolve", PROFILE, "--method", "substitution", "--degree", "2", "--cells", "4", "--w2", "1/1000"],
    ["revolve", PROFILE, "--method", "product", "--patch-file", FIRST, "--patch", "x", "--u", "1/2"],
    ["compare", FIRST, "--lines", "8", "--pieces", "0"],
    ["check", CERTIFICATE],
    ["check", LINE_CERTIFICATE],
    ["check", SELF_CERTIFICATE],
    ["compare", SECOND, "--lines", "4", "--pieces", "0", "--plane", "v,s"],
    *[
        ["verify", f"{path}", f"{path}".replace(".candidate", ""), "--tolerance", "1e-4"]
        for path in sorted(path.relative_to(ROOT) for path in (ROOT / "examples/candidates").glob("*.candidate.json"))
    ],
    ["verify", f"{CANDIDATES}/sisl-right.candidate.json", f"{CANDIDATES}/sisl-right.json"],
    ["verify", f"{CANDIDATES}/sisl-right.candidate.json", f"{CANDIDATES}/sisl-right.json", "--tolerance", "1e-4", "--max-seconds", "1e-9"],
]


BATCHES = [
    ["batch", FIRST],
    ["batch", SECOND, "--self"],
    ["batch", SECOND, "--self", "--full"],
    ["batch", FIRST, SECOND, "tests/cases/none.json", "--self"],
    ["batch", FIRST, "--max-seconds", "1e-9"],
]


def violations(document):
    schema = SCHEMAS[document["exsect"].replace("/", "-")]
    return [f"{'/'.join(map(str, e.absolute_path))}: {e.message[:300]}" for e in jsonschema.Draft7Validator(schema).iter_errors(document)]


@pytest.mark.parametrize("name", sorted(SCHEMAS))
def test_a_schema_is_one_of_draft_7(name):
    assert SCHEMAS[name]["$schema"] == "http://json-schema.org/draft-07/schema#"
    jsonschema.Draft7Validator.check_schema(SCHEMAS[name])


@pytest.mark.parametrize("arguments", COMMANDS, ids=" ".join)
def test_an_output_satisfies_its_schema(arguments):
    ended = subprocess.run([PROGRAM, *arguments, "--json", "-"], capture_output=True, text=True, cwd=ROOT)
    assert ended.returncode in ((0, 1, 3) if arguments[0] == "verify" else (0, 3)), ended.stderr
    document = json.loads(ended.stdout)
    assert (document["status"] == "incomplete") == (ended.returncode == 3)
    if arguments[0] == "verify":
        assert document["verdict"] == {0: "agrees", 1: "disagrees", 3: "undecided"}[ended.returncode]
    assert violations(document) == []


@pytest.mark.parametrize("arguments", BATCHES, ids=" ".join)
def test_lines_of_a_batch_satisfy_their_schemas(arguments, tmp_path):
    ended = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, cwd=ROOT)
    assert ended.returncode in (0, 3), ended.stderr
    (tmp_path / "shard").write_text(ended.stdout)
    merged = subprocess.run([PROGRAM, "batch-merge", tmp_path / "shard"], capture_output=True, text=True)
    assert (merged.returncode, merged.stdout) == (ended.returncode, ended.stdout)
    for line in map(json.loads, ended.stdout.splitlines()):
        assert violations(line) == []
        if "result" in line:
            assert violations({**line["result"], "work": {"milliseconds": 0, "steps": {}}}) == []


def test_every_command_and_every_form_is_covered():
    helped = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True).stdout
    commands = [line.split()[0] for line in helped.split("Subcommands:")[1].splitlines() if line.startswith("  ")]
    assert {arguments[0] for arguments in COMMANDS + BATCHES} | {"batch-merge"} >= set(commands)


@pytest.mark.parametrize("file", sorted([*(ROOT / "examples").rglob("*.json"), *(ROOT / "tests/cases").glob("*.json")]), ids=lambda f: f.name)
def test_an_input_file_satisfies_its_schema(file):
    document = json.loads(file.read_text())
    if "exsect" in document and not file.name.endswith(".expected.json"):
        assert violations(document) == []


@pytest.mark.parametrize("certificate", [CERTIFICATE, LINE_CERTIFICATE, SELF_CERTIFICATE, WEIGHTED_SELF_CERTIFICATE, SIDE_CERTIFICATE, CUBIC_CERTIFICATE, WEIGHTED_CERTIFICATE, EQUATION_CERTIFICATE, *SPECIAL],
                         ids=["curves", "line", "self", "weighted-self", "side", "cubic", "weighted", "equation", *SPECIAL_CASES])
def test_a_certificate_satisfies_its_schema_and_both_checkers(tmp_path, certificate):
    document = json.loads(Path(certificate).read_text())
    assert violations(document) == []
    document["summary"]["claims"][3] += 1
    changed = tmp_path / "changed.json"
    changed.write_text(json.dumps(document))
    for checker in ([PROGRAM, "check"], [sys.executable, "examples/check_certificate.py"]):
        for file, status, word in ((certificate, 0, "accepted"), (changed, 1, "rejected: $.summary: "), (FIRST, 2, "")):
            ended = subprocess.run([*checker, file], capture_output=True, text=True, cwd=ROOT)
            assert ended.returncode == status and ended.stdout.startswith(word), ended
    ended = subprocess.run([PROGRAM, "check", changed, "--json", "-"], capture_output=True, text=True, cwd=ROOT)
    assert ended.returncode == 1 and violations(json.loads(ended.stdout)) == []


@pytest.mark.parametrize(
    "change",
    [
        lambda d: d.pop("status"),
        lambda d: d.update(status="perhaps"),
        lambda d: d.update(extra=1),
        lambda d: d["nodes"][0]["box"].pop("u"),
        lambda d: d["nodes"][0]["box"].update(u=["0.5", "1"]),
        lambda d: d["arcs"][0].update(error_bound="small"),
        lambda d: d["arcs"][0]["polyline"][0].append(0.0),
        lambda d: d["components"][0].update(shape="round"),
    ],
)
def test_a_broken_result_violates_its_schema(change):
    ended = subprocess.run([PROGRAM, "intersect", FIRST, "--json", "-"], capture_output=True, text=True, cwd=ROOT)
    document = json.loads(ended.stdout)
    change(document)
    assert violations(document)
