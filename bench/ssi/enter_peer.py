#!/usr/bin/env python3
"""Answers of a program of bench/peers to SSI-Bench 1, as a folder that score.py reads.

    enter_peer.py ARCHIVE ANSWERS PROGRAM [ARGUMENTS...]

For instance: enter_peer.py build/ssi-bench-1 build/ssi-sisl build/release/bench/peers/exsect_peer_sisl --seconds 2
A pair at which the program crashes, fails or has no time left has no answer.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import archive


def main():
    folder, answers = map(pathlib.Path, sys.argv[1:3])
    pairs = [path.read_text() for family in archive.FAMILIES for path in sorted((folder / "pairs" / family).glob("*.json"))]
    with tempfile.NamedTemporaryFile("w", suffix=".pairs") as file:
        file.write("".join(pairs))
        file.flush()
        ended = subprocess.run([sys.argv[3], file.name, *sys.argv[4:]], check=True, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True)
    lines = [json.loads(line) for line in ended.stdout.splitlines()]
    milliseconds = {}
    for line in lines:
        if line["status"] != "done":
            continue
        milliseconds[line["name"]] = line["milliseconds"]
        path = answers / f"{line['name']}.candidate.json"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(archive.text({"exsect": "candidate/1", "patches": ["x", "y"], "source": line["program"],
                                      "curves": line["curves"], "points": line["points"]}))
    (answers / "entry.json").write_text(archive.text({"program": lines[0]["program"], "milliseconds": milliseconds}))


if __name__ == "__main__":
    main()
