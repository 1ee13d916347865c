#!/usr/bin/env python3
"""Writes a model (form model/1) of about N patches: a quilt, one smooth surface of biquadratic patches that share
their sides, and upright smooth sheets that cut through it. The same seed gives the same bytes.

    examples/batch/quilt.py 20000 --seed 1 > quilt.ndjson
"""

import argparse
import json
import math
import random
import sys


def sheet(name, rows, columns, origin, along, up, noise, rng, out):
    """A quadratic B-spline surface on a uniform grid; its Bezier patches meet with a common tangent plane.

    Coordinates are multiples of 1/1024, and so are, exactly, those of the Bezier points but for two more bits."""

    def coefficient(a, b):
        shift = [rng.randrange(-noise, noise + 1) / 1024 for _ in range(3)]
        return [o + a * d + b * e + s for o, d, e, s in zip(origin, along, up, shift)]

    def middle(p, q):
        return [(x + y) / 2 for x, y in zip(p, q)]

    grid = [[coefficient(a, b) for b in range(columns + 2)] for a in range(3)]
    for a in range(rows):
        for b in range(columns):
            net = [[grid[i][b + j] for j in range(3)] for i in range(3)]
            net = [[middle(p[0], p[1]), p[1], middle(p[1], p[2])] for p in net]
            points = [[middle(x, y) for x, y in zip(net[0], net[1])], net[1], [middle(x, y) for x, y in zip(net[1], net[2])]]
            json.dump({"name": f"{name}/{a}/{b}", "degree": [2, 2], "points": points}, out, separators=(",", ":"))
            out.write("\n")
        grid = [grid[1], grid[2], [coefficient(a + 3, b) for b in range(columns + 2)]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("patches", type=int)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    side = max(2, math.isqrt(options.patches * 5 // 6))  # five patches of six are in the quilt
    sheets, height = 4, max(1, (options.patches - side * side) // (4 * side))
    json.dump({"exsect": "model/1", "title": f"quilt, {side} by {side}, seed {options.seed}", "numbers": "binary64"}, sys.stdout)
    print()
    sheet("quilt", side, side, [0, 0, 0], [1, 0, 0], [0, 1, 0], 300, rng, sys.stdout)
    for k in range(sheets):
        origin = [(k + 0.5) * side / sheets, 0, -height / 2]
        sheet(f"sheet{k}", side, height, origin, [0.125, 1, 0], [0.25, 0, 1], 100, rng, sys.stdout)


if __name__ == "__main__":
    main()
