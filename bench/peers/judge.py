#!/usr/bin/env python3
"""Judges the answers of one program by `exsect verify`: one line of JSON for each pair.

    judge.py EXSECT PAIRS RESULTS [--tolerance 1e-4] [--save TITLE STEM]

PAIRS has one patch file a line, RESULTS what a program of bench/peers wrote for them. --save writes the pair of that
title and its answer instead, as STEM.json and STEM.candidate.json.
"""

import argparse
import collections
import json
import math
import pathlib
import subprocess
import tempfile
from fractions import Fraction

import numpy

MOST_VERTICES = 200  # of a curve that is saved


def numbers(value):
    return [numbers(v) for v in value] if isinstance(value, list) else float(Fraction(value))


def net_of(patch):
    """The control points times their weights, and these: an (m+1) x (n+1) x 4 array."""
    points = numpy.array(numbers(patch["points"]))
    weights = numpy.array(numbers(patch["weights"])) if "weights" in patch else numpy.ones(points.shape[:2])
    return numpy.concatenate([points * weights[:, :, None], weights[:, :, None]], axis=2)


def size_of(x, y):
    """The largest extent of the box around all control points."""
    points = numpy.concatenate([x.reshape(-1, 4), y.reshape(-1, 4)])
    return numpy.ptp(points[:, :3] / points[:, 3:], axis=0).max()


def evaluated(net, parameters):
    """Points and both derivatives at an n x 2 array of parameters."""
    def basis(n, t):
        values = numpy.stack([math.comb(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)], 1)
        if n == 0:
            return values, numpy.zeros_like(values)
        below, zero = basis(n - 1, t)[0], numpy.zeros((len(t), 1))
        return values, n * (numpy.hstack([zero, below]) - numpy.hstack([below, zero]))
    (a, da), (b, db) = (basis(net.shape[k] - 1, parameters[:, k]) for k in (0, 1))
    p, pu, pv = (numpy.einsum("ni,nj,ijk->nk", f, g, net) for f, g in ((a, b), (da, b), (a, db)))
    x = p[:, :3] / p[:, 3:]
    return x, *((d[:, :3] - d[:, 3:] * x) / p[:, 3:] for d in (pu, pv))


def distance_from_truth(x, y, points, parameters):
    """Largest distance of the points from the solutions that Newton's method finds from their parameters, as far as it
    finds any. In floating point, no proof."""
    size = size_of(x, y)
    p = parameters.copy()
    for _ in range(12):
        (a, au, av), (b, br, bs) = evaluated(x, p[:, :2]), evaluated(y, p[:, 2:])
        gap = a - b
        jacobian = numpy.stack([au, av, -br, -bs], 2)
        p = p - numpy.einsum("nij,nj->ni", numpy.linalg.pinv(jacobian, rcond=1e-9), gap)
        p = numpy.clip(p, -1, 2)
    tangent = numpy.cross(numpy.cross(au, av), numpy.cross(br, bs))
    tangent /= numpy.maximum(numpy.linalg.norm(tangent, axis=1), 1e-300)[:, None]
    off = points - a
    off -= numpy.einsum("ni,ni->n", off, tangent)[:, None] * tangent
    solved = numpy.linalg.norm(gap, axis=1) < 1e-11 * size
    near = numpy.abs(p - parameters).max(axis=1) < 1e-2
    return numpy.linalg.norm(off, axis=1)[solved & near].max(initial=0)


def numbers_of(pair, answer):
    """The largest residual |x(u,v) - y(r,s)| at a vertex, and the largest distance of vertices from the truth; of what
    is meant as a polyline at the middles of its chords as well. The bound is the tolerance if none is stated."""
    x, y = map(net_of, pair["patches"])
    bound = answer.get("bound", answer["tolerance"] * size_of(x, y))
    if not answer["curves"]:
        return {"bound": bound, "residual": 0, "distance": 0}
    lines = [numpy.hstack([curve["points"], curve["first"], curve["second"]]) for curve in answer["curves"]]
    vertices = numpy.vstack(lines)
    residual = numpy.linalg.norm(evaluated(x, vertices[:, 3:5])[0] - evaluated(y, vertices[:, 5:])[0], axis=1).max()
    if answer.get("polylines"):
        vertices = numpy.vstack([vertices, *((line[1:] + line[:-1]) / 2 for line in lines)])
    return {"bound": bound, "residual": residual,
            "distance": distance_from_truth(x, y, vertices[:, :3], vertices[:, 3:])}


def candidate_of(answer):
    return {"exsect": "candidate/1", "patches": ["x", "y"], "source": answer["program"], "curves": answer["curves"],
            "points": answer["points"]}


def verdict(program, pair, candidate, tolerance, directory):
    """The verdict/1 document of one answer, or None where the candidate is refused."""
    for name, content in (("pair.json", pair), ("answer.json", candidate)):
        (directory / name).write_text(json.dumps(content))
    command = [program, "verify", directory / "answer.json", directory / "pair.json", "--tolerance", tolerance,
               "--json", "-", "--max-seconds", "20", "--quiet"]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=600)
    return json.loads(ended.stdout) if ended.returncode in (0, 1, 3) else None


def judged(program, pair, answer, tolerance, directory):
    """What the tables need of one answer but its time."""
    line = {"name": answer["name"]}
    if answer["status"] != "done":
        return line
    line.update(numbers_of(pair, answer))
    found = verdict(program, pair, candidate_of(answer), tolerance, directory)
    if found is None:
        return line | {"verdict": "refused"}
    proved = [curve["distance"][0] for curve in found["curves"] if curve["spurious"]]  # others: of chords of samples
    return line | {
        "verdict": found["verdict"],
        "exact": found["exact"],
        "differences": collections.Counter(difference["kind"] for difference in found["differences"]),
        "components": collections.Counter(component["coverage"] for component in found["components"]),
        "invented": sum(bool(curve["spurious"]) for curve in found["curves"]),
        "distance": max([line["distance"], *proved]),
    }


def thinned(curve):
    count = len(curve["points"])
    if count > MOST_VERTICES:
        kept = [i * (count - 1) // (MOST_VERTICES - 1) for i in range(MOST_VERTICES)]
        curve = {key: [values[i] for i in kept] for key, values in curve.items()}
    return curve


def save(pair, answer, stem):
    candidate = candidate_of(answer)
    candidate["curves"] = [thinned(curve) for curve in candidate["curves"]]
    for end, content in ((".json", pair), (".candidate.json", candidate)):
        pathlib.Path(stem + end).write_text(json.dumps(content, separators=(",", ":")) + "\n")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("exsect")
    parser.add_argument("pairs", type=pathlib.Path)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--tolerance", default="1e-4")
    parser.add_argument("--save", nargs=2, metavar=("TITLE", "STEM"))
    arguments = parser.parse_args()
    with open(arguments.pairs, encoding="utf-8") as lines:
        pairs = {pair["title"]: pair for pair in map(json.loads, lines)}
    with tempfile.TemporaryDirectory() as scratch, open(arguments.results, encoding="utf-8") as lines:
        for answer in map(json.loads, lines):
            pair = pairs[answer["name"]]
            if not arguments.save:
                print(json.dumps(judged(arguments.exsect, pair, answer, arguments.tolerance, pathlib.Path(scratch))))
            elif answer["name"] == arguments.save[0]:
                save(pair, answer, arguments.save[1])


main()
