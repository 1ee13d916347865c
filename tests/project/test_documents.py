"""Every command and code block of README.md, CONTRIBUTING.md and docs/*.md is run, or is what a tested file holds.

sh: every line is run, `exsect` being the program just built. python: run with the module just built. cpp: the text of
one of docs/examples, which are built, run and compared by tests of their own. cmake: configured, built and run
against the installed tree. json: parsed, and validated where it names its form. text: the output of an example. In
blocks without a fence the lines that begin with "exsect " are run, the others are output. A comment
<!-- not run: reason --> exempts the block after it.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ["EXSECT_PROGRAM"])
PREFIX = os.environ.get("EXSECT_PREFIX", "")
MODULE = os.environ.get("EXSECT_PYTHON", "")
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
EXAMPLES = {path.name: path.read_text() for path in (ROOT / "docs/examples").iterdir() if path.is_file()}
MARKER = re.compile(r"<!-- not run: .{10,} -->")


def blocks(page):
    """(line, language, text) of every block to be tested; the language of one without a fence is "indented"."""
    lines = page.read_text().splitlines()
    found, i, exempt = [], 0, False
    while i < len(lines):
        line = lines[i]
        fence = re.fullmatch(r"```(\S*)", line)
        if fence:
            end = lines.index("```", i + 1)
            if not exempt:
                found.append((i + 1, fence[1], "\n".join(lines[i + 1 : end]) + "\n"))
            i, exempt = end, False
        elif line.startswith("    ") and (i == 0 or not lines[i - 1].strip()):
            start = i
            while i < len(lines) and (lines[i].startswith("    ") or not lines[i].strip()):
                i += 1
            text = "\n".join(row[4:] for row in lines[start:i])
            if not exempt and re.search(r"^exsect ", text, re.M):
                found.append((start + 1, "indented", text))
            i, exempt = i - 1, False
        elif line.strip():
            exempt = bool(MARKER.fullmatch(line))
        i += 1
    return found


def commands(language, text):
    joined = re.sub(r"\\\n\s*", "", text)
    lines = [line for line in joined.splitlines() if line.strip() and not line.startswith("#")]
    return [line for line in lines if language == "sh" or line.startswith("exsect ")]


ALL = [(page, *block) for page in PAGES for block in blocks(page)]


def of(*languages):
    return pytest.mark.parametrize(
        "page, line, language, text",
        [block for block in ALL if block[2] in languages],
        ids=lambda value: value.name if isinstance(value, Path) else str(value) if isinstance(value, int) else "",
    )


@pytest.fixture
def scratch(tmp_path):
    for name in ("examples", "tests"):
        (tmp_path / name).symlink_to(ROOT / name)
    (tmp_path / "docs/images").mkdir(parents=True)
    return tmp_path


def environment():
    path = f"{PROGRAM.parent}{os.pathsep}{os.environ['PATH']}"
    return {**os.environ, "PATH": path, "PYTHONPATH": MODULE, "PYTHONDONTWRITEBYTECODE": "1"}


def test_only_known_languages_occur():
    assert {block[2] for block in ALL} <= {"sh", "python", "cpp", "cmake", "json", "text", "indented", "{toctree}", "{eval-rst}"}
    assert len(ALL) > 20


@of("sh", "indented")
def test_commands_run(page, line, language, text, scratch):
    setup = (ROOT / "setup.sh").read_text()
    found = commands(language, text)
    assert found
    for command in found:
        words = command.split()
        if words[0] == "./setup.sh":  # this test is a part of it
            assert f"#   ./setup.sh {words[1]} " in setup
            continue
        ended = subprocess.run(["bash", "-c", command], cwd=scratch, env=environment(), capture_output=True, text=True)
        statuses = (0, 1, 3) if words[:2] == ["exsect", "verify"] else (0, 3)
        assert ended.returncode in statuses, f"{command}\n{ended.stderr}"


@of("python")
@pytest.mark.skipif(not MODULE, reason="the Python module is not built")
def test_python_runs(page, line, language, text, scratch):
    ended = subprocess.run([sys.executable, "-c", text], cwd=scratch, env=environment(), capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr


@of("cpp")
def test_programs_are_tested_examples(page, line, language, text):
    assert text in EXAMPLES.values()


@of("text")
def test_outputs_are_those_of_examples(page, line, language, text):
    assert text in EXAMPLES.values()


@of("cmake")
@pytest.mark.skipif(not PREFIX, reason="needs the installed tree")
def test_projects_build(page, line, language, text, scratch):
    (scratch / "CMakeLists.txt").write_text(text)
    shutil.copy(ROOT / "docs/examples/first_intersection.cpp", scratch)
    for command in (
        ["cmake", "-G", "Ninja", "-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={PREFIX}"],
        ["cmake", "--build", "build"],
    ):
        ended = subprocess.run(command, cwd=scratch, capture_output=True, text=True)
        assert ended.returncode == 0, ended.stdout + ended.stderr
    ran = subprocess.run(["build/consumer"], cwd=scratch, capture_output=True, text=True)
    assert ran.stdout == EXAMPLES["first_intersection.txt"]


@of("json")
def test_json_is_what_it_says(page, line, language, text):
    document = json.loads(text)
    if "exsect" in document:
        jsonschema = pytest.importorskip("jsonschema")
        schema = ROOT / "docs/schemas" / (document["exsect"].replace("/", "-") + ".schema.json")
        jsonschema.Draft7Validator(json.loads(schema.read_text())).validate(document)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page):
    text = re.sub(r"```.*?```", "", page.read_text(), flags=re.S)
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if not re.match(r"https?:|#", target):
            assert (page.parent / target.split("#")[0]).exists(), target
