"""The rooms of the solver and of the program's output: which may include which, and what is wrong with the tree.

    python3 tests/project/rooms.py           the table of includes between rooms, and violations
    python3 tests/project/rooms.py --modules also modules without a test of their name

A module is a header with the source of the same name. Of a library with rooms every include runs down a floor or stays
in its room; modules of one room include each other in circles of at most three; every source has its header; no two
sources of a folder, which compile in groups, have a local name in common, no two files define a type of one name, for
linkers would take the functions of one for those of the other, and every test has a namespace of the name of its file. Exit status 1 if one of these is violated.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^#include (?:"([^"]+)"|<(exsect/[^>]+)>)', re.M)

# From the ground up; rooms of one floor do not know each other. "" is the folder itself, the front.
FLOORS = {
    "solver": [
        ["answer"],
        ["curve"],
        ["shape", "line", "lift"],
        ["eliminant"],
        ["trace"],
        ["side", "star", "filter"],
        ["sweep", "special"],
        ["self"],
        ["overlap"],
        [""],
    ],
    "output": [["text"], ["drawing", "options"], ["report"]],
}
# What libraries beside the solver may use of its internal headers.
GUESTS = {"verify": {"answer"}, "implicit": {"answer", "curve", "line", "eliminant"}}
# Sources of one class, by what its members do: their header is that of the class.
PARTS = {"verify/verifier.h": {"arcs", "connections", "curves", "points"}}
LARGEST_CIRCLE = 3
COMPILED_IN_GROUPS = ["algebra", "geometry", "solver", "verify", "implicit", "checker", "output", "certificate", "cli"]
TESTS_IN_GROUPS = ["algebra", "geometry", "solver", "verify", "implicit", "support", "cli", "checker"]
LIBRARIES = ["solver", "verify", "implicit", "output", "certificate"]


def sources(library):
    return sorted(p for p in (ROOT / library).rglob("*") if p.suffix in (".h", ".cpp"))


def module(path):
    return path.relative_to(ROOT).with_suffix("")


HEADERS = {p.relative_to(ROOT) for name in LIBRARIES for p in sources(name) if p.suffix == ".h"}
PUBLIC = defaultdict(dict)  # by library the public name of a header
for header in HEADERS:
    PUBLIC[header.parts[0]][header.name] = header


def target(path, quoted, angled):
    """The header of this tree that is included, or nothing."""
    if angled:
        library, name = Path(angled).parts[1:3]
        return PUBLIC[library].get(name)
    here = path.relative_to(ROOT).parts[0]
    for folder in (path.parent.relative_to(ROOT), Path(here), Path("solver"), Path()):
        candidate = folder / quoted
        if candidate in HEADERS:
            return candidate
    return None


def includes():
    """(including file, included header), both within the libraries."""
    found = []
    for library in LIBRARIES:
        for path in sources(library):
            for quoted, angled in INCLUDE.findall(path.read_text()):
                header = target(path, quoted, angled)
                if header and module(path) != header.with_suffix(""):
                    found.append((path.relative_to(ROOT), header))
    return found


def room(path):
    parts = path.parts
    return parts[1] if len(parts) > 2 else ""


def floors(library):
    return {name: level for level, names in enumerate(FLOORS[library]) for name in names}


def circles(edges):
    """The strongly connected components with more than one member (Tarjan)."""
    order, low, stack, on_stack, found = {}, {}, [], set(), []

    def visit(start):
        work = [(start, iter(edges[start]))]
        order[start] = low[start] = len(order)
        stack.append(start)
        on_stack.add(start)
        while work:
            node, rest = work[-1]
            for other in rest:
                if other not in order:
                    order[other] = low[other] = len(order)
                    stack.append(other)
                    on_stack.add(other)
                    work.append((other, iter(edges[other])))
                    break
                if other in on_stack:
                    low[node] = min(low[node], order[other])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == order[node]:
                    component = []
                    while True:
                        component.append(stack.pop())
                        on_stack.discard(component[-1])
                        if component[-1] == node:
                            break
                    if len(component) > 1:
                        found.append(sorted(component))

    for node in list(edges):
        if node not in order:
            visit(node)
    return found


LOCAL = re.compile(
    r"^(?:struct|class|enum class|enum) (\w+)|^using (\w+) =|^constexpr [\w:<>* ]*[ *](\w+)(?: =|\{)"
    r"|^[A-Za-z][\w:<>,&* ]*[ &*](\w+)\(",
    re.M,
)


def local_names(library):
    """By folder and name, names that anonymous namespaces of more than one source there define."""
    where = defaultdict(set)
    for path in sources(library):
        if path.suffix != ".cpp":
            continue
        for body in re.findall(r"^namespace \{\n(.*?)^\}  // namespace$", path.read_text(), re.S | re.M):
            for name in re.findall(LOCAL, body):
                where[path.parent, next(part for part in name if part)].add(str(path.relative_to(ROOT)))
    return {name: files for name, files in where.items() if len(files) > 1}


TYPE = re.compile(r"^(?:struct|class|enum class|enum) (\w+)(?: final)?(?: : [^;{]*)?\s*\{", re.M)


def type_names():
    """By qualified name, types that more than one file defines outside of anonymous namespaces."""
    where = defaultdict(set)
    for library in COMPILED_IN_GROUPS:
        for path in sources(library):
            text = re.sub(r"^namespace \{\n.*?^\}  // namespace$", "", path.read_text(), flags=re.S | re.M)
            for found in TYPE.finditer(text):
                opened = re.findall(r"^namespace ([\w:]+) \{", text[: found.start()], re.M)
                where["::".join(opened[-1:] + [found[1]])].add(str(path.relative_to(ROOT)))
    return {name: files for name, files in where.items() if len(files) > 1}


def violations(found):
    wrong = [f"the type {name} stands in {' '.join(sorted(files))}" for name, files in sorted(type_names().items())]
    for path, header in found:
        library, used = path.parts[0], header.parts[0]
        if library in GUESTS and used == "solver" and f"<exsect/solver/{header.name}>" not in (ROOT / path).read_text():
            if room(header) not in GUESTS[library]:
                wrong.append(f"{path}: {header} is not for {library}/")
        if library != used or library not in FLOORS:
            continue
        level = floors(library)
        if room(path) not in level:
            wrong.append(f"{path}: the room {room(path)} has no floor in rooms.py")
        elif room(path) != room(header) and level[room(header)] >= level[room(path)]:
            wrong.append(f"{path}: includes {header}, which is not below it")
    edges = defaultdict(set)
    for path, header in found:
        edges[str(path.with_suffix(""))].add(str(header.with_suffix("")))
        edges[str(header.with_suffix(""))]
    for circle in circles(edges):
        if len(circle) > LARGEST_CIRCLE:
            wrong.append(f"a circle of {len(circle)} modules: {' '.join(circle)}")
    for library in COMPILED_IN_GROUPS:
        for (folder, name), files in sorted(local_names(library).items()):
            wrong.append(f"{folder.relative_to(ROOT)}/: the local name {name} stands in {' '.join(sorted(files))}")
    for test in sorted(path for folder in TESTS_IN_GROUPS for path in (ROOT / "tests" / folder).rglob("*_test.cpp")):
        if not re.search(rf"^namespace exsect::(\w+::)?{test.stem} {{$", test.read_text(), re.M):
            wrong.append(f"{test.relative_to(ROOT)}: no namespace exsect::{test.stem}")
    for library in LIBRARIES:
        for path in sources(library):
            own = {path.with_suffix(".h")} | {ROOT / h for h, parts in PARTS.items() if path.stem in parts and h.startswith(library)}
            if path.suffix == ".cpp" and not any(header.exists() for header in own):
                wrong.append(f"{path.relative_to(ROOT)} has no header")
    return wrong


def table(library, found):
    names = [name for level in FLOORS[library] for name in level]
    counts = defaultdict(int)
    for path, header in found:
        if path.parts[0] == header.parts[0] == library and room(path) != room(header):
            counts[room(path), room(header)] += 1
    shown = [name or "(front)" for name in names]
    print(f"{library}/: includes from row to column")
    print(" " * 12 + "".join(f"{name[:9]:>10}" for name in shown))
    for name, label in zip(names, shown):
        print(f"{label:<12}" + "".join(f"{counts[name, other] or '.':>10}" for other in names))


def without_test():
    tests = {p.name for p in (ROOT / "tests").rglob("*_test.cpp")}
    folders = defaultdict(list)
    for library in ("solver", "verify", "implicit"):
        for name in sorted({module(p) for p in sources(library)}):
            if name.name + "_test.cpp" not in tests:
                folders[str(name.parent)].append(name.name)
    return folders


def main():
    found = includes()
    for library in FLOORS:
        table(library, found)
    edges = defaultdict(set)
    for path, header in found:
        edges[str(path.with_suffix(""))].add(str(header.with_suffix("")))
        edges[str(header.with_suffix(""))]
    longest = max(circles(edges), key=len, default=[])
    print("longest circle:", " ".join(longest) or "none")
    missing = without_test()
    print("modules without a test of their name:", sum(map(len, missing.values())))
    if "--modules" in sys.argv:
        for folder, names in missing.items():
            print(f"  {folder}: {' '.join(names)}")
    wrong = violations(found)
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
