"""SSI-Bench 1: its families, its pairs, the candidate that a result is, and digests (docs/ssi-bench.md)."""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import subprocess
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAME = "ssi-bench-1"
SEED = 1
GENERATED = {"random-rational": 200, "random-double": 200, "loop": 120, "tangent": 120, "near": 120, "nearer": 120,
             "overlap": 96}  # as in bench/peers/pair_families.h
REPORTED = ROOT / "bench/ssi/reported"
FAMILIES = [*GENERATED, "reported"]
CERTIFIED = [family for family in FAMILIES if family != "nearer"]  # there some certificates take minutes
DRAWN_TO = "1e-5"  # of the true curves: a tenth of the tolerance of the score
PROGRAM = ROOT / "build/release/cli/exsect"
GENERATOR = ROOT / "build/release/bench/peers/exsect_peer_pairs"


def text(document):
    """JSON of the archive: the same bytes everywhere. Python writes a double with the fewest digits that give it back."""
    return json.dumps(document, separators=(",", ":"), ensure_ascii=False) + "\n"


def in_doubles(coordinate):
    return float(Fraction(coordinate)) if isinstance(coordinate, str) else float(coordinate)


def pair_document(name, source, patches):
    """The patch file of a pair: every coordinate the nearest double, so that all programs solve the same problem."""
    return {"exsect": "patches/1", "title": name, "source": source, "numbers": "binary64",
            "patches": [{"name": patch["name"], "degree": patch["degree"],
                         "points": [[[in_doubles(c) for c in point] for point in row] for row in patch["points"]]}
                        for patch in patches]}


def generated_pairs(generator, family):
    lines = subprocess.run([generator, family, str(GENERATED[family]), str(SEED)], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    for number, line in enumerate(lines):
        name = f"{family}/{number:03}"
        yield name, pair_document(name, f"exsect_peer_pairs {family}, seed {SEED}, pair {number}",
                                  json.loads(line)["patches"])


def reported_pairs():
    for path in sorted(REPORTED.glob("*.json")):
        document = json.loads(path.read_text())
        name = f"reported/{path.stem}"
        yield name, pair_document(name, document["source"], document["patches"])


def pairs(generator):
    """(name, patch file) of all pairs in the order of the archive; a name is FAMILY/MEMBER."""
    for family in GENERATED:
        yield from generated_pairs(generator, family)
    yield from reported_pairs()


def curve(arc):
    """A curve of a candidate from an arc of intersection/1."""
    vertices = arc["polyline"]
    return {"points": [v[4:7] for v in vertices], "first": [v[0:2] for v in vertices],
            "second": [v[2:4] for v in vertices], "contact": arc["contact"]}


def candidate(result, source):
    """candidate/1: the arcs, the rims of overlaps and the isolated points of an intersection/1."""
    rims = [arc for overlap in result["overlaps"] for chain in overlap["chains"] for arc in chain]
    isolated = [result["nodes"][node]["approx"] for node in result["isolated_points"]]
    return {"exsect": "candidate/1", "patches": [result["first"], result["second"]], "source": source,
            "curves": [curve(arc) for arc in [*result["arcs"], *rims]],
            "points": [{"point": node["point"], "first": [node["u"], node["v"]], "second": [node["r"], node["s"]]}
                       for node in isolated]}


def digest(files):
    """SHA-256 of the contents one after another: `cat FILES | sha256sum`."""
    result = hashlib.sha256()
    for content in files:
        result.update(content)
    return result.hexdigest()


def folder_digest(folder):
    """The same of all files in a folder, in the order of their names."""
    return digest(path.read_bytes() for path in sorted(folder.iterdir()))


def in_parallel(function, items, jobs=None):
    """The values in the order of the items; the work is done by programs that the function runs."""
    with concurrent.futures.ThreadPoolExecutor(jobs or os.cpu_count()) as pool:
        return list(pool.map(function, items))
