#!/usr/bin/env python3
"""Tables of a comparison, after bench/peers/run: DIRECTORY. Markdown on the standard output, see bench/README.md."""

import collections
import json
import pathlib
import statistics
import sys

PAIR_FAMILIES = ["random-rational", "random-double", "loop", "tangent", "near", "overlap"]
DEGREE_FAMILIES = ["bicubic", "weighted", "weighted-bicubic"]
PEERS = ["sisl", "surfaces", "section"]
PROGRAMS = ["exsect", "exact", "sisl", "surfaces", "section"]
LINE_FAMILIES = ["random-rational", "random-double"]
LINE_PROGRAMS = ["exsect", "exact", "sisl", "occt"]
LINES_OF_A_PAIR = 15
KINDS = ["lost-curve", "curve-as-points", "wrong-connection", "split", "gap", "spurious-curve", "repeated",
         "false-point", "point-on-curve", "lost-point"]


def read(path):
    """The results of one program, without the curves and with what judge.py says of each, as far as it does."""
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    for line in lines:
        line.pop("curves", None)
    judged = path.with_name(path.name + ".judged")
    verdicts = map(json.loads, judged.read_text().splitlines()) if judged.exists() else []
    by_name = {verdict["name"]: verdict for verdict in verdicts}
    return [by_name.get(line["name"], {}) | line for line in lines]


def table(heads, rows):
    print(f"\n| {' | '.join(heads)} |\n|{'---|' * len(heads)}")
    for row in rows:
        print(f"| {' | '.join(map(str, row))} |")


def times(results):
    """Milliseconds by the name of the pair."""
    return {line["name"]: line["milliseconds"] for line in results if line["status"] == "done"}


def ratio(own, other):
    """The median of own / other, pair by pair."""
    common = own.keys() & other.keys()
    return f"{statistics.median(own[name] / other[name] for name in common):.2g}" if common else ""


def total(results, key):
    result = collections.Counter()
    for line in results:
        result.update(line.get(key, {}))
    return result


def pair_row(results, filtered, exact):
    taken = times(results)
    statuses = collections.Counter(line["status"] for line in results)
    done = [line for line in results if line["status"] == "done"]
    components, differences = total(done, "components"), total(done, "differences")
    largest = {key: max((line.get(key, 0) for line in done), default=0) for key in ("residual", "bound", "distance")}
    declined = sum(not line["in_doubles"] for line in done) if done and "in_doubles" in done[0] else ""
    is_exsect = declined != ""
    return [results[0]["program"], f"{statistics.median(taken.values()):.3g} / {max(taken.values()):.3g}",
            "" if is_exsect else ratio(filtered, taken), "" if is_exsect else ratio(exact, taken), declined,
            f"{statuses['timeout']} / {len(results) - statuses['done'] - statuses['timeout']}",
            " / ".join(str(components[c]) for c in ("covered", "partly", "missed")),
            f"{sum(line.get('invented', 0) for line in done)} / {differences['false-point']}",
            *(f"{largest[key]:.0e}" for key in ("residual", "bound", "distance"))]


def pair_tables(directory):
    heads = ["program", "median / worst ms", "exsect/peer", "--exact/peer", "exact path", "time-outs / errors",
             "curves found / partly / lost", "invented curves / points", "residual", "bound", "distance"]
    for family in PAIR_FAMILIES:
        results = [read(directory / f"{family}.{program}") for program in PROGRAMS]
        filtered, exact = times(results[0]), times(results[1])
        print(f"\n**{family}**: {len(results[0])} pairs")
        table(heads, (pair_row(lines, filtered, exact) for lines in results))


def outcomes(results):
    """Numbers of pairs: complete, incomplete, without an answer."""
    done = [line for line in results if line["status"] == "done"]
    incomplete = sum(not line.get("complete", True) for line in done)
    return f"{len(done) - incomplete} / {incomplete} / {len(results) - len(done)}"


def degree_table(directory):
    """Patches of other kinds, in doubles, and what they take in multiples of random-double."""
    base = statistics.median(times(read(directory / "random-double.exsect")).values())
    rows = []
    for family in DEGREE_FAMILIES:
        for program in ["exsect", *PEERS]:
            results = read(directory / f"{family}.{program}")
            own, taken = times(read(directory / f"{family}.exsect")), times(results)
            components = total([line for line in results if line["status"] == "done"], "components")
            median = statistics.median(taken.values())
            rows.append([family, results[0]["program"], f"{median:.3g} / {max(taken.values()):.3g}",
                         f"{median / base:.2g}" if program == "exsect" else "",
                         "" if program == "exsect" else ratio(own, taken), outcomes(results),
                         " / ".join(str(components[c]) for c in ("covered", "partly", "missed"))])
    table(["family", "program", "median / worst ms", "/ random-double", "exsect/peer", "complete / incomplete / no answer",
           "curves found / partly / lost"], rows)


def other_lengths(results, reference):
    """Of the pairs that both answer, those whose curves differ in length by more than a thousandth."""
    lengths = {line["name"]: line["length"] for line in reference if line["status"] == "done"}
    return sum(abs(line["length"] - lengths[line["name"]]) > 1e-3 * max(lengths[line["name"]], line["length"])
               for line in results if line["status"] == "done" and line["name"] in lengths)


def round_table(directory):
    """Pairs by equations: with doubles first, exact ones, and Open CASCADE."""
    rows = []
    for pairs in sorted(directory.glob("*.round"), key=lambda path: path.stat().st_mtime):
        family = pairs.stem
        ours, exact, surfaces, section = (
            read(directory / f"{family}.{program}") for program in ("exsect", "exact", *PEERS[1:]))
        own = times(ours)
        row = [family, f"{statistics.median(own.values()):.3g} / {max(own.values()):.3g}", outcomes(ours),
               f"{statistics.median(times(exact).values()):.3g}"]
        for results in (surfaces, section):
            taken = times(results)
            row += [f"{statistics.median(taken.values()):.3g}", ratio(own, taken),
                    f"{other_lengths(results, exact)} / {len(results) - len(taken)}"]
        rows.append(row)
    table(["family", "exsect median / worst ms", "complete / incomplete / no answer", "--exact ms", "IntSS ms", "exsect/IntSS",
           "other length / no answer", "Section ms", "exsect/Section", "other length / no answer"], rows)


def verdict_row(family, results):
    """Numbers of pairs by verdict, and of those with a difference of each kind."""
    done = [line for line in results if "verdict" in line]
    verdicts = collections.Counter(line["verdict"] for line in done)
    kinds = collections.Counter(kind for line in done for kind in line.get("differences", {}))
    return [family, results[0]["program"], *(verdicts[v] for v in ("agrees", "disagrees", "undecided", "refused")),
            len(results) - len(done)], kinds


def verdict_table(directory):
    rows = [verdict_row(family, read(directory / f"{family}.{program}"))
            for family in PAIR_FAMILIES for program in PROGRAMS[2:]]
    occurring = [kind for kind in KINDS if any(kinds[kind] for _, kinds in rows)]
    table(["family", "program", "agrees", "disagrees", "undecided", "refused", "no answer", *occurring],
          ([*row, *(kinds[kind] or "" for kind in occurring)] for row, kinds in rows))


def unmatched(points, others):
    """Of the triples (v,r,s) of a line, those without a partner within 1e-4 in each parameter."""
    others = list(others)
    count = 0
    for p in points:
        partner = next((q for q in others if max(abs(a - b) for a, b in zip(p, q)) < 1e-4), None)
        if partner is None:
            count += 1
        else:
            others.remove(partner)
    return count


def line_row(family, results, filtered, exact, reference):
    taken = times(results)
    answers = {line["name"]: line["lines"] for line in results if line["status"] == "done"}
    both = [(p, q) for name in answers for p, q in zip(reference[name], answers[name])]
    microseconds = [1000 * value / LINES_OF_A_PAIR for value in (statistics.median(taken.values()), max(taken.values()))]
    return [family, results[0]["program"], *(f"{value:.3g}" for value in microseconds),
            ratio(filtered, taken), ratio(exact, taken), len(results) - len(taken),
            sum(len(p) for p, _ in both), sum(unmatched(p, q) for p, q in both), sum(unmatched(q, p) for p, q in both)]


def line_table(directory):
    rows = []
    for family in LINE_FAMILIES:
        results = [read(directory / f"{family}-lines.{program}") for program in LINE_PROGRAMS]
        filtered, exact = times(results[0]), times(results[1])
        reference = {line["name"]: line["lines"] for line in results[1]}
        rows += [line_row(family, lines, filtered, exact, reference) for lines in results]
    table(["family", "program", "median µs a line", "worst µs", "filtered/it", "exact/it", "pairs failed", "points",
           "lost", "invented"], rows)


def main(directory):
    print("Parameter lines:")
    line_table(directory)
    pair_tables(directory)
    print("\nPatches of other kinds:")
    degree_table(directory)
    print("\nSurfaces by their equations:")
    round_table(directory)
    print("\nVerdicts:")
    verdict_table(directory)


main(pathlib.Path(sys.argv[1]))
