"""The Python module against the program, exact identities and its own promises."""

import decimal
import html
import itertools
import json
import math
import os
import pickle
import subprocess
import sys
import threading
import time
from fractions import Fraction
from pathlib import Path

import pytest

import exsect

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
PROGRAM = os.environ.get("EXSECT_PROGRAM", "exsect")

UNIT = [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]  # (u, v, u v)


@pytest.fixture(scope="module")
def first():
    return exsect.read_patches(EXAMPLES / "chapter9-first.json")


@pytest.fixture(scope="module")
def result(first):
    return exsect.intersect(first["x"], first["y"])


def program(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def run(*arguments):
    """What the program prints with --json -, without the time it took."""
    tree = json.loads(program(*arguments, "--json", "-").stdout)
    return {key: value for key, value in tree.items() if key != "work"}


def same(mine):
    return {key: value for key, value in json.loads(mine.to_json()).items() if key != "work"}


def with_corner(number):
    return exsect.Patch([[[0, 0, number], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]])


# Numbers


@pytest.mark.parametrize(
    "number, value",
    [
        (3, 3),
        (-(10**40), -(10**40)),
        (Fraction(-3, 7), Fraction(-3, 7)),
        ("3/7", Fraction(3, 7)),
        ("-4/6", Fraction(-2, 3)),
        ("0.1", Fraction(1, 10)),
        ("-2.5e-3", Fraction(-1, 400)),
        ("0x1.8p-3", Fraction(3, 16)),
        (decimal.Decimal("0.1"), Fraction(1, 10)),
        (Fraction(3**9100, 2**9001 + 1), Fraction(3**9100, 2**9001 + 1)),
    ],
    ids=range(10),
)
def test_exact_numbers_come_back_unchanged(number, value):
    corner = with_corner(number).points[0][0][2]
    assert corner == value and type(corner) is Fraction


@pytest.mark.parametrize(
    "number, error, text",
    [
        (0.5, TypeError, "0.5 is a float"),
        (True, TypeError, "True is no number"),
        (None, TypeError, "None is no exact number"),
        ("1/0", ValueError, '"1/0" is not a number: zero denominator'),
        (" 1", ValueError, "is not a number"),
        ("nan", ValueError, "is not a number"),
        (decimal.Decimal("inf"), ValueError, "is not finite"),
    ],
)
def test_what_is_no_exact_number_is_refused_with_its_place(number, error, text):
    with pytest.raises(error, match=r"^points\[0\]\[0\]\[2\]: .*" + text):
        with_corner(number)


def test_floats_are_taken_by_name_and_mean_what_they_are():
    net = [[[0.1, 0.0, 0.0], [0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 1e-300]]]
    patch = exsect.Patch.from_floats(net)
    assert patch.points[0][0][0] == Fraction(0.1) != Fraction(1, 10)
    assert patch.points[2][2][2] == Fraction(1e-300)
    for bad in (math.nan, math.inf):
        with pytest.raises(ValueError, match=r"points\[0\]\[0\]\[0\]: "):
            exsect.Patch.from_floats([[[bad, 0, 0], [0, 1, 0]], UNIT[1]])
    with pytest.raises(TypeError, match="is no float"):
        exsect.Patch.from_floats([[["0.1", 0, 0], [0, 1, 0]], UNIT[1]])
    numpy = pytest.importorskip("numpy")
    assert exsect.Patch.from_floats(numpy.array(net)) == patch


@pytest.mark.parametrize(
    "points", [[], [[]], [[[0, 0, 0]]], [UNIT[0]], [UNIT[0], UNIT[0][:1]], "abc", 7, [[[0, 0]] * 2] * 2]
)
def test_shapes_that_are_no_patch_are_refused(points):
    with pytest.raises((ValueError, TypeError)):
        exsect.Patch(points)


def quarter_of_a_cylinder():
    return exsect.Patch([[[1, 0, 0], [1, 0, 1]], [[1, 1, 0], [1, 1, 1]], [[0, 1, 0], [0, 1, 1]]], [[1, 1], ["1", 1], [2, "2"]])


def cubic():
    return exsect.Patch([[[i, j, i * j % 3] for j in range(4)] for i in range(3)])


def test_weights_and_higher_degrees(tmp_path):
    patch = quarter_of_a_cylinder()
    assert patch.degree == (2, 1) and patch.weights == ((1, 1), (1, 1), (2, 2))
    assert patch("1/2", "1/3") == (Fraction(3, 5), Fraction(4, 5), Fraction(1, 3))
    assert cubic().degree == (2, 3) and cubic().weights == ((1, 1, 1, 1),) * 3
    assert cubic()(0, "1/3") == (0, 1, 0)
    assert exsect.Patch.from_floats([[[0.5, 0, 0], [0, 1, 0]], UNIT[1]], [[0.1, 1], [1, 1]]).weights[0][0] == Fraction(0.1)
    for each in (patch, cubic()):
        assert exsect.Patch(each.points, weights=each.weights) == each and pickle.loads(pickle.dumps(each)) == each
        exsect.write_patches(tmp_path / "p.json", {"a": each})
        assert exsect.read_patches(tmp_path / "p.json") == {"a": each}
    assert repr(patch) == "<Patch of bidegree (2, 1) with weights, with corners (1, 0, 0), (1, 0, 1), (0, 1, 0), (0, 1, 1)>"
    assert patch != exsect.Patch(patch.points)
    assert list(exsect.read_patches(EXAMPLES / "teapot.bpt")) == [str(k) for k in range(1, 33)]


@pytest.mark.parametrize(
    "weights, reason",
    [
        ([], "weights: must be as many rows"),
        ([[1, 1]], "weights: must be 2 rows as the points, has 1"),
        ([[1, 1], [1]], r"weights\[1\]: must be 2 weights as the points in a row, has 1"),
        ([[1, 1], [1, "nan"]], r"weights\[1\]\[1\]: "),
        ([[1, 1], [1, 0]], r"weights: the denominator vanishes at \(u,v\) = \(1, 1\)"),
        ([[1, -2], [1, 1]], r"weights: the denominator vanishes at \(u,v\) = \(0, 1/3\)"),
        ([[-1, -1], [-1, -1]], r"weights: the denominator is negative at \(u,v\) = \(0, 0\)"),
    ],
)
def test_weights_that_are_not_legal_are_refused(weights, reason):
    with pytest.raises(ValueError, match=reason):
        exsect.Patch(UNIT, weights)
    with pytest.raises((ValueError, TypeError), match="float|" + reason):
        exsect.Patch.from_floats(UNIT, weights)


def test_degrees_beyond_three_are_refused_by_name():
    with pytest.raises(ValueError, match="degree 4 is not supported"):
        exsect.Patch([[[i, j, 0] for j in range(5)] for i in range(2)])
    with pytest.raises(ValueError, match="degree 0 is not supported"):
        exsect.Patch([[[0, 0, 0], [1, 0, 0]]])


def test_functions_for_biquadratic_patches_name_the_kind_of_others(first):
    others = [(quarter_of_a_cylinder(), r"bidegree \(2,1\) with weights"), (cubic(), r"bidegree \(2,3\)")]
    for patch, kind in others:
        calls = [
            lambda p: exsect.implicitize(p),
            lambda p: exsect.compare(first["x"], p),
        ]
        for call in calls:
            with pytest.raises(ValueError, match="not supported here: " + kind + ", only polynomial"):
                call(patch)
        # The same patch with equal weights of another shape is taken.
        assert exsect.line(first["x"], exsect.Patch(UNIT, [[3, 3], [3, 3]]), u="1/2").complete


def test_a_patch_is_what_it_was_given_as(tmp_path):
    patch = exsect.Patch(UNIT)
    assert patch("1/3", Fraction(1, 5)) == (Fraction(1, 3), Fraction(1, 5), Fraction(1, 15))
    assert exsect.Patch(patch.points) == patch
    assert pickle.loads(pickle.dumps(patch)) == patch
    exsect.write_patches(tmp_path / "p.json", {"a": patch}, title="t")
    assert exsect.read_patches(tmp_path / "p.json") == {"a": patch}


def test_a_curve_is_what_it_was_given_as():
    circle = exsect.Curve([[1, 0], [1, 1], [0, 1]], [1, 1, 2])
    x, y = circle("2/7")
    assert x * x + y * y == 1
    assert (circle.degree, circle.dimension, circle.weights) == (2, 2, (1, 1, 2))
    assert pickle.loads(pickle.dumps(circle)) == circle
    with pytest.raises(ValueError):
        exsect.Curve([[1, 0], [1, 1]], [1, 0])


# Intersections


def test_intersect_gives_what_the_program_gives(result):
    assert same(result) == run("intersect", EXAMPLES / "chapter9-first.json")


def test_the_first_example_of_the_chapter(first, result):
    assert result.complete and not result.incomplete
    assert (result.count("closed"), result.count("open"), result.count("branched")) == (1, 1, 0)
    assert [result.turning_points(p) for p in "uvrs"] == [2, 3, 3, 2]
    for node in result.nodes:
        for name, value in node.parameters.items():
            assert node.box[name].lower <= node.box[name].upper
            assert abs(float(node.box[name].midpoint) - value) < 1e-9
        # another route to the same point
        x = first["x"](node.box["u"].midpoint, node.box["v"].midpoint)
        y = first["y"](node.box["r"].midpoint, node.box["s"].midpoint)
        assert max(abs(a - b) for a, b in zip(x, y)) < Fraction(1, 10**9)


def test_polylines_join_their_nodes(result):
    numpy = pytest.importorskip("numpy")
    for arc in result.arcs:
        assert isinstance(arc.polyline, numpy.ndarray) and arc.polyline.shape[1] == 7
        for row, end in zip((arc.polyline[0], arc.polyline[-1]), arc.ends):
            assert list(row[:4]) == pytest.approx(list(result.nodes[end].parameters.values()), abs=1e-6)
        assert 0 < arc.error_bound < 1e-6


def test_without_numpy_polylines_are_lists():
    code = (
        "import sys; sys.modules['numpy'] = None; import exsect;"
        f"p = exsect.read_patches({str(EXAMPLES / 'chapter9-first.json')!r});"
        "r = exsect.intersect(p['x'], p['y']);"
        "assert type(r.arcs[0].polyline) is list and type(r.arcs[0].polyline[0][0]) is float"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_self_intersect_gives_what_the_program_gives():
    patch = exsect.read_patches(EXAMPLES / "chapter9-second.json")["x"]
    mine = exsect.self_intersect(patch)
    assert same(mine) == run("self", EXAMPLES / "chapter9-second.json", "--patch", "x")
    assert mine.parameters == ("u1", "v1", "u2", "v2") and len(mine.components) == 1


def test_line_gives_what_the_program_gives(first):
    mine = exsect.line(first["x"], first["y"], u="1/2")
    assert same(mine) == run("line", EXAMPLES / "chapter9-first.json", "--u", "1/2")


def test_a_line_of_patches_of_every_kind(first):
    for patch in [quarter_of_a_cylinder(), cubic()]:
        for value in ["0", "1/3", "1"]:
            line = exsect.line(patch, first["x"], v=value)
            assert line.complete
            for point in line.points:
                fine = point.refined(Fraction(1, 2**80))
                ends = [patch(fine["u"].lower, value), first["x"](fine["r"].lower, fine["s"].lower)]
                assert all(abs(a - b) < Fraction(1, 2**60) for a, b in zip(*ends))
            assert line.to_svg() and line.to_report() and line.to_vtp() and line.to_csv()


def test_the_certificates_of_a_line_are_exact(first):
    line = exsect.line(first["x"], first["y"], u=Fraction(1, 2))
    assert line.shape == "conic" and line.eliminant.degree == 16 and len(line.points) == 2
    on_line = [first["x"]("1/2", v) for v in (0, "1/3", 1)]
    assert all(line.plane(point) == 0 and line.cylinder(*point) == 0 for point in on_line)
    point = line.points[0]
    assert point.parameters["v"] == pytest.approx(0.122377867125713)
    fine = point.refined(Fraction(1, 2**400))
    for name, interval in fine.items():
        assert interval.width <= Fraction(1, 2**400)
        assert point.box[name].lower <= interval.lower and interval.upper <= point.box[name].upper
    # a simple root of the eliminant between the ends
    assert line.eliminant(fine["s"].lower) * line.eliminant(fine["s"].upper) < 0
    assert any(branch.intervals for branch in line.feasible)
    with pytest.raises(ValueError, match="width: must be > 0"):
        point.refined(0)


def test_options_out_of_range_are_refused(first):
    x, y = first["x"], first["y"]
    for options, text in [
        ({"tolerance": 0}, "tolerance: 0 is not positive"),
        ({"tolerance": "abc"}, 'tolerance: "abc" is not a number'),
        ({"tolerance": math.nan}, "tolerance: "),
        ({"turning": "u,w"}, 'turning: "u,w" is not a list of u, v, r, s'),
        ({"max_seconds": -1}, "max_seconds: -1 is not positive"),
    ]:
        with pytest.raises(ValueError, match=text):
            exsect.intersect(x, y, **options)
    for given, error in [({}, ValueError), ({"u": 0, "s": 1}, ValueError), ({"u": "3/2"}, ValueError), ({"u": 0.5}, TypeError)]:
        with pytest.raises(error):
            exsect.line(x, y, **given)
    with pytest.raises(TypeError):
        exsect.intersect(x, 7)


def test_bad_files_are_refused_in_the_programs_words(tmp_path):
    file = tmp_path / "bad.json"
    file.write_text('{"exsect": "patches/1", "patches": [{"name": "x", "degree": [1,1], "points": [[[0,0,0]]]}]}')
    with pytest.raises(exsect.InputError) as caught:
        exsect.read_patches(file)
    assert program("intersect", file).stderr == f"exsect: {caught.value}\n"
    assert isinstance(caught.value, ValueError)
    with pytest.raises(OSError):
        exsect.write_patches(tmp_path / "missing" / "p.json", {"x": exsect.Patch(UNIT)})


def test_exact_mode_skips_floating_point_and_finds_the_same(first):
    quick = exsect.intersect(first["x"], first["y"])
    exact = exsect.intersect(first["x"], first["y"], exact=True)
    assert quick.tree["work"]["steps"]["filtered"] == 1
    assert "filtered" not in exact.tree["work"]["steps"]
    assert [node["kinds"] for node in quick.tree["nodes"]] == [node["kinds"] for node in exact.tree["nodes"]]
    with pytest.raises(ValueError, match=r"exact arithmetic for bidegree \(2,3\) and bidegree \(2,2\)"):
        exsect.intersect(cubic(), first["x"], exact=True)


def test_an_incomplete_result_says_where_and_why(first):
    result = exsect.intersect(first["x"], first["y"], max_seconds="1e-9")
    assert not result.complete
    assert set(result.incomplete[0].where) == set("uvrs") and result.incomplete[0].why
    assert result.incomplete[0].reason == "time"


# The interpreter


def test_other_threads_run_during_the_work():
    patch = exsect.read_patches(EXAMPLES / "chapter9-second.json")["y"]
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.monotonic()
    exsect.self_intersect(patch)
    end = time.monotonic()
    done.set()
    thread.join()
    assert sum(start < t < end for t in ticks) > 5


def test_threads_get_what_one_thread_gets(first, result):
    found = [None] * 3

    def work(i):
        found[i] = exsect.intersect(first["x"], first["y"])

    threads = [threading.Thread(target=work, args=(i,)) for i in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(same(f) == same(result) for f in found)


def test_an_exception_in_the_progress_function_ends_the_work(first):
    seen = []

    def progress(fraction, step):
        seen.append((fraction, step))
        if len(seen) == 1:
            raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        exsect.intersect(first["x"], first["y"], progress=progress)
    assert all(0 <= fraction <= 1 and step for fraction, step in seen)


# Implicit equations


def test_the_circle_is_the_circle():
    circle = exsect.read_curve(EXAMPLES / "rational-circle.json")
    found = exsect.implicitize(circle)
    assert found.complete and found.exact and found.kind == "planar-curve"
    assert same(found) == run("implicitize", EXAMPLES / "rational-circle.json")
    assert all(found.equation(*circle(Fraction(k, 7))) == 0 for k in range(8))


def test_an_approximate_equation_keeps_its_proved_residual():
    curve = exsect.read_curve(EXAMPLES / "profile.json")
    found = exsect.implicitize(curve, degree=2, variables=("r", "z"))
    assert same(found) == run("implicitize", EXAMPLES / "profile.json", "--degree", "2", "--variables", "r,z")
    assert not found.exact and found.equation.variables == ("r", "z")
    assert max(abs(found.equation(*curve(Fraction(k, 50)))) for k in range(51)) <= found.bound("residual")


def test_a_patch_and_a_curve_of_space_have_equations(first):
    found = exsect.implicitize(first["x"])
    assert found.equation.degree == 8 and len(found.equation) == 165
    assert found.equation(*first["x"]("1/3", "2/7")) == 0
    curve = exsect.read_curve(EXAMPLES / "space-cubic.json")
    pair = exsect.implicitize(curve)
    assert set(pair.equations) == {"f", "g"}
    assert all(f(*curve("3/11")) == 0 for f in pair.equations.values())
    with pytest.raises(ValueError, match="there is no picture"):
        found.to_svg()


def test_options_of_implicitize_have_the_programs_words():
    with pytest.raises(ValueError) as caught:
        exsect.implicitize(exsect.read_curve(EXAMPLES / "profile.json"), method="dokken")
    assert program("implicitize", EXAMPLES / "profile.json", "--method", "dokken").stderr == f"exsect: --{caught.value}\n"


def test_revolve_gives_what_the_program_gives(first):
    curve = exsect.read_curve(EXAMPLES / "profile.json")
    found = exsect.revolve(curve, method="product", degree=3, region=(2, 0, 2), patch=first["x"], lines=["1/2"])
    arguments = ["--method", "product", "--degree", "3", "--region", "2,0,2", "--u", "1/2"]
    arguments += ["--patch-file", EXAMPLES / "chapter9-first.json", "--patch", "x"]
    assert same(found) == run("revolve", EXAMPLES / "profile.json", *arguments)
    r, z = Fraction(3, 5), Fraction(-2, 3)
    assert found.surface(Fraction(3, 5) * r, Fraction(4, 5) * r, z) == found.profile(r, z) * found.profile(-r, z)
    assert found.rings is not None


def test_coefficients_beyond_pythons_decimal_limit_cross():
    big = 7**6000  # more than 4300 digits
    line = exsect.implicitize(exsect.Curve([[0, 0], [1, big]]))
    assert line.equation(1, big) == 0 and line.equation(1, big + 1) != 0


# Polynomials


def test_polynomials_are_what_sympy_takes():
    polynomial = exsect.implicitize(exsect.read_curve(EXAMPLES / "rational-circle.json")).equation
    assert dict(polynomial) == {(2, 0): 1, (0, 2): 1, (0, 0): -1}
    assert str(polynomial) == "x^2+y^2-1" and repr(polynomial) == "Polynomial(('x', 'y'), 'x^2+y^2-1')"
    sympy = pytest.importorskip("sympy")
    x, y = sympy.symbols("x y")
    assert sympy.Poly.from_dict(dict(polynomial), x, y).as_expr() == x**2 + y**2 - 1


@pytest.mark.parametrize("options", [{"degree": 3}, {}])
def test_the_text_of_a_polynomial_is_the_programs(options):
    found = exsect.implicitize(exsect.read_curve(EXAMPLES / "profile.json"), **options)
    assert str(found.equation) == found.tree["equations"][0]["text"]


# Forms


def test_results_show_their_report_in_a_notebook(first, result):
    profile = exsect.read_curve(EXAMPLES / "profile.json")
    cubic = exsect.read_curve(EXAMPLES / "space-cubic.json")
    shown = [result, exsect.self_intersect(first["x"]), exsect.line(first["x"], first["y"], u="1/2")]
    shown += [exsect.implicitize(first["x"]), exsect.implicitize(profile), exsect.implicitize(cubic)]
    shown += [exsect.revolve(profile, method="product", degree=3, region=(2, 0, 2))]
    for each in shown:
        page = each.to_report()
        assert page.startswith("<!DOCTYPE html>") and "Content-Security-Policy" in page
        notebook = each._repr_html_()
        assert "complete" in notebook.split("<iframe")[0]
        assert html.unescape(notebook.split('srcdoc="')[1].split('"></iframe>')[0]) == page
    assert "1 closed, 1 open" in repr(result)


def test_exports_are_the_programs(first, tmp_path):
    title = json.loads((EXAMPLES / "chapter9-first.json").read_text())["title"]
    mine = exsect.intersect(first["x"], first["y"], title=title)
    forms = ("svg", "obj", "ply", "vtp", "csv")
    arguments = [argument for form in forms for argument in (f"--{form}", tmp_path / form)]
    assert program("intersect", EXAMPLES / "chapter9-first.json", *arguments).returncode == 0
    for form in forms:
        assert getattr(mine, f"to_{form}")() == (tmp_path / form).read_text()


def test_everything_public_is_documented():
    for name in exsect.__all__:
        assert getattr(exsect, name).__doc__, name
    assert exsect.__version__


# Pickling, other programs' answers, certificates, many pairs


def kept(value):
    return pickle.loads(pickle.dumps(value))


def solve(pair):
    return exsect.intersect(*pair)


def test_results_are_pickled_with_all_their_forms(first, result):
    profile = exsect.read_curve(EXAMPLES / "profile.json")
    line = exsect.line(first["x"], first["y"], u="1/2")
    shown = [result, exsect.self_intersect(first["x"]), line, exsect.implicitize(profile, degree=3)]
    shown += [exsect.revolve(profile, method="product", degree=3, region=(2, 0, 2))]
    for each in shown:
        again = kept(each)
        assert type(again) is type(each) and again.tree == each.tree and repr(again) == repr(each)
        assert again.to_json() == each.to_json() and again.to_svg() == each.to_svg()
    assert kept(result).nodes == result.nodes and kept(result).arcs == result.arcs
    assert kept(result).to_csv() == result.to_csv()
    assert kept(line).points[1].refined("1e-40") == line.points[1].refined("1e-40")
    assert kept(line.eliminant) == line.eliminant and kept(line.eliminant).variables == line.eliminant.variables
    assert kept(kept(result)).to_csv() == result.to_csv()


def test_a_result_that_was_cut_short_is_pickled_as_it_is(first):
    short = exsect.intersect(first["x"], first["y"], max_seconds="1e-9", progress=lambda fraction, step: None)
    again = kept(short)
    assert not again.complete and again.incomplete == short.incomplete and again.to_json() == short.to_json()


def test_a_pool_of_processes_maps_over_pairs(first, result):
    multiprocessing = pytest.importorskip("multiprocessing")
    pair = (first["x"], first["y"])
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        found = pool.map(solve, [pair, pair[::-1]])
    assert found[0].nodes == result.nodes
    assert [found[1].turning_points(p) for p in "uvrs"] == [result.turning_points(p) for p in "rsuv"]


def test_all_pairs_on_several_threads(first, result):
    flat = exsect.Patch([[[0, 0, "1/2"], [0, 1, "1/2"]], [[1, 0, "1/2"], [1, 1, "1/2"]]])
    patches = {**first, "flat": flat}
    found = list(exsect.intersect_all(patches, jobs=3))
    assert [(a, b) for a, b, _ in found] == [("x", "y"), ("x", "flat"), ("y", "flat")]
    assert found[0][2].nodes == result.nodes and json.loads(found[1][2].to_json())["second"] == "flat"
    chosen = list(exsect.intersect_all([flat, first["x"]], [(1, 0)], tolerance="1e-3"))
    assert chosen[0][:2] == (1, 0)
    with pytest.raises(ValueError, match="there is no patch 'z'"):
        exsect.intersect_all(first, [("x", "z")])


def candidate_case(name):
    folder = EXAMPLES / "candidates"
    model = exsect.read_patches(folder / f"{name}.json")
    return folder / f"{name}.candidate.json", *model.values()


@pytest.mark.parametrize("name", ["sisl-right", "sisl-lost-curve", "occt-touch-point-lost"])
def test_verify_says_what_the_program_says(name):
    path, first, second = candidate_case(name)
    verdict = exsect.verify(path, first, second, tolerance="1e-4")
    mine, theirs = same(verdict), run("verify", path, EXAMPLES / "candidates" / f"{name}.json", "--tolerance", "1e-4")
    for key in ("verdict", "differences", "tolerance", "curves"):
        assert mine[key] == theirs[key], key
    assert verdict.agrees == (name == "sisl-right") == (not verdict.differences)
    assert [d.text for d in verdict.differences] == [d["text"] for d in theirs["differences"]]
    assert verdict.to_report().startswith("<!DOCTYPE html>") and verdict.to_svg().startswith("<?xml")
    assert kept(verdict).differences == verdict.differences and kept(verdict).to_svg() == verdict.to_svg()
    same_again = exsect.verify(json.loads(path.read_text()), first, second, absolute_tolerance=verdict.absolute_tolerance)
    assert same_again.verdict == verdict.verdict
    assert same_again.absolute_tolerance == pytest.approx(verdict.absolute_tolerance, rel=1e-12)


def test_verify_takes_weights():
    plane = exsect.Patch([[[-1, -1, "1/4"], [-1, 2, "1/4"]], [[2, -1, 1], [2, 2, 1]]])  # z = 1/2 + x/4
    ellipse = {"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "points": [[1, 0, 0.75], [1, 1, 0.75], [0, 1, 0.5]], "weights": [1, 1, 2]}
    candidate = {"exsect": "candidate/1", "patches": ["x", "y"], "curves": [{"points": ellipse}]}
    verdict = exsect.verify(candidate, quarter_of_a_cylinder(), plane, tolerance="1e-4")
    assert verdict.agrees and verdict.to_report().startswith("<!DOCTYPE html>")
    ellipse["points"][1][2] = 0.7
    assert exsect.verify(candidate, quarter_of_a_cylinder(), plane, tolerance="1e-4").differences


def circle_as_candidate(z, radius_squared, names):
    """The circle of this height about the z axis, with its points in 720 equal steps."""
    steps = [2 * math.pi * k / 720 for k in range(720)]
    r = math.sqrt(radius_squared)
    points = [[r * math.cos(t), r * math.sin(t), float(z)] for t in steps]
    return {"exsect": "candidate/1", "patches": list(names), "curves": [{"points": points, "closed": True}]}


@pytest.mark.parametrize("pair", [("roof", "ball"), ("ball", "roof"), ("ball", "floor")])
@pytest.mark.parametrize("is_right", [True, False])
def test_verify_takes_equations_as_the_program_does(tmp_path, pair, is_right):
    corners = [[["-3", "-3", "1/2"], ["-3", "3", "1/2"]], [["3", "-3", "1/2"], ["3", "3", "1/2"]]]
    shapes = {"ball": exsect.sphere([0, 0, 0], 2), "floor": exsect.plane([0, 0, "1/2"], [0, 0, 3]), "roof": exsect.Patch(corners)}
    entries = {name: json.loads(shape.entry) for name, shape in shapes.items() if name != "roof"}
    entries["roof"] = {"degree": [1, 1], "points": corners}
    model = tmp_path / "model.json"
    model.write_text(json.dumps({"exsect": "patches/1", "patches": [{**entries[name], "name": name} for name in pair]}))
    candidate = circle_as_candidate("0.5", 3.75 if is_right else 3.5, pair)
    if is_right and "roof" in pair:  # the parameters of the patch, of whichever place it has
        on_patch = [[p[0] / 6 + 0.5, p[1] / 6 + 0.5] for p in candidate["curves"][0]["points"]]
        candidate["curves"][0]["first" if pair[0] == "roof" else "second"] = on_patch
    file = tmp_path / "circle.candidate.json"
    file.write_text(json.dumps(candidate))
    verdict = exsect.verify(file, *[shapes[name] for name in pair], tolerance="1e-4", names=pair)
    mine, theirs = same(verdict), run("verify", file, model, "--tolerance", "1e-4")
    for key in ("verdict", "differences", "tolerance", "curves"):
        assert mine[key] == theirs[key], key
    assert verdict.agrees == is_right == (not verdict.differences)
    assert verdict.to_report().startswith("<!DOCTYPE html>") and verdict.to_svg().startswith("<?xml")
    assert kept(verdict).differences == verdict.differences and kept(verdict).to_svg() == verdict.to_svg()


def test_a_gap_of_two_equations_has_vertices_alone():
    candidate = circle_as_candidate("0.5", 3.75, ("x", "y"))
    candidate["curves"][0]["points"][10:200] = []
    candidate["curves"][0]["closed"] = False
    verdict = exsect.verify(candidate, exsect.sphere([0, 0, 0], 2), exsect.plane([0, 0, "1/2"], [0, 0, 1]), tolerance="1e-4")
    gaps = [d for d in verdict.differences if d.kind == "gap"]
    assert gaps and all(d.gap is None and d.vertices[0] < d.vertices[1] for d in gaps)


def test_verify_of_equations_refuses_what_cannot_be_compared():
    ball, pipe = exsect.sphere([0, 0, 0], 2), exsect.cylinder([0, 0, 0], [0, 0, 1], 1)
    circle = circle_as_candidate("0.5", 3.75, ("x", "y"))
    with pytest.raises(ValueError, match="the surfaces are one"):
        exsect.verify(circle, ball, ball)
    with pytest.raises(ValueError, match="goes on to infinity"):
        exsect.verify(circle, pipe, exsect.plane([0, 0, 0], [1, 0, 0]))
    with pytest.raises(ValueError, match="absolute_tolerance"):
        exsect.verify(circle, ball, pipe, absolute_tolerance=1)
    circle["curves"][0]["first"] = [[0, 0] for _ in circle["curves"][0]["points"]]
    with pytest.raises(ValueError, match="parameters of a surface given by its equation"):
        exsect.verify(circle, ball, exsect.Patch([[[-3, -3, "1/2"], [-3, 3, "1/2"]], [[3, -3, "1/2"], [3, 3, "1/2"]]]))


def test_bad_candidates_are_refused():
    _, first, second = candidate_case("sisl-right")
    with pytest.raises(exsect.InputError, match="candidate"):
        exsect.verify({"exsect": "candidate/1"}, first, second)
    with pytest.raises(exsect.InputError):
        exsect.verify("no-such-file.json", first, second)
    with pytest.raises(exsect.InputError):
        exsect.verify("a.txt", first, second)


def test_certificates_are_written_and_replayed(first, result):
    proof = result.to_certificate()
    found = exsect.check(proof)
    assert found and found.accepted and found.summary["closed"] == 1 and found.summary["open"] == 1
    assert found.summary["nodes"] == len(result.nodes)
    assert exsect.check(exsect.line(first["x"], first["y"], u="1/2").to_certificate()).summary == {"points": 2}
    plane = exsect.Patch([[[-1, -1, "1/3"], [-1, 4, "1/2"]], [[4, -1, "3/5"], [4, 4, "3/7"]]])
    for patch in (cubic(), quarter_of_a_cylinder()):
        assert exsect.check(exsect.intersect(plane, patch).to_certificate()).accepted
        assert exsect.check(exsect.line(patch, plane, u="1/3").to_certificate()).accepted
    forged = proof.replace("3/7", "4/7")
    if forged != proof:
        try:
            rejected = exsect.check(forged)
            assert not rejected and rejected.reason
        except ValueError:
            pass
    with pytest.raises(ValueError):
        exsect.check("{}")
    cut = exsect.intersect(first["x"], first["y"], max_seconds="1e-9")
    with pytest.raises(exsect.NoCertificate):
        cut.to_certificate()


def test_compare_gives_a_row_for_each_method(first):
    found = exsect.compare(first["x"], first["y"], lines=8)
    theirs = run("compare", EXAMPLES / "chapter9-first.json", "--lines", 8)
    assert [(m["method"], m["detail"], m["answer"]) for m in found.methods] == [
        (m["method"], m["detail"], m["answer"]) for m in theirs["methods"]
    ]
    with pytest.raises(ValueError, match="^lines: "):
        exsect.compare(first["x"], first["y"], lines=0)


# Shapes and curves in doubles


def test_components_are_joined(first, result):
    for component in result.components:
        points = [tuple(row) for row in component.polyline()]
        parts = [result.arcs[i] for i in component.arcs]
        assert len(points) == sum(len(arc.polyline) for arc in parts) - len(parts) + 1
        assert component.error_bound == max(arc.error_bound for arc in parts)
        assert (points[0] == points[-1]) == component.closed and not component.tangential
        places = [points.index(tuple(arc.polyline[len(arc.polyline) // 2])) for arc in parts]
        assert places == sorted(places)
    # as few rows as there can be: no vertex is far from the one before
    closed = next(component for component in result.components if component.closed)
    rows = [list(row) for row in closed.polyline()]
    assert max(math.dist(a[4:], b[4:]) for a, b in zip(rows, rows[1:])) < 0.05


def test_touching_patches_have_tangential_components():
    patches = exsect.read_patches(EXAMPLES / "touching-curve.json")
    found = exsect.intersect(*patches.values())
    for component in found.components:
        assert component.tangential == all(found.arcs[i].contact == "tangential" for i in component.arcs)
    assert any(component.tangential for component in found.components)


def test_a_branched_component_has_no_polyline():
    patches = exsect.read_patches(ROOT / "tests" / "cases" / "crossing.json")
    found = exsect.intersect(*patches.values())
    branched = next(component for component in found.components if component.shape == "branched")
    with pytest.raises(ValueError, match="branched"):
        branched.polyline()


def test_columns_of_an_arc(first, result):
    arc = result.arcs[0]
    for row, uv, rs, xyz in zip(arc.polyline, arc.uv, arc.rs, arc.xyz):
        assert list(row) == [*uv, *rs, *xyz]
        exact = first["x"](Fraction(uv[0]), Fraction(uv[1]))
        assert math.dist([float(c) for c in exact], xyz) < 1e-5


def test_absolute_tolerances(first):
    points = [p for patch in first.values() for row in patch.points for p in row]
    size = max(max(p[k] for p in points) - min(p[k] for p in points) for k in range(3))
    wanted = Fraction(1, 1000)
    found = exsect.intersect(first["x"], first["y"], absolute_tolerance=wanted)
    assert found.complete and max(arc.error_bound for arc in found.arcs) <= wanted
    relative = exsect.intersect(first["x"], first["y"], tolerance=wanted / size)
    assert sum(len(arc.polyline) for arc in found.arcs) == sum(len(arc.polyline) for arc in relative.arcs)
    for bad in (0, -1, "x", math.nan, math.inf):
        with pytest.raises(ValueError, match="^absolute_tolerance: "):
            exsect.intersect(first["x"], first["y"], absolute_tolerance=bad)


def test_representations_are_short(first, result):
    line = exsect.line(first["x"], first["y"], u="1/2")
    curve = exsect.read_curve(EXAMPLES / "profile.json")
    for each in [first["x"], curve, result, result.nodes[0], result.arcs[0], line, line.points[0], line.eliminant]:
        assert len(repr(each)) < 200 and "\n" not in repr(each), repr(each)
    assert repr(exsect.Patch(UNIT)) == "<Patch with corners (0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 1)>"


def test_errors_are_in_the_terms_of_python(first):
    profile = exsect.read_curve(EXAMPLES / "profile.json")
    with pytest.raises(ValueError) as error:
        exsect.implicitize(profile, degree=99)
    assert "--" not in str(error.value) and "degree" in str(error.value)
    with pytest.raises(ValueError) as error:
        exsect.revolve(profile, method="product", degree=3, lines=["1/2", "2"], patch=first["x"])
    assert "--" not in str(error.value)


def test_polynomials_in_latex_and_sympy():
    polynomial = exsect.Polynomial(("x", "u1"), [((2, 0), Fraction(-3, 7)), ((1, 12), Fraction(1)), ((0, 0), Fraction(-2))])
    assert polynomial._repr_latex_() == r"$-\frac{3}{7}x^{2}+xu_{1}^{12}-2$"
    assert exsect.Polynomial("x", [])._repr_latex_() == "$0$"
    sympy = pytest.importorskip("sympy")
    x, u1 = sympy.symbols("x u1")
    assert polynomial.sympy().as_expr() == -sympy.Rational(3, 7) * x**2 + x * u1**12 - 2


def test_evaluation_by_numpy(first):
    numpy = pytest.importorskip("numpy")
    u = numpy.linspace(0, 1, 7)
    for patch in (first["x"], quarter_of_a_cylinder(), cubic()):
        points = patch.evaluate(u[:, None], u[None, :])
        assert points.shape == (7, 7, 3) and patch.evaluate(0.5, 0.25).shape == (3,)
        for i, a in enumerate(u):
            for j, b in enumerate(u):
                exact = patch(Fraction(float(a)), Fraction(float(b)))
                assert max(abs(float(c) - d) for c, d in zip(exact, points[i, j])) < 1e-15 * 8


def test_plots_by_matplotlib(first, result):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    figure = result.plot()
    assert [axes.name for axes in figure.axes] == ["3d", "rectilinear", "rectilinear"]
    for axes, names in zip(figure.axes[1:], ("uv", "rs")):
        assert (axes.get_xlabel(), axes.get_ylabel()) == tuple(names)
        assert len(axes.lines) == len(result.arcs) + len(result.nodes)
    assert kept(result).plot() is not None and first["x"].plot().name == "3d"
    assert quarter_of_a_cylinder().plot().name == "3d"


def test_dir_shows_what_is_public():
    assert dir(exsect) == sorted(exsect.__all__)


def test_the_notebook_runs(monkeypatch):
    """Every cell in one namespace; those that need matplotlib where it is installed."""
    monkeypatch.chdir(ROOT)
    notebook = json.loads((EXAMPLES / "intersections.ipynb").read_text())
    assert notebook["nbformat"] == 4
    try:
        import matplotlib

        matplotlib.use("Agg")
        missing = set()
    except ImportError:
        missing = {"matplotlib"}
    namespace = {}
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code" and not missing & set(cell["metadata"].get("tags", ())):
            assert not cell["outputs"] and cell["execution_count"] is None
            exec(compile("".join(cell["source"]), cell["id"], "exec"), namespace)
    nbformat = pytest.importorskip("nbformat", reason="the notebook's form is checked where nbformat is installed")
    nbformat.validate(nbformat.read(EXAMPLES / "intersections.ipynb", as_version=4))


SADDLE = [[[-4, -4, 1], [-4, 4, -1]], [[4, -4, -1], [4, 4, 1]]]  # z = x y / 16


def surfaces():
    return {
        "floor": exsect.plane([0, 0, -1], [0, 0, 1]),
        "oblique": exsect.cylinder([0, 0, 0], [1, 1, 1], 1),
        "cone": exsect.cone([0, 0, 3], [0, 0, -1], "1/2"),
        "ball": exsect.sphere([1, 0, 0], radius_squared=2),
        "torus": exsect.torus([0, 0, 0], [0, 0, 1], 3, 1),
        "quartic": exsect.implicit({(4, 0, 0): 1, (0, 4, 0): 1, (0, 0, 4): 1, (0, 0, 0): -81}),
    }


def test_a_patch_and_an_equation_give_what_the_program_gives():
    saddle = exsect.Patch(SADDLE)
    for name, surface in surfaces().items():
        result = exsect.intersect(saddle, surface, names=("saddle", name))
        ran = program("intersect", EXAMPLES / "surfaces.json", "--first", "saddle", "--second", name, "--json", "-")
        expected = json.loads(ran.stdout)
        given = json.loads(result.to_json())
        del expected["work"], given["work"]
        assert given == expected
        assert result.complete and result.parameters == ("u", "v")
        exchanged = json.loads(exsect.intersect(surface, saddle, names=(name, "saddle")).to_json())
        del exchanged["work"]
        assert exchanged == expected


def test_arcs_of_a_patch_and_an_equation_have_no_parameters_of_the_equation():
    result = exsect.intersect(exsect.Patch(SADDLE), surfaces()["ball"])
    arc = result.arcs[0]
    assert {arc.left, arc.right} == {-1, 1}
    assert len(arc.polyline[0]) == 5 and len(arc.uv[0]) == 2 and len(arc.rs[0]) == 0
    for x, y, z in arc.xyz:
        assert abs((x - 1) ** 2 + y**2 + z**2 - 2) < 1e-4
    assert "v" in result.to_vtp() and result.to_svg().startswith("<")
    assert result.patches == (exsect.Patch(SADDLE),)
    again = pickle.loads(pickle.dumps(result))
    assert again.arcs == result.arcs
    found = exsect.check(result.to_certificate())
    assert found.accepted and found.summary["closed"] == 1 and found.summary["nodes"] == 4
    with pytest.raises(exsect.NoCertificate, match="a surface with bounds"):
        exsect.intersect(exsect.Patch(SADDLE), surfaces()["cone"]).to_certificate()
    assert result.to_report().startswith("<!DOCTYPE html>")
    for node in result.nodes:
        x, y, z = node.point
        assert set(node.chart) == {"turn", "height"}
        assert abs(float(node.chart["height"].lower) - z) < 1e-9
        turn = math.atan2(y, x - 1) / (2 * math.pi) % 1
        assert abs((float(node.chart["turn"].upper) - turn + 0.5) % 1 - 0.5) < 1e-9


def test_nodes_of_two_equations_have_the_parameters_of_both():
    common = exsect.intersect(exsect.cylinder([0, 0, 0], [0, 0, 2], 1), exsect.plane([0, 0, 1], [1, 0, 1]))
    assert common.nodes
    for node in common.nodes:
        on_cylinder, on_plane = node.charts
        assert set(on_cylinder) == {"turn", "height"} and on_plane == {}
        assert abs(2 * float(on_cylinder["height"].lower) - node.point[2]) < 1e-9


def test_sides_of_two_patches():
    bump = exsect.read_patches(EXAMPLES / "bump.json")
    result = exsect.intersect(bump["bump"], bump["plane"])
    assert {(arc.left, arc.right) for arc in result.arcs} in ({(1, -1)}, {(-1, 1)})
    exchanged = exsect.intersect(bump["plane"], bump["bump"])
    assert all(arc.left == -arc.right for arc in exchanged.arcs)
    same = exsect.intersect(bump["bump"], bump["bump"])
    assert [overlap.normals for overlap in same.overlaps] == [1]


def test_sides_of_two_equations():
    ball, plane = exsect.sphere([0, 0, 0], 2), exsect.plane([0, 0, 1], [0, 0, 1])
    result, exchanged = exsect.intersect(ball, plane), exsect.intersect(plane, ball)
    assert all({arc.left, arc.right} == {-1, 1} for arc in result.arcs)
    assert [(arc.right, arc.left) for arc in exchanged.arcs] == [(arc.left, arc.right) for arc in result.arcs]
    below = exsect.intersect(ball, exsect.plane([0, 0, 2], [0, 0, 1]))
    assert [node.around for node in below.nodes] == [-1] and below.normals is None
    bore = exsect.intersect(ball, exsect.cylinder([0, 0, 0], [0, 0, 1], 2))
    assert {(arc.left, arc.right) for arc in bore.arcs} == {(-1, -1)}
    turned = exsect.intersect(plane, exsect.plane([5, 0, 1], [0, 0, -2]))
    assert turned.same and turned.normals == -1


def test_two_equations_give_what_the_program_gives():
    named = surfaces()
    for names in itertools.combinations(["floor", "oblique", "cone", "ball", "torus", "quartic"], 2):
        result = exsect.intersect(named[names[0]], named[names[1]], names=names, tolerance="1e-3")
        ran = program(
            "intersect", EXAMPLES / "surfaces.json", "--first", names[0], "--second", names[1], "--tolerance", "1e-3", "--json", "-"
        )
        expected = json.loads(ran.stdout)
        given = json.loads(result.to_json())
        del expected["work"], given["work"]
        assert given == expected
        assert len(result.curves) == sum(result.count(kind) for kind in {curve.kind for curve in result.curves})
        assert result.complete == (result.incomplete == ())


def test_two_equations_have_named_curves_and_every_form():
    named = surfaces()
    circle = exsect.intersect(named["torus"], named["floor"])
    assert circle.complete and circle.summary == "1 circle" and not circle.same
    assert circle.curves[0].radius_squared == 9 and circle.curves[0].point == (0, 0, -1)
    assert circle.curves[0].multiplicity == 2 and circle.curves[0].closed
    for arc in circle.arcs:
        assert all(abs(math.hypot(p[0], p[1]) - 3) <= arc.error_bound + 1e-12 for p in arc.polyline)
    for node in circle.nodes:
        assert all(low <= Fraction(c) <= high for (low, high), c in zip(node.box, node.point)) or node.kind == "joint"
    assert exsect.intersect(named["ball"], named["ball"]).same
    assert circle.to_svg().startswith("<") and "surfaces/1" in circle.to_report() and "<iframe" in circle._repr_html_()
    assert "circle" in circle.to_obj() and circle.to_ply() and circle.to_vtp() and circle.to_csv().startswith("id,kind,arcs")
    again = pickle.loads(pickle.dumps(circle))
    assert again.curves == circle.curves and again.to_svg() == circle.to_svg()
    assert "1 circle" in repr(circle)
    with pytest.raises(ValueError, match="not supported yet with two surfaces"):
        circle.to_certificate()
    with pytest.raises(ValueError, match="absolute_tolerance"):
        exsect.intersect(named["ball"], named["floor"], absolute_tolerance=1)
    assert not exsect.intersect(named["torus"], named["oblique"], max_seconds="1e-9").complete


def test_rays_give_what_the_program_gives():
    named = {"saddle": exsect.Patch(SADDLE), **surfaces()}
    ray = exsect.ray([-5, 0, 0], [1, 0, 0], named)
    ran = program("ray", EXAMPLES / "surfaces.json", "--origin=-5,0,0", "--direction", "1,0,0", "--json", "-")
    expected = json.loads(ran.stdout)
    assert [hit.surface for hit in ray.hits] == [hit["surface"] for hit in expected["hits"]]
    assert [hit.place for hit in ray.hits] == list(range(1, 13))
    assert all(Fraction(hit["t"]["box"][0]) == own.t.lower for hit, own in zip(expected["hits"], ray.hits))
    assert ray.complete and ray.overlaps == (exsect.RayOverlap("saddle", exsect.Interval(1, 1), exsect.Interval(9, 9)),)
    hit = exsect.ray([1, 2, -9], [0, 0, 1], exsect.Patch(SADDLE)).hits[0]
    assert hit.parameters == {"u": (Fraction(5, 8), Fraction(5, 8)), "v": (Fraction(3, 4), Fraction(3, 4))}
    assert hit.t.lower == Fraction(73, 8) and hit.contact == "transversal"
    assert exsect.ray([0, 0, -1], [1, 0, 0], surfaces()["floor"]).overlaps[0].end is None


def faces():
    return {
        "fillet": exsect.cylinder(
            [0, 0, 0], [0, 0, 5], 1, box={"sector": {"from": [1, 0, 0], "to": [0, 1, 0]}, "height": [0, Fraction(1, 5)]}
        ),
        "lid": exsect.sphere([0, 0, 0], radius_squared=2, box={"axis": [0, 0, 1], "height": [1, "3/2"]}),
        "groove": exsect.torus(
            [0, 0, 1],
            [0, 0, 1],
            "3/2",
            "1/4",
            box={"sector": {"from": (1, 1, 0), "to": (-1, 1, 0)}, "tube": {"from": [1, 0], "to": [-1, 0]}},
        ),
        "floor": exsect.plane([-1, -1, "4/3"], [0, 0, 1], box={"sides": [[2, 0, 0], [0, 2, 0]]}),
    }


def test_faces_give_what_the_program_gives():
    roof = exsect.Patch([[[-2, -2, 2], [-2, 2, 2]], [[2, -2, 0], [2, 2, 0]]])
    for name, face in faces().items():
        result = exsect.intersect(roof, face, names=("roof", name))
        ran = program("intersect", EXAMPLES / "faces.json", "--first", "roof", "--second", name, "--json", "-")
        expected = json.loads(ran.stdout)
        given = json.loads(result.to_json())
        del expected["work"], given["work"]
        assert given == expected
        assert result.complete and result.count("open") == 1
        assert pickle.loads(pickle.dumps(face)) == face
    fillet = faces()["fillet"]
    ends = exsect.intersect(roof, fillet).nodes
    assert {node.bounds for node in ends} == {("sector=to", "height=to"), ("sector=from",)}
    assert (1, 0, 1) in fillet and (1, 0, "11/10") not in fillet and (-1, 0, 1) not in fillet
    with pytest.raises(ValueError, match="box.height: does not ascend"):
        exsect.cylinder([0, 0, 0], [0, 0, 1], 1, box={"height": [1, 1]})
    with pytest.raises(TypeError, match="box.height: a float"):
        exsect.cylinder([0, 0, 0], [0, 0, 1], 1, box={"height": [0, 0.5]})
    rim = exsect.intersect(fillet, faces()["lid"])
    assert rim.complete and [(curve.kind, curve.closed) for curve in rim.curves] == [("circle", False)]
    assert {node.bounds for node in rim.nodes} == {
        (("sector=from", "height=to"), ("height=from",)),
        (("sector=to", "height=to"), ("height=from",)),
    }


def test_surfaces_are_exact_values():
    torus = surfaces()["torus"]
    assert torus.kind == "torus" and (4, 0, 0) in torus and (Fraction(4), 0, "1/10") not in torus
    assert pickle.loads(pickle.dumps(torus)) == torus == surfaces()["torus"] != surfaces()["ball"]
    assert "torus" in repr(torus)
    assert exsect.cone([0, 0, 0], [0, 0, 1], slope_squared=2, nappes=2).kind == "cone"
    with pytest.raises(ValueError, match="axis: the vector is zero"):
        exsect.cylinder([0, 0, 0], [0, 0, 0], 1)
    with pytest.raises(ValueError, match="radius: not positive"):
        exsect.sphere([0, 0, 0], -1)
    with pytest.raises(ValueError, match="radius_squared"):
        exsect.sphere([0, 0, 0], 1, radius_squared=1)
    with pytest.raises(ValueError, match="spindle"):
        exsect.torus([0, 0, 0], [0, 0, 1], 1, 2)
    with pytest.raises(TypeError, match="float"):
        exsect.sphere([0, 0, 0], 0.5)
    with pytest.raises(ValueError, match="direction: the vector is zero"):
        exsect.ray([0, 0, 0], [0, 0, 0], torus)
    with pytest.raises(ValueError, match="origin"):
        exsect.ray([0, 0], [0, 0, 1], torus)
    with pytest.raises(ValueError, match="degree is above 4"):
        exsect.implicit({(3, 2, 0): 1})
