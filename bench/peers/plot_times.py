#!/usr/bin/env python3
"""Distribution of the processor times of all programs: DIRECTORY SVG, after bench/peers/run."""
import json
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
from matplotlib import pyplot

FAMILIES = ["random-rational", "random-double", "loop", "tangent", "near", "overlap"]
PROGRAMS = {
    "exsect": ("exsect", "#1b6ca8"),
    "exact": ("exsect --exact", "#7fb2d9"),
    "sisl": ("SISL, 1e-6", "#d1495b"),
    "surfaces": ("Open CASCADE, GeomAPI_IntSS", "#66a182"),
    "section": ("Open CASCADE, BRepAlgoAPI_Section", "#8d6a9f"),
}


def times(path):
    """Milliseconds of the pairs that were answered, ascending, and the number of all pairs."""
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    return sorted(line["milliseconds"] for line in lines if line["status"] == "done"), len(lines)


def main(directory, svg):
    matplotlib.rcParams.update({"svg.hashsalt": "exsect", "font.size": 8, "svg.fonttype": "none"})
    figure, axes = pyplot.subplots(2, 3, figsize=(9.5, 5.5), sharex=True, sharey=True)
    for axis, family in zip(axes.flat, FAMILIES):
        for name, (label, colour) in PROGRAMS.items():
            path = directory / f"{family}.{name}"
            if not path.exists():
                continue
            values, count = times(path)
            shown = sorted({*range(0, len(values), 1 + len(values) // 200), len(values) - 1})
            axis.step([values[i] for i in shown], [100 * (i + 1) / count for i in shown], where="post",
                      label=label, color=colour, linewidth=1.2)
        axis.set_title(f"{family} ({count})")
        axis.set_xscale("log")
        axis.grid(alpha=0.3)
    for axis in axes[1]:
        axis.set_xlabel("ms of processor time")
    for axis in axes[:, 0]:
        axis.set_ylabel("% of the pairs answered")
    figure.legend(*axes[0][0].get_legend_handles_labels(), loc="lower center", ncol=5, frameon=False)
    figure.tight_layout(rect=(0, 0.04, 1, 1))
    figure.savefig(svg, metadata={"Date": None, "Creator": None})


main(pathlib.Path(sys.argv[1]), sys.argv[2])
