#!/usr/bin/env python3
"""Check a certificate of exsect (docs/certificate.md): python3 check_certificate.py FILE

A second checker, written from the document alone, in exact fractions. It prints "accepted" with what is proved, or
"rejected" with place and reason; exit status 0, 1, or 2 for what is no certificate.
"""

import json
import math
import re
import sys
from fractions import Fraction

LETTERS = "uvrs"
NUMBER = re.compile(r"-?(0|[1-9][0-9]*)(/[1-9][0-9]*)?")


class Rejected(Exception):
    """place, reason"""


def require(holds, place, reason):
    if not holds:
        raise Rejected(place, reason)


# ---- The form


def seal(text):
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


def compact(value):
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False)


def claim(value, place, keys):
    require(isinstance(value, dict) and "seal" in value, place, "not a claim with a seal")
    rest = {key: value[key] for key in value if key != "seal"}
    require(list(rest) == keys, place, "not the documented keys")
    require(value["seal"] == seal(place + compact(rest)), place, "the seal does not fit the claim")
    return rest


def number(text, place):
    require(isinstance(text, str) and NUMBER.fullmatch(text), place, "not a number")
    value = Fraction(text)
    require(str(value) == text, place, "not in lowest terms")
    return value


def numbers(value, size, place):
    require(isinstance(value, list) and len(value) == size, place, f"not {size} numbers")
    return [number(text, place) for text in value]


def count(value, place):
    require(type(value) is int and value >= 0, place, "not an integer >= 0")
    return value


def parameter(text, place):
    require(text in list(LETTERS), place, "not a parameter")
    return LETTERS.index(text)


def element(values, i, place):
    require(count(i, place) < len(values), place, "names nothing")
    return values[i]


def no_key_twice(pairs):
    if len({key for key, _ in pairs}) != len(pairs):
        raise ValueError("a key is given twice")
    return dict(pairs)


# ---- Balls (middle, radius) and the derivatives of F


def magnitude(ball):
    return abs(ball[0]) + ball[1]


def sign(ball):
    return 1 if ball[0] > ball[1] else -1 if ball[0] < -ball[1] else 0


def add(a, b):
    return a[0] + b[0], a[1] + b[1]


def times(a, b):
    return a[0] * b[0], abs(a[0]) * b[1] + a[1] * magnitude(b)


def shifted(c, u, v):
    """Coefficients of c(u + ., v + .), c[i][j][d]."""
    rows = []
    for j in range(3):
        rows.append([[c[0][j][d] + u * (c[1][j][d] + u * c[2][j][d]) for d in range(3)],
                     [c[1][j][d] + 2 * u * c[2][j][d] for d in range(3)], c[2][j]])
    return [[[rows[0][i][d] + v * (rows[1][i][d] + v * rows[2][i][d]) for d in range(3)],
             [rows[1][i][d] + 2 * v * rows[2][i][d] for d in range(3)], rows[2][i]] for i in range(3)]


def derivative(c, d, a, b, hu, hv):
    middle = radius = Fraction(0)
    for i in range(a, 3):
        for j in range(b, 3):
            value = math.perm(i, a) * math.perm(j, b) * c[i][j][d]
            if (i, j) == (a, b):
                middle = value
            elif value:
                radius += abs(value) * hu ** (i - a) * hv ** (j - b)
    return middle, radius


class Pair:
    """x and -y at a point, perhaps times a matrix."""

    def __init__(self, x, y):
        self.x, self.y = x, y

    def at(self, w):
        return Pair(shifted(self.x, w[0], w[1]), shifted(self.y, w[2], w[3]))

    def times(self, matrix):
        def product(net):
            return [[[sum(m * q for m, q in zip(row, p)) for row in matrix] for p in line] for line in net]
        return Pair(product(self.x), product(self.y))

    def value(self, d):
        return self.x[0][0][d] + self.y[0][0][d]

    def first(self, d, j, h):
        if j < 2:
            return derivative(self.x, d, 1 - j, j, h[0], h[1])
        return derivative(self.y, d, 3 - j, j - 2, h[2], h[3])

    def second(self, d, t, h):
        result = (0, 0)
        for net, (p, q), (hp, hq) in ((self.x, t[:2], h[:2]), (self.y, t[2:], h[2:])):
            result = add(result, times(times(derivative(net, d, 2, 0, hp, hq), p), p))
            result = add(result, times(times(times((2, 0), derivative(net, d, 1, 1, hp, hq)), p), q))
            result = add(result, times(times(derivative(net, d, 0, 2, hp, hq), q), q))
        return result


def tangent(local, h):
    """T_i / T_k is the derivative of w_i with respect to w_k."""
    result = []
    for k in range(4):
        e = [[local.first(d, j, h) for j in range(4) if j != k] for d in range(3)]
        total = (0, 0)
        for a, b, c, s in ((0, 1, 2, 1), (1, 2, 0, 1), (2, 0, 1, 1), (0, 2, 1, -1), (1, 0, 2, -1), (2, 1, 0, -1)):
            total = add(total, times((s * (-1) ** k, 0), times(e[0][a], times(e[1][b], e[2][c]))))
        result.append(total)
    return result


def near_inverse(local, k):
    """A matrix near the inverse of the columns of DF other than k: any will do if the defect comes out below 1."""
    zero = [Fraction(0)] * 4
    m = [[local.first(d, j, zero)[0] for j in others(k)] for d in range(3)]
    cofactors = [[m[(j + 1) % 3][(i + 1) % 3] * m[(j + 2) % 3][(i + 2) % 3] - m[(j + 1) % 3][(i + 2) % 3] * m[(j + 2) % 3][(i + 1) % 3]
                  for j in range(3)] for i in range(3)]
    det = sum(cofactors[0][j] * m[j][0] for j in range(3))
    return [[Fraction(float(c / det)) if det else Fraction(0) for c in row] for row in cofactors]


def others(k):
    return [i for i in range(4) if i != k]


def defect_rows(local, k, h):
    rows = []
    for d in range(3):
        total = Fraction(0)
        for j, parameter_j in enumerate(others(k)):
            middle, radius = local.first(d, parameter_j, h)
            total += abs(middle - (d == j)) + radius
        rows.append(total)
    return rows


class Bounds:
    """Derivatives of the curve with respect to w_k over a box."""

    def __init__(self, local, k, h):
        rows = defect_rows(local, k, h)
        self.defect = max(rows)
        if self.defect >= 1:
            return

        def solved(g, axis):
            most = max(map(magnitude, g)) / (1 - self.defect)
            result = [(b[0], b[1] + row * most) for b, row in zip(g, rows)]
            return result[:k] + [axis] + result[k:]

        def minus(ball):
            return -ball[0], ball[1]

        self.first = solved([minus(local.first(d, k, h)) for d in range(3)], (Fraction(1), Fraction(0)))
        self.second = solved([minus(local.second(d, self.first, h)) for d in range(3)], (Fraction(0), Fraction(0)))


# ---- Tubes


class Tube:
    def __init__(self, value, place):
        value = claim(value, place, ["centre", "axis", "slope", "reach", "width", "inverse"])
        self.centre = numbers(value["centre"], 4, place)
        self.axis = parameter(value["axis"], place)
        self.slope = numbers(value["slope"], 4, place)
        self.reach, self.width = number(value["reach"], place), number(value["width"], place)
        require(isinstance(value["inverse"], list) and len(value["inverse"]) == 3, place, "not a matrix")
        self.inverse = [numbers(row, 3, place) for row in value["inverse"]]

    def contains(self, w, h):
        k = self.axis
        t = w[k] - self.centre[k]
        return abs(t) + h[k] <= self.reach and all(
            abs(w[i] - self.centre[i] - self.slope[i] * t) + h[i] + abs(self.slope[i]) * h[k] <= self.width
            for i in others(k))

    def check(self, pair, place):
        k, t, z = self.axis, self.reach, self.width
        require(self.slope[k] == 1 and t > 0 and z > 0, place, "not a tube")
        h = [abs(d) * t + (0 if i == k else z) for i, d in enumerate(self.slope)]
        local = pair.at(self.centre).times(self.inverse)
        rows = defect_rows(local, k, h)
        for d in range(3):
            f = abs(local.value(d))
            for power in range(1, 5):
                f += t**power * abs(sum(
                    net[i][power - i][d] * p**i * q ** (power - i)
                    for net, (p, q) in ((local.x, self.slope[:2]), (local.y, self.slope[2:]))
                    for i in range(3) if 0 <= power - i <= 2))
            require(f + rows[d] * z < z, place, "no contraction")
        self.bounds = Bounds(local, k, h)
        for i in range(4):
            inside = self.centre[i] >= h[i] and self.centre[i] + h[i] <= 1
            require(sign(self.bounds.first[i]) or (sign(self.bounds.second[i]) and inside), place,
                    "a parameter may turn more than once, or outside the domain")

    def distance(self, pair, w, place):
        require(self.contains(w, [0] * 4), place, "a point is not in its tube")
        f = [pair.at(w).value(d) for d in range(3)]
        return max(abs(sum(m * q for m, q in zip(row, f))) for row in self.inverse) / (1 - self.bounds.defect)


# ---- Relations and nodes


def one_parameter(net, direction, p):
    f = []
    for i in range(3):
        for j in range(3):
            value = sum(n * q for n, q in zip(direction, net[i][j] if p % 2 == 0 else net[j][i]))
            if j == 0:
                f.append(value)
            elif value:
                return None
    return f


class Node:
    def __init__(self, value, place):
        value = claim(value, place, ["tube", "at", "radius", "on", "wrt"])
        self.tube, self.at, self.radius = value["tube"], numbers(value["at"], 4, place), number(value["radius"], place)
        require(isinstance(value["on"], list) and isinstance(value["wrt"], list), place, "not lists")
        for side in value["on"]:
            require(side in [f"{p}={c}" for p in LETTERS for c in (0, 1)], place, "not a side")
        self.on = {LETTERS.index(side[0]): int(side[2]) for side in value["on"]}
        require(len(self.on) == len(value["on"]), place, "on two sides of one parameter")
        self.wrt = [parameter(p, place) for p in value["wrt"]]


class Checker:
    def __init__(self, root):
        require(root.get("command") in ("intersect", "line"), "$.command", "neither intersect nor line")
        lists = ["relations", "tubes", "nodes", "arcs", "components", "cover"]
        keys = ["exsect", "command", "first", "second", *lists, "summary"]
        self.fixed = None
        if root["command"] == "line":
            lists = ["tubes", "points", "cover"]
            keys = ["exsect", "command", "fixed", "first", "second", *lists, "summary"]
        require(list(root) == keys, "$", "not the documented keys")
        for key in lists:
            require(isinstance(root[key], list), "$." + key, "not a list")
        if "fixed" in root:
            value = claim(root["fixed"], "$.fixed", ["parameter", "value"])
            self.fixed = parameter(value["parameter"], "$.fixed"), number(value["value"], "$.fixed")
            require(0 <= self.fixed[1] <= 1, "$.fixed", "not in [0,1]")
        self.root = root
        self.nets = [self.net(root[key], "$." + key) for key in ("first", "second")]
        x, y = (self.power_basis(net) for net in self.nets)
        self.pair = Pair(x, [[[-q for q in p] for p in row] for row in y])

    @staticmethod
    def net(value, place):
        points = claim(value, place, ["name", "points"])["points"]
        require(isinstance(points, list) and [len(row) for row in points] == [3, 3, 3], place, "not 3 x 3 points")
        return [[numbers(p, 3, place) for p in row] for row in points]

    @staticmethod
    def power_basis(net):
        def power(a, b, c):
            return a, [2 * (q - p) for p, q in zip(a, b)], [p - 2 * q + r for p, q, r in zip(a, b, c)]
        columns = [power(*(net[i][j] for i in range(3))) for j in range(3)]
        rows = [power(*(columns[j][i] for j in range(3))) for i in range(3)]
        return [[rows[i][j] for j in range(3)] for i in range(3)]

    def check(self):
        self.tubes = []
        for i, value in enumerate(self.root["tubes"]):
            self.tubes.append(Tube(value, f"$.tubes[{i}]"))
            self.tubes[i].check(self.pair, f"$.tubes[{i}]")
        if self.fixed:
            self.check_points()
        else:
            self.check_curves()
        self.check_cover()
        return self.root["summary"]

    def check_curves(self):
        self.relations = [self.relation(value, f"$.relations[{i}]") for i, value in enumerate(self.root["relations"])]
        self.nodes = []
        for i, value in enumerate(self.root["nodes"]):
            self.check_node(Node(value, f"$.nodes[{i}]"), f"$.nodes[{i}]")
        self.ends = [[] for _ in self.nodes]
        self.arcs = [self.check_arc(value, f"$.arcs[{i}]") for i, value in enumerate(self.root["arcs"])]
        used = {piece[0] for arc in self.arcs for piece in arc["pieces"]}
        for i in range(len(self.tubes)):
            require(i in used, f"$.tubes[{i}]", "no arc runs through it")
        self.check_graph()

    def check_points(self):
        k, fixed = self.fixed
        points = []
        for i, value in enumerate(self.root["points"]):
            place = f"$.points[{i}]"
            value = claim(value, place, ["tube", "at", "radius"])
            tube, at, radius = element(self.tubes, value["tube"], place), numbers(value["at"], 4, place), number(value["radius"], place)
            require(at[k] == fixed and tube.axis == k, place, "not on the line, or its tube has another axis")
            require(radius > 0 and tube.distance(self.pair, at, place) <= radius, place, "its box may miss the solution")
            margin = radius if any(self.pair.at(at).value(d) for d in range(3)) else 0
            require(all(margin <= at[j] <= 1 - margin for j in others(k)), place, "its box leaves [0,1]")
            for other, size in points:
                require(any(abs(at[j] - other[j]) > radius + size for j in others(k)), place, "its box meets that of an earlier point")
            points.append((at, radius))
        used = {value["tube"] for value in self.root["points"]}
        for i in range(len(self.tubes)):
            require(i in used, f"$.tubes[{i}]", "no point is in it")
        said = claim(self.root["summary"], "$.summary", ["claims"])
        require(said["claims"] == [0, len(self.tubes), len(points), 0, len(self.root["cover"])], "$.summary", "does not agree with the claims")

    def relation(self, value, place):
        value = claim(value, place, ["direction", "first", "second"])
        i, j = parameter(value["first"], place), parameter(value["second"], place)
        require(i < 2 <= j, place, "not between a parameter of either patch")
        direction = numbers(value["direction"], 3, place)
        f, g = one_parameter(self.pair.x, direction, i), one_parameter(self.pair.y, direction, j)
        require(f and g, place, "a third parameter occurs")
        for p in (f, g):
            require(p[1] * (p[1] + 2 * p[2]) > 0, place, "not monotone")
        return i, j, f, g

    def related(self, i, j, sides=None):
        if i > j:
            i, j, sides = j, i, sides and sides[::-1]
        for p, q, f, g in self.relations:
            if (p, q) == (i, j) and (sides is None or f[0] + sides[0] * (f[1] + f[2]) + g[0] + sides[1] * (g[1] + g[2]) == 0):
                return True
        return False

    def check_node(self, node, place):
        tube = element(self.tubes, node.tube, place)
        require(bool(node.on) != bool(node.wrt), place, "neither on a side only nor a turning point only")
        require(node.radius > 0 and tube.contains(node.at, [node.radius] * 4), place, "its box is not in its tube")
        for j in range(4):
            require(j in node.on or node.radius < node.at[j] < 1 - node.radius, place, "its box leaves (0,1)")
        near = tube.distance(self.pair, node.at, place)
        if node.on:
            require(near <= node.radius, place, "its box may miss the curve")
            require(all(node.at[j] == value for j, value in node.on.items()), place, "not on its sides")
            known, waiting = [], dict(node.on)
            while waiting:
                j = next((j for j in waiting if j == tube.axis or any(
                    self.related(k, j, (node.on[k], node.on[j])) for k in known)), None)
                if j is None and known and not any(self.pair.at(node.at).value(d) for d in range(3)):
                    break
                require(j is not None, place, "a side does not follow from that of the tube's axis")
                known.append(j)
                del waiting[j]
        else:
            i, second = node.wrt[0], tube.bounds.second[node.wrt[0]]
            require(i != tube.axis and sign(second), place, "the second derivative may vanish")
            for j in range(1, len(node.wrt)):
                require(node.wrt[j - 1] < node.wrt[j], place, "parameters not in order")
                require(any(self.related(k, node.wrt[j]) for k in node.wrt[:j]), place, "no relation")
            t = tangent(self.pair.at(node.at), [near] * 4)
            require(sign(t[tube.axis]), place, "no derivative here")
            along = abs(t[tube.axis][0]) - t[tube.axis][1]
            away = magnitude(t[i]) / along / (abs(second[0]) - second[1])
            require(abs(node.at[tube.axis] - tube.centre[tube.axis]) + away <= tube.reach, place, "may be outside its tube")
            require(all(near + away * magnitude(b) <= node.radius for b in tube.bounds.first), place, "its box may miss the point")
        for other in self.nodes:
            require(any(abs(a - b) > node.radius + other.radius for a, b in zip(node.at, other.at)), place, "meets an earlier node")
        self.nodes.append(node)

    # ---- Arcs

    def check_arc(self, value, place):
        arc = claim(value, place, ["component", "from", "to", "points", "pieces", "error_bound"])
        start, end = element(self.nodes, arc["from"], place), element(self.nodes, arc["to"], place)
        require(isinstance(arc["points"], list) and len(arc["points"]) >= 2, place, "without points")
        require(isinstance(arc["pieces"], list) and arc["pieces"], place, "without pieces")
        points = [numbers(p, 7 if isinstance(p, list) and len(p) == 7 else 4, place) for p in arc["points"]]
        vertices = [p[4:] for p in points]
        points = [p[:4] for p in points]
        require(points[0] == start.at and points[-1] == end.at, place, "does not begin and end at its nodes")
        radii = [start.radius] + [Fraction(0)] * (len(points) - 2) + [end.radius]
        first, entered, grows, directions = 0, start.radius, None, []
        for piece in arc["pieces"]:
            require(isinstance(piece, list) and len(piece) == 2, place, "not a piece")
            last = count(piece[1], place)
            tube = element(self.tubes, piece[0], place)
            require(first < last < len(points), place, "a piece is empty")
            require(tube.contains(points[first], [entered] * 4), place, "not in two tubes where they join")
            near = [tube.distance(self.pair, points[j], place) for j in range(first, last + 1)]
            for j in range(first, last + 1):
                radii[j] = max(radii[j], near[j - first])
            final = last + 1 == len(points)
            leaves = radii[-1] if final else near[-1]
            k = tube.axis
            direction = 1 if points[first + 1][k] > points[first][k] else -1
            for j in range(first, last):
                least = (entered if j == first else 0) + (leaves if j + 1 == last else 0)
                require(direction * (points[j + 1][k] - points[j][k]) > least, place, "a piece runs back")
            ends = [(points[first], entered, start if first == 0 else None), (points[last], leaves, end if final else None)]
            signs = [direction * self.slope_sign(tube, i, ends) for i in range(4)]
            grows = grows or signs
            require(0 not in signs and signs == grows, place, "not monotone in a parameter")
            directions.append(direction)
            first, entered = last, leaves
        require(first + 1 == len(points), place, "its pieces do not cover it")
        require(arc["pieces"][0][0] == start.tube and arc["pieces"][-1][0] == end.tube, place, "does not begin and end in its nodes' tubes")
        self.ends[arc["from"]].append(directions[0])
        self.ends[arc["to"]].append(-directions[-1])
        bound = number(arc["error_bound"], place)
        require(self.error_bound(arc["pieces"], points, vertices, radii, place) <= bound, place, "the error bound is too small")
        return arc

    def slope_sign(self, tube, i, ends):
        if sign(tube.bounds.first[i]):
            return sign(tube.bounds.first[i])
        signs = []
        for at, near, node in ends:
            if node and i in node.wrt:
                continue
            t = tangent(self.pair.at(at), [near] * 4)
            signs.append(sign(t[i]) * sign(t[tube.axis]))
        return signs[0] if signs and signs[0] == signs[-1] else 0

    def error_bound(self, pieces, points, vertices, radii, place):
        require(vertices[0] and vertices[-1], place, "an end of the polyline is missing")
        x = self.pair.x
        at = [shifted(x, p[0], p[1])[0][0] for p in points]
        places = []
        a = 0
        for b in range(1, len(points)):
            if not vertices[b]:
                continue
            edge = [q - p for p, q in zip(vertices[a], vertices[b])]
            before = Fraction(0)
            places.append(vertices[a])
            for j in range(a + 1, b):
                require(any(edge), place, "an edge of the polyline has no length")
                t = sum(e * (q - p) for e, q, p in zip(edge, at[j], vertices[a])) / sum(e * e for e in edge)
                before = t = min(max(before, t), 1)
                places.append([p + t * e for p, e in zip(vertices[a], edge)])
            a = b
        places.append(vertices[-1])
        most, first = Fraction(0), 0
        for name, last in pieces:
            tube = self.tubes[name]
            for begin in range(first, last, 4):
                stop = min(begin + 4, last)
                margin = max(radii[begin : stop + 1])
                unit = Fraction(1, 2**24)
                middle = [unit * math.floor((p + q) / 2 / unit) for p, q in zip(points[begin], points[stop])]
                half = [unit * (math.floor((abs(p - q) / 2 + 2 * margin) / unit) + 2) for p, q in zip(points[begin], points[stop])]
                here = self.pair.at(middle)
                bounds = Bounds(here.times(near_inverse(here, tube.axis)), tube.axis, half)
                require(bounds.defect < 1, place, "no derivative over a step of the polyline")
                alone = Pair(here.x, [[[0] * 3] * 3] * 3)
                second, slope = [], []
                for d in range(3):
                    xu, xv = alone.first(d, 0, half), alone.first(d, 1, half)
                    bend = add(alone.second(d, bounds.first, half), add(times(xu, bounds.second[0]), times(xv, bounds.second[1])))
                    second.append(magnitude(bend))
                    slope.append(magnitude(xu) + magnitude(xv))
                bend, speed = root_above(second) / 8, root_above(slope)
                ends = [root_above([p - q for p, q in zip(at[j], places[j])]) + speed * radii[j] for j in range(begin, stop + 1)]
                for j in range(begin, stop):
                    step = points[j + 1][tube.axis] - points[j][tube.axis]
                    most = max(most, max(ends[j - begin], ends[j - begin + 1]) + step * step * bend)
            first = last
        return most

    # ---- The graph and the cover

    def check_graph(self):
        for i, node in enumerate(self.nodes):
            require(len(self.ends[i]) == 1 if node.on else sorted(self.ends[i]) == [-1, 1], f"$.nodes[{i}]", "not the end of its arcs")
        shapes, seen = [], []
        for c, value in enumerate(self.root["components"]):
            place = f"$.components[{c}]"
            value = claim(value, place, ["closed", "arcs"])
            nodes = set()
            require(isinstance(value["arcs"], list) and value["arcs"], place, "without arcs")
            for a in value["arcs"]:
                arc = element(self.arcs, a, place)
                require(arc["component"] == c and a not in seen, place, "an arc of another component")
                require(not nodes or nodes & {arc["from"], arc["to"]}, place, "not connected")
                nodes |= {arc["from"], arc["to"]}
                seen.append(a)
            require(all(arc["component"] == c or not nodes & {arc["from"], arc["to"]} for arc in self.arcs), place, "connected with another")
            require(value["closed"] is not any(self.nodes[n].on for n in nodes), place, "open and closed confused")
            shapes.append(value["closed"])
        require(len(seen) == len(self.arcs), "$.components", "an arc is missing")
        said = claim(self.root["summary"], "$.summary", ["claims", "components", "closed", "open", "boundary", "turning"])
        counted = {"claims": [len(self.root[key]) for key in ("relations", "tubes", "nodes", "arcs", "cover")],
                   "components": len(shapes), "closed": shapes.count(True), "open": shapes.count(False),
                   "boundary": sum(bool(node.on) for node in self.nodes),
                   "turning": [sum(p in node.wrt for node in self.nodes) for p in range(4)]}
        require(said == counted, "$.summary", "does not agree with the claims and their graph")

    def check_cover(self):
        cover = self.root["cover"]
        scale = math.lcm(*(q.denominator for net in self.nets for row in net for p in row for q in p))
        middle, half = [Fraction(1, 2)] * 4, [Fraction(1, 2)] * 4
        whole = list(self.nets)
        if self.fixed:
            k, value = self.fixed
            scale *= value.denominator**2
            whole[k // 2] = restricted(whole[k // 2], k % 2, value)
            middle[k], half[k] = value, Fraction(0)
        nets = [[[[int(q * scale) for q in p] for p in row] for row in net] for net in whole]
        waiting = [(nets, (0, 0), middle, half)]  # the deepest last
        for i, entry in enumerate(cover):
            place = f"$.cover[{i}]"
            require(isinstance(entry, str) and " #" in entry, place, "no seal")
            text, mark = entry.split(" #", 1)
            require(mark == seal(place + text), place, "the seal does not fit the claim")
            require(waiting, place, "beyond the end of the subdivision")
            nets, levels, middle, width = waiting.pop()
            if len(text) == 1 and text in LETTERS:
                p = LETTERS.index(text)
                for upper in (True, False):
                    parts, deeper = list(nets), list(levels)
                    parts[p // 2] = halved(nets[p // 2], p % 2, upper)
                    deeper[p // 2] += 1
                    h = [w / 2 if j == p else w for j, w in enumerate(width)]
                    m = [q + (h[p] if upper else -h[p]) if j == p else q for j, q in enumerate(middle)]
                    waiting.append((parts, deeper, m, h))
            elif re.fullmatch("t(0|[1-9][0-9]*)", text):
                require(element(self.tubes, int(text[1:]), place).contains(middle, width), place, "the cell is not in the tube")
            else:
                require(re.fullmatch("-?[0-9]+ -?[0-9]+ -?[0-9]+", text), place, "not a cell")
                direction = [int(part) for part in text.split()]
                require(" ".join(map(str, direction)) == text, place, "not a direction")
                values = [[sum(n * q for n, q in zip(direction, p)) for row in net for p in row] for net in nets]
                require(min(values[0]) << 2 * levels[1] > max(values[1]) << 2 * levels[0], place, "the direction does not separate the patches")
        require(not waiting, f"$.cover[{len(cover)}]", "the subdivision is not complete")


def root_above(vector):
    """At least the Euclidean norm."""
    q = sum(a * a for a in vector)
    if q == 0:
        return Fraction(0)
    shift = max(0, 64 - (q.numerator.bit_length() - q.denominator.bit_length()) // 2)
    return Fraction(math.isqrt((q.numerator << 2 * shift) // q.denominator + 1) + 1, 2**shift)


def restricted(net, second, t):
    """Control points of the line where the first or second parameter is t, thrice."""
    def point(a, b, c):
        return [(1 - t) ** 2 * p + 2 * t * (1 - t) * q + t * t * r for p, q, r in zip(a, b, c)]
    if second:
        return [[point(*row)] * 3 for row in net]
    return [[point(*(net[i][j] for i in range(3))) for j in range(3)]] * 3


def halved(net, second, upper):
    """Four times the control points of one half in the first or second parameter."""
    def half(a, b, c):
        if upper:
            a, c = c, a
        parts = [[4 * p for p in a], [2 * (p + q) for p, q in zip(a, b)], [p + 2 * q + r for p, q, r in zip(a, b, c)]]
        return parts[::-1] if upper else parts
    if second:
        return [half(*row) for row in net]
    columns = [half(*(net[i][j] for i in range(3))) for j in range(3)]
    return [[columns[j][i] for j in range(3)] for i in range(3)]


def main():
    sys.set_int_max_str_digits(0)
    try:
        with open(sys.argv[1], encoding="utf-8") as file:
            root = json.load(file, object_pairs_hook=no_key_twice)
        if not isinstance(root, dict) or root.get("exsect") != "certificate/1":
            raise ValueError("not of the form certificate/1")
    except (OSError, ValueError, IndexError) as error:
        print(f"{sys.argv[1:]}: {error}", file=sys.stderr)
        return 2
    try:
        said = Checker(root).check()
    except Rejected as rejected:
        print("rejected: {}: {}".format(*rejected.args))
        return 1
    print("accepted:", f"{said['closed']} closed, {said['open']} open" if "closed" in said else f"{said['claims'][2]} points")
    return 0


if __name__ == "__main__":
    sys.exit(main())
