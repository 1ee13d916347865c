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

import os
from fractions import Fraction
from typing import Any, Callable, Dict, Iterable, Mapping, Optional, Sequence, Tuple, Union

from . import _core
from ._core import Curve, InputError, Patch
from ._core import __version__ as __version__
from ._results import (
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
    Revolution,
    Statement,
    Unproved,
)

__all__ = [
    "Arc",
    "Branch",
    "Component",
    "Curve",
    "End",
    "Implicit",
    "Incomplete",
    "InputError",
    "Intersection",
    "Interval",
    "Line",
    "LinePoint",
    "Node",
    "Overlap",
    "Patch",
    "Plane",
    "Polynomial",
    "Revolution",
    "Statement",
    "Unproved",
    "implicitize",
    "intersect",
    "line",
    "read_curve",
    "read_patches",
    "revolve",
    "self_intersect",
    "write_patches",
]

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


def intersect(
    x: Patch,
    y: Patch,
    *,
    turning: Union[str, Iterable[str], None] = "u,v,r,s",
    tolerance: Union[Number, float] = "1e-6",
    max_seconds: Union[Number, float, None] = None,
    exact: bool = False,
    names: Tuple[str, str] = ("x", "y"),
    title: str = "",
    progress: Optional[Progress] = None,
) -> Intersection:
    """Every point of x(u,v) = y(r,s), as a graph of nodes and arcs.

    `turning`: parameters whose turning points become nodes. `tolerance` bounds the proved distance of polylines,
    relative to the size of the model. After `max_seconds` the result is incomplete. `exact` skips the solution in
    floating point with proved errors; the graph is the same. `progress` is called now and then with a fraction and
    the name of the step; an interrupt from the keyboard is seen at these times.
    ValueError for options out of range.
    """
    limit = "" if max_seconds is None else _text(max_seconds)
    core = _core.intersect(x, y, list(names), _turning(turning), _text(tolerance), limit, exact, progress)
    return Intersection(core, title)


def self_intersect(
    x: Patch,
    *,
    turning: Union[str, Iterable[str], None] = "u1,v1,u2,v2",
    tolerance: Union[Number, float] = "1e-6",
    max_seconds: Union[Number, float, None] = None,
    name: str = "x",
    title: str = "",
    progress: Optional[Progress] = None,
) -> Intersection:
    """Where a patch meets itself: all x(u1,v1) = x(u2,v2) of different parameters, each curve once.

    Nodes of kind "cusp" are the cuspidal points in which such curves end. Options as for intersect.
    """
    limit = "" if max_seconds is None else _text(max_seconds)
    core = _core.self_intersect(x, name, _turning(turning), _text(tolerance), limit, progress)
    return Intersection(core, title)


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
    return Line(_core.line(x, y, list(names), name, value), title)


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
    return Implicit(_core.implicitize(shape, options), title)


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
    core = _core.revolve(profile, options, patch, patch_name, [_text(u) for u in lines])
    return Revolution(core, title)


def read_patches(path: Union[str, "os.PathLike[str]"]) -> Dict[str, Patch]:
    """The patches of a file patches/1 by name, in the order of the file. InputError names file, place and reason."""
    return dict(_core.read_patches(os.fspath(path)))


def write_patches(path: Union[str, "os.PathLike[str]"], patches: Mapping[str, Patch], *, title: str = "") -> None:
    """Writes a file patches/1, whole or not at all. OSError if it cannot be written."""
    _core.write_patches(os.fspath(path), dict(patches), title)


def read_curve(path: Union[str, "os.PathLike[str]"]) -> Curve:
    """The curve of a file curve/1. InputError names file, place and reason."""
    return _core.read_curve(os.fspath(path))
