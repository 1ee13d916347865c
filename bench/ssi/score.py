#!/usr/bin/env python3
"""Scores the answers of a program to SSI-Bench 1: one table, and with --json all verdicts (docs/ssi-bench.md).

    score.py ARCHIVE ANSWERS [--tolerance 1e-4] [--json FILE] [--family NAME]...

ANSWERS/FAMILY/NAME.candidate.json, .json, .csv, .obj or .g2 is the answer to the pair ARCHIVE/pairs/FAMILY/NAME.json, in a form
that `exsect verify` reads. ANSWERS/entry.json may name the program and its times:
{"program": "Kernel 1.0", "milliseconds": {"loop/000": 1.5, ...}}.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
from fractions import Fraction

import archive

TOLERANCE = "1e-4"
COARSER = 100  # an answer that agrees at so many tolerances is inaccurate, but right in its parts
MOST_SECONDS = "60"
ENDINGS = [".candidate.json", ".json", ".csv", ".obj", ".g2"]
KINDS = {"lost": {"lost-curve", "lost-point", "gap", "curve-as-points"},
         "invented": {"spurious-curve", "false-point", "point-on-curve", "repeated", "repeated-point"},
         "misjoined": {"wrong-connection", "split", "wrong-contact"}}
SCORES = ["right", "inaccurate", "wrong", "undecided", "refused", "no answer"]


def answer_to(answers, name):
    """The file, or None."""
    return next((path for ending in ENDINGS if (path := answers / (name + ending)).is_file()), None)


def verdict(program, answer, pair, tolerance):
    """The verdict/1 document, or what the program says against the answer."""
    ended = subprocess.run([program, "verify", answer, pair, "--tolerance", tolerance, "--json", "-", "--quiet",
                            "--max-seconds", MOST_SECONDS], capture_output=True, text=True)
    return json.loads(ended.stdout) if ended.returncode in (0, 1, 3) else ended.stderr.strip()


def coarser(tolerance):
    return str(Fraction(tolerance) * COARSER)


def scored(program, pairs, answers, tolerance, name):
    """{"name", "score"} and, of a wrong answer, "kinds" of differences; of a refused one, "why"."""
    answer = answer_to(answers, name)
    if answer is None:
        return {"name": name, "score": "no answer"}
    said = verdict(program, answer, pairs / f"{name}.json", tolerance)
    if isinstance(said, str):
        return {"name": name, "score": "refused", "why": said}
    if said["verdict"] != "disagrees":
        return {"name": name, "score": {"agrees": "right"}.get(said["verdict"], "undecided")}
    kinds = sorted({difference["kind"] for difference in said["differences"]})
    again = verdict(program, answer, pairs / f"{name}.json", coarser(tolerance))
    return {"name": name, "score": "inaccurate" if again["verdict"] == "agrees" else "wrong", "kinds": kinds}


def row(family, lines, milliseconds):
    numbers = {score: sum(line["score"] == score for line in lines) for score in SCORES}
    wrong = [set(line["kinds"]) for line in lines if line["score"] == "wrong"]
    of_kind = {name: sum(bool(kinds & found) for found in wrong) for name, kinds in KINDS.items()}
    times = [milliseconds[line["name"]] for line in lines if line["name"] in milliseconds]
    return {"family": family, "pairs": len(lines), **numbers, **of_kind,
            "median ms": statistics.median(times) if times else None, "worst ms": max(times, default=None)}


def table(rows):
    """Markdown. Kinds of differences count wrong answers; one may be of several kinds."""
    heads = ["family", "pairs", "right", "inaccurate", "wrong", *KINDS, "undecided", "refused", "no answer", "median ms",
             "worst ms"]
    cells = [["" if row[head] is None else f"{row[head]:.3g}" if head.endswith("ms") else str(row[head]) for head in heads]
             for row in rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in [heads, ["---"] * len(heads), *cells])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("archive", type=pathlib.Path)
    parser.add_argument("answers", type=pathlib.Path)
    parser.add_argument("--exsect", type=pathlib.Path, default=archive.PROGRAM)
    parser.add_argument("--tolerance", default=TOLERANCE, help="relative to the size of the pair")
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--family", action="append")
    parser.add_argument("--jobs", type=int)
    arguments = parser.parse_args()
    pairs = arguments.archive / "pairs"
    if not pairs.is_dir() or not arguments.answers.is_dir():
        parser.error(f"{pairs} and {arguments.answers} have to be folders")
    families = [family for family in arguments.family or archive.FAMILIES if (pairs / family).is_dir()]
    names = {family: sorted(f"{family}/{path.stem}" for path in (pairs / family).iterdir()) for family in families}
    lines = archive.in_parallel(
        lambda name: scored(arguments.exsect, pairs, arguments.answers, arguments.tolerance, name),
        [name for of_family in names.values() for name in of_family], arguments.jobs)
    entry_file = arguments.answers / "entry.json"
    entry = json.loads(entry_file.read_text()) if entry_file.exists() else {}
    milliseconds = entry.get("milliseconds", {})
    rows = [row(family, [line for line in lines if line["name"] in of_family], milliseconds)
            for family, of_family in ((family, set(of_family)) for family, of_family in names.items())]
    rows.append(row("all", lines, milliseconds))
    print(f"{entry.get('program', arguments.answers)}, at {arguments.tolerance} of the size\n\n{table(rows)}", end="")
    if arguments.json:
        arguments.json.write_text(json.dumps({"program": entry.get("program"), "tolerance": arguments.tolerance,
                                              "rows": rows, "pairs": lines}, indent=1) + "\n")


if __name__ == "__main__":
    main()
