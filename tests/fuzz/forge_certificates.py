#!/usr/bin/env python3
"""Forge certificates, with seals that fit, and see whether a checker accepts a false one.

    forge_certificates.py --program build/release/cli/exsect hand-made [EVERY]
    forge_certificates.py --program build/release/cli/exsect random FIRST COUNT
    forge_certificates.py --program build/release/cli/exsect false [EVERY]

`hand-made` puts numbers, lists and words of all extremes in the place of each kind of claim, and makes false claims on
purpose; with EVERY = 7 only every seventh. `random` makes one to three random changes for each seed from FIRST on.
Both checkers, `exsect check` and examples/check_certificate.py, judge each forgery. They have to agree, none may end
otherwise than with a verdict, and what they accept has to be true: the same graph, boxes and polylines as the result of
`exsect` for the patches in the file. `false` makes claims that cannot be true: arcs with the ends of others, left out or twice,
boxes moved, other sides and turning points, other multiplicities; all have to be rejected. --bases N takes the first N of the certificates only; the shortest come first.
Exit status 1 if something does not hold.
"""

import argparse
import collections
import importlib.util
import itertools
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[2]
spec = importlib.util.spec_from_file_location("check_certificate", ROOT / "examples" / "check_certificate.py")
checker = importlib.util.module_from_spec(spec)
spec.loader.exec_module(checker)

# ---- Certificates to begin with


def patches(*nets):
    return {"exsect": "patches/1", "patches": [{"name": name, "degree": [len(net) - 1, len(net[0]) - 1], "points": net}
                                               for name, net in zip("xy", nets)]}


def surface(name, claim):
    """The entry of a patch file for a claim of a certificate."""
    if "equation" in claim:
        return {"name": name, "type": "implicit", "terms": [[c, powers] for c, *powers in claim["equation"]]}
    entry = patches(claim["points"])["patches"][0]
    return {**entry, "name": name, **({"weights": claim["weights"]} if "weights" in claim else {})}


def plane(origin, u, v):
    def add(*points):
        return [str(sum(map(Fraction, c))) for c in zip(*points)]
    return [[add(origin), add(origin, v)], [add(origin, u), add(origin, u, v)]]


FLOOR = plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
SLOPE = plane((0, 0, "-3/5"), (1, "1/4", 1), ("1/3", 1, "1/2"))


def umbrella():
    """(s t, s, t^2), s = u + v/4 - 5/8, t = u/8 + v - 5/12."""
    def point(i, j):
        s, t = ([Fraction(-5, 8), Fraction(1), Fraction(1, 4)], [Fraction(-5, 12), Fraction(1, 8), Fraction(1)])

        def product(p, q):  # the control point of p q: by the coefficients of monomials
            total = Fraction(0)
            for m, a in enumerate(p):
                for n, b in enumerate(q):
                    power = [(m == 1) + (n == 1), (m == 2) + (n == 2)]
                    share = math.prod(Fraction(math.comb(k, d), math.comb(2, d)) for k, d in zip((i, j), power))
                    total += a * b * share
            return total
        return [str(product(s, t)), str(product(s, [1, 0, 0])), str(product(t, t))]
    return [[point(i, j) for j in range(3)] for i in range(3)]


def quarter_turn(angle, *profile):
    """A quarter of a turn of the straight line, from the angle with this cosine and sine."""
    cosine, sine = map(Fraction, angle)
    rows = [[[str(Fraction(across) * (cosine * x - sine * y)), str(Fraction(across) * (sine * x + cosine * y)), str(height)]
             for across, height in profile] for x, y in ((1, 0), (1, 1), (0, 1))]
    return {"degree": [2, 1], "points": rows, "weights": [["1", "1"], ["1", "1"], ["2", "2"]]}


def touching_neighbours():
    """(u, v, u^2 + v^2) and (1 + r (1 + s) / 2, s, 1 + s^2 + r (1 + s) + r^2 / 3), which touch where u = 1, r = 0 and v = s."""
    square = [0, 0, 1]
    yield [[[str(Fraction(c)) for c in (Fraction(i, 2), Fraction(j, 2), square[i] + square[j])] for j in range(3)] for i in range(3)]
    along = [[Fraction(i, 2) + Fraction(i * j, 4) for j in range(3)] for i in range(3)]
    yield [[[str(Fraction(c)) for c in (1 + along[i][j] / 2, Fraction(j, 2), 1 + square[j] + along[i][j] + Fraction(square[i], 3))] for j in range(3)]
           for i in range(3)]


def random_patch(generator, height):
    return [[[str(Fraction(i, 2) + Fraction(generator.randint(-9, 9), 97)), str(Fraction(j, 2) + Fraction(generator.randint(-9, 9), 89)),
              str(Fraction(generator.randint(-30, 30), 50) * height)] for j in range(3)] for i in range(3)]


def models():
    """(name, command, model or path): the kinds of certificates."""
    generator = random.Random(7)
    cases = ROOT / "tests" / "cases"
    first = ROOT / "examples" / "chapter9-first.json"
    yield "nothing", ["intersect"], patches(FLOOR, plane((0, 0, 1), (1, 0, 0), (0, 1, "1/2")))
    yield "self, nothing", ["self", "--patch", "x"], first
    yield "line", ["line", "--u", "1/2"], first
    yield "overlap", ["intersect"], cases / "overlap.json"
    yield "part of a side", ["intersect"], cases / "part-of-a-side.json"
    yield "tangent curve", ["intersect"], cases / "tangent-curve.json"
    yield "shared side", ["intersect"], patches(FLOOR, plane((0, 0, 0), (0, "1/2", 1), (0, 1, 0)))
    yield "planes", ["intersect"], patches(FLOOR, SLOPE)
    ground, wall = plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), [["-13/30", "17/30"], ["-1/3", "2/3"], ["-7/30", "23/30"]]
    for name, control in (("side touched from outside", [("-1/4", "0"), ("1/4", "1/2"), ("-1/4", "1")]), ("corner left both ways", [("-1/2", "1/2"), (0, 0), ("1/2", "-1/2")]),
                          ("side touched from inside", [("1/4", "0"), ("-1/4", "1/2"), ("1/4", "1")])):
        yield name, ["intersect"], patches(ground, [[[u, v, z] for z in heights] for (u, v), heights in zip(control, wall)])
    yield "line of planes", ["line", "--s", "2/7"], patches(FLOOR, SLOPE)
    yield "two near sheets", ["intersect"], cases / "two-near-sheets.json"
    yield "side and arc", ["intersect"], cases / "side-and-arc.json"
    yield "shared side of curved patches", ["intersect"], cases / "shared-side.json"
    yield "double cover", ["intersect"], cases / "double-cover.json"
    yield "self, umbrella", ["self", "--patch", "x"], patches(umbrella(), FLOOR)
    with_weights = {"name": "x", "degree": [2, 2], "points": umbrella(), "weights": [["1", "3/2", "1"], ["4/3", "1", "1"], ["1", "1", "5/4"]]}
    yield "self, umbrella with weights", ["self", "--patch", "x"], {"exsect": "patches/1", "patches": [with_weights]}
    yield "cap", ["intersect"], cases / "cap.json"
    yield "tangent and transversal", ["intersect"], cases / "tangent-and-transversal.json"
    yield "nearly crossing", ["intersect"], cases / "nearly-crossing.json"
    yield "crossing", ["intersect"], cases / "crossing.json"
    yield "two branches tangent to each other", ["intersect"], cases / "two-branches-tangent-to-each-other.json"
    yield "irrational crossing", ["intersect"], ROOT / "tests" / "project" / "irrational-crossing.json"
    yield "random", ["intersect"], patches(random_patch(generator, 1), random_patch(generator, Fraction(1, 2)))
    yield "first example", ["intersect"], first
    bent = {"name": "x", "degree": [2, 1], "points": [[[0, 0, 0], [0, 1, "1/8"]], [["1/2", 0, "1/5"], ["1/2", 1, 0]], [[1, 0, 0], [1, 1, "1/7"]]],
            "weights": [[1, 1], ["3/2", "4/3"], [1, 1]]}
    across = {"name": "y", "degree": [1, 1], "points": plane(("1/3", "-1/10", -1), (0, "6/5", "1/7"), ("1/9", 0, 2))}
    yield "weights", ["intersect"], {"exsect": "patches/1", "patches": [bent, across]}
    ball = {"name": "y", "type": "sphere", "centre": ["1/2", "1/2", "1/10"], "radius": "1/3"}
    yield "equation and weights", ["intersect"], {"exsect": "patches/1", "patches": [bent, ball]}
    yield "nodes next to each other", ["intersect"], cases / "found" / "corner-arc-twice.json"
    cone, cylinder = (quarter_turn(*arguments) for arguments in (((1, 0), ("10/7", 0), ("3/7", 2)), (("4/5", "3/5"), (1, "9/35"), (1, "123/70"))))
    yield "neighbours", ["intersect"], cases / "found" / "smooth-neighbours.json"
    yield "neighbours that touch", ["intersect"], patches(*touching_neighbours())
    # (u, u^2, 0) + v (0, 1/3, 1 + u / 3) and (s, 1/2, 0) + r (0, 1, 1/2), in whose common corner u^2 = 1/2, turned.

    def turn(x, y, z):
        return [str(x + z), str(y - z), str(y + z)]
    half, third = Fraction(1, 2), Fraction(1, 3)
    low = [[turn(i * half, i // 2 + v * third, v * (1 + i * half * third)) for v in range(2)] for i in range(3)]
    yield "irrational corner", ["intersect"], patches(low, [[turn(Fraction(s), half + r, r * half) for s in range(2)] for r in range(2)])
    # (u, 1/4 + u^2 / 2) and (r^2, r) in the plane, each along a line, in other coordinates.
    heights = [[(0, "1/4"), ("1/2", "1/4"), (1, "3/4")], [(0, 0), (0, "1/2"), (1, 1)]]
    walls = [[[turn(Fraction(a) + z / 3, Fraction(b), z) for z in ends] for a, b in row] for row, ends in zip(heights, ((0, Fraction(1)), (-third, Fraction(4, 5))))]
    yield "parallel lines", ["intersect"], patches(*walls)
    yield "circles around an axis", ["intersect"], {"exsect": "patches/1", "patches": [dict(cone, name="x"), dict(cylinder, name="y")]}


class Program:
    def __init__(self, path, folder):
        self.path, self.folder = str(pathlib.Path(path).resolve()), pathlib.Path(folder)

    def run(self, *arguments):
        return subprocess.run([self.path, *map(str, arguments)], capture_output=True, text=True, timeout=600)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8", newline="")
        return path

    def certificate(self, command, model):
        path = model if isinstance(model, pathlib.Path) else self.file("model.json", json.dumps(model))
        target = self.folder / "certificate.json"
        options = [] if command[0] == "line" else ["--tolerance", "1e-1"]
        ended = self.run(command[0], path, *command[1:], *options, "--quiet", "--certificate", target)
        if ended.returncode != 0:
            raise SystemExit(f"no certificate of {path}: {ended.stderr}")
        return target.read_text(encoding="utf-8")

    def accepts(self, text):
        """True or False; what else happened as a text."""
        ended = self.run("check", self.file("forged.json", text), "--json", "-")
        if ended.returncode in (0, 1):
            return ended.returncode == 0
        unreadable = ended.returncode == 2 and any(why in ended.stderr for why in ("not valid JSON", "not of the form certificate/1"))
        return None if unreadable else f"status {ended.returncode}: {ended.stderr[:300]}"

    def result(self, root):
        """What the program finds for the patches of a certificate; None if that is incomplete."""
        surfaces = [surface(name, root[key]) for name, key in (("x", "first"), ("y", "second")) if key in root]
        path = self.file("truth.json", json.dumps({"exsect": "patches/1", "patches": surfaces}))
        if root["command"] == "line":
            command = ["line", path, "--" + root["fixed"]["parameter"], root["fixed"]["value"]]
        elif root["command"] == "self":
            command = ["self", path, "--patch", "x"]
        else:
            command = ["intersect", path, "--tolerance", "1e-4"]
        ended = self.run(*command, "--json", "-")
        return json.loads(ended.stdout) if ended.returncode == 0 else None


# ---- Seals


class Raw(str):
    """A text that is written as it stands."""


def compact(value):
    if isinstance(value, Raw):
        return str(value)
    if isinstance(value, list):
        return "[" + ",".join(map(compact, value)) + "]"
    if isinstance(value, dict):
        return "{" + ",".join(json.dumps(key, ensure_ascii=False) + ":" + compact(inner) for key, inner in value.items()) + "}"
    return json.dumps(value, ensure_ascii=False)


known_seals = {}


def seal(text):
    if text not in known_seals:
        if len(known_seals) > 20000:
            known_seals.clear()
        known_seals[text] = checker.seal(text)
    return known_seals[text]


def sealed(root):
    """The text of a certificate, each claim with its seal."""
    def claim(value, place):
        if not isinstance(value, dict):
            return compact(value)
        body = compact({key: inner for key, inner in value.items() if key != "seal"})
        return body[:-1] + ("," if len(body) > 2 else "") + f'"seal":"{seal(place + body)}"' + "}"

    def part(key, value):
        place = "$." + key
        if key == "cover" and isinstance(value, list):
            rows = [(f"{place}[{i}]", row) for i, row in enumerate(value)]
            return "[" + ",".join(compact(row.split(" #")[0] + " #" + seal(at + row.split(" #")[0])) if isinstance(row, str) else compact(row)
                                  for at, row in rows) + "]"
        if isinstance(value, list):
            return "[" + ",".join(claim(inner, f"{place}[{i}]") for i, inner in enumerate(value)) + "]"
        return claim(value, place)

    return "{" + ",".join(f'"{key}":{part(key, value)}' for key, value in root.items()) + "}"


def recounted(root):
    """The summary says what the lists say."""
    cells = sum(len(row.split(" #")[0].split(" ")) for row in root["cover"] if isinstance(row, str)) if isinstance(root["cover"], list) else 0
    sizes = {key: len(value) for key, value in root.items() if isinstance(value, list)}
    claims = [sizes.get(key, 0) for key in ("factors", "stars", "tubes", "nodes", "arcs")] + [cells, sizes.get("overlaps", 0)]
    if root["command"] == "line":
        claims[3] = sizes.get("points", 0)
    if not isinstance(root["summary"], dict):
        return root
    root["summary"]["claims"] = claims
    if "components" in sizes and "nodes" in sizes:
        shapes = [c.get("shape") for c in root["components"] if isinstance(c, dict)]
        nodes = [n for n in root["nodes"] if isinstance(n, dict)]
        root["summary"].update(components=len(shapes), boundary=sum(bool(n.get("on")) for n in nodes),
                               turning=[sum(isinstance(n.get("wrt"), list) and p in n["wrt"] for n in nodes) for p in "uvrs"],
                               **{shape: shapes.count(shape) for shape in ("closed", "open", "branched")})
    return root


# ---- Changes

NUMBERS = ["0", "1", "-1", "1/2", "1/2^60", "1/2^1074", "-1/2^2000", str(2**1023), "-" + "1" + "0" * 400, "1/1" + "0" * 400, "1/3",
           "1" + "0" * 6098, "1" + "0" * 6101, "1/0", "00", "-0", "1/2^2001", "2/4", "NaN", "Infinity", "1e5", "0.5", "", " 1", Raw("1"), Raw("null")]
COUNTS = [0, 1, 2, 3, 7, 2**31 - 1, 2**31, 2**32, 2**32 + 1, 2**63 - 1, 2**63, 2**64 - 1, Raw(str(2**64)), Raw("1" + "0" * 50), Raw("-1"),
          Raw("-0"), Raw("1.0"), Raw("1e0"), Raw("01"), Raw("NaN"), Raw("true"), "1"]
WORDS = ["u", "v", "r", "s", "u=0", "u=1", "v=0", "r=1", "s=0", "pair", "first", "second", "factor0", "factor1", "star0u+", "star0v-", "star0u+factor0",
         "star1u-", "open", "closed", "branched", "", "t0", "lower", "x\\u0000", "factor18446744073709551615", "star4294967296u+"]
CELLS = ["u", "v", "r", "s", "t0", "t1", "t2", "p0", "s0", "m0", "lower", "0,0,0", "0,0,1", "0,0,-1", "1,0,0", "-1,0,0", "0,1,0", "0,-1,0", "i1,0,0", "i0,0,0",
         "2147483647,-2147483648,0", "2147483648,0,0", "t18446744073709551615", "t-1", "-0,0,1", "1,2", "", "x"]
LISTS = [[], Raw("{}"), Raw("[" * 30 + "]" * 30), Raw("[" * 5000 + "]" * 5000), "", Raw("null")]


def leaves(value, path=()):
    """(path, leaf) of all strings and integers below."""
    if isinstance(value, (list, dict)):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            if key != "seal":
                yield from leaves(inner, path + (key,))
    else:
        yield path, value


def containers(value, path=()):
    if isinstance(value, (list, dict)):
        yield path, value
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from containers(inner, path + (key,))


def at(root, path):
    for key in path:
        root = root[key]
    return root


def put(root, path, value):
    at(root, path[:-1])[path[-1]] = value


def copy(value):
    if isinstance(value, list):
        return [copy(inner) for inner in value]
    if isinstance(value, dict):
        return {key: copy(inner) for key, inner in value.items()}
    return value


def kind(path):
    """The same for elements of one list, but for the first two of short ones."""
    return tuple(("*" if n < 2 or len(path) > 6 else min(key, 2)) if isinstance(key, int) else key for n, key in enumerate(path))


def pool(path, value):
    if path[0] in ("exsect", "command"):
        return ["intersect", "self", "line", "", "certificate/2", 1]
    if path[0] == "cover" or "charts" in path:
        return []
    return COUNTS if isinstance(value, int) else WORDS if value and value[0] not in "-0123456789" else NUMBERS


class Forged:
    """A certificate that gets its seals when it is asked for."""

    def __init__(self, root):
        self.root = root

    def text(self):
        return sealed(self.root)


def hand_made(base):
    """(what, Forged) of all forgeries by hand."""
    seen = collections.Counter()
    for path, value in list(leaves(base)):
        seen[kind(path)] += 1
        if seen[kind(path)] > 1:
            continue
        for other in pool(path, value):
            if other != value or isinstance(other, Raw):
                root = copy(base)
                put(root, path, other)
                yield f"{path}: {other!s:.40}", Forged(recounted(root) if path[0] != "summary" else root)
    seen.clear()
    for path, value in list(containers(base)):
        seen[kind(path)] += 1
        if not path or seen[kind(path)] > 1:
            continue
        for other in LISTS:
            root = copy(base)
            put(root, path, other)
            yield f"{path}: {other!s:.20}", Forged(root if path[0] == "summary" else recounted(root))
        if isinstance(value, list) and value and path[0] != "cover":
            for what, change in (("repeated", lambda l: l.append(copy(l[0]))), ("dropped", lambda l: l.pop()), ("reversed", lambda l: l.reverse()),
                                 ("first dropped", lambda l: l.pop(0))):
                root = copy(base)
                change(at(root, path))
                yield f"{path}: {what}", Forged(recounted(root) if path[0] != "summary" else root)
        if isinstance(value, dict):
            for key in value:
                body = compact({k: v for k, v in value.items() if k != "seal"})
                root = copy(base)
                put(root, path, Raw(body[:-1] + f',"{key}":{compact(value[key])}' + "}"))
                yield f"{path}: {key} twice", Forged(root)
                root = copy(base)
                at(root, path).pop(key)
                yield f"{path}: without {key}", Forged(root)
    rows = " ".join(row.split(" #")[0] for row in base["cover"])
    entries = rows.split(" ")
    for entry in CELLS:
        for what, cover in ((f"cover: {entry}", [entry]), (f"first leaf {entry}", None), (f"all exclusions {entry}", None)):
            root = copy(base)
            changed = list(entries)
            if what.startswith("first"):
                changed[next(i for i, e in enumerate(entries) if e not in ("u", "v", "r", "s"))] = entry
            elif what.startswith("all"):
                changed = [entry if "," in e else e for e in entries]
            root["cover"] = cover or [" ".join(changed)]
            yield what, Forged(recounted(root))
    for i in range(0, len(entries), max(1, len(entries) // 12)):
        for what, changed in (("dropped", entries[:i] + entries[i + 1 :]), ("twice", entries[: i + 1] + entries[i:]),
                              ("turned", entries[:i] + [turned(entries[i])] + entries[i + 1 :])):
            root = copy(base)
            root["cover"] = [" ".join(changed)]
            yield f"entry {i} {what}", Forged(recounted(root))
    for key in ("first", "second"):
        for what, change in NET_CHANGES if "points" in base.get(key, {}) else ():
            root = copy(base)
            root[key]["points"] = [[change(list(map(Fraction, p)), i, j) for j, p in enumerate(row)] for i, row in enumerate(root[key]["points"])]
            yield f"{key}: {what}", Forged(root)
    for key in base:
        for what, factor in (("twice", 2), ("a millionth", Fraction(1, 10**6)), ("2^40 times", 2**40), ("minus", -1)):
            for field in ("reach", "width", "radius", "error_bound", "inverse", "slope"):
                root = copy(base)
                found = [claim for claim in root[key] if isinstance(claim, dict) and field in claim] if isinstance(root[key], list) else []
                for claim in found:
                    claim[field] = scaled(claim[field], factor)
                if found:
                    yield f"{key}: {what} {field}", Forged(root)
    yield from without_a_component(base)


def turned(entry):
    return ",".join(str(-int(n)) for n in entry.split(",")) if entry[0] in "-0123456789" else "0,0,1"


def scaled(value, factor):
    if isinstance(value, list):
        return [scaled(inner, factor) for inner in value]
    return str(checker.number(value, "") * factor)


def moved(d, by):
    return lambda p, i, j: [str(c + by if k == d else c) for k, c in enumerate(p)]


NET_CHANGES = [("moved by 1", moved(2, 1)), ("moved by 2^-40", moved(2, Fraction(1, 2**40))), ("moved by 2^-200", moved(0, Fraction(1, 2**200))),
               ("one point", lambda p, i, j: ["1", "2", "3"]), ("all 0", lambda p, i, j: ["0", "0", "0"]),
               ("a corner at 10^308", lambda p, i, j: [str(c * 10**308 if i == j == 2 else c) for c in p]),
               ("a corner at 10^400", lambda p, i, j: [str(10**400 if i == j == 2 else c) for c in p]),
               ("times 2^-1074", lambda p, i, j: [str(c / 2**1074) for c in p]), ("times 2^1000", lambda p, i, j: [str(c * 2**1000) for c in p]),
               ("mirrored", lambda p, i, j: [str(p[0]), str(p[1]), str(-p[2])]), ("bent", lambda p, i, j: [str(c + (k == 2 and i == j == 1)) for k, c in enumerate(p)])]


def without_a_component(base):
    """One component is missing altogether, and what it needs; its cells are said to be empty, or in another tube."""
    for lost in range(len(base.get("components", []))):
        arcs = [i for i, arc in enumerate(base["arcs"]) if arc["component"] != lost]
        kept = sorted({n for i in arcs for n in (base["arcs"][i]["from"], base["arcs"][i]["to"]) if n < len(base["nodes"])})
        tubes = sorted({p[0] for i in arcs for p in base["arcs"][i]["pieces"]} | {base["nodes"][n]["tube"] for n in kept})
        for instead in ("0,0,1", "0,0,0", "t0"):
            root = copy(base)
            root["nodes"] = [dict(root["nodes"][n], tube=tubes.index(root["nodes"][n]["tube"])) for n in kept]
            shift = len(kept) - len(base["nodes"])
            end = {n: kept.index(n) if n in kept else n + shift for n in range(len(base["nodes"]) + len(base["stars"]))}
            root["arcs"] = [dict(base["arcs"][i], component=base["arcs"][i]["component"] - (base["arcs"][i]["component"] > lost),
                                 pieces=[[tubes.index(t), last] for t, last in base["arcs"][i]["pieces"]],
                                 **{"from": end[base["arcs"][i]["from"]], "to": end[base["arcs"][i]["to"]]}) for i in arcs]
            root["components"] = [dict(c, arcs=[arcs.index(a) for a in c["arcs"]]) for n, c in enumerate(base["components"]) if n != lost]
            root["tubes"] = [base["tubes"][t] for t in tubes]
            rename = {f"t{t}": f"t{i}" for i, t in enumerate(tubes)}
            root["cover"] = [" ".join(rename.get(e, instead) if e[0] == "t" else e for e in row.split(" #")[0].split(" ")) for row in base["cover"]]
            yield f"without component {lost}, {instead}", Forged(recounted(root))


def polynomial_product(a, b):
    terms = [(Fraction(p[0]) * Fraction(q[0]), *map(sum, zip(p[1:], q[1:]))) for p in a for q in b]
    total = collections.Counter()
    for c, *power in terms:
        total[tuple(power)] += c
    return [[str(c), *power] for power, c in total.items() if c]


def exchanged(root, key, i, j, fields):
    a, b = root[key][i], root[key][j]
    for field in fields:
        a[field], b[field] = b[field], a[field]


def false_claims(base):
    """(what, Forged) of claims none of which can be true, whatever the patches: every one has to be rejected."""
    def changed(change):
        root = copy(base)
        change(root)
        return Forged(recounted(root))

    arcs, nodes = base.get("arcs", []), base.get("nodes", base.get("points", []))
    key = "nodes" if "nodes" in base else "points"
    for i, j in itertools.islice(itertools.combinations(range(len(arcs)), 2), 6):
        fields = [field for field in ("from", "to", "points", "pieces") if arcs[i][field] != arcs[j][field]]
        for field in fields:
            yield f"arcs {i} and {j}: {field} exchanged", changed(lambda root: exchanged(root, "arcs", i, j, [field]))
        if arcs[i]["to"] != arcs[j]["to"]:
            yield f"arcs {i} and {j}: other ends", changed(lambda root: exchanged(root, "arcs", i, j, ["to", "points"]))
    for i, arc in enumerate(arcs[:6]):
        if arc["from"] != arc["to"]:
            yield f"arc {i}: ends exchanged", changed(lambda root: root["arcs"][i].update({"from": arc["to"], "to": arc["from"]}))
        yield f"arc {i}: twice", changed(lambda root: root["arcs"].append(copy(arc)) or root["components"][arc["component"]]["arcs"].append(len(arcs)))
        yield f"arc {i}: left out", changed(lambda root: root["arcs"].pop(i) and [
            c.update(arcs=[a - (a > i) for a in c["arcs"] if a != i]) for c in root["components"]])
    for i, node in enumerate(nodes[:6]):
        radius = Fraction(checker.number(node["radius"], ""))
        for n, letter in enumerate("uvrs"):
            at = Fraction(checker.number(node["at"][n], ""))
            new = at + 3 * radius if at < Fraction(1, 2) else at - 3 * radius

            def move(root):
                root[key][i]["at"][n] = str(new)
                for arc in root.get("arcs", []):
                    for end, place in (("from", 0), ("to", -1)):
                        if arc[end] == i:
                            arc["points"][place][n] = str(new)
            yield f"node {i}: its box moved in {letter}", changed(move)
            if key == "nodes" and letter not in node["wrt"]:
                yield f"node {i}: turning in {letter}", changed(lambda root: root["nodes"][i]["wrt"].append(letter) or root["nodes"][i]["wrt"].sort(key="uvrs".index))
            if key == "nodes" and not any(on[0] == letter for on in node["on"]):
                yield f"node {i}: on {letter}=0", changed(lambda root: root["nodes"][i]["on"].append(letter + "=0"))
        if key == "nodes" and len(node["on"]) + len(node["wrt"]) == 1:
            yield f"node {i}: nothing there", changed(lambda root: root["nodes"][i].update(on=[], wrt=[]))
    used = {int(tube["curve"].split("factor")[1]) for tube in base["tubes"] if "factor" in tube["curve"] and not tube["curve"].startswith("star")}
    for f in sorted(used):
        for j, power in enumerate(base["factors"][f]["powers"]):
            yield f"factor {f}: power {j} greater", changed(lambda root: put(root, ("factors", f, "powers", j), power + 1))
            if power == 1 or not base["factors"][f]["columns"][2]:
                continue

            def lower(root):  # true, but where the map vanishes the column does, too
                factor = root["factors"][f]
                factor["powers"][j] -= 1
                factor["columns"][j] = [polynomial_product(c, factor["map"][j]) for c in factor["columns"][j]]
            yield f"factor {f}: power {j} less", changed(lower)
    for field, by in (("tangential", 1), ("tangential", -1), ("isolated", 1), ("closed", 1), ("branched", 1)):
        if field in base["summary"] and base["summary"][field] + by >= 0:
            root = copy(base)
            root["summary"][field] += by
            yield f"{field}: {by}", Forged(root)


# ---- Random changes


def near_number(text, generator):
    q = checker.number(text, "")
    change = generator.choice([lambda: q + Fraction(generator.randint(-3, 3), 2 ** generator.randint(1, 80)), lambda: q * Fraction(generator.randint(-3, 9), 4),
                               lambda: -q, lambda: q * (1 + Fraction(1, 2 ** generator.randint(5, 50))), lambda: Fraction(generator.randint(-3, 3))])
    return str(change())


def changed_once(root, bases, generator):
    """Changes root; what was changed."""
    how = generator.random()
    paths = [path for path, value in leaves(root) if path[0] not in ("exsect",) or how < 0.02]
    by_part = collections.defaultdict(list)
    for path in paths:
        by_part[path[0]].append(path)
    part = generator.choice([key for key in by_part for _ in range(1 if key in ("command", "cover", "summary") else 3)])
    path = generator.choice(by_part[part])
    value = at(root, path)
    if part == "cover" or "charts" in path:
        entries = str(value).split(" #")[0].split(" ")
        i = generator.randrange(len(entries))
        other = generator.choice([lambda: [], lambda: [entries[i], entries[i]], lambda: [generator.choice(CELLS)], lambda: [turned(entries[i] or "u")],
                                  lambda: [generator.choice(entries)], lambda: [f"t{generator.randrange(40)}"],
                                  lambda: [",".join(str(generator.randint(-9, 9)) for _ in range(3))]])()
        put(root, path, " ".join(entries[:i] + other + entries[i + 1 :]))
        return f"{path}: entry {i} {other}"
    if how < 0.55:
        if isinstance(value, int):
            other = generator.choice([lambda: max(0, value + generator.choice([-1, 1])), lambda: generator.randrange(12), lambda: generator.choice(COUNTS)])()
        elif isinstance(value, str) and value and value[0] in "-0123456789" and not isinstance(value, Raw):
            try:
                other = near_number(value, generator) if generator.random() < 0.75 else generator.choice(NUMBERS)
            except checker.Rejected:
                other = generator.choice(NUMBERS)
        else:
            other = generator.choice(WORDS)
        put(root, path, other)
        return f"{path}: {other!s:.60}"
    lists = [path for path, inner in containers(root) if isinstance(inner, list) and inner and path[0] != "cover"]
    where = generator.choice(lists)
    inner = at(root, where)
    if how < 0.85:
        i, j = generator.randrange(len(inner)), generator.randrange(len(inner))
        what = generator.choice(["dropped", "repeated", "exchanged", "copied", "emptied"])
        if what == "dropped":
            inner.pop(i)
        elif what == "repeated":
            inner.insert(j, copy(inner[i]))
        elif what == "exchanged":
            inner[i], inner[j] = inner[j], inner[i]
        elif what == "copied":
            inner[i] = copy(inner[j])
        elif generator.random() < 0.2:
            inner.clear()
        return f"{where}: {i}, {j} {what}"
    other = generator.choice(bases)
    keys = [key for key in root if key in other and key not in ("exsect", "command")]
    key = generator.choice(keys)
    if isinstance(root[key], list) and root[key] and other[key] and generator.random() < 0.8:
        root[key][generator.randrange(len(root[key]))] = copy(generator.choice(other[key]))
    else:
        root[key] = copy(other[key])
    return f"{key} of another certificate"


def random_forgery(bases, weights, seed):
    generator = random.Random(seed)
    which = generator.choices(range(len(bases)), weights)[0]
    while True:
        root = copy(bases[which])
        what = [changed_once(root, bases, generator) for _ in range(generator.choice([1, 1, 1, 2, 3]))]
        if root != bases[which]:
            break
    try:
        recount = isinstance(root.get("summary"), dict) and generator.random() < 0.8
        text = sealed(recounted(root) if recount else root)
    except (AttributeError, TypeError):
        text = sealed(root)
    return which, "; ".join(what), text


# ---- The truth


def away(p, line):
    """The distance of a point from a polyline, in floating point."""
    best = math.inf
    for a, b in zip(line, line[1:]):
        e = [q - c for c, q in zip(a, b)]
        square = sum(c * c for c in e)
        t = min(1.0, max(0.0, sum((x - c) * d for x, c, d in zip(p, a, e)) / square)) if square > 0 else 0.0
        best = min(best, math.dist(p, [c + t * d for c, d in zip(a, e)]))
    return best


def double(text):
    """The number near enough to compare polylines; infinite beyond the doubles."""
    q = checker.number(text, "")
    try:
        return float(q)
    except OverflowError:
        return math.inf if q > 0 else -math.inf


def boxes_fit(claims, nodes, parameters="uvrs"):
    """Each claimed box holds one of the nodes' boxes, in part at least, of the same kind, and each node is in one."""
    def meets(claim, node):
        radius = checker.number(claim["radius"], "")
        return all(Fraction(node["box"][p][0]) <= checker.number(q, "") + radius and Fraction(node["box"][p][1]) >= checker.number(q, "") - radius
                   for p, q in zip(parameters, claim["at"]) if p in node["box"])  # of a line without the fixed one
    def same(claim, node):
        return sorted(claim.get("on", [])) == sorted(node.get("on", [])) and sorted(claim.get("wrt", [])) == sorted(node.get("wrt", []))
    return all(sum(meets(claim, node) and same(claim, node) for node in nodes) == 1 for claim in claims)


def falsehood(root, base, result):
    """What an accepted certificate says that is not true; None if all is."""
    if root["command"] == "line":
        points = result["points"]
        return None if len(points) == len(root["points"]) and boxes_fit(root["points"], points) else "other points"
    summary, graph = root["summary"], result
    shapes = [component["shape"] for component in graph["components"]]
    nodes = graph["nodes"]
    counts = {"closed": shapes.count("closed"), "open": shapes.count("open"), "branched": shapes.count("branched"), "components": len(shapes)}
    counts["boundary"] = sum(bool(node["on"]) and not (node["id"] in graph["isolated_points"]) for node in nodes)
    counts["turning"] = [sum(p in node["wrt"] for node in nodes) for p in "uvrs"]
    for key, n in counts.items():
        if summary[key] != n and summary[key] != base["summary"][key]:
            return f"{key}: {summary[key]} for {n}"
    if root["command"] == "self":
        return None
    if "overlaps" in graph and len(graph["overlaps"]) != len(root["overlaps"]):
        return "overlaps"
    ends = [node for node in nodes if node["on"] or node["wrt"]]
    if root["nodes"] != base["nodes"] and not boxes_fit(root["nodes"], ends):
        return "a node's box"
    lines = [[v["point"] if isinstance(v, dict) else v[-3:] for v in arc["polyline"]] for arc in graph["arcs"]]
    size = max((abs(c) for line in lines for p in line for c in p), default=1.0)
    for arc in root["arcs"]:
        bound = double(arc["error_bound"]) + 3e-4 * size
        claimed = [[double(q) for q in p[4:]] for p in arc["points"] if len(p) == 7]
        if any(min((away(p, line) for line in lines), default=math.inf) > bound for p in claimed):
            return "an arc's polyline"
    return None


class Campaign:
    def __init__(self, program, names, bases):
        self.program, self.names, self.bases = program, names, bases
        self.count, self.failures, self.truth = collections.Counter(), [], {}

    def judge(self, which, what, text, false=False):
        """With `false` it has to be rejected."""
        self.count["forgeries"] += 1
        if self.count["forgeries"] % 500 == 0:
            print(dict(self.count), len(self.failures), "failures", file=sys.stderr, flush=True)
        cpp = self.program.accepts(text)
        try:
            said, why = checker.verdict(text)
            python = said is not None
            if why:
                self.count["rejected, " + self.kind_of(why[0])] += 1
        except ValueError:
            python = None
        except Exception as error:  # noqa: BLE001: any other end is what is looked for
            python = repr(error)
        if bool(cpp) != bool(python) or isinstance(cpp, str) or isinstance(python, str):
            return self.fail(which, what, text, f"C++ {cpp}, Python {python}")
        if not cpp:
            self.count["unreadable"] += cpp is None
            return None
        if false:
            return self.fail(which, what, text, "FALSE: accepted")
        root, base = json.loads(text), self.bases[which]
        same = all(root.get(key, {}).get("points") == base.get(key, {}).get("points") for key in ("first", "second")) and root.get("fixed") == base.get("fixed")
        self.count["accepted, of the same patches" if same else "accepted, of other patches"] += 1
        key = json.dumps([root["command"], root.get("fixed"), root["first"]["points"], root.get("second", {}).get("points")])
        if key not in self.truth:
            self.truth[key] = self.program.result(root)
        if self.truth[key] is None:
            self.count["accepted, the program is incomplete"] += 1
            return None
        false = falsehood(root, base if same else {"summary": collections.defaultdict(lambda: None), "nodes": None}, self.truth[key])
        return self.fail(which, what, text, "FALSE: " + false) if false else None

    @staticmethod
    def kind_of(place):
        return place.split(".")[1].split("[")[0] if "." in place else "$"

    def fail(self, which, what, text, why):
        self.failures.append(why)
        path = pathlib.Path(tempfile.gettempdir()) / f"forged-{len(self.failures)}.json"
        path.write_text(text, encoding="utf-8")
        print(f"{self.names[which]}: {what}: {why} ({path})", flush=True)

    def report(self):
        for key in sorted(self.count):
            print(f"{self.count[key]:7} {key}")
        print(f"{len(self.failures)} failures")
        return 1 if self.failures else 0


def main():
    sys.set_int_max_str_digits(0)
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--program", required=True)
    arguments.add_argument("--bases", type=int, default=100)
    commands = arguments.add_subparsers(dest="command", required=True)
    by_hand = commands.add_parser("hand-made")
    by_hand.add_argument("every", type=int, nargs="?", default=1)
    commands.add_parser("false").add_argument("every", type=int, nargs="?", default=1)
    by_seed = commands.add_parser("random")
    by_seed.add_argument("first", type=int)
    by_seed.add_argument("count", type=int)
    options = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        program = Program(options.program, folder)
        chosen = list(models())[: options.bases]
        texts = [program.certificate(command, model) for _, command, model in chosen]
        campaign = Campaign(program, [name for name, _, _ in chosen], [json.loads(text) for text in texts])
        for which, text in enumerate(texts):
            if checker.verdict(text)[0] is None or not program.accepts(sealed(campaign.bases[which])):
                campaign.fail(which, "no change", text, "rejected")
        if options.command == "hand-made":
            done = 0
            for which, base in enumerate(campaign.bases):
                for what, forged in hand_made(base):
                    if done % options.every == 0:
                        campaign.judge(which, what, forged.text())
                    done += 1
        elif options.command == "false":
            for which, base in enumerate(campaign.bases):
                for what, forged in list(false_claims(base))[:: options.every]:
                    campaign.judge(which, what, forged.text(), false=True)
        else:
            weights = [1 / (3000 + len(text)) for text in texts]
            for seed in range(options.first, options.first + options.count):
                which, what, text = random_forgery(campaign.bases, weights, seed)
                campaign.judge(which, f"seed {seed}: {what}", text)
        return campaign.report()


if __name__ == "__main__":
    sys.exit(main())
