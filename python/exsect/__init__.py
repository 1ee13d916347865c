"""Exact, certified intersection of biquadratic Bezier surface patches.

>>> import exsect
>>> x = exsect.Patch([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]])
>>> y = exsect.Patch([[[0, 0, "1/4"], [0, 1, "1/4"]], [[1, 0, "1/4"], [1, 1, "1/4"]]])
>>> result = exsect.intersect(x, y)
>>> result.complete, result.count("open")
(True, 1)
>>> exsect.line(x, y, u="1/2").points[0].box["v"]
Interval(lower=Fraction(1, 2), upper=Fraction(1, 2))

Numbers are exact: int, fractions.Fraction, decimal.Decimal, or strings such as "3/7", "0.1" (exactly 1/10) and
"0x1.8p-3". Floats are taken only by Patch.from_floats and Curve.from_floats. Functions release the interpreter's
lock while they work and raise ValueError with the library's own text.
"""

from __future__ import annotations

import itertools
import json
import os
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any, Callable, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Tuple, Union, overload

from . import _core
from ._core import Curve, InputError, NoCertificate, Patch, Surface
from ._core import __version__ as __version__
from ._results import (
    Again,
    Arc,
    Branch,
    Component,
    End,
    Implicit,
    Incomplete,
    Intersection,
    Interval,
    Line,
    LinePoint,
    Node,
    Overlap,
    Plane,
    Polynomial,
    RayHit,
    RayIntersection,
    RayOverlap,
    Revolution,
    SpaceArc,
    SpaceCurve,
    SpaceNode,
    Statement,
    SurfaceIntersection,
    Unproved,
)
from ._verdict import Check, Comparison, Difference, Verdict

__all__ = [
    "Arc",
    "Branch",
    "Check",
    "Comparison",
    "Component",
    "Curve",
    "Difference",
    "End",
    "Implicit",
    "Incomplete",
    "InputError",
    "Intersection",
    "Interval",
    "Line",
    "LinePoint",
    "NoCertificate",
    "Node",
    "Overlap",
    "Patch",
    "Plane",
    "Polynomial",
    "RayHit",
    "RayIntersection",
    "RayOverlap",
    "Revolution",
    "SpaceArc",
    "SpaceCurve",
    "SpaceNode",
    "Statement",
    "Surface",
    "SurfaceIntersection",
    "Unproved",
    "Verdict",
    "check",
    "compare",
    "cone",
    "cylinder",
    "implicit",
    "implicitize",
    "intersect",
    "intersect_all",
    "line",
    "plane",
    "ray",
    "read_curve",
    "read_patches",
    "revolve",
    "self_intersect",
    "sphere",
    "torus",
    "verify",
    "write_patches",
]


def __dir__() -> List[str]:
    return sorted(__all__)


Number = Union[int, str, Fraction]
Progress = Callable[[float, str], object]


def _text(value: Any) -> str:
    """An option as the program takes it: "1/2", "3", "x"; lists with commas."""
    if isinstance(value, (list, tuple)):
        return ",".join(_text(item) for item in value)
    if isinstance(value, float):
        return value.hex() if value == value and abs(value) != float("inf") else str(value)
    return str(value)


def _turning(parameters: Union[str, Iterable[str], None]) -> str:
    if parameters is None:
        return "none"
    return parameters if isinstance(parameters, str) else ",".join(parameters) or "none"


def _relative(tolerance: Any, absolute: Any, *patches: Patch) -> str:
    """The tolerance relative to the size of the model: the largest extent of all control points, taken exactly."""
    if absolute is None:
        return _text(tolerance)
    points = [point for patch in patches for row in patch.points for point in row]
    size = max(max(p[k] for p in points) - min(p[k] for p in points) for k in range(3))
    try:
        length = Fraction(absolute)
    except (TypeError, ValueError, ZeroDivisionError, OverflowError):
        raise ValueError(f"absolute_tolerance: {absolute!r} is not a number") from None
    if length <= 0:
        raise ValueError("absolute_tolerance: must be > 0")
    if size == 0:
        return _text(tolerance)
    # Rounded down by more than the conversion to a double can round up.
    return _text(length / size * (1 - Fraction(1, 2**50)))


def _relative_of(x: Any, y: Any, tolerance: Any, absolute: Any) -> str:
    """As above, of the patches among the two; two surfaces given by their equations have no such size."""
    patches = [shape for shape in (x, y) if isinstance(shape, Patch)]
    if not patches and absolute is not None:
        raise ValueError("absolute_tolerance: not with two surfaces given by their equations")
    return _relative(tolerance, absolute, *patches)


def _same_again(function: str, *arguments: Any, progress: Any = ()) -> Tuple[Any, Again]:
    """The compiled result, and what computes it again after pickling: without a progress function."""
    again = Again(function, arguments if progress == () else (*arguments, None))
    return getattr(_core, function)(*arguments, *((progress,) if progress != () else ())), again


def _entry_number(value: Any, where: str) -> str:
    """An exact number as the text of a patch file."""
    if isinstance(value, str):
        return value
    if isinstance(value, float):
        raise TypeError(f"{where}: a float is not taken, give an int, a Fraction or a string")
    return str(Fraction(value))


def _entry_vector(values: Sequence[Any], where: str) -> List[str]:
    return [_entry_number(value, where) for value in values]


def _entry_box(value: Any, where: str) -> Any:
    """A box as a patch file has it."""
    if isinstance(value, Mapping):
        return {key: _entry_box(part, f"{where}.{key}") for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [_entry_box(part, where) for part in value]
    return _entry_number(value, where)


def _lengths(**given: Any) -> Dict[str, str]:
    return {key: _entry_number(value, key) for key, value in given.items() if value is not None}


def _surface(kind: str, box: Optional[Mapping[str, Any]] = None, **members: Any) -> Surface:
    if box is not None:
        members["box"] = _entry_box(box, "box")
    return Surface(json.dumps({"name": kind, "type": kind, **members}))


Vector = Sequence[Number]


def plane(point: Vector, normal: Vector, *, box: Optional[Mapping[str, Any]] = None) -> Surface:
    """The plane through the point; directions here and below are of any length but 0. `box`, here and below: the
    part that a patch file says so (docs/formats.md), as {"sides": [[2, 0, 0], [0, 3, 0]]}."""
    return _surface("plane", box, point=_entry_vector(point, "point"), normal=_entry_vector(normal, "normal"))


def cylinder(
    point: Vector,
    axis: Vector,
    radius: Optional[Number] = None,
    *,
    radius_squared: Optional[Number] = None,
    box: Optional[Mapping[str, Any]] = None,
) -> Surface:
    """The cylinder about the line through the point; the radius, or its square where it is irrational."""
    lengths = _lengths(radius=radius, radius_squared=radius_squared)
    return _surface("cylinder", box, point=_entry_vector(point, "point"), axis=_entry_vector(axis, "axis"), **lengths)


def cone(
    apex: Vector,
    axis: Vector,
    slope: Optional[Number] = None,
    *,
    slope_squared: Optional[Number] = None,
    nappes: int = 1,
    box: Optional[Mapping[str, Any]] = None,
) -> Surface:
    """The cone of radius slope * height; one nappe, the one that the axis points to, or both."""
    lengths = _lengths(slope=slope, slope_squared=slope_squared)
    vectors = {"apex": _entry_vector(apex, "apex"), "axis": _entry_vector(axis, "axis")}
    return _surface("cone", box, **vectors, **lengths, nappes=nappes)


def sphere(
    centre: Vector,
    radius: Optional[Number] = None,
    *,
    radius_squared: Optional[Number] = None,
    box: Optional[Mapping[str, Any]] = None,
) -> Surface:
    """The sphere; the radius, or its square where it is irrational."""
    lengths = _lengths(radius=radius, radius_squared=radius_squared)
    return _surface("sphere", box, centre=_entry_vector(centre, "centre"), **lengths)


def torus(
    centre: Vector,
    axis: Vector,
    major: Optional[Number] = None,
    minor: Optional[Number] = None,
    *,
    major_squared: Optional[Number] = None,
    minor_squared: Optional[Number] = None,
    box: Optional[Mapping[str, Any]] = None,
) -> Surface:
    """The torus of radii 0 < minor < major."""
    lengths = _lengths(major=major, major_squared=major_squared, minor=minor, minor_squared=minor_squared)
    return _surface("torus", box, centre=_entry_vector(centre, "centre"), axis=_entry_vector(axis, "axis"), **lengths)


def implicit(terms: Mapping[Tuple[int, int, int], Number]) -> Surface:
    """The zeros of a polynomial of degree 1 to 4: coefficients by exponents of x, y, z, as in Polynomial."""
    return _surface("implicit", terms=[[_entry_number(c, "terms"), list(e)] for e, c in terms.items()])


def ray(
    origin: Vector, direction: Vector, surfaces: Union[Patch, Surface, Mapping[str, Union[Patch, Surface]]]
) -> RayIntersection:
    """All points origin + t direction, t >= 0, on one surface or on several by name, in exact order along the ray.

    The surfaces are patches of every kind and surfaces given by their equations. ValueError for a direction of
    length 0.
    """
    named = surfaces if isinstance(surfaces, Mapping) else {"surface": surfaces}
    if not named:
        raise ValueError("surfaces: at least one is needed")
    return RayIntersection(_core.ray(list(origin), list(direction), dict(named)))


def _intersect_equation(
    x: Any, y: Any, turning: str, tolerance: str, limit: str, names: Tuple[str, str], title: str, progress: Any
) -> Intersection:
    surface, patch, ordered = (x, y, names[::-1]) if isinstance(x, Surface) else (y, x, names)
    core, again = _same_again(
        "intersect_equation", surface, patch, list(ordered), turning, tolerance, limit, progress=progress
    )
    return Intersection(core, title, again)


@overload
def intersect(
    x: Surface,
    y: Surface,
    *,
    tolerance: Union[Number, float] = ...,
    max_seconds: Union[Number, float, None] = ...,
    names: Tuple[str, str] = ...,
    title: str = ...,
    progress: Optional[Progress] = ...,
) -> SurfaceIntersection: ...


@overload
def intersect(
    x: Patch,
    y: Union[Patch, Surface],
    *,
    turning: Union[str, Iterable[str], None] = ...,
    tolerance: Union[Number, float] = ...,
    absolute_tolerance: Union[Number, float, None] = ...,
    max_seconds: Union[Number, float, None] = ...,
    exact: bool = ...,
    names: Tuple[str, str] = ...,
    title: str = ...,
    progress: Optional[Progress] = ...,
) -> Intersection: ...


@overload
def intersect(
    x: Surface,
    y: Patch,
    *,
    turning: Union[str, Iterable[str], None] = ...,
    tolerance: Union[Number, float] = ...,
    absolute_tolerance: Union[Number, float, None] = ...,
    max_seconds: Union[Number, float, None] = ...,
    exact: bool = ...,
    names: Tuple[str, str] = ...,
    title: str = ...,
    progress: Optional[Progress] = ...,
) -> Intersection: ...


def intersect(
    x: Union[Patch, Surface],
    y: Union[Patch, Surface],
    *,
    turning: Union[str, Iterable[str], None] = "u,v,r,s",
    tolerance: Union[Number, float] = "1e-6",
    absolute_tolerance: Union[Number, float, None] = None,
    max_seconds: Union[Number, float, None] = None,
    exact: bool = False,
    names: Tuple[str, str] = ("x", "y"),
    title: str = "",
    progress: Optional[Progress] = None,
) -> Union[Intersection, SurfaceIntersection]:
    """Every point of x(u,v) = y(r,s), as a graph of nodes and arcs.

    One of the two may be a surface given by its equation: then the patch has the parameters u and v, there are no
    others, and the solution is exact. Of two such surfaces the curves are found as a SurfaceIntersection, exactly; then
    `tolerance` is relative to the extent of what is drawn, and `turning`, `absolute_tolerance` and `exact` are not
    taken.

    `turning`: parameters whose turning points become nodes. `tolerance` bounds the proved distance of polylines,
    relative to the size of the model (the largest extent of all control points); `absolute_tolerance`, if it is
    given, in the units of the model instead. After `max_seconds` the result is incomplete. `exact` skips the solution in
    floating point with proved errors; the graph is the same. `progress` is called now and then with a fraction and
    the name of the step; an interrupt from the keyboard is seen at these times.
    ValueError for options out of range.
    """
    limit = "" if max_seconds is None else _text(max_seconds)
    relative = _relative_of(x, y, tolerance, absolute_tolerance)
    if isinstance(x, Surface) and isinstance(y, Surface):
        core, again = _same_again("intersect_surfaces", x, y, list(names), relative, limit, progress=progress)
        return SurfaceIntersection(core, title, again)
    if not (isinstance(x, Patch) and isinstance(y, Patch)):
        return _intersect_equation(x, y, _turning(turning), relative, limit, names, title, progress)
    core, again = _same_again(
        "intersect", x, y, list(names), _turning(turning), relative, limit, exact, progress=progress
    )
    return Intersection(core, title, again)


def intersect_all(
    patches: Union[Mapping[str, Patch], Sequence[Patch]],
    pairs: Optional[Iterable[Tuple[Any, Any]]] = None,
    *,
    jobs: Optional[int] = None,
    **options: Any,
) -> Iterator[Tuple[Any, Any, Intersection]]:
    """Intersects many pairs in `jobs` threads (one for each processor): (first, second, result), in order.

    `patches` by name, as read_patches gives them, or in a list, where names are indices. Without `pairs` all pairs
    of different patches, the first before the second. Options as for intersect; errors are raised when their
    pair's turn comes. A batch that is written to a file, resumable and in shards, is `exsect batch`.
    """
    named: Dict[Any, Patch] = dict(patches) if isinstance(patches, Mapping) else dict(enumerate(patches))
    chosen = list(itertools.combinations(named, 2)) if pairs is None else [(first, second) for first, second in pairs]
    for name in itertools.chain.from_iterable(chosen):
        if name not in named:
            raise ValueError(f"there is no patch {name!r}")

    def solve(pair: Tuple[Any, Any]) -> Intersection:
        first, second = pair
        chosen_options: Dict[str, Any] = {"names": (str(first), str(second)), **options}
        return intersect(named[first], named[second], **chosen_options)

    def results() -> Iterator[Tuple[Any, Any, Intersection]]:
        with ThreadPoolExecutor(jobs or os.cpu_count() or 1) as pool:
            for (first, second), result in zip(chosen, pool.map(solve, chosen)):
                yield first, second, result

    return results()


def verify(
    candidate: Union[str, "os.PathLike[str]", Mapping[str, Any]],
    x: Union[Patch, Surface],
    y: Union[Patch, Surface],
    *,
    tolerance: Union[Number, float] = "1e-6",
    absolute_tolerance: Union[Number, float, None] = None,
    max_seconds: Union[Number, float, None] = None,
    names: Tuple[str, str] = ("x", "y"),
    title: str = "",
) -> Verdict:
    """Holds what another program computed against the proved intersection of x and y.

    `candidate`: a file of form candidate/1, CSV, OBJ or g2 (formats.md), or a dictionary in the shape of
    candidate/1. Tolerances and `max_seconds` as for intersect. A surface given by its equation has no parameters,
    so a candidate that states some of it is a ValueError, as are two such surfaces that are one or have a common
    curve that goes on to infinity. InputError, with file and place, for a candidate that is not of its form.
    """
    if isinstance(candidate, Mapping):
        text, filename = json.dumps(candidate).encode(), "candidate.json"
    else:
        filename = os.fspath(candidate)
        text = _core.candidate_bytes(filename)
    limit = "" if max_seconds is None else _text(max_seconds)
    relative = _relative_of(x, y, tolerance, absolute_tolerance)
    if isinstance(x, Surface) and isinstance(y, Surface):
        return Verdict(*_titled("verify_surfaces", title, text, filename, x, y, list(names), relative, limit))
    if isinstance(x, Patch) and isinstance(y, Patch):
        return Verdict(*_titled("verify", title, text, filename, x, y, list(names), relative, limit))
    is_exchanged = isinstance(x, Surface)
    patch, surface, ordered = (y, x, names[::-1]) if is_exchanged else (x, y, names)
    arguments = (text, filename, patch, surface, list(ordered), is_exchanged, relative, limit)
    return Verdict(*_titled("verify_equation", title, *arguments))


def compare(
    x: Patch,
    y: Patch,
    *,
    lines: int = 64,
    pieces: int = 2,
    fit: str = "conics",
    plane: str = "u,r",
    names: Tuple[str, str] = ("x", "y"),
    title: str = "",
) -> Comparison:
    """The methods of the chapter side by side on one pair; the options are those of `exsect compare`."""
    return Comparison(*_titled("compare", title, x, y, list(names), lines, pieces, fit, plane))


def check(certificate: str) -> Check:
    """Replays the proof in a certificate, given as its text (Intersection.to_certificate, or the content of a file).

    Every polynomial is computed anew from the control points in it, by code that shares nothing with the solver.
    ValueError for text that is no certificate.
    """
    found = _core.check(certificate)
    return Check(found["accepted"], found["place"], found["reason"], dict(found["summary"]))


def _titled(function: str, title: str, *arguments: Any) -> Tuple[Any, str, Again]:
    core, again = _same_again(function, *arguments)
    return core, title, again


def self_intersect(
    x: Patch,
    *,
    turning: Union[str, Iterable[str], None] = "u1,v1,u2,v2",
    tolerance: Union[Number, float] = "1e-6",
    absolute_tolerance: Union[Number, float, None] = None,
    max_seconds: Union[Number, float, None] = None,
    name: str = "x",
    title: str = "",
    progress: Optional[Progress] = None,
) -> Intersection:
    """Where a patch meets itself: all x(u1,v1) = x(u2,v2) of different parameters, each curve once.

    Nodes of kind "cusp" are the cuspidal points in which such curves end. Options as for intersect.
    """
    limit = "" if max_seconds is None else _text(max_seconds)
    relative = _relative(tolerance, absolute_tolerance, x)
    core, again = _same_again("self_intersect", x, name, _turning(turning), relative, limit, progress=progress)
    return Intersection(core, title, again)


def line(
    x: Patch,
    y: Patch,
    *,
    u: Optional[Number] = None,
    v: Optional[Number] = None,
    r: Optional[Number] = None,
    s: Optional[Number] = None,
    names: Tuple[str, str] = ("x", "y"),
    title: str = "",
) -> Line:
    """One parameter line of x (give u or v) or y (give r or s) on the other patch.

    Exactly one parameter is given, an exact number in [0,1]; ValueError otherwise.
    """
    given = {name: value for name, value in zip("uvrs", (u, v, r, s)) if value is not None}
    if len(given) != 1:
        raise ValueError("give only one of u, v, r, s" if given else "give one of u, v, r, s")
    ((name, value),) = given.items()
    return Line(*_titled("line", title, x, y, list(names), name, value))


def implicitize(
    shape: Union[Curve, Patch],
    *,
    method: Optional[str] = None,
    degree: Optional[int] = None,
    space: Optional[str] = None,
    cells: Optional[int] = None,
    samples: Optional[int] = None,
    w1: Optional[Number] = None,
    w2: Optional[Number] = None,
    digits: Optional[int] = None,
    box: Optional[Sequence[Number]] = None,
    axis: Optional[str] = None,
    factor_degree: Optional[int] = None,
    epsilon: Optional[Number] = None,
    variables: Optional[Sequence[str]] = None,
    exact_arithmetic: bool = False,
    title: str = "",
) -> Implicit:
    """Implicit equations of a curve of the plane or of space, or of a patch.

    Without `degree` the equation is exact. Methods with a degree: "least-squares", "bernstein", "legendre",
    "chebyshev", "lagrange" for a planar curve; "dokken", "conics" for a patch. A curve of space gets two surfaces:
    "cylinders", "orthogonal" or "root-free". The options are those of `exsect implicitize`; ValueError, in the
    program's words, for those that the method does not have and for values out of range.
    """
    given = {
        "method": method,
        "degree": degree,
        "space": space,
        "cells": cells,
        "samples": samples,
        "w1": w1,
        "w2": w2,
        "digits": digits,
        "box": box,
        "axis": axis,
        "factor_degree": factor_degree,
        "epsilon": epsilon,
        "variables": variables,
        "exact_arithmetic": exact_arithmetic or None,
    }
    options = {name: _text(value) for name, value in given.items() if value is not None}
    return Implicit(*_titled("implicitize", title, shape, options))


def revolve(
    profile: Curve,
    *,
    method: str = "elimination",
    degree: Union[int, Tuple[int, int], None] = None,
    cells: Union[int, Tuple[int, int], None] = None,
    samples: Optional[int] = None,
    w1: Optional[Number] = None,
    w2: Optional[Number] = None,
    region: Optional[Sequence[Number]] = None,
    patch: Optional[Patch] = None,
    patch_name: str = "x",
    lines: Sequence[Number] = (),
    title: str = "",
) -> Revolution:
    """The implicit surface that a planar curve (r,z), r >= 0, sweeps about the z axis.

    `method`: "elimination", "product" or "substitution". Without `degree` the profile's equation is exact; a pair
    is a degree in r and one in z. Rings and branches are looked for in the `region` (b, c, d): 0 < r <= b,
    c <= z <= d. With a `patch` the curve on it is in `tree["patch"]`, with the exact points on the `lines`
    u = const. ValueError as the program says it.
    """

    def pair(value: Union[int, Tuple[int, int], None]) -> Optional[str]:
        return value if value is None else "x".join(map(str, value)) if isinstance(value, tuple) else str(value)

    given = {
        "method": method,
        "degree": pair(degree),
        "cells": pair(cells),
        "samples": samples,
        "w1": w1,
        "w2": w2,
        "region": region,
    }
    options = {name: _text(value) for name, value in given.items() if value is not None}
    texts = [_text(u) for u in lines]
    return Revolution(*_titled("revolve", title, profile, options, patch, patch_name, texts))


def read_patches(path: Union[str, "os.PathLike[str]"]) -> Dict[str, Patch]:
    """The patches of a file patches/1 by name, in the order of the file. InputError names file, place and reason."""
    return dict(_core.read_patches(os.fspath(path)))


def write_patches(path: Union[str, "os.PathLike[str]"], patches: Mapping[str, Patch], *, title: str = "") -> None:
    """Writes a file patches/1, whole or not at all. OSError if it cannot be written."""
    _core.write_patches(os.fspath(path), dict(patches), title)


def read_curve(path: Union[str, "os.PathLike[str]"]) -> Curve:
    """The curve of a file curve/1. InputError names file, place and reason."""
    return _core.read_curve(os.fspath(path))


def _evaluate(patch: Patch, first: Any, second: Any) -> Any:
    """Points in doubles at arrays of parameters: an array of the broadcast shape with x, y, z in the last axis.

    Needs numpy; ImportError where it is not installed. The error is that of the doubles: patch(u, v) is exact.
    """
    from ._plot import evaluated

    return evaluated(patch, first, second)


def _plot_patch(patch: Patch, axes: Any = None, **options: Any) -> Any:
    """Draws the patch by matplotlib in axes of projection "3d", by default new ones, and returns them.

    Options go to plot_surface. ImportError where matplotlib is not installed.
    """
    from ._plot import draw_patch

    return draw_patch(patch, axes, options)


setattr(Patch, "evaluate", _evaluate)
setattr(Patch, "plot", _plot_patch)
