#!/usr/bin/env python3
"""Check a certificate of exsect (docs/certificate.md): python3 check_certificate.py FILE

A second checker, written from the document alone, in exact fractions. It prints "accepted" with what is proved, or
"rejected" with place and reason; exit status 0, 1, or 2 for what is no certificate.
"""

import itertools
import json
import math
import re
import sys
from fractions import Fraction

MAX_BYTES = 256 << 20
MAX_ENTRIES = 1 << 20
MAX_CHARACTERS = 6100  # of a number
MAX_DEPTH = 16  # of lists and objects in each other
MAX_DENOMINATOR_CELLS = 4096
LEAST_HALF_EDGE = Fraction(1, 2**51)
LETTERS = "uvrs"
DIRECTIONS = [p + sign for p in LETTERS for sign in "+-"]
DYADIC = re.compile(r"(-?[1-9][0-9]*)/2\^([1-9][0-9]*)")
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


class Raw(str):
    """A string as it stands between its quotation marks, nothing of it decoded."""


TOKEN = re.compile(r"""[ \t\r\n]*(?:"([^"\\]*(?:\\.[^"\\]*)*)"|(0|[1-9][0-9]*)|([][{}:,]))""", re.DOTALL)


def parsed(text):
    """Objects, lists, strings and integers >= 0: all that certificates consist of. ValueError for anything else."""
    tokens, at, text = [], 0, text.rstrip(" \t\r\n")
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match or len(match[2] or "") > 20:
            raise ValueError(f"neither a list, an object, a string nor an integer >= 0, at character {at}")
        tokens.append(Raw(match[1]) if match[1] is not None else int(match[2]) if match[2] is not None else (match[3],))
        at = match.end()
    tokens.append(None)
    tokens.reverse()

    def value(depth):
        token = tokens.pop()
        if token is None or depth > MAX_DEPTH:
            raise ValueError("nested too deeply" if token else "ends too early")
        if not isinstance(token, tuple):
            return token
        if token[0] not in "[{":
            raise ValueError(f"{token[0]} where a value must be")
        result, end = ([], ("]",)) if token[0] == "[" else ({}, ("}",))
        while tokens[-1] != end:
            if result:
                if tokens.pop() != (",",):
                    raise ValueError("no comma between two values")
            key = None
            if isinstance(result, dict):
                key = tokens.pop()
                if not isinstance(key, Raw) or key in result or tokens.pop() != (":",):
                    raise ValueError("no key, or a key twice")
            inner = value(depth + 1)
            result.append(inner) if key is None else result.__setitem__(key, inner)
        tokens.pop()
        return result

    result = value(0)
    if tokens.pop() is not None:
        raise ValueError("more than one value")
    return result


def is_json(text):
    try:
        json.loads(text)
    except ValueError:
        return False
    return True


def compact(value):
    """The text of a value without blanks outside of strings."""
    if isinstance(value, Raw):
        return f'"{value}"'
    if isinstance(value, list):
        return "[" + ",".join(map(compact, value)) + "]"
    if isinstance(value, dict):
        return "{" + ",".join(f'"{key}":{compact(inner)}' for key, inner in value.items()) + "}"
    return str(value)


def claim(value, place, keys):
    require(isinstance(value, dict) and list(value) == [*keys, "seal"], place, "not the documented keys")
    rest = {key: value[key] for key in keys}
    require(value["seal"] == seal(place + compact(rest)), place, "the seal does not fit the claim")
    return rest


def number(text, place):
    require(not isinstance(text, str) or len(text) <= MAX_CHARACTERS, place, "a number of more than 6100 characters")
    dyadic = DYADIC.fullmatch(text) if isinstance(text, str) else None
    if dyadic:
        p = int(dyadic[1])
        require(p % 2 == 1 and len(dyadic[2]) <= 4 and int(dyadic[2]) <= 2000, place, "not in lowest terms")
        n = int(dyadic[2])
        return Fraction(p, 2**n)
    require(isinstance(text, str) and NUMBER.fullmatch(text), place, "not a number")
    value = Fraction(text)
    require(str(value) == text, place, "not in lowest terms")
    return value


def numbers(value, size, place):
    require(isinstance(value, list) and len(value) == size, place, f"not {size} numbers")
    return [number(text, place) for text in value]


def count(value, place):
    require(type(value) is int and 0 <= value < 2**64, place, "not an integer from 0 to 2^64 - 1")
    return value


def parameter(text, place):
    require(isinstance(text, str) and text in list(LETTERS), place, "not a parameter")
    return LETTERS.index(text)


def element(values, i, place):
    require(count(i, place) < len(values), place, "names nothing")
    return values[i]


def near(q):
    """A double near the rational number, as a fraction; 0 if there is none."""
    try:
        return Fraction(float(q))
    except OverflowError:
        return Fraction(0)


# ---- Balls (middle, radius) and the derivatives of F


def magnitude(ball):
    return abs(ball[0]) + ball[1]


def sign(ball):
    return 1 if ball[0] > ball[1] else -1 if ball[0] < -ball[1] else 0


def add(a, b):
    return a[0] + b[0], a[1] + b[1]


def times(a, b):
    return a[0] * b[0], abs(a[0]) * b[1] + a[1] * magnitude(b)


def subtract(a, b):
    return a[0] - b[0], a[1] + b[1]


def divide(a, b, place):
    require(sign(b), place, "a divisor that may be 0")
    q = a[0] / b[0]
    return q, (a[1] + abs(q) * b[1]) / (abs(b[0]) - b[1])


# ---- Irrational numbers, of stars


class Root:
    """A real root of the modulus between two numbers at which it has opposite signs."""

    def __init__(self, modulus, between, place):
        require(isinstance(modulus, list) and 2 <= len(modulus) <= 65, place, "not a modulus")
        self.modulus = numbers(modulus, len(modulus), place)
        require(self.modulus[-1] == 1, place, "its modulus has no leading coefficient 1")
        lower, upper = numbers(between, 2, place)
        low, high = (sum(c * t**i for i, c in enumerate(self.modulus)) for t in (lower, upper))
        require(lower < upper and low * high < 0, place, "its modulus changes no sign between the two numbers")
        self.ball = (lower + upper) / 2, (upper - lower) / 2

    def number(self, value, place):
        """A rational number, or a polynomial in the root."""
        if not isinstance(value, list):
            return number(value, place)
        require(len(value) <= 64, place, "a number of a degree above 64")
        return Algebraic(numbers(value, len(value), place), self).simplest()

    def numbers(self, value, size, place):
        require(isinstance(value, list) and len(value) == size, place, f"not {size} numbers")
        return [self.number(q, place) for q in value]


class Algebraic:
    """A polynomial in a root, modulo the modulus. What is 0 is no Algebraic, but the Fraction."""

    def __init__(self, c, root):
        self.c, self.root = list(c), root
        n = len(root.modulus)
        while len(self.c) >= n:
            top = self.c[-1]
            self.c = [q - top * root.modulus[i - len(self.c) + n] if i >= len(self.c) - n else q for i, q in enumerate(self.c)][:-1]

    def simplest(self):
        return self if any(self.c[1:]) else self.c[0] if self.c else Fraction(0)

    def __add__(self, other):
        pairs = itertools.zip_longest(self.c, coefficients(other), fillvalue=Fraction(0))
        return Algebraic([p + q for p, q in pairs], self.root).simplest()

    def __mul__(self, other):
        d = coefficients(other)
        c = [Fraction(0)] * (len(self.c) + len(d) - 1)
        for i, p in enumerate(self.c):
            for j, q in enumerate(d):
                c[i + j] += p * q
        return Algebraic(c, self.root).simplest()

    def __sub__(self, other):
        return self + -1 * other

    def __rsub__(self, other):
        return -1 * self + other

    def __eq__(self, other):
        return not self - other

    def __pow__(self, n):
        return math.prod([self] * n)

    __radd__, __rmul__ = __add__, __mul__

    def ball(self):
        result = (Fraction(0), Fraction(0))
        for c in reversed(self.c):
            result = add(times(result, self.root.ball), (c, Fraction(0)))
        return result


def coefficients(q):
    return q.c if isinstance(q, Algebraic) else [Fraction(q)]


def ball_of(q):
    """Of a rational number, an Algebraic or a Near."""
    return q.ball() if isinstance(q, (Algebraic, Near)) else (q, Fraction(0))


class Near:
    """A coefficient of a map of which a ball is known: its sums, multiples, and an upper bound as absolute value."""

    def __init__(self, ball):
        # A short middle; the rest goes to the radius.
        unit = Fraction(1, 2**160)
        self.middle = unit * math.floor(ball[0] / unit)
        self.radius = unit * (math.floor(ball[1] / unit) + 2)

    def ball(self):
        return self.middle, self.radius

    def __add__(self, other):
        return Near(add(self.ball(), ball_of(other)))

    def __mul__(self, factor):
        return Near(times(self.ball(), (factor, Fraction(0))))

    def __sub__(self, other):
        return self + -1 * other

    def __abs__(self):
        return magnitude(self.ball())

    __radd__, __rmul__ = __add__, __mul__


class Map:
    """A polynomial map of four variables to space: {(i, j, k, l): coefficient}, with all lower monomials."""

    def __init__(self, terms=()):
        self.terms, self.box = {}, None
        for power, factor, c in terms:
            for lower in itertools.product(*(range(i + 1) for i in power)):
                self.terms.setdefault(lower, [Fraction(0)] * 3)
            self.terms[power] = [q + factor * a for q, a in zip(self.terms[power], c)]

    def mapped(self, change):
        result = Map()
        result.terms = {power: change(power, c) for power, c in self.terms.items()}
        return result

    def at(self, w):
        """Taylor coefficients at w: one variable after the other, by Horner's rule in each line of monomials."""
        result = self.mapped(lambda _, c: c)
        terms = result.terms
        for j, a in enumerate(w):
            lines = {}
            for power in terms if a else ():
                rest = power[:j], power[j + 1 :]
                lines[rest] = max(lines.get(rest, 0), power[j])
            for (before, after), n in lines.items():
                line = [(*before, i, *after) for i in range(n + 1)]
                for k in range(n):
                    for i in range(n - 1, k - 1, -1):
                        terms[line[i]] = [p + a * q if q else p for p, q in zip(terms[line[i]], terms[line[i + 1]])]
        return result

    def times(self, matrix):
        return self.mapped(lambda _, c: [sum(m * q for m, q in zip(row, c)) for row in matrix])

    def value(self, w=None):
        if w is None:
            return self.terms.get((0, 0, 0, 0), [0, 0, 0])
        factors = [(math.prod(a**i for a, i in zip(w, power)), c) for power, c in self.terms.items()]
        return [sum(f * c[d] for f, c in factors) for d in range(3)]

    def derivative(self, d, a, h):
        """The ball of this derivative of component d over |dw_i| <= h_i."""
        middle = radius = Fraction(0)
        for c, size in self.sizes(a, tuple(h)):
            if size is None:
                middle, rest = ball_of(math.prod(map(math.factorial, a)) * c[d])
                radius += rest
            elif c[d]:
                radius += abs(c[d]) * size
        return middle, radius

    def sizes(self, a, h):
        """For each term that counts in it, how much; None for the term of these exponents. Kept for the last box."""
        if self.box != h:
            self.box, self.kept, self.powers = h, {}, [[x**n for n in range(4)] for x in h]
        if a not in self.kept:
            found = self.kept[a] = []
            for power, c in self.terms.items():
                rest = [i - j for i, j in zip(power, a)]
                if min(rest) >= 0 and any(c):
                    size = math.prod(map(math.perm, power, a))
                    for x, n in enumerate(rest):
                        if n:
                            size *= self.powers[x][n] if n < 4 else h[x] ** n
                    found.append((c, size if any(rest) else None))
        return self.kept[a]

    def first(self, d, j, h):
        return self.derivative(d, tuple(int(i == j) for i in range(4)), h)

    def second(self, d, t, h):
        total = (Fraction(0), Fraction(0))
        for i in range(4):
            for j in range(i, 4):
                a = tuple(int(n == i) + int(n == j) for n in range(4))
                if a in self.terms:
                    entry = times(times(self.derivative(d, a, h), t[i]), t[j])
                    total = add(add(total, entry), entry if i != j else (0, 0))
        return total


def entries(c):
    """((i, j), entry) for all entries of a net."""
    return [((i, j), entry) for i, row in enumerate(c) for j, entry in enumerate(row)]


def pair_map(x, y):
    """F = w_y X - w_x Y"""
    return Map([((*i, *k), w, p) for i, p in entries(x.points) for k, (w,) in entries(y.weights)]
               + [((*i, *k), -w, p) for k, p in entries(y.points) for i, (w,) in entries(x.weights)])


def space_degree(equation):
    return max(map(sum, equation), default=0)


def section(equation, x):
    """w^d f(X / w) as a polynomial in u and v, d the degree of f."""
    degree = space_degree(equation)
    parts = [{(*i, 0, 0): p[d] for i, p in entries(x.points)} for d in range(3)] + [{(*i, 0, 0): w for i, (w,) in entries(x.weights)}]
    result = {}
    for power, c in equation.items():
        term = {(0, 0, 0, 0): c}
        for part, n in zip(parts, (*power, degree - sum(power))):
            for _ in range(n):
                term = product(term, part)
        for p, q in term.items():
            result[p] = result.get(p, 0) + q
    return {p: q for p, q in result.items() if q}


def section_map(polynomial):
    """F = (polynomial, r - 1/2, s - 1/2)"""
    return Map([(power, c, [1, 0, 0]) for power, c in polynomial.items()]
               + [((0, 0, 1, 0), 1, [0, 1, 0]), ((0, 0, 0, 1), 1, [0, 0, 1]), ((0, 0, 0, 0), Fraction(-1, 2), [0, 1, 1])])


def section_net(polynomial, m, n):
    """A positive multiple of its Bernstein coefficients of bidegree (m,n) over the unit square, in integers."""
    net = [[sum(math.comb(i, k) * math.comb(j, l) * c / (math.comb(m, k) * math.comb(n, l)) for (k, l, _, _), c in polynomial.items() if k <= i and l <= j)
            for j in range(n + 1)] for i in range(m + 1)]
    scale = math.lcm(*(Fraction(c).denominator for row in net for c in row))
    return [[[int(c * scale)] for c in row] for row in net]


class Position:
    """The point of space X / W of two maps, W the first component of the second one, or X alone."""

    def __init__(self, points, weight=None):
        self.points, self.weight = points, weight

    def value(self, w):
        result = self.points.value(w)
        if not self.weight:
            return result
        divisor = ball_of(self.weight.value(w)[0])
        require(sign(divisor) > 0, "$.first", "a denominator that may be 0")
        balls = [divide(ball_of(c), divisor, "$.first") for c in result]
        return [Near(ball) if ball[1] else ball[0] for ball in balls]

    def bounds(self, middle, half, bounds, place):
        """Of each component: derivatives over the box, and the second one along the curve."""
        local = self.points.at(middle)
        weight = self.weight and self.weight.at(middle)
        result = []
        for d in range(3):
            partial = [local.first(d, i, half) for i in range(4)]
            bend = local.second(d, bounds.first, half)
            if weight:
                w, slope = weight.derivative(0, (0, 0, 0, 0), half), [weight.first(0, i, half) for i in range(4)]
                require(sign(w) > 0, place, "a denominator that may be 0")
                p = divide(local.derivative(d, (0, 0, 0, 0), half), w, place)
                partial = [divide(subtract(b, times(p, c)), w, place) for b, c in zip(partial, slope)]
                along, w_along = (total(times(b, t) for b, t in zip(c, bounds.first)) for c in (partial, slope))
                bend = subtract(subtract(bend, times((2, 0), times(along, w_along))), times(p, weight.second(0, bounds.first, half)))
                bend = divide(bend, w, place)
            result.append((partial, add(bend, total(times(b, w) for b, w in zip(partial, bounds.second)))))
        return result


def total(balls):
    result = (Fraction(0), Fraction(0))
    for ball in balls:
        result = add(result, ball)
    return result


def position_on(x):
    def map_of(c):
        return Map([((*i, 0, 0), 1, [*a, 0, 0][:3]) for i, a in entries(c)])
    return Position(map_of(x.points), map_of(x.weights) if x.weighted else None)


def parts_by_parity(c):
    """A, B, C, D, maps of (U, V, a^2, b^2), with c(U + a, V + b) = A + a B + b C + a b D."""
    parts = [[], [], [], []]
    for (i, j), entry in entries(c):
        for k, l in itertools.product(range(i + 1), range(j + 1)):
            parts[k % 2 + 2 * (l % 2)].append(((i - k, j - l, k // 2, l // 2), math.comb(i, k) * math.comb(j, l), [*entry, 0, 0][:3]))
    return [Map(terms) for terms in parts]


def divided_maps(x, w):
    """P and Q of F(U + a, V + b, U - a, V - b) = 2 (a P + b Q), maps of (U, V, a^2, b^2), of the parts of X and w."""
    result = []
    for p in (1, 2):
        square = (0, 0, int(p == 2), int(p == 1))
        products = [(1, w[0], x[p], (0, 0, 0, 0)), (-1, w[p], x[0], (0, 0, 0, 0)), (1, w[3], x[3 - p], square), (-1, w[3 - p], x[3], square)]
        result.append(Map([(tuple(map(sum, zip(i, j, more))), side * q[0], c)
                           for side, weight, points, more in products for i, q in weight.terms.items() if q[0] for j, c in points.terms.items()]))
    return result


def chart_map(parts):
    """In (U,V,m,w): the sum of the maps of (U, V, a^2, b^2), each times a monomial, where a = t, b = m t, w = t^2."""
    return Map([((u, v, 2 * b + more[0], a + b + more[1]), 1, c) for part, more in parts for (u, v, a, b), c in part.terms.items()])


def mean_of_pairs(parts):
    return chart_map([(parts[0], (0, 0)), (parts[3], (1, 1))])


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
    return [[near(c / det) if det else Fraction(0) for c in row] for row in cofactors]


# ---- Pairs of points of one patch: boxes of (U,V,a,b)


def halves(exchanged, w):
    if exchanged:
        w = [w[1], w[0], w[3], w[2]]
    half = (Fraction(1, 2), 0)
    return [times(half, add(w[0], w[2])), times(half, add(w[1], w[3])),
            times(half, subtract(w[0], w[2])), times(half, subtract(w[1], w[3]))]


def square(a):
    most, least = magnitude(a) ** 2, (abs(a[0]) - a[1]) ** 2 if sign(a) else Fraction(0)
    return (most + least) / 2, (most - least) / 2


def divided(maps, pairs, m):
    """R = P + m Q and Q."""
    box = [pairs[0], pairs[1], square(pairs[2]), square(pairs[3])]
    middle, half = zip(*box)
    p, q = (c.at(middle) for c in maps)
    r = Map([(power, factor, c) for factor, part in ((1, p), (m, q)) for power, c in part.terms.items()])
    return [[c.derivative(d, (0, 0, 0, 0), half) for d in range(3)] for c in (r, q)]


def volume(n, maps, pairs):
    """n . (P x Q)"""
    p, q = divided(maps, pairs, Fraction(0))
    pq, qq = (sum(a[0] * b[0] for a, b in zip(c, q)) for c in (p, q))
    r = divided(maps, pairs, near(-pq / qq) if qq else Fraction(0))[0]
    total = (Fraction(0), Fraction(0))
    for d in range(3):
        e, f = (d + 1) % 3, (d + 2) % 3
        total = add(total, times((n[d], 0), subtract(times(r[e], q[f]), times(r[f], q[e]))))
    return total


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
        value = claim(value, place, ["centre", "axis", "slope", "reach", "width", "inverse", "curve"])
        self.curve = value["curve"]
        require(isinstance(self.curve, str) and re.fullmatch("pair|first|second|(star(0|[1-9][0-9]{0,9})[uvrs][+-])?(factor(0|[1-9][0-9]{0,9}))?", self.curve)
                and self.curve, place, "not a curve")
        self.charted = self.curve in ("first", "second")
        star, factor = (re.search(text, self.curve) for text in ("star([0-9]+)(..)", "factor([0-9]+)"))
        self.star, self.direction = (int(star[1]), DIRECTIONS.index(star[2])) if star else (None, None)
        self.factor = int(factor[1]) if factor else None
        self.constant = []
        self.centre = numbers(value["centre"], 4, place)
        self.axis = parameter(value["axis"], place)
        self.slope = numbers(value["slope"], 4, place)
        self.reach, self.width = number(value["reach"], place), number(value["width"], place)
        require(isinstance(value["inverse"], list) and len(value["inverse"]) == 3, place, "not a matrix")
        self.inverse = [numbers(row, 3, place) for row in value["inverse"]]

    def contains(self, box):
        k = self.axis
        t = box[k][0] - self.centre[k]
        return abs(t) + box[k][1] <= self.reach and all(
            abs(box[i][0] - self.centre[i] - self.slope[i] * t) + box[i][1] + abs(self.slope[i]) * box[k][1] <= self.width
            for i in others(k))

    def surrounds(self, box):
        """The box lies in the one around the tube, in which no other zeros are than those of the tube."""
        return all(abs(b[0] - c) + b[1] <= h for b, c, h in zip(box, self.centre, self.extent()))

    def check(self, system, place):
        k, t, z = self.axis, self.reach, self.width
        require(self.slope[k] == 1 and t > 0 and z > 0, place, "not a tube")
        require(self.curve != "first" and self.curve != "second" or self.curve in system.equation, place, "a chart of two patches")
        if self.star is not None:
            self.star = element(system.stars, self.star, place)
            self.map, self.space = self.star.maps[self.direction]
        else:
            self.map = system.equation[self.curve if self.charted else "pair"]
            self.space = system.space[self.curve if self.charted else "pair"]
        self.divided = system.divided.get(self.curve)
        self.exact = system.equation["pair"]
        if self.factor is not None:
            self.factor = element(system.factors, self.factor, place)
            self.check_factored(place)
        elif system.section is not None:
            self.find_constant(list(zip(self.centre, self.extent())))
        self.check_contraction(place)
        if self.charted:
            h = self.extent()
            end = self.centre[3] + t
            u, v, m = (magnitude(b) for b in self.bounds.first[:3])
            rest = abs(self.centre[2]) - h[2] - 2 * end * m
            require(k == 3 and end > 0 and rest > 0 and 4 * end * u * u < 1 and 4 * end * v * v < rest * rest, place,
                    "a parameter may turn")
            return
        if self.star is not None:
            self.check_half_branch(system.tubes, place)
            return
        h = self.extent()
        for i in range(4):
            inside = self.centre[i] >= h[i] and self.centre[i] + h[i] <= 1
            require(i in self.constant or sign(self.bounds.first[i]) or inside, place, "a parameter may turn outside the domain")

    def monotone(self, d, i):
        """Component d of the map is, in w_i."""
        return sign(self.map.at(self.centre).first(d, i, self.extent()))

    def extent(self):
        return [abs(d) * self.reach + (0 if i == self.axis else self.width) for i, d in enumerate(self.slope)]

    def check_contraction(self, place):
        k, t, z, h = self.axis, self.reach, self.width, self.extent()
        local = self.map.at(self.centre).times(self.inverse)
        rows = defect_rows(local, k, h)
        for d in range(3):
            f = [Fraction(0)] * (1 + max(map(sum, local.terms)))
            for power, c in local.terms.items():
                f[sum(power)] += c[d] * math.prod(s**i for s, i in zip(self.slope, power))
            require(sum(abs(q) * t**m for m, q in enumerate(f)) + rows[d] * z < z, place, "no contraction")
        self.bounds = Bounds(local, k, h)

    def check_factored(self, place):
        """There are no other solutions in the tube; which parameters are constant."""
        factor, self.exact = self.factor, self.factor.map
        require(not factor.surface or factor.is_edge(), place, "its surface goes on in the domain")
        box = parameters = list(zip(self.centre, self.extent()))
        self.map, columns = factor.map, factor.columns
        if self.star is not None:
            box = box[: self.axis] + [(self.reach / 2, self.reach / 2)] + box[self.axis + 1 :]
            parameters = self.star.from_chart(self.direction, box)
            self.map, columns = self.star.factor(factor, self.direction)
        walled = factor.walls is not None and self.star is None
        require(independent(columns, factor.surface, box) or walled and factor.on_one_side(box), place, "there may be other solutions")
        self.find_constant(parameters)

    def find_constant(self, parameters):
        local, half = self.exact.at([near(b[0]) for b in parameters]), [b[1] for b in parameters]
        half = [h + abs(near(b[0]) - b[0]) for h, b in zip(half, parameters)]
        for _, d, i in itertools.product(range(4), range(3), range(4)):
            alone = all(j == i or j in self.constant or not occurs(self.exact, d, j) for j in range(4))
            if alone and i not in self.constant and sign(local.first(d, i, half)):
                self.constant.append(i)

    def check_half_branch(self, earlier, place):
        star, k = self.star, self.direction // 2
        require(self.axis == k and self.centre[k] == 0, place, "does not begin at its star's point")
        require(all(abs(self.centre[j]) + self.width < 1 for j in others(k)), place, "begins beyond its chart")
        for other in earlier:
            require(other.star is not star or other.direction != self.direction or any(
                abs(self.centre[j] - other.centre[j]) > self.width + other.width for j in others(k)), place,
                "may begin where an earlier tube does")
        t = (self.reach / 2, self.reach / 2)
        self.grows = []
        for i in range(4):
            used = [j for j in range(4) if star.axes[i][j]]
            least = min(star.weights[j] for j in used)
            slope = (Fraction(0), Fraction(0))
            for j in used:
                weight = Fraction(star.weights[j])
                term = (weight * star.side(self.direction), Fraction(0))
                if j != k:
                    d = (self.centre[j], self.width + abs(self.slope[j]) * self.reach)
                    term = add(times((weight, Fraction(0)), d), times(t, self.bounds.first[j]))
                for _ in range(least, star.weights[j]):
                    term = times(term, t)
                slope = add(slope, times(ball_of(star.axes[i][j]), term))
            self.grows.append(0 if i in self.constant else sign(slope))
            require(i in self.constant or self.grows[i], place, "a parameter may turn")

    def derivatives(self, middle, half):
        """Of the curve in the box."""
        here = self.map.at(middle)
        return Bounds(here.times(near_inverse(here, self.axis)), self.axis, half)

    def leaves_domain(self):
        return self.star is not None and any(
            (a == 0 and grows < 0) or (a == 1 and grows > 0) for a, grows in zip(self.star.at, self.grows))

    def in_chart(self, w, place):
        """The box w of parameters in the variables of the map."""
        if self.star is not None:
            return self.star.in_chart(self.direction, w, place)
        if not self.charted:
            return w
        u, v, a, b = halves(self.curve == "second", w)
        require(sign(a), place, "a pair of points that may be one")
        return [u, v, divide(b, a, place), times(a, a)]

    def cell_in_chart(self, w, place):
        """The same for all solutions in a cell."""
        if not self.charted:
            return w
        pairs = halves(self.curve == "second", w)
        m = self.centre[2]
        r, q = divided([c.times(self.inverse) for c in self.divided], pairs, m)
        any_m = (m, self.extent()[2] + 1)
        return [pairs[0], pairs[1], subtract((m, Fraction(0)), divide(r[2], q[2], place)) if sign(q[2]) else any_m, square(pairs[2])]

    def node_box(self, node, place):
        if isinstance(node, Star):
            require(node is self.star, place, "not in a chart of its star")
            return [(a, Fraction(0)) for a in self.centre]
        require(self.star is None, place, "a node in the tube of a star")
        if not self.charted:
            return [(a, node.radius) for a in node.at]
        require(not node.on and not node.wrt and node.at[:2] == node.at[2:], place, "not a cuspidal point")
        u, v, _, _ = halves(self.curve == "second", [(a, Fraction(0)) for a in node.at])
        m = self.centre[2] - self.slope[2] * self.centre[3]
        return [(q, node.radius) for q in (u[0], v[0], m, Fraction(0))]

    def distance(self, w, place):
        require(self.contains([(a, 0) for a in w]), place, "a point is not in its tube")
        f = self.map.value(w)
        return max(abs(sum(m * q for m, q in zip(row, f))) for row in self.inverse) / (1 - self.bounds.defect)


class Edge(Tube):
    """The straight line between two places."""

    def __init__(self, a, b):
        k = self.axis = max(range(4), key=lambda p: (abs(b[p] - a[p]), -p))
        unit = [tuple(int(i == p) for i in range(4)) for p in range(4)]
        terms = []
        for d, p in enumerate(others(k)):
            slope, one = (b[p] - a[p]) / (b[k] - a[k]), [Fraction(d == i) for i in range(3)]
            terms += [((0, 0, 0, 0), slope * a[k] - a[p], one), (unit[p], 1, one), (unit[k], -slope, one)]
        self.charted, self.star = False, None
        self.map, self.inverse, self.bounds = Map(terms), [[Fraction(i == j) for j in range(3)] for i in range(3)], Bounds.__new__(Bounds)
        self.bounds.defect = 0

    def contains(self, box):
        return True


# ---- Factors


def component(polynomials, d):
    """Component d as {exponents: coefficient}."""
    return {power: c[d] for power, c in polynomials.terms.items() if c[d]}


def degree(polynomial):
    return max((sum(power) for power, c in polynomial.items() if c), default=0)


def product(a, b):
    result = {}
    for p, c in a.items():
        for q, d in b.items():
            power = tuple(map(sum, zip(p, q)))
            result[power] = result.get(power, 0) + c * d
    return result


def is_multiple(a, b):
    """b, which is not 0, divides a: by division with the greatest terms first, in the order of their exponents."""
    rest, top = dict(a), max(power for power, c in b.items() if c)
    while rest:
        power = max(rest)
        factor = rest.pop(power) / b[top]
        shift = tuple(p - q for p, q in zip(power, top))
        if factor and min(shift) < 0:
            return False
        for q, c in b.items() if factor else ():
            if c and q != top:
                key = tuple(map(sum, zip(q, shift)))
                rest[key] = rest.get(key, 0) - factor * c
    return True


def separates(a, i, j):
    """a is a product g h of polynomials in w_i and w_j and in the others: its terms make a matrix of rank 1."""
    matrix = {}
    for power, c in a.items():
        key = tuple(p if n in (i, j) else 0 for n, p in enumerate(power))
        matrix.setdefault(key, {})[tuple(p - q for p, q in zip(power, key))] = c
    rows = list(matrix.values())
    columns = set().union(*rows)
    return all(row.get(p, 0) * rows[0].get(q, 0) == row.get(q, 0) * rows[0].get(p, 0)
               for row in rows for p, q in itertools.combinations(columns, 2))


def occurs(polynomials, d, j):
    return any(power[j] and c[d] for power, c in polynomials.terms.items())


def vanishes(polynomials, d, known):
    """Component d is 0 wherever the parameters have these values."""
    local = polynomials.at([Fraction(known.get(j, 0)) for j in range(4)])
    return not any(c[d] for power, c in local.terms.items() if not any(power[j] for j in known))


def values_over(columns, box):
    middle, half = [b[0] for b in box], [b[1] for b in box]
    return [[local.derivative(d, (0, 0, 0, 0), half) for d in range(3)] for local in (column.at(middle) for column in columns)]


def cross(a, b):
    return [subtract(times(a[d - 2], b[d - 1]), times(a[d - 1], b[d - 2])) for d in range(3)]


def dot(a, b):
    total = (Fraction(0), Fraction(0))
    for p, q in zip(a, b):
        total = add(total, times(p, q))
    return total


def independent(columns, surface, box):
    """The columns, of a surface the first two, are independent in the box."""
    a, b, c = values_over(columns, box)
    normal = cross(a, b)
    return sign(dot(normal, [(near(q[0]), Fraction(0)) for q in normal] if surface else c))


def determinant(columns):
    total = {}
    for p in itertools.permutations(range(3)):
        odd = sum(p[i] > p[j] for i, j in ((0, 1), (0, 2), (1, 2))) % 2
        for power, q in product(columns[0][p[0]], product(columns[1][p[1]], columns[2][p[2]])).items():
            total[power] = total.get(power, 0) + (-q if odd else q)
    return total


def on_sides(polynomial, sides):
    """With these values, 0 or 1, for these parameters."""
    result = {}
    for power, c in polynomial.items():
        if all(b or not power[j] for j, b in sides.items()):
            rest = tuple(0 if j in sides else n for j, n in enumerate(power))
            result[rest] = result.get(rest, 0) + c
    return {power: c for power, c in result.items() if c}


class Factor:
    """F = sum of columns_j g_j^powers_j, g_j the components of the map."""

    def __init__(self, value, place, system):
        value = claim(value, place, ["map", "powers", "columns"])
        require(all(isinstance(value[key], list) and len(value[key]) == 3 for key in value), place, "not three of each")
        self.map, self.powers = self.polynomials(value["map"], place), [count(n, place) for n in value["powers"]]
        self.columns = [self.polynomials(column, place) for column in value["columns"]]
        self.surface = not any(value["columns"][2])
        require(all(1 <= n <= 6 for n in self.powers), place, "a power is not in 1, ..., 6")
        rests = [component(system.equation["pair"], d) for d in range(3)]
        for j, column in enumerate(self.columns):
            g = component(self.map, j)
            for d, rest in enumerate(rests):
                term = component(column, d)
                require(degree(term) + self.powers[j] * degree(g) <= 24, place, "a product of a degree above 24")
                for _ in range(self.powers[j]):
                    term = product(term, g)
                for power, c in term.items():
                    rest[power] = rest.get(power, 0) - c
        require(not any(any(rest.values()) for rest in rests), place, "not a sum of multiples of its map")
        self.walls = None if self.surface else self.find_walls()
        self.touches = self.surface or max(self.powers) > 1 or self.walls is not None and self.singular_along()

    def wall(self, j):
        """(parameter, value, sign in [0,1]^4) where g_j is a multiple of this parameter minus 0 or 1."""
        g = component(self.map, j)
        powers = [power for power in g if sum(power)]
        if len(powers) != 1 or sum(powers[0]) != 1:
            return None
        slope, rest = g[powers[0]], g.get((0, 0, 0, 0), 0)
        value = {0: 0, -slope: 1}.get(rest)
        return None if value is None else (powers[0].index(1), value, sign((slope * (1 - 2 * value), Fraction(0))))

    def find_walls(self):
        """(a, b, c): g_a and g_b are walls of different parameters, and g_c is there a number times w_k and a rest without it."""
        for a, b, c in ((1, 2, 0), (2, 0, 1), (0, 1, 2)):
            first, second = self.wall(a), self.wall(b)
            if first and second and first[0] != second[0]:
                g = on_sides(component(self.map, c), {first[0]: first[1], second[0]: second[1]})
                if any([power for power in g if power[k]] == [tuple(int(i == k) for i in range(4))] for k in range(4)):
                    return a, b, c
        return None

    def singular_along(self):
        """The determinant of the columns is 0 on the curve on both walls, whose equation is g_c."""
        a, b, c = self.walls
        sides = {self.wall(j)[0]: self.wall(j)[1] for j in (a, b)}
        m = [[on_sides(component(column, d), sides) for d in range(3)] for column in self.columns]
        return is_multiple(determinant(m), on_sides(component(self.map, c), sides))

    def on_one_side(self, box):
        """Both M_a x M_c and M_b x M_c have, with the signs of g_a^m_a and g_b^m_b, positive products with one vector."""
        values, across = values_over(self.columns, box), []
        for j in self.walls[:2]:
            normal = cross(values[j], values[self.walls[2]])
            across.append(normal if self.powers[j] % 2 == 0 or self.wall(j)[2] > 0 else [(-q, r) for q, r in normal])
        longest = [max(abs(q) for q, _ in normal) for normal in across]
        if not all(longest):
            return False
        n = [(near(sum(normal[d][0] / most for normal, most in zip(across, longest))), Fraction(0)) for d in range(3)]
        return all(sign(dot(n, normal)) > 0 for normal in across)

    @staticmethod
    def polynomials(value, place):
        require(isinstance(value, list) and len(value) == 3, place, "not three polynomials")
        terms = []
        for d, polynomial in enumerate(value):
            require(isinstance(polynomial, list), place, "not a polynomial")
            for term in polynomial:
                require(isinstance(term, list) and len(term) == 5, place, "not a coefficient and four exponents")
                power = tuple(count(n, place) for n in term[1:])
                require(sum(power) <= 12, place, "exponents with a sum above 12")
                terms.append((power, number(term[0], place), [Fraction(d == i) for i in range(3)]))
        return Map(terms)

    def is_edge(self):
        """g_1 is linear in two parameters, in [0,1]^4 only 0 at a corner of them, where g_3 is."""
        used = [j for j in range(4) if occurs(self.map, 0, j)]
        if len(used) != 2 or any(sum(power) > 1 and c[0] for power, c in self.map.terms.items()):
            return False
        for corner in itertools.product((0, 1), repeat=2):
            at, *near = ([Fraction(dict(zip(used, place)).get(j, 0)) for j in range(4)]
                         for place in (corner, (1 - corner[0], corner[1]), (corner[0], 1 - corner[1])))
            a, b = (self.map.value(w)[0] for w in near)
            if not self.map.value(at)[0] and a * b > 0 and vanishes(self.map, 2, dict(zip(used, corner))):
                return True
        return False

    def on_surface(self, w):
        return not any(self.map.value(w)[:2])

    def coordinates(self):
        """Two parameters that are coordinates of the plane g_1 = g_2 = 0, if it is one."""
        if not self.surface or any(sum(power) > 1 and any(c[:2]) for power, c in self.map.terms.items()):
            return None
        slope = [[self.map.first(d, j, [Fraction(0)] * 4)[0] for j in range(4)] for d in range(2)]
        for i, j in itertools.combinations(range(4), 2):
            if slope[0][i] * slope[1][j] != slope[0][j] * slope[1][i]:
                return [k for k in range(4) if k not in (i, j)]
        return None


# ---- Stars


UNIT = [[Fraction(i == j) for j in range(3)] for i in range(3)]


class Star:
    on, wrt, radius = {}, [], Fraction(0)

    def __init__(self, value, place, system):
        self.place = place
        value = claim(value, place, ["modulus", "between", "at", "axes", "coordinates", "weights", "rows", "orders", "charts"])
        all_numbers = Root(value["modulus"], value["between"], place).numbers
        self.at = all_numbers(value["at"], 4, place)
        for key, rows, columns in (("axes", 4, 4), ("coordinates", 4, 4), ("rows", 3, 3)):
            require(isinstance(value[key], list) and len(value[key]) == rows, place, "not a matrix")
            setattr(self, key, [all_numbers(row, columns, place) for row in value[key]])
        for key, size in (("weights", 4), ("orders", 3), ("charts", 8)):
            require(isinstance(value[key], list) and len(value[key]) == size, place, "not a list of this length")
        self.weights, self.orders = ([count(n, place) for n in value[key]] for key in ("weights", "orders"))
        self.charts = value["charts"]
        require(all(isinstance(text, str) for text in self.charts), place, "not eight subdivisions")
        require(sum(text.count(" ") + 1 for text in self.charts) <= MAX_ENTRIES, place, "more than 1048576 entries of subdivisions")
        require(all(1 <= w <= 6 for w in self.weights) and min(self.orders) >= 1, place, "not a weight, or not an order")
        for i in range(4):
            for j in range(4):
                require(sum(self.coordinates[i][n] * self.axes[n][j] for n in range(4)) == (i == j), place, "not the inverse")
        a, b, c = self.rows
        volume_of_rows = sum(a[d] * (b[d - 2] * c[d - 1] - b[d - 1] * c[d - 2]) for d in range(3))
        require(sign(ball_of(volume_of_rows)), place, "its rows are dependent")
        polynomial = system.equation["pair"]
        require(all(q == 0 or sign(ball_of(q)) > 0 for a in self.at for q in (a, 1 - a)), place, "not in [0,1]^4")
        self.singular = all(sum(power) != 1 or not sum(n * t for n, t in zip(c, q)) for power, q in polynomial.at(self.at).terms.items())
        space = system.space["pair"]
        equation, points, weight = (self.centred(c) if c else None for c in (polynomial, space.points, space.weight))
        self.maps = [(self.chart(equation, n, self.rows, self.orders),
                      Position(*(self.chart(c, n, UNIT, [0, 0, 0]) for c in (points, weight) if c))) for n in range(8)]

    def factor(self, factor, direction):
        """Its map and columns in the chart, divided by powers of t."""
        terms = self.centred(factor.map)
        orders = [min(self.degree(power) for power, c in terms.items() if c[d]) if any(c[d] for c in terms.values()) else 0 for d in range(3)]
        columns = [self.chart(self.centred(factor.columns[j]), direction, self.rows, [n - factor.powers[j] * orders[j] for n in self.orders])
                   for j in range(3)]
        return self.chart(terms, direction, UNIT, orders), columns

    def degree(self, power):
        return sum(w * p for w, p in zip(self.weights, power))

    def centred(self, polynomial):
        """Its coefficients in e, w = at + axes e."""
        result = {}
        for power, c in polynomial.at(self.at).terms.items():
            product = {(0, 0, 0, 0): Fraction(1)}
            for i in range(4):
                for _ in range(power[i]):
                    longer = {}
                    for lower, q in product.items():
                        for j in range(4):
                            if self.axes[i][j]:
                                key = tuple(p + (n == j) for n, p in enumerate(lower))
                                longer[key] = longer.get(key, 0) + q * self.axes[i][j]
                    product = longer
            for key, q in product.items():
                result[key] = [a + q * b for a, b in zip(result.get(key, [0] * 3), c)]
        return result

    @staticmethod
    def side(direction):
        return -1 if direction % 2 else 1

    def chart(self, polynomial, direction, rows, orders):
        """rows times it at e = d t^weights, divided by t^orders."""
        k, terms = direction // 2, [((0, 0, 0, 0), 0, [Fraction(0)] * 3)]
        for power, c in polynomial.items():
            degree = self.degree(power)
            for d in range(3):
                value = sum(n * q for n, q in zip(rows[d], c)) * self.side(direction) ** power[k]
                if value:
                    require(degree >= orders[d], self.place, "not of this order at its point")
                    key = power[:k] + (degree - orders[d],) + power[k + 1 :]
                    value = Near(ball_of(value)) if isinstance(value, Algebraic) else value
                    terms.append((key, value, [Fraction(d == i) for i in range(3)]))
        return Map(terms)

    def box(self, w):
        """A box of parameters in e."""
        result = [(Fraction(0), Fraction(0))] * 4
        for j in range(4):
            for i in range(4):
                result[j] = add(result[j], times(ball_of(self.coordinates[j][i]), subtract(w[i], ball_of(self.at[i]))))
        return result

    def in_chart(self, direction, w, place):
        k, e = direction // 2, self.box(w)
        size = times((self.side(direction), 0), e[k])
        require(sign(size) > 0, place, "not on its side of the star's point")
        t = root(size, self.weights[k], place)
        for j in others(k):
            for _ in range(self.weights[j]):
                e[j] = divide(e[j], t, place)
        return e[:k] + [t] + e[k + 1 :]

    def from_chart(self, direction, z):
        """The parameters of all points of a chart in the box."""
        k = direction // 2
        t, z = z[k], z[:k] + [(Fraction(self.side(direction)), Fraction(0))] + z[k + 1 :]
        for j in range(4):
            for _ in range(self.weights[j]):
                z[j] = times(z[j], t)
        result = [ball_of(a) for a in self.at]
        for i in range(4):
            for j in range(4):
                result[i] = add(result[i], times(ball_of(self.axes[i][j]), z[j]))
        return result

    def check_no_arc_inside(self, tubes):
        """It is singular, or has two half branches, one outside, or with a parameter that grows, or falls, along both."""
        own = [tube for tube in tubes if tube.star is self]
        require(self.singular or len(own) == 2, self.place, "its last row is not normal to both patches")
        same = self.singular or any(a * b > 0 for a, b in zip(own[0].grows, own[1].grows))
        require(same or any(tube.leaves_domain() for tube in own), self.place, "an arc may run through its point")

    def check_charts(self, tubes):
        for direction, text in enumerate(self.charts):
            place, k = f"{self.place}.charts[{direction}]", direction // 2
            waiting = [([Fraction(j == k, 2) for j in range(4)], [Fraction(1, 2) if j == k else Fraction(1) for j in range(4)])]
            for entry in text.split(" "):
                require(waiting, place, "beyond the end of the subdivision")
                middle, half = waiting.pop()
                if len(entry) == 1 and entry in LETTERS:
                    p = LETTERS.index(entry)
                    less = [h / 2 if j == p else h for j, h in enumerate(half)]
                    require(less[p] >= LEAST_HALF_EDGE, place, "a half edge below 2^-51")
                    for step in (less[p], -less[p]):
                        waiting.append(([m + step if j == p else m for j, m in enumerate(middle)], less))
                elif re.fullmatch("t(0|[1-9][0-9]{0,9})", entry):
                    tube = element(tubes, int(entry[1:]), place)
                    require(tube.star is self and tube.direction == direction, place, "a tube of another chart")
                    require(tube.surrounds(list(zip(middle, half))), place, "a cell is not in its tube's box")
                else:
                    n = direction_of(entry, place)
                    local = self.maps[direction][0].at(middle).times([n, n, n])
                    require(sign(local.derivative(0, (0, 0, 0, 0), half)), place, "a cell may hold a solution")
            require(not waiting, place, "the subdivision is not complete")


def root(ball, n, place):
    """t > 0 with t^n in the ball"""
    if n == 1:
        return ball
    q = Fraction(float(near(ball[0])) ** (1 / n))
    require(q > 0, place, "no root")
    return q, (abs(q**n - ball[0]) + ball[1]) / q ** (n - 1)


def direction_of(text, place):
    require(re.fullmatch("-?[0-9]+,-?[0-9]+,-?[0-9]+", text), place, "not a cell")
    direction = [int(part) for part in text.split(",") if len(part) <= 11]
    require(all(-(2**31) <= n < 2**31 for n in direction), place, "not a direction")
    require(",".join(map(str, direction)) == text, place, "not a direction")
    return direction


# ---- Nodes


class Node:
    def __init__(self, value, place):
        value = claim(value, place, ["tube", "at", "radius", "on", "wrt"])
        self.tube, self.at, self.radius = value["tube"], numbers(value["at"], 4, place), number(value["radius"], place)
        require(isinstance(value["on"], list) and isinstance(value["wrt"], list), place, "not lists")
        for side in value["on"]:
            require(isinstance(side, str) and side in [f"{p}={c}" for p in LETTERS for c in (0, 1)], place, "not a side")
        self.on = {LETTERS.index(side[0]): int(side[2]) for side in value["on"]}
        require(len(self.on) == len(value["on"]), place, "on two sides of one parameter")
        self.wrt = [parameter(p, place) for p in value["wrt"]]


def check_name(name, place):
    require(isinstance(name, str) and is_json(f'"{name}"'), place, "not a name")


class Checker:
    def __init__(self, root):
        require(isinstance(root.get("command"), str) and root["command"] in ("intersect", "line", "self"), "$.command", "neither intersect, line nor self")
        self.alone = root["command"] == "self"
        lists = ["factors", "stars", "tubes", "nodes", "arcs", "components", "overlaps", "cover"]
        names = ["first"] if self.alone else ["first", "second"]
        keys = ["exsect", "command", *names, *lists, "summary"]
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
        for i, row in enumerate(root["cover"]):
            require(isinstance(row, str) and " #" in row, f"$.cover[{i}]", "no seal")
        self.cells = sum(row.split(" #", 1)[0].count(" ") + 1 for row in root["cover"])
        self.section = None  # of an equation in the place of the second patch
        surface = root["second"] if root["command"] == "intersect" and isinstance(root["second"], dict) and "equation" in root["second"] else None
        self.nets = [self.net(root[key], "$." + key) for key in names[: 1 if surface else 2]]
        self.nets = [self.nets[0], self.nets[-1]]
        points = self.nets[0].points
        power = [Net(power_basis(net.points), power_basis(net.weights)) for net in self.nets]
        self.equation = {"pair": pair_map(*power)}
        self.space = {"pair": position_on(power[0])}
        one = {(0, 0, 0, 0): 1}
        self.denominators = [one, one] if surface else [{(*[0] * n, *i, *[0] * (2 - n)): w for i, (w,) in entries(net.weights)} for n, net in zip((0, 2), power)]
        if surface:
            equation = self.surface_equation(surface, "$.second")
            self.section = section(equation, power[0])
            self.bidegree = [(n - 1) * space_degree(equation) for n in (len(points), len(points[0]))]
            self.equation = {"pair": section_map(self.section)}
        self.divided = {}  # of the charts of one patch
        for name in ("first", "second") if self.alone else ():
            turned = transposed if name == "second" else list
            x, w = (parts_by_parity(turned(c)) for c in (power[0].points, power[0].weights))
            p, q = self.divided[name] = divided_maps(x, w)
            self.equation[name] = chart_map([(p, (0, 0)), (q, (1, 0))])
            self.space[name] = Position(mean_of_pairs(x), mean_of_pairs(w) if power[0].weighted else None)

    @staticmethod
    def surface_equation(value, place):
        """{exponents of x, y, z: coefficient}"""
        value = claim(value, place, ["name", "equation"])
        check_name(value["name"], place)
        require(isinstance(value["equation"], list), place, "not a polynomial")
        result = {}
        for term in value["equation"]:
            require(isinstance(term, list) and len(term) == 4, place, "not a coefficient and three exponents")
            power = tuple(count(n, place) for n in term[1:])
            require(sum(power) <= 4, place, "exponents with a sum above 4")
            result[power] = result.get(power, 0) + number(term[0], place)
        return {power: c for power, c in result.items() if c}

    @staticmethod
    def net(value, place):
        weighted = isinstance(value, dict) and "weights" in value
        value = claim(value, place, ["name", "points", "weights"] if weighted else ["name", "points"])
        points = value["points"]
        check_name(value["name"], place)
        require(isinstance(points, list) and 2 <= len(points) <= 4 and all(isinstance(row, list) for row in points), place, "not 2 to 4 rows")
        require(len({len(row) for row in points}) == 1 and 2 <= len(points[0]) <= 4, place, "not rows of 2 to 4 points")
        points = [[numbers(p, 3, place) for p in row] for row in points]
        if not weighted:
            return Net(points)
        require(isinstance(value["weights"], list) and len(value["weights"]) == len(points), place, "not a weight for each point")
        weights = [numbers(row, len(points[0]), place) for row in value["weights"]]
        check_positive([[[w] for w in row] for row in weights], place)
        return Net([[[w * c for c in p] for w, p in zip(*rows)] for rows in zip(weights, points)], [[[w] for w in row] for row in weights])

    def check(self):
        self.factors = [Factor(value, f"$.factors[{i}]", self) for i, value in enumerate(self.root.get("factors", []))]
        self.stars = [Star(value, f"$.stars[{i}]", self) for i, value in enumerate(self.root.get("stars", []))]
        self.tubes = []
        for i, value in enumerate(self.root["tubes"]):
            tube = Tube(value, f"$.tubes[{i}]")
            tube.check(self, f"$.tubes[{i}]")
            self.tubes.append(tube)
        if self.fixed:
            self.check_points()
        else:
            self.check_curves()
        self.check_cover()
        return self.root["summary"]

    def check_curves(self):
        self.nodes = []
        for star in self.stars:
            star.check_charts(self.tubes)
            star.check_no_arc_inside(self.tubes)
        for i, value in enumerate(self.root["nodes"]):
            node = Node(value, f"$.nodes[{i}]")
            self.check_node(node, f"$.nodes[{i}]")
            self.add_node(node, f"$.nodes[{i}]", self.tubes[node.tube].charted)
        for star in self.stars:
            self.add_node(star, star.place, False)
        self.ends = [[] for _ in self.nodes]  # directions; at a star, tubes
        self.arcs = [self.check_arc(value, f"$.arcs[{i}]") for i, value in enumerate(self.root["arcs"])]
        self.planes = []
        for i, value in enumerate(self.root["overlaps"]):
            self.planes.append(self.check_overlap(value, f"$.overlaps[{i}]"))
        used = {piece[0] for arc in self.arcs for piece in arc["pieces"]}
        for i in range(len(self.tubes)):
            require(i in used or self.tubes[i].leaves_domain(), f"$.tubes[{i}]", "no arc runs through it")
        self.check_graph()

    def check_points(self):
        k, fixed = self.fixed
        points = []
        for i, value in enumerate(self.root["points"]):
            place = f"$.points[{i}]"
            value = claim(value, place, ["tube", "at", "radius"])
            tube, at, radius = element(self.tubes, value["tube"], place), numbers(value["at"], 4, place), number(value["radius"], place)
            require(at[k] == fixed and tube.axis == k, place, "not on the line, or its tube has another axis")
            require(radius > 0 and tube.distance(at, place) <= radius, place, "its box may miss the solution")
            margin = radius if any(self.equation["pair"].value(at)) else 0
            require(all(margin <= at[j] <= 1 - margin for j in others(k)), place, "its box leaves [0,1]")
            for other, size in points:
                require(any(abs(at[j] - other[j]) > radius + size for j in others(k)), place, "its box meets that of an earlier point")
            points.append((at, radius))
        used = {value["tube"] for value in self.root["points"]}
        for i in range(len(self.tubes)):
            require(i in used, f"$.tubes[{i}]", "no point is in it")
        said = claim(self.root["summary"], "$.summary", ["claims"])
        require(said["claims"] == [0, 0, len(self.tubes), len(points), 0, self.cells, 0], "$.summary", "does not agree with the claims")

    @staticmethod
    def follows(tube, known, j, value):
        """From what is known, by a component of the map that is monotone in w_j and 0 wherever they have these values."""
        if not known:
            return j == tube.axis
        return any(vanishes(tube.exact, d, {**known, j: value}) and tube.monotone(d, j) for d in range(3))

    @staticmethod
    def related(tube, i, j):
        """A component of the map is monotone in both, and a product g h with the others in h alone."""
        return any(tube.monotone(d, i) and tube.monotone(d, j) and separates(component(tube.exact, d), i, j) for d in range(3))

    def check_node(self, node, place):
        tube = element(self.tubes, node.tube, place)
        require(not node.on or not node.wrt, place, "both on a side and a turning point")
        box = tube.node_box(node, place)
        require(node.radius > 0 and tube.contains(box), place, "its box is not in its tube")
        for j in range(4):
            require(j in node.on or node.radius < node.at[j] < 1 - node.radius, place, "its box leaves (0,1)")
        near = tube.distance([b[0] for b in box], place)
        require(near <= node.radius, place, "its box may miss the curve")
        if node.on:
            require(tube.axis in node.on, place, "its tube has another axis")
            require(all(node.at[j] == value for j, value in node.on.items()), place, "not on its sides")
            known, waiting = {}, dict(node.on)
            while waiting:
                j = next((j for j in waiting if self.follows(tube, known, j, node.on[j])), None)
                if j is None and known and not any(self.equation["pair"].value(node.at)):
                    break
                require(j is not None, place, "a side does not follow from that of the tube's axis")
                known[j] = waiting.pop(j)
        elif not tube.charted:
            require(node.wrt, place, "neither on a side nor a turning point")
            i, second = node.wrt[0], tube.bounds.second[node.wrt[0]]
            require(i != tube.axis and sign(second), place, "the second derivative may vanish")
            for j in range(1, len(node.wrt)):
                require(node.wrt[j - 1] < node.wrt[j], place, "parameters not in order")
                require(any(self.related(tube, k, node.wrt[j]) for k in node.wrt[:j]), place, "no relation")
            t = tangent(tube.map.at(node.at), [near] * 4)
            require(sign(t[tube.axis]), place, "no derivative here")
            along = abs(t[tube.axis][0]) - t[tube.axis][1]
            away = magnitude(t[i]) / along / (abs(second[0]) - second[1])
            require(abs(node.at[tube.axis] - tube.centre[tube.axis]) + away <= tube.reach, place, "may be outside its tube")
            require(all(near + away * magnitude(b) <= node.radius for b in tube.bounds.first), place, "its box may miss the point")

    def add_node(self, node, place, cusp):
        def apart(at, other):
            return any(b[0] > b[1] + node.radius + other.radius or -b[0] > b[1] + node.radius + other.radius
                       for b in (subtract(ball_of(p), ball_of(q)) for p, q in zip(at, other.at)))

        for other in self.nodes:
            require(apart(node.at, other), place, "meets an earlier node")
            require(not self.alone or apart(node.at[2:] + node.at[:2], other), place, "meets an earlier node, mirrored")
        require(not self.alone or cusp or apart(node.at[2:] + node.at[:2], node), place, "meets its mirror image")
        self.nodes.append(node)

    # ---- Overlaps

    def check_overlap(self, value, place):
        value = claim(value, place, ["factor", "edges"])
        factor, edges = element(self.factors, value["factor"], place), value["edges"]
        plane = factor.coordinates()
        require(plane and isinstance(edges, list) and len(edges) >= 3, place, "not a polygon of a plane")
        for edge in edges:
            require(isinstance(edge, dict) and list(edge) == ["points", "error_bound"] and isinstance(edge["points"], list)
                    and len(edge["points"]) >= 2, place, "not an edge")
        points = [[numbers(p, 7 if isinstance(p, list) and len(p) == 7 else 4, place) for p in edge["points"]] for edge in edges]
        corners = [edge[0][:4] for edge in points]
        for corner in corners:
            require(factor.on_surface(corner), place, "a corner is not on the plane")
            require(all(0 <= q <= 1 for q in corner), place, "a corner is not in [0,1]^4")
        require(not any(all(map(other.on_surface, corners)) for other in self.planes), place, "the same as an earlier one")

        def turn(a, b, c):
            a, b, c = ([w[j] for j in plane] for w in (a, b, c))
            return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

        for i, edge in enumerate(points):
            a, b = corners[i], corners[(i + 1) % len(corners)]
            others_ = [c for c in corners if c is not a and c is not b]
            require(all(turn(a, b, c) * turn(*corners[:3]) > 0 for c in others_), place, "not convex, or not in order")
            require(any(a[p] == b[p] in (0, 1) and any(c[p] != a[p] for c in others_) for p in range(4)), place, "an edge is on no side")
            require(edge[-1][:4] == b, place, "an edge does not end where the next one begins")
            line = Edge(a, b)
            at, vertices = [p[:4] for p in edge], [p[4:] for p in edge]
            k, direction = line.axis, 1 if b[line.axis] > a[line.axis] else -1
            require(all(direction * (q[k] - p[k]) > 0 for p, q in zip(at, at[1:])), place, "an edge runs back")
            line.space, bound = self.space["pair"], number(edges[i]["error_bound"], place)
            most = self.check_steps(line, at, [line.distance(w, place) for w in at], self.places_on_polyline(at, vertices, place), [], bound, place)[0]
            require(most <= bound, f"{place}.edges[{i}]", "the error bound is too small")
        return factor

    # ---- Arcs

    def check_arc(self, value, place):
        arc = claim(value, place, ["component", "from", "to", "points", "pieces", "error_bound"])
        start, end = element(self.nodes, arc["from"], place), element(self.nodes, arc["to"], place)
        require(isinstance(arc["points"], list) and len(arc["points"]) >= 2, place, "without points")
        require(isinstance(arc["pieces"], list) and arc["pieces"], place, "without pieces")
        points = [numbers(p, 7 if isinstance(p, list) and len(p) == 7 else 4, place) for p in arc["points"]]
        vertices = [p[4:] for p in points]
        points = [p[:4] for p in points]
        for point, node in ((points[0], start), (points[-1], end)):
            require(all(p == q or abs(Near(ball_of(p - q))) <= Fraction(isinstance(q, Algebraic), 2**40) for p, q in zip(point, node.at)), place,
                    "does not begin and end at its nodes")
        places = self.places_on_polyline(points, vertices, place)
        bound = number(arc["error_bound"], place)
        first, entered, grows, directions, most = 0, start.radius, None, [], Fraction(0)
        for piece in arc["pieces"]:
            require(isinstance(piece, list) and len(piece) == 2, place, "not a piece")
            last = count(piece[1], place)
            tube = element(self.tubes, piece[0], place)
            require(first < last < len(points), place, "a piece is empty")

            def box(j, radius, tube=tube):
                if j in (0, len(points) - 1):
                    return tube.node_box(end if j else start, place)
                return tube.in_chart([(a, radius) for a in points[j]], place)

            enters = box(first, entered)
            require(tube.contains(enters), place, "not in two tubes where they join")
            at = [[b[0] for b in box(j, Fraction(0))] for j in range(first, last + 1)]
            near = [tube.distance(w, place) for w in at]
            final = last + 1 == len(points)
            out = near[-1]
            near[0] = max([near[0]] + [b[1] for b in enters])
            near[-1] = max(near[-1], end.radius) if final else near[-1]
            k = tube.axis
            direction = 1 if at[1][k] > at[0][k] else -1
            for j in range(len(at) - 1):
                least = (enters[k][1] if j == 0 else 0) + (near[-1] if j + 2 == len(at) else 0)
                require(direction * (at[j + 1][k] - at[j][k]) > least, place, "a piece runs back")
            if tube.star:
                signs = tube.grows
            elif tube.charted:
                signs = self.pair_signs(tube, [points[j] for j in range(first, last + 1) if 0 < j < len(points) - 1], place)
            else:
                ends = [(points[first], entered, start if first == 0 else None), (points[last], near[-1], end if final else None)]
                signs = [self.slope_sign(tube, i, ends) for i in range(4)]
            open_ones = [i for i in range(4) if not signs[i] and i not in tube.constant]
            distance, along = self.check_steps(tube, at, near, places[first : last + 1], open_ones, bound, place)
            most = max(most, distance)
            signs = [direction * (along[i] if i in open_ones else signs[i]) for i in range(4)]
            grows = grows or signs
            require(all(signs[i] or i in tube.constant for i in range(4)) and signs == grows, place, "not monotone in a parameter")
            directions.append(direction)
            first, entered = last, 2 * out if tube.charted else out
            if tube.star and not final:
                z = [(b[0], b[1] + (0 if i == k else out)) for i, b in enumerate(box(last, Fraction(0)))]
                w = tube.star.from_chart(tube.direction, z)
                entered = max(abs(b[0] - a) + b[1] for b, a in zip(w, points[last]))
        require(first + 1 == len(points), place, "its pieces do not cover it")
        for node, name, piece, direction in ((start, "from", 0, directions[0]), (end, "to", -1, -directions[-1])):
            tube = arc["pieces"][piece][0]
            require(isinstance(node, Star) or tube == node.tube, place, "does not begin and end in its nodes' tubes")
            self.ends[arc[name]].append(tube if isinstance(node, Star) else direction)
        require(most <= bound, place, "the error bound is too small")
        return arc

    @staticmethod
    def pair_signs(tube, points, place):
        p = 1 if tube.curve == "second" else 0
        sides = {q[p] > q[p + 2] for q in points if q[p] != q[p + 2]}
        require(points and len(sides) == 1 and all(q[p] != q[p + 2] for q in points), place, "not on one side of the diagonal")
        side = 1 if sides.pop() else -1
        m = side if tube.centre[2] > 0 else -side
        return [m, side, -m, -side] if p else [side, m, -side, -m]

    def slope_sign(self, tube, i, ends):
        if sign(tube.bounds.first[i]) or i in tube.constant or not sign(tube.bounds.second[i]):
            return sign(tube.bounds.first[i])
        signs = []
        for at, near, node in ends:
            if node and i in node.wrt:
                continue
            t = tangent(tube.map.at(at), [near] * 4)
            slope = sign(t[i]) * sign(t[tube.axis])
            if slope or not node or not node.on or not self.turns_on_sides(tube, i, node.on):
                signs.append(slope)
        return signs[0] if signs and signs[0] == signs[-1] else 0

    def turns_on_sides(self, tube, i, sides):
        """T_i vanishes wherever the parameters are on the sides and the map is 0: it is a multiple of a component there, as a polynomial,
        with the columns c F_j - c_j F, c = 1 or the denominator of w_j's patch."""
        one = {(0, 0, 0, 0): 1}
        return any(self.turns_with(factors, tube.exact, i, sides) for factors in ((one, one), self.denominators))

    @staticmethod
    def turns_with(factors, polynomials, i, sides):
        def derivative(polynomial, j):
            return on_sides({tuple(p - (n == j) for n, p in enumerate(power)): power[j] * c for power, c in polynomial.items() if power[j]}, sides)

        def entry(d, j):
            f, c = component(polynomials, d), factors[j // 2]
            result = product(on_sides(c, sides), derivative(f, j))
            for power, q in product(derivative(c, j), on_sides(f, sides)).items():
                result[power] = result.get(power, 0) - q
            return result

        total = determinant([[entry(d, j) for d in range(3)] for j in others(i)])
        components = (on_sides(component(polynomials, d), sides) for d in range(3))
        return not any(total.values()) or any(any(g.values()) and is_multiple(total, g) for g in components)

    def places_on_polyline(self, points, vertices, place):
        require(vertices[0] and vertices[-1], place, "an end of the polyline is missing")
        at = [self.space["pair"].value(p) for p in points]
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
        return places + [vertices[-1]]

    def check_steps(self, tube, points, near, places, open_ones, bound, place):
        """The greatest distance between curve and polyline on a piece, in the variables of the tube's map, and the signs of
        the derivatives, 0 where they differ: four steps together, or one by one where four say too little."""
        most, signs, begin, together = Fraction(0), None, 0, 4
        while begin < len(points) - 1:
            stop = min(begin + together, len(points) - 1)
            distance, found = self.steps_together(tube, points, near, places, open_ones, begin, stop, place)
            if together > 1 and (distance is None or distance > bound or not all(found[i] for i in open_ones)):
                together = 1
                continue
            require(distance is not None, place, "no derivative over a step of the polyline")
            most = max(most, distance)
            signs = [a if a == b else 0 for a, b in zip(signs or found, found)]
            begin, together = stop, 4
        return most, signs

    @staticmethod
    def steps_together(tube, points, near, places, open_ones, begin, stop, place):
        margin = max(near[begin : stop + 1])
        unit = Fraction(1, 2**24)
        step = abs(points[begin][tube.axis] - points[stop][tube.axis])
        beyond = [2 * margin] * 4  # the hull of both ends
        for i in range(4):  # what need not be monotone
            if tube.charted or tube.star or i in open_ones:
                longer = step / 2 + (margin if i in open_ones else 0)
                bend = longer / 2 * magnitude(tube.bounds.second[i]) if i in open_ones else tube.bounds.first[i][1]
                beyond[i] += longer * min(tube.bounds.first[i][1], bend)
        middle = [unit * math.floor((p + q) / 2 / unit) for p, q in zip(points[begin], points[stop])]
        half = [unit * (math.floor((abs(p - q) / 2 + more) / unit) + 2) for p, q, more in zip(points[begin], points[stop], beyond)]
        bounds = tube.derivatives(middle, half)
        if bounds.defect >= 1:
            return None, None
        second, slope = [], []
        for partial, bend in tube.space.bounds(middle, half, bounds, place):
            second.append(magnitude(bend))
            slope.append(sum(magnitude(partial[i]) for i in others(tube.axis)))
        bend, speed = root_above(second) / 8, root_above(slope)
        ends = [root_above([p - q for p, q in zip(tube.space.value(points[j]), places[j])]) + speed * near[j]
                for j in range(begin, stop + 1)]
        distance = Fraction(0)
        for j in range(begin, stop):
            step = points[j + 1][tube.axis] - points[j][tube.axis]
            distance = max(distance, max(ends[j - begin], ends[j - begin + 1]) + step * step * bend)
        signs = [sign(b) for b in bounds.first]
        for c in (begin + stop) // 2, (begin + stop + 1) // 2:  # both ends of a single step
            if all(signs[i] for i in open_ones):
                break
            k = tube.axis
            length = margin + max(abs(points[c][k] - points[end][k]) for end in (begin, stop))
            there = tube.derivatives(points[c], [near[c]] * 4)
            if there.defect < 1:
                signs = [s or sign((b[0], b[1] + length * magnitude(h))) for s, b, h in zip(signs, there.first, bounds.second)]
        return distance, signs

    # ---- The graph and the cover

    def check_graph(self):
        for i, node in enumerate(self.nodes):
            ends = self.ends[i]
            if isinstance(node, Star):
                require(len(set(ends)) == len(ends), node.place, "two arcs on one half branch")
            else:
                require(sorted(ends) == [-1, 1] if node.wrt else len(ends) == 1, f"$.nodes[{i}]", "not the end of its arcs")
        shapes, seen = [], []
        for c, value in enumerate(self.root["components"]):
            place = f"$.components[{c}]"
            value = claim(value, place, ["shape", "arcs"])
            nodes = set()
            require(isinstance(value["arcs"], list) and value["arcs"], place, "without arcs")
            for a in value["arcs"]:
                arc = element(self.arcs, a, place)
                require(arc["component"] == c and a not in seen, place, "an arc of another component")
                require(not nodes or nodes & {arc["from"], arc["to"]}, place, "not connected")
                nodes |= {arc["from"], arc["to"]}
                seen.append(a)
            require(all(arc["component"] == c or not nodes & {arc["from"], arc["to"]} for arc in self.arcs), place, "connected with another")
            degrees = [len(self.ends[n]) for n in nodes]
            shape = "branched" if max(degrees) > 2 else "open" if 1 in degrees else "closed"
            require(value["shape"] == shape, place, "open, closed and branched confused")
            shapes.append(shape)
        require(len(seen) == len(self.arcs), "$.components", "an arc is missing")
        said = claim(self.root["summary"], "$.summary", ["claims", "components", "closed", "open", "branched", "isolated", "boundary", "tangential", "turning"])
        counted = {"claims": [*(len(self.root[key]) for key in ("factors", "stars", "tubes", "nodes", "arcs")), self.cells, len(self.planes)],
                   "components": len(shapes), "closed": shapes.count("closed"), "open": shapes.count("open"),
                   "branched": shapes.count("branched"), "isolated": sum(not ends for ends in self.ends),
                   "boundary": sum(bool(node.on) for node in self.nodes),
                   "tangential": sum(map(self.is_tangential, self.arcs)),
                   "turning": [sum(p in node.wrt for node in self.nodes) for p in range(4)]}
        require(said == counted, "$.summary", "does not agree with the claims and their graph")

    def is_tangential(self, arc):
        """The patches touch all along the arc."""
        factors = [self.tubes[t].factor for t, _ in arc["pieces"]]
        return all(factor is not None and factor.touches for factor in factors)

    def check_cover(self):
        cover = []
        for i, row in enumerate(self.root["cover"]):
            place = f"$.cover[{i}]"
            text, mark = row.split(" #", 1)
            require(mark == seal(place + text), place, "the seal does not fit the claim")
            cover += [(place, entry) for entry in text.split(" ")]
        self.check_cells(cover)

    def check_cells(self, cover):
        scale = math.lcm(*(q.denominator for net in self.nets for c in (net.points, net.weights) for row in c for p in row for q in p))
        middle, half = [Fraction(1, 2)] * 4, [Fraction(1, 2)] * 4
        whole = list(self.nets)
        if self.fixed:
            k, value = self.fixed
            scale *= value.denominator**3
            whole[k // 2] = Net(restricted(whole[k // 2].points, k % 2, value), restricted(whole[k // 2].weights, k % 2, value))
            middle[k], half[k] = value, Fraction(0)
        nets = [[[[[int(q * scale) for q in p] for p in row] for row in c] for c in (net.points, net.weights)] for net in whole]
        if self.section is not None:
            half[2] = half[3] = Fraction(0)
            nets = [section_net(self.section, *self.bidegree)]
        waiting = [(nets, middle, half)]  # the deepest last; points and weights of both patches, times integers > 0
        for place, text in cover:
            require(waiting, place, "beyond the end of the subdivision")
            nets, middle, width = waiting.pop()
            if len(text) == 1 and text in LETTERS:
                p = LETTERS.index(text)
                require(width[p] / 2 >= LEAST_HALF_EDGE, place, "a half edge below 2^-51, or the fixed parameter")
                for upper in (True, False):
                    parts = list(nets)
                    parts[p // 2] = halved(nets[0], p, upper) if self.section is not None else half_of(*nets[p // 2], p % 2, upper)
                    h = [w / 2 if j == p else w for j, w in enumerate(width)]
                    m = [q + (h[p] if upper else -h[p]) if j == p else q for j, q in enumerate(middle)]
                    waiting.append((parts, m, h))
                continue
            box = list(zip(middle, width))
            if re.fullmatch("[tm](0|[1-9][0-9]{0,9})", text):
                require(text[0] == "t" or self.alone, place, "of one patch only")
                tube = element(self.tubes, int(text[1:]), place)
                require(tube.star is None, place, "a tube of a star")
                require(tube.surrounds(tube.cell_in_chart(box if text[0] == "t" else box[2:] + box[:2], place)), place, "the cell is not in the tube's box")
            elif re.fullmatch("p(0|[1-9][0-9]{0,9})", text):
                e = element(self.stars, int(text[1:]), place).box(box)
                require(all(magnitude(b) <= 1 for b in e), place, "the cell is not in the star")
            elif re.fullmatch("s(0|[1-9][0-9]{0,9})", text):
                require(not self.fixed, place, "of curves only")
                require(independent(element(self.planes, int(text[1:]), place).columns, True, box), place, "there may be solutions beside the plane")
            elif text == "lower":
                require(self.alone and middle[0] + width[0] <= middle[2] - width[2], place, "not below the diagonal")
            else:
                direction = direction_of(text.removeprefix("i"), place)
                if text[0] == "i":
                    require(self.alone and sign(volume(direction, self.divided["first"], halves(False, box))), place,
                            "different points of the cell may have the same place")
                    continue
                if self.section is not None:
                    require(all(direction[0] * c > 0 for row in nets[0] for (c,) in row), place, "the cell may hold a solution")
                    continue
                require(separated(*nets, direction), place, "the direction does not separate the patches")
        require(not waiting, "$.cover", "the subdivision is not complete")


def root_above(vector):
    """At least the Euclidean norm."""
    q = sum(abs(a) ** 2 for a in vector)
    if q == 0:
        return Fraction(0)
    shift = max(0, 64 - (q.numerator.bit_length() - q.denominator.bit_length()) // 2)
    return Fraction(math.isqrt((q.numerator << 2 * shift) // q.denominator + 1) + 1, 2**shift)


class Net:
    """Points times weights, and weights, each a list; weights are one 1 if there are none."""

    def __init__(self, points, weights=None):
        self.points, self.weighted = points, weights is not None and weights != [[[1]]]
        self.weights = weights or [[[Fraction(1)]]]


def check_positive(weights, place):
    """The polynomial is, in the unit square: halved in u and v in turn until all Bernstein coefficients over a cell are positive."""
    scale = math.lcm(*(w.denominator for row in weights for (w,) in row))
    waiting, cells = [([[[int(scale * w)] for (w,) in row] for row in weights], False)], 0
    while waiting:
        require(cells < MAX_DENOMINATOR_CELLS, place, "its denominator may be 0 in the square")
        cells += 1
        net, second = waiting.pop()
        if all(w > 0 for row in net for (w,) in row):
            continue
        require(all(net[i][j][0] > 0 for i in (0, -1) for j in (0, -1)), place, "its denominator is not positive in the square")
        waiting += [(halved(net, second, upper), not second) for upper in (False, True)]


def half_of(points, weights, second, upper):
    """2^n times both, n the degree; without weights the one for all points."""
    n = len(points[0] if second else points) - 1
    has_weights = len(weights) + len(weights[0]) > 2
    return halved(points, second, upper), halved(weights, second, upper) if has_weights else [[[weights[0][0][0] << n]]]


def separated(x, y, direction):
    """direction . F is positive: all its Bernstein coefficients are."""
    def values(points, weights):
        """Pairs direction . (w P), w; of the extreme one alone where all weights are one."""
        flat = [w for row in weights for (w,) in row]
        return list(zip((sum(n * q for n, q in zip(direction, p)) for row in points for p in row), itertools.cycle(flat))), len(flat) > 1
    (a, a_weighted), (b, b_weighted) = values(*x), values(*y)
    a, b = a if a_weighted else [min(a)], b if b_weighted else [max(b)]
    return all(p * w > q * v for p, v in a for q, w in b)


def power_basis(net):
    def power(line):
        """Coefficients of t^k: binomials times differences."""
        n = len(line) - 1
        return [[math.comb(n, k) * sum((-1) ** (k - i) * math.comb(k, i) * line[i][d] for i in range(k + 1)) for d in range(len(line[0]))]
                for k in range(n + 1)]
    return transposed([power(column) for column in transposed([power(row) for row in net])])


def transposed(net):
    return [list(column) for column in zip(*net)]


def restricted(net, second, t):
    """Control points of the line where the first or second parameter is t, by de Casteljau's algorithm: one row, or rows of one."""
    def point(line):
        while len(line) > 1:
            line = [[(1 - t) * p + t * q for p, q in zip(a, b)] for a, b in zip(line, line[1:])]
        return line
    return [point(row) for row in net] if second else transposed([point(column) for column in transposed(net)])


def halved(net, second, upper):
    """2^n times the control points of one half in the first or second parameter, n the degree in it."""
    def half(line):
        # Sums of k + 1 neighbours with binomial weights are 2^k times what de Casteljau's algorithm gives on level k.
        line, parts = line[::-1] if upper else line, []
        for k in range(len(line), 0, -1):
            parts.append([p << k - 1 for p in line[0]])
            line = [[p + q for p, q in zip(a, b)] for a, b in zip(line, line[1:])]
        return parts[::-1] if upper else parts
    return [half(row) for row in net] if second else transposed([half(column) for column in transposed(net)])


def calls_itself_certificate(text):
    """A text of JSON that is no certificate."""
    try:
        root = json.loads(text)
        return isinstance(root, dict) and root.get("exsect") == "certificate/1"
    except ValueError:
        return False
    except RecursionError:
        return re.match(r'\s*{\s*"exsect"\s*:\s*"certificate/1"', text) is not None


def verdict(text):
    """(summary, None) if every claim holds, otherwise (None, (place, reason)); ValueError if the text is no certificate."""
    try:
        root = parsed(text)
    except ValueError as error:
        if calls_itself_certificate(text):
            return None, ("$", str(error))
        raise
    if not isinstance(root, dict) or root.get("exsect") != "certificate/1":
        raise ValueError("not of the form certificate/1")
    try:
        checker = Checker(root)
        checker.check()
    except Rejected as rejected:
        return None, rejected.args
    return checker.root["summary"], None


def main():
    sys.set_int_max_str_digits(0)
    try:
        with open(sys.argv[1], encoding="utf-8", newline="") as file:
            text = file.read(MAX_BYTES + 1)
        if len(text) > MAX_BYTES:
            raise ValueError("longer than 256 MiB")
        said, rejected = verdict(text)
    except (OSError, ValueError, IndexError) as error:
        print(f"{sys.argv[1:]}: {error}", file=sys.stderr)
        return 2
    if rejected:
        print("rejected: {}: {}".format(*rejected))
        return 1
    print("accepted:", f"{said['closed']} closed, {said['open']} open, {said['branched']} branched" if "closed" in said else f"{said['claims'][3]} points")
    return 0


if __name__ == "__main__":
    sys.exit(main())
