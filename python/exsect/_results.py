"""What exsect computes: results as immutable objects with exact numbers."""

from __future__ import annotations

import html
import importlib
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Type, Union

try:
    import numpy
except ImportError:  # lists are given in the place of arrays
    numpy = None  # type: ignore[assignment]

Exponents = Tuple[int, ...]


def _array(rows: List[List[float]]) -> Any:
    return rows if numpy is None else numpy.array(rows, dtype=float)


class Interval(NamedTuple):
    """A closed interval with exact ends that contains the true value."""

    lower: Fraction
    upper: Fraction

    @property
    def width(self) -> Fraction:
        return self.upper - self.lower

    @property
    def midpoint(self) -> Fraction:
        return (self.lower + self.upper) / 2

    def __contains__(self, value: object) -> bool:
        return self.lower <= value <= self.upper  # type: ignore[operator]


class Polynomial(Dict[Exponents, Fraction]):
    """A polynomial as a dictionary from exponents, one for each of `variables`, to coefficients that are not 0.

    It is what ``sympy.Poly.from_dict`` and the ``from_dict`` of python-flint's contexts take; ``str`` gives the
    text that Singular, Sage and PARI/GP read.
    """

    variables: Tuple[str, ...]

    def __init__(self, variables: Sequence[str], terms: Iterable[Tuple[Sequence[int], Fraction]]):
        super().__init__((tuple(exponents), coefficient) for exponents, coefficient in terms)
        self.variables = tuple(variables)

    @property
    def degree(self) -> int:
        """The total degree, -1 for zero."""
        return max((sum(exponents) for exponents in self), default=-1)

    def __call__(self, *values: Any) -> Any:
        """The value; exact if the values are."""
        if len(values) != len(self.variables):
            raise TypeError(f"needs {len(self.variables)} values, for {', '.join(self.variables)}")
        total: Any = Fraction(0)
        for exponents, coefficient in self.items():
            term: Any = coefficient
            for value, exponent in zip(values, exponents):
                term = term * value**exponent
            total = total + term
        return total

    def __str__(self) -> str:
        text = ""
        for exponents, coefficient in self.items():
            factors = [
                name if exponent == 1 else f"{name}^{exponent}"
                for name, exponent in zip(self.variables, exponents)
                if exponent
            ]
            if not factors or abs(coefficient) != 1:
                factors.insert(0, str(abs(coefficient)))
            sign = "-" if coefficient < 0 else "+" if text else ""
            text += sign + "*".join(factors)
        return text or "0"

    def __repr__(self) -> str:
        text = str(self)
        if len(text) > 80:
            return f"<Polynomial in {', '.join(self.variables)} of degree {self.degree} with {len(self)} terms>"
        return f"Polynomial({self.variables!r}, {text!r})"

    def __reduce__(self) -> Tuple[Any, ...]:
        return Polynomial, (self.variables, list(self.items()))

    def _repr_latex_(self) -> str:
        """For notebooks: the polynomial in LaTeX, between dollars."""
        parts = []
        for exponents, coefficient in self.items():
            factors = "".join(
                _latex_name(name) + (f"^{{{exponent}}}" if exponent > 1 else "")
                for name, exponent in zip(self.variables, exponents)
                if exponent
            )
            size = abs(coefficient)
            number = str(size) if size.denominator == 1 else rf"\frac{{{size.numerator}}}{{{size.denominator}}}"
            parts.append(("-" if coefficient < 0 else "+") + ("" if factors and size == 1 else number) + factors)
        return "$" + ("".join(parts).lstrip("+") or "0") + "$"

    def sympy(self) -> Any:
        """The same as a sympy.Poly over QQ; ImportError where SymPy is not installed."""
        sympy: Any = importlib.import_module("sympy")

        symbols = sympy.symbols(list(self.variables))
        terms = {exponents: sympy.Rational(c.numerator, c.denominator) for exponents, c in self.items()}
        return sympy.Poly.from_dict(terms, *symbols, domain=sympy.QQ)


def _latex_name(name: str) -> str:
    head, tail = name.rstrip("0123456789"), name[len(name.rstrip("0123456789")) :]
    return head + (f"_{{{tail}}}" if tail else "")


def _interval(pair: Sequence[Fraction]) -> Interval:
    return Interval(pair[0], pair[1])


def _triple(values: Sequence[Any]) -> Tuple[Any, Any, Any]:
    return values[0], values[1], values[2]


def _bound(bound: Optional[float]) -> float:
    return float("inf") if bound is None else bound


def _box(tree: Mapping[str, Sequence[Fraction]]) -> Dict[str, Interval]:
    return {name: _interval(pair) for name, pair in tree.items()}


def _polynomial(variables: Sequence[str], terms: Iterable[Any]) -> Polynomial:
    return Polynomial(variables, [(exponents, coefficient) for coefficient, exponents in terms])


def _columns(rows: Any, start: int, stop: Optional[int]) -> Any:
    return [row[start:stop] for row in rows] if numpy is None or isinstance(rows, list) else rows[:, start:stop]


def _joined(arcs: Sequence["Arc"]) -> Any:
    """The polylines of arcs that follow each other, run through in their order."""
    rows: List[Any] = []
    end: Optional[int] = None
    for i, arc in enumerate(arcs):
        first, last = arc.ends
        if end is None:
            following = arcs[i + 1].ends if i + 1 < len(arcs) else (last,)
            # Two arcs with both ends in common are told apart by nothing: the first one is taken forwards.
            forwards = last in following
        else:
            forwards = first == end
        piece = list(arc.polyline) if forwards else list(arc.polyline)[::-1]
        rows += piece if end is None else piece[1:]
        end = last if forwards else first
    return rows if numpy is None else numpy.array(rows, dtype=float)


@dataclass(frozen=True)
class Node:
    """A certified point of the intersection: its closed box holds exactly one point with these properties."""

    id: int
    #: "boundary", "turning", "corner", "touch", "crossing", "cusp", "end-of-overlap".
    kinds: Tuple[str, ...]
    #: Sides of the parameter squares it lies on, exactly: "u=0".
    on: Tuple[str, ...]
    #: Parameters with respect to which the curve turns here.
    wrt: Tuple[str, ...]
    #: Parameters that run through their whole interval of the box at this one point of space.
    free: Tuple[str, ...]
    #: Exact intervals by parameter.
    box: Dict[str, Interval]
    #: Approximate parameters, inside the box up to rounding.
    parameters: Dict[str, float]
    #: The approximate point of space.
    point: Tuple[float, float, float]
    #: Bounds of the box of a surface given by its equation that it lies on, exactly: "height=from".
    bounds: Tuple[str, ...] = ()
    #: Of an isolated point: the side, -1 or 1 as `Arc.left`, on which the first patch lies around it, where that is proved.
    around: Optional[int] = None
    #: With a cylinder, cone, sphere or torus: the exact intervals of "turn" and "height", or "turn" and "tube" (formats.md).
    chart: Dict[str, Interval] = field(default_factory=dict)

    def __repr__(self) -> str:
        words = [", ".join(self.kinds) or "point", *self.on, *self.bounds] + [f"turns in {p}" for p in self.wrt]
        places = ", ".join(f"{name}={value:.6g}" for name, value in self.parameters.items())
        return f"<Node {self.id}: {', '.join(words)}; {places}>"


@dataclass(frozen=True)
class Arc:
    """A piece of the curve between two nodes, with no node inside."""

    id: int
    #: -1 on the rim of an overlap.
    component: int
    #: Ids of the nodes it joins.
    ends: Tuple[int, int]
    #: "interior" or "patch-boundary".
    on: str
    #: "transversal" or "tangential".
    contact: str
    free: Tuple[str, ...]
    #: Rows of four parameters and x, y, z, or of two with a surface given by its equation: an array of numpy where numpy is installed, else lists.
    polyline: Any = field(compare=False)
    #: Proved: true arc and polyline are within this distance of each other in space. Infinite if a coordinate of the
    #: polyline is beyond the range of floats.
    error_bound: float
    #: The side of the second surface on which the first patch lies to the left and to the right of the arc from its
    #: first end, in the square with u to the right and v upwards: 1 is where the normal y_r x y_s points to, -1 the other
    #: one; of a surface given by its equation, the equation's sign (-1: inside). None where it is not proved.
    left: Optional[int] = None
    right: Optional[int] = None

    @property
    def uv(self) -> Any:
        """The two parameters of the first patch (of a self-intersection: u1, v1) at every vertex."""
        return _columns(self.polyline, 0, 2)

    @property
    def rs(self) -> Any:
        """The two parameters of the second patch (of a self-intersection: u2, v2) at every vertex; none of an equation."""
        return _columns(self.polyline, 2, -3)

    @property
    def xyz(self) -> Any:
        """The points of space."""
        return _columns(self.polyline, -3, None)

    def __repr__(self) -> str:
        return (
            f"<Arc {self.id} of component {self.component}: node {self.ends[0]} to {self.ends[1]}, {self.on}, "
            f"{self.contact}, {len(self.polyline)} vertices within {self.error_bound:.3g}>"
        )


@dataclass(frozen=True)
class Component:
    """A connected component of the arcs."""

    id: int
    #: "open", "closed" or "branched".
    shape: str
    #: Ids of arcs; of an open or closed one in order along the curve.
    arcs: Tuple[int, ...]
    _members: Tuple[Arc, ...] = field(default=(), repr=False, compare=False)

    @property
    def closed(self) -> bool:
        """A simple closed curve."""
        return self.shape == "closed"

    @property
    def tangential(self) -> bool:
        """The patches touch along all of it; False where they do so along a part only."""
        return bool(self._members) and all(arc.contact == "tangential" for arc in self._members)

    @property
    def error_bound(self) -> float:
        """Proved: curve and polyline are within this distance of each other in space."""
        return max((arc.error_bound for arc in self._members), default=0.0)

    def polyline(self) -> Any:
        """One polyline of the whole component: its arcs joined in order, each node once.

        Rows as of Arc.polyline; of a closed component the last row is the first one. ValueError for a branched
        component, which is no single curve.
        """
        if self.shape == "branched":
            raise ValueError(f"component {self.id} is branched: take the polylines of its arcs")
        return _joined(self._members)


@dataclass(frozen=True)
class Overlap:
    """A region where both patches lie on one surface, with its closed chains of boundary arcs."""

    id: int
    chains: Tuple[Tuple[Arc, ...], ...]
    #: 1 if the normals of both patches point to the same side at the nodes of the chains, -1 if to opposite ones; None with
    #: an equation, and where it is not proved.
    normals: Optional[int] = None


@dataclass(frozen=True)
class Incomplete:
    """Parameters that are not decided, and why: `reason` is "tangency", "crossing", "corner", "time",
    "failed proof", or "not decided" where none of these is known to be it."""

    where: Dict[str, Interval]
    why: str
    reason: str


class Again(NamedTuple):
    """What computes a result: a function of the compiled module, by its name, and its arguments."""

    function: str
    arguments: Tuple[Any, ...]

    def __call__(self) -> Any:
        from . import _core

        return getattr(_core, self.function)(*self.arguments)


class _Pickled(NamedTuple):
    """Stands for the compiled result after unpickling."""

    again: Again
    saved_tree: Dict[str, Any]

    def tree(self) -> Dict[str, Any]:
        return self.saved_tree


def _unpickled(kind: Type["Result"], again: Again, title: str, tree: Dict[str, Any], json: str) -> "Result":
    result = kind(_Pickled(again, tree), title, again)
    result._json = json
    return result


def _without_work(tree: Mapping[str, Any]) -> Dict[str, Any]:
    return {name: value for name, value in tree.items() if name != "work"}


class Result:
    """What all results share.

    `tree` is the result in the shape of the JSON file (formats.md), rationals as Fraction.
    """

    tree: Dict[str, Any]

    def __init__(self, core: Any, title: str, again: Optional[Again] = None):
        self._made: Any = core
        self._title = title
        self._again = again
        self._json: Optional[str] = None
        self.tree = core.tree()

    @property
    def _core(self) -> Any:
        """The compiled result; after unpickling it is computed again, and must be the same."""
        if isinstance(self._made, _Pickled):
            kept = self._made
            core = kept.again()
            if _without_work(core.tree()) != _without_work(kept.saved_tree):
                raise RuntimeError("the result cannot be computed again: it was cut short by max_seconds, or by another version")
            self._made = core
        return self._made

    def __reduce__(self) -> Tuple[Any, ...]:
        if self._again is None:
            raise TypeError(f"this {type(self).__name__} cannot be pickled")
        return _unpickled, (type(self), self._again, self._title, self.tree, self.to_json())

    @property
    def complete(self) -> bool:
        """The whole answer is proved; otherwise the result says what is missing, and why."""
        return bool(self.tree["status"] == "complete")

    def to_json(self) -> str:
        """The text that the program writes for --json."""
        if self._json is None:
            self._json = str(self._core.json())
        return self._json

    def to_svg(self, title: Optional[str] = None) -> str:
        """The picture that the program draws for --svg."""
        return str(self._core.svg(self._title if title is None else title))

    def _facts(self) -> List[Tuple[str, str]]:
        return [("status", self.tree["status"])]

    def to_report(self, title: Optional[str] = None) -> str:
        """The page that the program writes for --report: one HTML file that needs nothing else."""
        return str(self._core.report(self._title if title is None else title))

    def _repr_html_(self) -> str:
        """The report in a frame of its own, under a summary for viewers that show no frames."""
        rows = "".join(
            f"<tr><th style='text-align:left'>{html.escape(name)}</th><td>{html.escape(value)}</td></tr>"
            for name, value in self._facts()
        )
        frame = (
            "<iframe title='exsect report' sandbox='allow-scripts allow-downloads' style='width:100%;height:720px;border:0' "
            f'srcdoc="{html.escape(self.to_report())}"></iframe>'
        )
        return f"<div><table>{rows}</table>{frame}</div>"


class _Exportable(Result):
    def to_certificate(self) -> str:
        """The proof that `check` replays, as the program writes it for --certificate.

        NoCertificate, a ValueError, for a result that is incomplete or has no certificate.
        """
        return str(self._core.certificate())

    def to_obj(self, grid: int = 32) -> str:
        """Wavefront OBJ of patches on a grid of grid x grid cells, curves and points."""
        return str(self._core.exported("obj", self._title, grid))

    def to_ply(self, grid: int = 32) -> str:
        """The same as PLY."""
        return str(self._core.exported("ply", self._title, grid))

    def to_vtp(self, grid: int = 32) -> str:
        """The same as VTK XML PolyData, with ids, kinds and bounds as arrays."""
        return str(self._core.exported("vtp", self._title, grid))

    def to_csv(self) -> str:
        """The nodes (of a line: the points) as a table."""
        return str(self._core.exported("csv", self._title, 1))


class Intersection(_Exportable):
    """The intersection of two patches, or of a patch with itself, as a graph of nodes and arcs."""

    #: Names of the parameters: u, v, r, s, or u1, v1, u2, v2, or u, v with a surface given by its equation.
    parameters: Tuple[str, ...]
    nodes: Tuple[Node, ...]
    arcs: Tuple[Arc, ...]
    components: Tuple[Component, ...]
    #: Ids of nodes that are a whole piece of the intersection.
    isolated_points: Tuple[int, ...]
    overlaps: Tuple[Overlap, ...]
    #: Empty if the result is complete.
    incomplete: Tuple[Incomplete, ...]
    #: The largest error bound of an arc, if it is above the tolerance because floats cannot write the polylines more
    #: finely; else None. The result is not incomplete for it.
    drawn_to: Optional[float]

    def __init__(self, core: Any, title: str, again: Optional[Again] = None):
        super().__init__(core, title, again)
        tree = self.tree
        self.parameters = tuple(tree["summary"]["turning"])
        self.nodes = tuple(self._node(node) for node in tree["nodes"])
        self.arcs = tuple(self._arc(arc) for arc in tree["arcs"])
        self.components = tuple(
            Component(c["id"], c["shape"], tuple(c["arcs"]), tuple(self.arcs[i] for i in c["arcs"]))
            for c in tree["components"]
        )
        self.isolated_points = tuple(tree["isolated_points"])
        self.overlaps = tuple(
            Overlap(o["id"], tuple(tuple(self._arc(arc) for arc in chain) for chain in o["chains"]), o.get("normals"))
            for o in tree["overlaps"]
        )
        self.incomplete = tuple(Incomplete(_box(i["where"]), i["why"], i["reason"]) for i in tree["incomplete"])
        self.drawn_to = _bound(tree["coarse"]["bound"]) if "coarse" in tree else None

    def _node(self, node: Mapping[str, Any]) -> Node:
        approx = node["approx"]
        return Node(
            node["id"],
            tuple(node["kinds"]),
            tuple(node["on"]),
            tuple(node["wrt"]),
            tuple(node["free"]),
            _box(node["box"]),
            {name: approx[name] for name in self.parameters},
            _triple(approx["point"]),
            tuple(node.get("bounds", ())),
            node.get("around"),
            _box(node.get("chart", {})),
        )

    @staticmethod
    def _arc(arc: Mapping[str, Any]) -> Arc:
        return Arc(
            arc["id"],
            arc["component"],
            (arc["from"], arc["to"]),
            arc["on"],
            arc["contact"],
            tuple(arc["free"]),
            _array(arc["polyline"]),
            _bound(arc["error_bound"]),
            arc.get("left"),
            arc.get("right"),
        )

    @property
    def patches(self) -> Tuple[Any, ...]:
        """The patches that were intersected: two, or one of a self-intersection or with an equation."""
        if self._again is None:
            return ()
        if len(self.parameters) == 2:
            return (self._again.arguments[1],)
        return tuple(self._again.arguments[: 1 if self.parameters[0] == "u1" else 2])

    def plot(self, **options: Any) -> Any:
        """A figure of matplotlib: patches and curve in space, and both parameter squares.

        Options go to matplotlib.pyplot.figure. Returns the figure; ImportError where matplotlib is not installed.
        """
        from ._plot import result_figure

        return result_figure(self, options)

    def count(self, shape: str) -> int:
        """The number of components that are "open", "closed" or "branched"."""
        return sum(component.shape == shape for component in self.components)

    def turning_points(self, parameter: str) -> int:
        """The number of nodes in which the curve turns with respect to the parameter."""
        return int(self.tree["summary"]["turning"][parameter])

    def _facts(self) -> List[Tuple[str, str]]:
        shapes = ", ".join(f"{self.count(s)} {s}" for s in ("closed", "open", "branched") if self.count(s))
        bounds = [arc.error_bound for arc in self.arcs]
        facts = super()._facts() + [("components", shapes or "none"), ("nodes", str(len(self.nodes)))]
        facts.append(("arcs", f"{len(self.arcs)}, each within {max(bounds, default=0.0):.3g} of its polyline"))
        facts += [("overlaps", str(len(self.overlaps)))] if self.overlaps else []
        return facts + [("not decided", reason.why) for reason in self.incomplete]

    def __repr__(self) -> str:
        return "<Intersection: " + "; ".join(f"{name} {value}" for name, value in self._facts()) + ">"


@dataclass(frozen=True)
class Plane:
    """normal . P + constant = 0."""

    normal: Tuple[Fraction, Fraction, Fraction]
    constant: Fraction

    def __call__(self, point: Sequence[Any]) -> Any:
        return sum((n * p for n, p in zip(self.normal, point)), self.constant)


class End(NamedTuple):
    """An algebraic end of an interval: isolated by `interval`, near `approx`; closed if it belongs to it."""

    interval: Interval
    approx: float
    closed: bool


@dataclass(frozen=True)
class Branch:
    """Where one branch of the pulled-back plane lies on the other patch, between the ends of the line."""

    branch: int
    intervals: Tuple[Tuple[End, End], ...]


@dataclass(frozen=True)
class SpaceNode:
    """A node of the intersection of two surfaces given by their equations."""

    id: int
    #: "joint", "cut", "end", "touch", "crossing" or "singular" (formats.md).
    kind: str
    #: The number of ends of arcs.
    degree: int
    #: Exact intervals of x, y, z.
    box: Tuple[Interval, Interval, Interval]
    #: The approximate point.
    point: Tuple[float, float, float]
    #: On both surfaces: the exact intervals of "turn" and "height", or "turn" and "tube" (formats.md); empty on planes.
    charts: Tuple[Dict[str, Interval], Dict[str, Interval]]
    #: What it lies on of the box of the first surface, and of the second: "sector=from", ... (formats.md).
    bounds: Tuple[Tuple[str, ...], Tuple[str, ...]] = ((), ())
    #: Of a touch point: the sign of the second equation on the first surface around it, -1 or 1, where that is proved.
    around: Optional[int] = None


@dataclass(frozen=True)
class SpaceArc:
    """A piece of a curve between two nodes."""

    id: int
    #: Id of its curve.
    curve: int
    #: Ids of nodes.
    ends: Tuple[int, int]
    #: 1 where the surfaces cross; above 1 they touch along the arc, of this order.
    multiplicity: int
    #: Rows x, y, z.
    polyline: Any = field(repr=False, compare=False)
    #: Proved: arc and polyline are nowhere farther apart.
    error_bound: float
    #: The sign of the second equation on the first surface to the left of the arc, -1 or 1: seen from the first end to the
    #: second one and from where the first equation is positive. Equal to `right` where they touch without crossing; None
    #: where it is not proved, and of what one surface's boxes share.
    left: Optional[int] = None
    right: Optional[int] = None


@dataclass(frozen=True)
class SpaceCurve:
    """A curve as a whole, by its name."""

    id: int
    #: "line", "circle", "ellipse", "parabola", "hyperbola" or "general".
    kind: str
    closed: bool
    multiplicity: int
    #: Ids of its arcs.
    arcs: Tuple[int, ...]
    #: Of a line; the centre of a circle, ellipse or hyperbola; None where it is not rational.
    point: Optional[Tuple[Fraction, Fraction, Fraction]]
    #: Of a line; the normal of the plane of others.
    direction: Optional[Tuple[Fraction, Fraction, Fraction]]
    #: Of a circle.
    radius_squared: Optional[Fraction]


class SurfaceIntersection(_Exportable):
    """The common points of two surfaces given by their equations: named curves, arcs and nodes in space."""

    #: What is common, in words: "2 ellipses, 2 crossings".
    summary: str
    #: The surfaces are one.
    same: bool
    #: Then: 1 if both equations are positive on the same side, -1 if on opposite ones; None if they are not proportional.
    normals: Optional[int]
    nodes: Tuple[SpaceNode, ...]
    arcs: Tuple[SpaceArc, ...]
    curves: Tuple[SpaceCurve, ...]
    #: Pairs of why and reason; empty if the result is complete.
    incomplete: Tuple[Tuple[str, str], ...]

    def __init__(self, core: Any, title: str, again: Optional[Again] = None):
        super().__init__(core, title, again)
        tree = self.tree
        self.summary = tree["summary"]
        self.same = tree["same"]
        self.normals = tree.get("normals")
        self.nodes = tuple(
            SpaceNode(
                n["id"],
                n["kind"],
                n["degree"],
                _triple([_interval(pair) for pair in n["box"]]),
                _triple(n["approx"]),
                (_box(n["charts"][0]), _box(n["charts"][1])),
                (tuple(n["bounds"]["first"]), tuple(n["bounds"]["second"])) if "bounds" in n else ((), ()),
                n.get("around"),
            )
            for n in tree["nodes"]
        )
        self.arcs = tuple(
            SpaceArc(
                a["id"],
                a["curve"],
                (a["from"], a["to"]),
                a["multiplicity"],
                _array(a["polyline"]),
                _bound(a["error_bound"]),
                a.get("left"),
                a.get("right"),
            )
            for a in tree["arcs"]
        )
        self.curves = tuple(
            SpaceCurve(
                c["id"],
                c["kind"],
                c["closed"],
                c["multiplicity"],
                tuple(c["arcs"]),
                _triple(c["point"]) if "point" in c else None,
                _triple(c["direction"]) if "direction" in c else None,
                c.get("radius_squared"),
            )
            for c in tree["curves"]
        )
        self.incomplete = tuple((gap["why"], gap["reason"]) for gap in tree["incomplete"])

    def count(self, kind: str) -> int:
        """The number of curves that are a "line", "circle", "ellipse", "parabola", "hyperbola" or "general"."""
        return sum(curve.kind == kind for curve in self.curves)

    def _facts(self) -> List[Tuple[str, str]]:
        return super()._facts() + [("in common", self.summary)]

    def __repr__(self) -> str:
        return f"<SurfaceIntersection: {self.tree['status']}, {self.summary}>"


@dataclass(frozen=True)
class LinePoint:
    """A certified point of a parameter line on the other patch."""

    #: Exact intervals of u, v, r, s.
    box: Dict[str, Interval]
    #: Sides of the parameter squares it lies on, exactly.
    on: Tuple[str, ...]
    #: Approximate parameters.
    parameters: Dict[str, float]
    #: The approximate point of space.
    point: Tuple[float, float, float]
    #: 1: line and patch cross transversally; 0: they do not, and there is no eliminant.
    multiplicity: int
    #: 1 or 2; 0 where the branches meet or are not defined.
    branch: int
    _line: Any = field(repr=False, compare=False)
    _index: int = field(repr=False, compare=False)

    def __repr__(self) -> str:
        places = ", ".join(f"{name}={value:.6g}" for name, value in self.parameters.items())
        return f"<LinePoint: {places}; multiplicity {self.multiplicity}>"

    def refined(self, width: Union[int, str, Fraction]) -> Dict[str, Interval]:
        """A box around the same point, at most `width` wide in every parameter: any width is possible."""
        return {name: _interval(pair) for name, pair in zip("uvrs", self._line._core.box(self._index, width))}


class Line(_Exportable):
    """A parameter line of one patch on the other: plane, cylinder, eliminant, certified points."""

    #: The fixed parameter and its value.
    fixed: Tuple[str, Fraction]
    #: "conic", "straight", "folded" (a segment run through more than once in part), "point", "plane cubic"
    #: or "twisted cubic".
    shape: str
    #: None for a point and a twisted cubic.
    plane: Optional[Plane]
    #: Of a straight or folded line.
    second_plane: Optional[Plane]
    #: In x, y, z; vanishes on the line; None unless it is a conic.
    cylinder: Optional[Polynomial]
    #: In the other patch's second parameter; zero where there is none, as for cubics.
    eliminant: Polynomial
    feasible: Tuple[Branch, ...]
    points: Tuple[LinePoint, ...]
    #: Intervals of the line's parameter where it lies on the other patch.
    on_patch: Tuple[Tuple[End, End], ...]
    incomplete: Tuple[Incomplete, ...]

    def __init__(self, core: Any, title: str, again: Optional[Again] = None):
        super().__init__(core, title, again)
        tree = self.tree
        self.fixed = next(iter(tree["fixed"].items()))
        self.shape = tree["shape"]
        self.plane = self._plane(tree["plane"])
        self.second_plane = self._plane(tree.get("second_plane"))
        self.cylinder = None if tree["cylinder"] is None else _polynomial("xyz", tree["cylinder"]["terms"])
        coefficients = tree["eliminant"]["coefficients"]
        self.eliminant = Polynomial(
            [tree["eliminant"]["variable"]],
            [((i,), coefficients[i]) for i in reversed(range(len(coefficients))) if coefficients[i]],
        )
        self.feasible = tuple(
            Branch(branch["branch"], self._intervals(branch["intervals"])) for branch in tree["feasible"]
        )
        self.points = tuple(self._point(i, point) for i, point in enumerate(tree["points"]))
        self.on_patch = self._intervals(tree["on_patch"])
        self.incomplete = tuple(Incomplete(_box(i["where"]), i["why"], i["reason"]) for i in tree["incomplete"])

    @staticmethod
    def _plane(tree: Optional[Mapping[str, Any]]) -> Optional[Plane]:
        return None if tree is None else Plane(_triple(tree["normal"]), tree["constant"])

    @staticmethod
    def _intervals(tree: Iterable[Mapping[str, Any]]) -> Tuple[Tuple[End, End], ...]:
        def end(e: Mapping[str, Any]) -> End:
            return End(_interval(e["box"]), e["approx"], e["closed"])

        return tuple((end(interval["from"]), end(interval["to"])) for interval in tree)

    def _point(self, index: int, point: Mapping[str, Any]) -> LinePoint:
        name, value = self.fixed
        box = _box(point["box"])
        box[name] = Interval(value, value)
        return LinePoint(
            {parameter: box[parameter] for parameter in "uvrs"},
            tuple(point["on"]),
            {parameter: point["approx"][parameter] for parameter in "uvrs"},
            _triple(point["approx"]["point"]),
            point["multiplicity"],
            point["branch"],
            self,
            index,
        )

    def _facts(self) -> List[Tuple[str, str]]:
        name, value = self.fixed
        facts = super()._facts() + [("line", f"{name} = {value}"), ("shape", self.shape)]
        facts += [("eliminant", f"degree {self.eliminant.degree} in {self.eliminant.variables[0]}")]
        facts += [("points", str(len(self.points)))]
        return facts + [("not decided", reason.why) for reason in self.incomplete]

    def __repr__(self) -> str:
        return "<Line: " + "; ".join(f"{name} {value}" for name, value in self._facts()) + ">"


@dataclass(frozen=True)
class Statement:
    """A proved statement, with the exact number that it speaks of, if there is one."""

    name: str
    statement: str
    value: Optional[Fraction]


@dataclass(frozen=True)
class Unproved:
    """A statement that could not be proved, where, and why."""

    name: str
    where: Dict[str, Interval]
    why: str


class _Implicit(Result):
    #: The method by which the equations were found.
    method: str
    #: The equations vanish on the curve or patch: proved.
    exact: bool
    #: Polynomials by name; empty for splines, see `tree["cells"]`.
    equations: Dict[str, Polynomial]
    proved: Tuple[Statement, ...]
    not_proved: Tuple[Unproved, ...]

    def __init__(self, core: Any, title: str, again: Optional[Again], variables: Mapping[str, Sequence[str]]):
        super().__init__(core, title, again)
        tree = self.tree
        self.method = tree["method"]
        self.exact = tree["exact"]
        self.equations = {
            e["name"]: _polynomial(variables.get(e["name"]) or tree["variables"], e["terms"])
            for e in tree["equations"]
        }
        self.proved = tuple(Statement(s["name"], s["statement"], s.get("value")) for s in tree["proved"])
        self.not_proved = tuple(Unproved(s["name"], _box(s["where"]), s["why"]) for s in tree["not_proved"])

    def bound(self, name: str) -> Optional[Fraction]:
        """The exact value of the proved statement of this name, as "one-sided"; None if it is not proved."""
        return next((statement.value for statement in self.proved if statement.name == name), None)

    def _facts(self) -> List[Tuple[str, str]]:
        facts = super()._facts() + [("method", self.method), ("exact", "yes" if self.exact else "no")]
        for name, polynomial in self.equations.items():
            text = str(polynomial)
            facts.append((name, text if len(text) <= 400 else f"degree {polynomial.degree}, {len(polynomial)} terms"))
        for proved in self.proved:
            value = "" if proved.value is None else f" ({float(proved.value):.3g})"
            facts.append((proved.name, proved.statement + value))
        return facts + [(s.name + " not proved", s.why) for s in self.not_proved]

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.method}, {', '.join(map(repr, self.equations.values()))}>"


class Implicit(_Implicit):
    """Implicit equations of a curve or a patch: `equations` holds f, of a curve of space f and g."""

    #: "planar-curve", "space-curve" or "patch".
    kind: str

    def __init__(self, core: Any, title: str, again: Optional[Again] = None):
        super().__init__(core, title, again, {})
        self.kind = self.tree["kind"]

    @property
    def equation(self) -> Polynomial:
        """The first equation. KeyError for a spline."""
        return self.equations["f"]


class Revolution(_Implicit):
    """An implicit surface of revolution: `equations` holds the profile in r, z and the surface in x, y, z."""

    def __init__(self, core: Any, title: str, again: Optional[Again] = None):
        super().__init__(core, title, again, {"profile": "rz", "surface": "xyz"})

    @property
    def profile(self) -> Polynomial:
        return self.equations["profile"]

    @property
    def surface(self) -> Polynomial:
        return self.equations["surface"]

    @property
    def rings(self) -> Optional[Tuple[Tuple[Interval, Interval], ...]]:
        """Boxes (r, z) of the circles in which the surface crosses its mirrored copy, one in each."""
        rings = self.tree["rings"]
        if rings is None:
            return None
        return tuple((_interval(ring["r"]["box"]), _interval(ring["z"]["box"])) for ring in rings)


@dataclass(frozen=True)
class RayHit:
    """A point of a ray on a surface."""

    surface: str
    #: The number of the point along the ray, from 1 on: equal for hits in one point.
    place: int
    #: Encloses the ray's parameter; both ends are the number itself if it is rational.
    t: Interval
    #: 0 where a curve of parameters of a patch, as a collapsed side, is the one point.
    multiplicity: int
    #: "transversal", "tangential" or "singular".
    contact: str
    #: Of a patch: u and v, if they are not a whole curve.
    parameters: Optional[Dict[str, Interval]]
    #: Approximate.
    point: Tuple[float, float, float]


@dataclass(frozen=True)
class RayOverlap:
    """A closed part of a ray on a surface; without `end` it goes on for ever."""

    surface: str
    begin: Interval
    end: Optional[Interval]


class RayIntersection:
    """All points of a ray on surfaces."""

    #: In exact order along the ray.
    hits: Tuple[RayHit, ...]
    overlaps: Tuple[RayOverlap, ...]
    #: Surfaces on which something may be missing, and why.
    incomplete: Dict[str, str]

    def __init__(self, tree: Mapping[str, Any]):
        #: The content of ray/1 (formats.md).
        self.tree = tree
        self.hits = tuple(
            RayHit(
                hit["surface"],
                hit["place"],
                _interval(hit["t"]["box"]),
                hit["multiplicity"],
                hit["contact"],
                {key: _interval(box) for key, box in hit["parameters"].items()} if "parameters" in hit else None,
                _triple(hit["point"]),
            )
            for hit in tree["hits"]
        )
        self.overlaps = tuple(
            RayOverlap(
                overlap["surface"],
                _interval(overlap["from"]["box"]),
                None if overlap["to"] is None else _interval(overlap["to"]["box"]),
            )
            for overlap in tree["overlaps"]
        )
        self.incomplete = {entry["surface"]: entry["why"] for entry in tree["incomplete"]}

    @property
    def complete(self) -> bool:
        return not self.incomplete

    def __repr__(self) -> str:
        state = "complete" if self.complete else "incomplete"
        return f"<RayIntersection {state}: {len(self.hits)} hits, {len(self.overlaps)} overlaps>"
