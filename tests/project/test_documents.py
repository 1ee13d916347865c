"""Every command and code block of README.md, CONTRIBUTING.md and docs/*.md is run, or is what a tested file holds.

sh: every line is run, `exsect` being the program just built; pictures that it writes into docs/images say what those say that
are there. console: lines that begin with "$ " are run, and the others are what they print, times apart; "..." stands for any
lines. python: run with the module just built. cpp: the text of
one of docs/examples, which are built, run and compared by tests of their own. cmake: configured, built and run
against the installed tree. json: parsed, and validated where it names its form. text: the output of an example. In
blocks without a fence the lines that begin with "exsect " are run, and whole files, from {"exsect" on, are
json. A comment
<!-- not run: reason --> exempts the block after it.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from collections import Counter
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
            elif not exempt and text.startswith('{"exsect"') and "..." not in text:
                found.append((start + 1, "json", text))
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
    assert {block[2] for block in ALL} <= {"sh", "python", "cpp", "cmake", "json", "text", "console", "indented", "{toctree}", "{eval-rst}"}
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
        picture = re.search(r"--svg (docs/images/\S+)", command)
        if picture and words[1] != "compare":  # whose pictures tell times
            assert words_in(scratch / picture[1]) == words_in(ROOT / picture[1]), f"{picture[1]} is not up to date"


def words_in(picture):
    """Titles, labels and numbers: lines may differ by rounding from processor to processor."""
    return re.findall(r">([^<>]+)</t", picture.read_text())


def shell(command, folder):
    return subprocess.run(["bash", "-c", command], cwd=folder, env=environment(), capture_output=True, text=True).stdout


def without_times(text):
    return re.sub(r"\b[0-9.]+ ms\b", "some ms", text).splitlines()


def prints(shown, expected):
    """Whether the lines are those expected, where "..." stands for any number of them."""
    if not expected:
        return not shown
    if expected[0] == "...":
        return any(prints(shown[i:], expected[1:]) for i in range(len(shown) + 1))
    return bool(shown) and shown[0] == expected[0] and prints(shown[1:], expected[1:])


@pytest.mark.parametrize("page", sorted({block[0] for block in ALL if block[2] == "console"}), ids=lambda page: page.name)
def test_commands_print_what_is_shown(page, scratch):
    """The blocks of a page one after the other, in one folder."""
    text = "".join(block[3] for block in ALL if block[0] == page and block[2] == "console")
    for part in re.split(r"^\$ ", text, flags=re.M)[1:]:
        command, _, expected = part.partition("\n")
        shown = shell(command, scratch)
        assert prints(without_times(shown), without_times(expected)), f"{command}\n{shown}"


def test_what_is_not_printed_is_found():
    assert prints(["a", "b", "c"], ["a", "...", "c"]) and prints([], []) and prints(["a"], ["...", "a", "..."])
    assert not prints(["a", "b"], ["a"]) and not prints(["a"], ["b"]) and not prints(["b", "a"], ["...", "b"])
    assert without_times("0.7 ms, x") == without_times("12 ms, x")


PROGRAMS = ("exsect", "SISL", "GeomAPI_IntSS", "BRepAlgoAPI_Section")


def cells(row):
    return [cell.strip() for cell in row.strip("|").split("|")]


def measured(family):
    """The rows of a family of pairs in bench/README.md, in the order of PROGRAMS, as the cells after the program's name."""
    table = (ROOT / "bench/README.md").read_text().split(f"**{family}**: ")[1].split("\n\n")[1].splitlines()[2:]
    rows = [cells(row) for row in table if "--exact" not in row]
    return [next(row[1:] for row in rows if program in row[0]) for program in PROGRAMS]


def numbers(families, column, part):
    """The number at a place of a cell, "a / b / c", for every program: a list over the families."""
    tables = [measured(family) for family in families]
    return [[float(table[k][column].split(" / ")[part]) for table in tables] for k in range(len(PROGRAMS))]


@pytest.mark.parametrize(
    "families, curves, medians",
    [
        (["random-rational", "random-double"], "| 600 random pairs", "| median time"),
        (["loop", "tangent", "near", "overlap"], "| 160 loops", "| medians by family"),
    ],
)
def test_the_comparison_in_the_readme_is_that_of_the_benchmarks(families, curves, medians):
    def shown(start):
        return cells(next(row for row in (ROOT / "README.md").read_text().splitlines() if row.startswith(start)))[1:]

    lost, invented, times = numbers(families, 5, 2), numbers(families, 6, 0), numbers(families, 0, 0)
    assert shown(curves) == [f"{sum(a):g} / {sum(b):g}" for a, b in zip(lost, invented)]
    assert shown(medians) == [f"{min(row):g} to {max(row):g}" for row in times]
    if "loop" in families:
        assert shown("| no answer") == [f"{sum(row):g}" for row in numbers(families, 4, 0)]


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


LABEL = re.compile(r"(?:   |\|).*\((\d+\.\d+[a-z]?|F\d)\)(?: \|)?$")
IN_PROOFS_ALONE = {"4.10", "4.12", "4.17f"}


def test_equations_are_cited_where_they_are_implemented():
    """Every numbered equation of the method, but those that only proofs use, stands in a source with its number."""
    folders = ["algebra", "geometry", "solver", "verify", "implicit"]
    text = "".join(path.read_text() for folder in folders for path in (ROOT / folder).rglob("*.[hc]*"))
    cited = set(re.findall(r"\((\d+\.\d+[a-z]?|F\d)\)", text))
    for number, letters in re.findall(r"\((\d+\.\d+)((?:[a-z](?:, )?)+)\)", text):
        cited.update(number + letter for letter in re.findall("[a-z]", letters))
    pages = sorted((ROOT / "docs").glob("method*.md"))
    labels = {m[1] for page in pages for line in page.read_text().splitlines() if (m := LABEL.search(line))}
    assert len(labels) > 150
    assert sorted(labels - cited) == sorted(IN_PROOFS_ALONE)


def test_equations_have_numbers_of_their_own():
    """No number stands beside two equations, as it would then not say which of them a source is about."""
    numbers = [
        m[1]
        for page in sorted((ROOT / "docs").glob("method*.md"))
        for line in page.read_text().splitlines()
        if line.startswith("    ") and (m := LABEL.search(line))
    ]
    assert len(numbers) > 150
    assert [number for number, count in Counter(numbers).items() if count > 1] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page):
    text = re.sub(r"```.*?```", "", page.read_text(), flags=re.S)
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if not re.match(r"https?:|#", target):
            assert (page.parent / target.split("#")[0]).exists(), target
