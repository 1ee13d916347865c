"""SSI-Bench: what is frozen, the same bytes each time, and a score that sees every kind of wrong answer."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["EXSECT_PROGRAM"]
GENERATOR = os.environ["EXSECT_PAIRS"]
FROZEN = json.loads((ROOT / "bench/ssi/frozen.json").read_text())
FAMILIES = list(FROZEN["pairs"])
WITH_LOOP = "loop/000"


def run(script, *arguments):
    return subprocess.run([sys.executable, ROOT / "bench/ssi" / script, *map(str, arguments), "--exsect", PROGRAM],
                          capture_output=True, text=True)


def build(output, generator=GENERATOR, members=1):
    return run("build.py", "--output", output, "--generator", generator, "--members", members)


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The first pair of each family."""
    output = tmp_path_factory.mktemp("ssi") / "archive"
    ended = build(output)
    assert ended.returncode == 0, ended.stderr
    return output


@pytest.fixture
def answers(built, tmp_path):
    """The truth as answers, to be damaged."""
    return Path(shutil.copytree(built / "truth", tmp_path / "answers"))


def change(answers, name, function):
    path = answers / f"{name}.candidate.json"
    candidate = json.loads(path.read_text())
    function(candidate)
    path.write_text(json.dumps(candidate))


def score(built, answers, *arguments):
    """Lines of the pairs by name, and rows of the table by family."""
    file = answers.parent / "score.json"
    ended = run("score.py", built, answers, "--json", file, *arguments)
    assert ended.returncode == 0, ended.stderr
    document = json.loads(file.read_text())
    assert all(f"| {row['family']} | {row['pairs']} | {row['right']} |" in ended.stdout for row in document["rows"])
    return ({line["name"]: line for line in document["pairs"]}, {row["family"]: row for row in document["rows"]})


def test_counts_are_of_1000_pairs():
    lines = (ROOT / "bench/ssi/counts.csv").read_text().splitlines()[1:]
    assert len(lines) == len({line.split(",")[0] for line in lines}) == 1000


def test_what_is_reported_names_its_source_and_its_numbers_are_doubles():
    files = sorted((ROOT / "bench/ssi/reported").glob("*.json"))
    assert len(files) == 24
    for file in files:
        document = json.loads(file.read_text())
        assert document["title"] == file.stem and document["source"].startswith("https://github.com/")
        texts = [c for patch in document["patches"] for line in patch["points"] for point in line for c in point]
        for numerator, _, denominator in (text.partition("/") for text in texts):
            assert int(denominator or 1).bit_count() == 1 and abs(int(numerator)) < 2**53


def test_bytes_are_the_same_each_time(built, tmp_path):
    again = build(tmp_path / "archive")
    assert again.returncode == 0
    assert (tmp_path / "archive.tar").read_bytes() == built.with_name("archive.tar").read_bytes()
    owners = subprocess.run(["tar", "--list", "--verbose", "--numeric-owner", "--utc", "-f", tmp_path / "archive.tar"],
                            capture_output=True, text=True).stdout.splitlines()
    assert owners and all(line.startswith("-rw-r--r-- 0/0 ") and "1970-01-01 00:00" in line for line in owners)


def test_a_changed_pair_is_not_frozen(built, tmp_path):
    generator = tmp_path / "generator"
    first_coordinate = r's/\["[^"]*"/["9\/16"/'
    generator.write_text(f"#!/bin/sh\n'{GENERATOR}' \"$@\" | sed '7{first_coordinate}'\n")  # of the seventh pair
    generator.chmod(0o755)
    ended = build(tmp_path / "archive", generator)
    assert ended.returncode == 1
    generated = [family for family in FAMILIES if family != "reported"]
    assert ended.stderr.splitlines() == [f"pairs of the family {family} are not the frozen ones" for family in generated]


def test_a_changed_count_is_seen(built, tmp_path):
    swapped = tmp_path / "generator"
    swapped.write_text(f"#!/bin/sh\nif [ $1 = loop ]; then set -- near 120 1; fi\n'{GENERATOR}' \"$@\"\n")
    swapped.chmod(0o755)
    ended = build(tmp_path / "archive", swapped)
    assert ended.returncode == 1 and "counts are not the frozen ones: loop/000,0," in ended.stderr


def test_the_truth_is_right(built, answers):
    lines, rows = score(built, answers)
    assert {line["score"] for line in lines.values()} == {"right"}
    assert list(rows) == [*FAMILIES, "all"] and rows["all"]["pairs"] == rows["all"]["right"] == len(lines) == len(FAMILIES)


def test_every_damage_is_seen(built, answers):
    points = [p for patch in json.loads((built / f"pairs/{WITH_LOOP}.json").read_text())["patches"]
              for line in patch["points"] for p in line]
    size = max(max(values) - min(values) for values in zip(*points))

    def lost(candidate):
        candidate["curves"].clear()

    def loop_invented(candidate):
        square = [[8, 8, 8], [9, 8, 8], [9, 9, 8], [8, 9, 8], [8, 8, 8]]
        candidate["curves"].append({"points": square})

    def moved(candidate):
        for curve in candidate["curves"]:
            curve["points"] = [[x, y, z + 2e-4 * size] for x, y, z in curve["points"]]

    def open_at_the_seam(candidate):
        for curve in candidate["curves"]:
            for key in ("points", "first", "second"):
                curve[key] = curve[key][len(curve[key]) // 8:-(len(curve[key]) // 8)]

    def point_for_a_curve(candidate):
        curve = candidate["curves"].pop()
        candidate["curves"].clear()
        candidate["points"].append({key: curve[column][0] for key, column in
                                    (("point", "points"), ("first", "first"), ("second", "second"))})

    change(answers, "random-rational/000", lost)
    change(answers, "random-double/000", loop_invented)
    change(answers, WITH_LOOP, moved)
    change(answers, "near/000", open_at_the_seam)
    change(answers, "nearer/000", point_for_a_curve)
    (answers / "tangent/000.candidate.json").write_text('{"exsect": "candidate/1"')
    (answers / "overlap/000.candidate.json").unlink()
    lines, rows = score(built, answers)
    assert lines["random-rational/000"] == {"name": "random-rational/000", "score": "wrong", "kinds": ["lost-curve"]}
    assert lines["random-double/000"] == {"name": "random-double/000", "score": "wrong", "kinds": ["spurious-curve"]}
    assert lines[WITH_LOOP]["score"] == "inaccurate"
    assert lines["near/000"]["score"] == "wrong" and "gap" in lines["near/000"]["kinds"]
    assert lines["nearer/000"]["score"] == "wrong" and "curve-as-points" in lines["nearer/000"]["kinds"]
    assert lines["tangent/000"]["score"] == "refused" and "tangent/000.candidate.json" in lines["tangent/000"]["why"]
    assert lines["overlap/000"] == {"name": "overlap/000", "score": "no answer"}
    last = rows["all"]
    assert [last[key] for key in ("right", "inaccurate", "wrong", "undecided", "refused", "no answer")] == [1, 1, 4, 0, 1, 1]
    assert [last[key] for key in ("lost", "invented", "misjoined")] == [3, 2, 0]


def test_an_empty_answer_is_wrong_where_there_is_something(built, answers):
    for path in answers.rglob("*.candidate.json"):
        path.unlink()
        (path.parent / (path.name.split(".")[0] + ".csv")).write_text("x,y,z\n")
    lines, rows = score(built, answers)
    counts = dict(line.split(",", 1) for line in (ROOT / "bench/ssi/counts.csv").read_text().splitlines())
    for name, line in lines.items():
        assert line["score"] == ("right" if counts[name] == "0,0,0,0,0,0" else "wrong"), line
    assert rows["all"]["lost"] == rows["all"]["wrong"] > 4 and rows["all"]["invented"] == 0


def test_other_forms_and_times(built, answers, tmp_path):
    for path in answers.rglob("*.candidate.json"):
        path.unlink()
    subprocess.run([PROGRAM, "intersect", built / f"pairs/{WITH_LOOP}.json", "--tolerance", "1e-5", "--quiet", "--obj",
                    answers / f"{WITH_LOOP}.obj"], check=True)
    (answers / "entry.json").write_text(json.dumps({"program": "Kernel 1.0", "milliseconds": {WITH_LOOP: 1.25}}))
    lines, rows = score(built, answers, "--family", "loop")
    assert lines == {WITH_LOOP: {"name": WITH_LOOP, "score": "right"}}
    assert rows["loop"]["median ms"] == rows["loop"]["worst ms"] == 1.25
    missing = run("score.py", built / "pairs", answers)
    assert missing.returncode == 2 and "have to be folders" in missing.stderr
