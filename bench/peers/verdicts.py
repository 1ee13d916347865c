#!/usr/bin/env python3
"""How often programs are wrong, judged by `exsect verify`: a table of proved verdicts.

    verdicts.py EXSECT PAIRS RESULT... [--tolerance 1e-3] [--save KIND NUMBER DIRECTORY PREFIX]

PAIRS has one patch file a line, each RESULT what a program of bench/peers wrote for them. --save keeps the first NUMBER
pairs whose verdict has a difference of this KIND, as PREFIX-1.json and PREFIX-1.candidate.json, and so on.
"""

import argparse
import collections
import json
import pathlib
import subprocess
import tempfile

KINDS = ["lost-curve", "curve-as-points", "wrong-connection", "split", "gap", "spurious-curve", "repeated", "false-point", "lost-point"]


def verdict(program, pair, candidate, tolerance, directory):
    """The verdict/1 document of one answer, or None where the program gives none."""
    for name, content in (("pair.json", pair), ("answer.json", candidate)):
        (directory / name).write_text(json.dumps(content))
    command = [program, "verify", directory / "answer.json", directory / "pair.json", "--tolerance", tolerance, "--json", "-"]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=600)
    return json.loads(ended.stdout) if ended.returncode in (0, 1, 3) else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("exsect")
    parser.add_argument("pairs", type=pathlib.Path)
    parser.add_argument("results", type=pathlib.Path, nargs="+")
    parser.add_argument("--tolerance", default="1e-3")
    parser.add_argument("--save", nargs=4, metavar=("KIND", "NUMBER", "DIRECTORY", "PREFIX"))
    arguments = parser.parse_args()
    pairs = {pair["title"]: pair for pair in map(json.loads, arguments.pairs.read_text().splitlines())}
    rows = collections.defaultdict(collections.Counter)
    saved = 0
    with tempfile.TemporaryDirectory() as scratch:
        for line in (line for path in arguments.results for line in path.read_text().splitlines()):
            answer = json.loads(line)
            row = rows[answer["program"]]
            if answer["status"] != "done":
                row["no answer"] += 1
                continue
            candidate = {"exsect": "candidate/1", "patches": ["x", "y"], "source": answer["program"],
                         "curves": answer["curves"], "points": answer["points"]}
            pair = pairs[answer["name"]]
            result = verdict(arguments.exsect, pair, candidate, arguments.tolerance, pathlib.Path(scratch))
            if result is None:
                row["refused"] += 1
                continue
            row[result["verdict"]] += 1
            kinds = {difference["kind"] for difference in result["differences"]}
            row.update(kinds)
            if arguments.save and arguments.save[0] in kinds and saved < int(arguments.save[1]):
                saved += 1
                stem = pathlib.Path(arguments.save[2]) / f"{arguments.save[3]}-{saved}"
                for end, content in ((".json", pair), (".candidate.json", candidate)):
                    stem.with_name(stem.name + end).write_text(json.dumps(content, separators=(",", ":")) + "\n")
    family = next(iter(pairs)).split("/")[0]
    heads = ["program", "agrees", "disagrees", "undecided", "no answer", "refused", *KINDS]
    print(f"**{family}**: {len(pairs)} pairs\n\n| {' | '.join(heads)} |\n|{'---|' * len(heads)}")
    for program, row in sorted(rows.items()):
        print(f"| {program} | {' | '.join(str(row[head]) for head in heads[1:])} |")
    print()


main()
