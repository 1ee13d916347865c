"""What is proved of other programs' answers, and of certificates."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Dict, List, Mapping, Optional, Tuple

from ._results import Again, Result


@dataclass(frozen=True)
class Difference:
    """A proved difference between a candidate and the true curve."""

    #: "lost-curve", "gap", "spurious-curve", "wrong-connection", "split", "repeated", "curve-as-points",
    #: "false-point", "point-on-curve", "lost-point", "repeated-point", "wrong-contact".
    kind: str
    #: In words.
    text: str
    #: Ids of components of the true curve.
    components: Tuple[int, ...]
    #: Index of the candidate's curve, or of its point.
    curve: Optional[int]
    point: Optional[int]
    #: Id of an arc of the true curve with the open interval of a parameter that is not covered; of two surfaces given
    #: by their equations there is no parameter. `vertices`: the same on the arc's polyline, rounded outwards.
    arc: Optional[int]
    gap: Optional[Tuple[str, Fraction, Fraction]]
    vertices: Optional[Tuple[int, int]]

    def __repr__(self) -> str:
        return f"<Difference: {self.kind}: {self.text}>"


def _difference(tree: Mapping[str, Any]) -> Difference:
    gap = tree.get("gap")
    return Difference(
        tree["kind"],
        tree["text"],
        tuple(tree["components"]),
        tree.get("curve"),
        tree.get("point"),
        tree.get("arc"),
        None if gap is None or "parameter" not in gap else (gap["parameter"], gap["from"], gap["to"]),
        None if gap is None else (gap["vertices"][0], gap["vertices"][1]),
    )


class Verdict(Result):
    """A candidate for the intersection of two shapes, held against the proved one."""

    #: "agrees", "disagrees" or "undecided".
    verdict: str
    #: In the units of the model.
    absolute_tolerance: float
    #: Each of them proved.
    differences: Tuple[Difference, ...]
    #: What could not be decided.
    undecided: Tuple[str, ...]

    def __init__(self, core: Any, title: str, again: Optional[Again] = None):
        super().__init__(core, title, again)
        tree = self.tree
        self.verdict = tree["verdict"]
        self.absolute_tolerance = tree["tolerance"]
        self.differences = tuple(_difference(difference) for difference in tree["differences"])
        self.undecided = tuple(tree["undecided"])

    @property
    def agrees(self) -> bool:
        """Proved: the candidate is the whole intersection, within the tolerance, joined in the same way."""
        return self.verdict == "agrees"

    def _facts(self) -> List[Tuple[str, str]]:
        facts = [("verdict", self.verdict), ("tolerance", f"{self.absolute_tolerance:.3g}")]
        return facts + [(d.kind, d.text) for d in self.differences] + [("not decided", u) for u in self.undecided]

    def __repr__(self) -> str:
        return f"<Verdict: {self.verdict} within {self.absolute_tolerance:.3g}, {len(self.differences)} differences>"


class Comparison(Result):
    """The methods of the chapter on one pair of patches; `methods` has a row for each, as in the JSON result."""

    methods: Tuple[Dict[str, Any], ...]

    def __init__(self, core: Any, title: str, again: Optional[Again] = None):
        super().__init__(core, title, again)
        self.methods = tuple(self.tree["methods"])

    def _facts(self) -> List[Tuple[str, str]]:
        rows = [(f"{m['method']} ({m['detail']})", f"{m['found']['number']} found, {m['answer']}") for m in self.methods]
        return super()._facts() + rows

    def __repr__(self) -> str:
        return f"<Comparison: {', '.join(m['method'] for m in self.methods)}>"


@dataclass(frozen=True)
class Check:
    """What replaying a certificate gave; true if it was accepted."""

    accepted: bool
    #: Where and why it was rejected.
    place: str
    reason: str
    #: Numbers of what is proved: components, closed, open, branched, isolated, nodes, arcs; of a line: points.
    summary: Dict[str, int]

    def __bool__(self) -> bool:
        return self.accepted
