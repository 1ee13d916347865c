"""Pictures by matplotlib, where it is installed: for the eye, in doubles."""

from __future__ import annotations

import math
from typing import Any, Dict, Tuple

#: Of components in their order, and of the two patches; told apart by readers who see no colours as well.
_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b37c00", "#3b9fd9", "#000000")
_DASHES = ("solid", (0, (6, 2)), (0, (2, 2)), (0, (6, 2, 2, 2)), (0, (10, 3)), (0, (4, 2, 4, 6)), (0, (1, 3)))
_PATCHES = ("#6fa3cf", "#e3b04b")


def evaluated(patch: Any, first: Any, second: Any) -> Any:
    """Points of a patch in doubles, by numpy."""
    import numpy

    u, v = numpy.broadcast_arrays(numpy.asarray(first, dtype=float), numpy.asarray(second, dtype=float))
    net = numpy.array([[[float(c) for c in point] for point in row] for row in patch.points])
    weights = numpy.array([[float(w) for w in row] for row in patch.weights])

    def basis(t: Any, n: int) -> Any:
        return numpy.stack([math.comb(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)], axis=-1)

    blend = numpy.einsum("...i,...j,ij->...ij", basis(u, patch.degree[0]), basis(v, patch.degree[1]), weights)
    return numpy.einsum("...ij,ijk->...k", blend, net) / blend.sum(axis=(-2, -1))[..., None]


def _style(component: int) -> Dict[str, Any]:
    if component < 0:
        return {"color": "#1b1b1b", "linestyle": "solid"}
    return {"color": _COLOURS[component % len(_COLOURS)], "linestyle": _DASHES[component % len(_DASHES)]}


def draw_patch(patch: Any, axes: Any, options: Dict[str, Any]) -> Any:
    """The patch as a surface in axes of projection "3d", new ones if there are none."""
    import numpy
    from matplotlib import pyplot  # type: ignore[import]

    if axes is None:
        axes = pyplot.figure().add_subplot(projection="3d")
        axes.set(xlabel="x", ylabel="y", zlabel="z")
    t = numpy.linspace(0, 1, 25)
    points = evaluated(patch, t[:, None], t[None, :])
    chosen = {"alpha": 0.5, "color": _PATCHES[0], "linewidth": 0.2, **options}
    axes.plot_surface(points[..., 0], points[..., 1], points[..., 2], **chosen)
    return axes


def _draw_square(axes: Any, result: Any, which: int, names: Tuple[str, str]) -> None:
    rims = [arc for overlap in result.overlaps for chain in overlap.chains for arc in chain]
    for arc in (*result.arcs, *rims):
        points = arc.uv if which == 0 else arc.rs
        axes.plot([p[0] for p in points], [p[1] for p in points], **_style(arc.component))
    for node in result.nodes:
        place = [node.parameters[name] for name in names]
        turns = "turning" in node.kinds
        axes.plot(*place, marker="o" if turns else "s", markersize=4, color="#1b1b1b", markerfacecolor="white" if turns else None)
    axes.set(xlim=(0, 1), ylim=(0, 1), xlabel=names[0], ylabel=names[1], aspect="equal")


def result_figure(result: Any, options: Dict[str, Any]) -> Any:
    """Space and both squares side by side."""
    from matplotlib import pyplot

    figure = pyplot.figure(**{"figsize": (12, 4), "layout": "constrained", **options})
    space = figure.add_subplot(1, 3, 1, projection="3d")
    space.set(xlabel="x", ylabel="y", zlabel="z")
    for patch, colour in zip(result.patches, _PATCHES):
        draw_patch(patch, space, {"color": colour, "alpha": 0.35})
    for arc in result.arcs:
        points = arc.xyz
        space.plot(*([p[k] for p in points] for k in range(3)), **_style(arc.component))
    for which in range(len(result.parameters) // 2):
        names = (result.parameters[2 * which], result.parameters[2 * which + 1])
        _draw_square(figure.add_subplot(1, 3, 2 + which), result, which, names)
    return figure
