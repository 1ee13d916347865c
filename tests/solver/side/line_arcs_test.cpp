// Arcs of parameter lines on the other patch: exact ends, every sheet, and vertices on both patches.
#include "side/line_arcs.h"

#include <exsect/solver/line_patch.h>

#include <algorithm>
#include <cmath>

#include "answer/parameter_box.h"
#include "support/catch.h"
#include "support/random_pairs.h"
#include "trace/tube_points.h"

namespace exsect::line_arcs_test {
namespace {

Rational q(int a, int b) { return {a, b}; }

LineArcs arcs_of(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  const ModelScale scale = model_scale(x, y);
  return line_arcs(x, y, query, scale, 1e-6 * scale.extent, {});
}

/// The arcs cover the intervals that line_points finds by another route (equal where there is one sheet).
void check_against_intervals(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  const LineArcs found = arcs_of(x, y, query);
  const LinePoints points = line_points(x, y, query);
  CHECK(!found.incomplete);
  REQUIRE(found.arcs.size() == points.on_patch.size());
  const std::size_t t = index(query.fixed) ^ 1;
  for (std::size_t i = 0; i < found.arcs.size(); ++i) {
    const RationalInterval from = found.ends[found.arcs[i].from].box()[t];
    const RationalInterval to = found.ends[found.arcs[i].to].box()[t];
    CHECK(points.on_patch[i].from.compare(from.lower) >= 0);
    CHECK(points.on_patch[i].from.compare(from.upper) <= 0);
    CHECK(points.on_patch[i].to.compare(to.lower) >= 0);
    CHECK(points.on_patch[i].to.compare(to.upper) <= 0);
    for (const PolylineVertex& vertex : found.arcs[i].polyline) {
      const auto& z = vertex.parameters;
      const Point a = x(from_double(z[0]), from_double(z[1]));
      const Point b = y(from_double(z[2]), from_double(z[3]));
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(to_double(a[c]) == Approx(to_double(b[c])).margin(1e-9));
        CHECK(to_double(a[c]) == Approx(vertex.point[c]).margin(1e-9));
      }
    }
  }
}

TEST_CASE("boundary and inner lines of random patches on pieces of themselves") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    const BezierPatch x = random_pairs::small_rationals(generator).x;
    const BezierPatch y = x.restricted_to(q(1, 3), q(4, 3), q(-1, 4), q(3, 4));
    check_against_intervals(x, y, {Parameter::u, 1});
    check_against_intervals(x, y, {Parameter::v, q(1, 2)});
    check_against_intervals(x, y.exchanged(), {Parameter::s, 0});
    check_against_intervals(x, y, {Parameter::u, 0});  // not on y
  }
}

TEST_CASE("a line on a patch that covers it twice has an arc for each sheet") {
  ControlNet folded;
  for (auto& row : folded) row.fill(Point{0, 0, 0});
  folded[0][0] = {1, 0, 0};  // ((2 r - 1)^2, s, s^2)
  folded[1][0] = {-4, 0, 0};
  folded[2][0] = {4, 0, 0};
  folded[0][1] = {0, 1, 0};
  folded[0][2] = {0, 0, 1};
  ControlNet piece = folded;
  piece[0][0] = {q(1, 16), 0, 0};  // (1/16 + 3/16 u, v, v^2)
  piece[1][0] = {q(3, 16), 0, 0};
  piece[2][0] = {0, 0, 0};
  const BezierPatch x = BezierPatch::from_power_basis(piece);
  const BezierPatch y = BezierPatch::from_power_basis(folded);
  const LineArcs found = arcs_of(x, y, {Parameter::u, 1});
  CHECK(!found.incomplete);
  REQUIRE(found.arcs.size() == 2);
  for (const LineArc& arc : found.arcs) {
    const RationalInterval r = arc.inside.box()[2];
    CHECK((r.lower <= q(1, 4) ? q(1, 4) <= r.upper : r.lower <= q(3, 4) && q(3, 4) <= r.upper));
  }
}

/// sum of the terms, power basis.
BezierPatch patch_of(const std::vector<std::pair<std::array<std::size_t, 2>, Point>>& terms) {
  ControlNet c{};
  for (const auto& [power, coefficient] : terms) c[power[0]][power[1]] = coefficient;
  return BezierPatch::from_power_basis(c);
}

TEST_CASE("a common side is one arc where patches are singular on it") {
  // (u², v, u (v - 1/2)) is singular at (0,1/2), (u², v, u v) at (0,0), (-r, s², 0) on s = 0.
  const BezierPatch plane = patch_of({{{1, 0}, {-1, 0, 0}}, {{0, 1}, {0, 1, 0}}});
  const BezierPatch squared = patch_of({{{1, 0}, {-1, 0, 0}}, {{0, 2}, {0, 1, 0}}});
  for (const Rational& singular : {Rational(0), q(1, 2), q(2, 7)}) {
    const BezierPatch x = patch_of(
        {{{2, 0}, {1, 0, 0}}, {{0, 1}, {0, 1, 0}}, {{1, 0}, {0, 0, -singular}}, {{1, 1}, {0, 0, 1}}});
    for (const BezierPatch& y : {plane, squared})
      for (const bool exchanged : {false, true}) {
        const BezierPatch& own = exchanged ? y : x;
        const BezierPatch& other = exchanged ? x : y;
        check_against_intervals(own, other, {Parameter::u, 0});
        check_against_intervals(own.exchanged(), other, {Parameter::v, 0});
        check_against_intervals(own, other.exchanged(), {Parameter::u, 0});
        check_against_intervals(own.reversed_second(), other, {Parameter::u, 0});
      }
  }
}

bool contains(const RationalInterval& i, const Rational& q) { return i.lower <= q && q <= i.upper; }

TEST_CASE("a side that folds back on itself, on another such side") {
  // (t² - 2 turn t, 0, 0) for both: t = s and t = 2 turn - s.
  const auto patch = [](const Rational& turn, const Rational& sign) {
    return patch_of(
        {{{0, 2}, {1, 0, 0}}, {{0, 1}, {-2 * turn, 0, 0}}, {{1, 0}, {0, sign, 0}}, {{1, 1}, {0, 0, 1}}});
  };
  using Ends = std::array<Rational, 4>;  // t and s where t is least, and where it is greatest
  const Rational third = q(1, 3);
  const Rational half = q(1, 2);
  const std::vector<std::pair<Rational, std::vector<Ends>>> cases = {
      {third,
       {{0, 0, third, third},
        {0, 2 * third, third, third},
        {third, third, 1, 1},
        {third, third, 2 * third, 0}}},
      {half, {{0, 0, half, half}, {0, 1, half, half}, {half, half, 1, 0}, {half, half, 1, 1}}}};
  for (const auto& [turn, arcs] : cases)
    for (const Parameter side : {Parameter::u, Parameter::r}) {
      const LineArcs found = arcs_of(patch(turn, 1), patch(turn, -1), {side, 0});
      CHECK(!found.incomplete);
      CHECK(found.arcs.size() == arcs.size());
      const std::size_t t = index(side) + 1;
      for (const Ends& ends : arcs)
        CHECK(std::count_if(found.arcs.begin(), found.arcs.end(), [&](const LineArc& arc) {
                const ParameterBox& from = found.ends[arc.from].box();
                const ParameterBox& to = found.ends[arc.to].box();
                return contains(from[t], ends[0]) && contains(from[4 - t], ends[1]) &&
                       contains(to[t], ends[2]) && contains(to[4 - t], ends[3]);
              }) == 1);
    }
}

TEST_CASE("parts of a side that folds back on itself") {
  // u = 0 is (v² - v, 0, 0); r = 0 is (s - 1/8, 0, 0) or (s² - 1/8, 0, 0): v² - v >= -1/8.
  const BezierPatch x =
      patch_of({{{0, 2}, {1, 0, 0}}, {{0, 1}, {-1, 0, 0}}, {{1, 0}, {0, 1, 0}}, {{1, 1}, {0, 0, 1}}});
  for (const std::size_t power : {1U, 2U}) {
    const BezierPatch y =
        patch_of({{{0, 0}, {q(-1, 8), 0, 0}}, {{0, power}, {1, 0, 0}}, {{1, 0}, {0, 1, 0}}});
    const LineArcs found = arcs_of(x, y, {Parameter::u, 0});
    CHECK(!found.incomplete);
    REQUIRE(found.arcs.size() == 2);
    for (const LineArc& arc : found.arcs) {
      const Rational from = found.ends[arc.from].box()[1].midpoint();
      const Rational to = found.ends[arc.to].box()[1].midpoint();
      CHECK((from == 0) != (to == 1));
      CHECK(to_double(to - from) == Approx(0.5 - std::sqrt(0.125)));
      for (const PolylineVertex& vertex : arc.polyline) {
        const auto& z = vertex.parameters;
        CHECK(z[1] * (z[1] - 1) == Approx(std::pow(z[3], power) - 0.125).margin(1e-9));
      }
      for (const ParameterBox& hull : arc.hulls) CHECK(hull[1].width() <= to - from + q(1, 1000));
    }
  }
}

TEST_CASE("at a fold of the other patch two arcs begin, or end") {
  // r = 0 is (s, 0, 0); the other patch is (1/4 + 2 (u - 1/2)², v - 1/2 - (u - 1/2) / 4, 0) or its mirror
  // image.
  const BezierPatch own = patch_of({{{0, 1}, {1, 0, 0}}, {{1, 0}, {0, 0, 1}}});
  for (const int sign : {1, -1}) {
    const BezierPatch folded = patch_of({{{0, 0}, {q(1, 2) + sign * q(1, 4), q(-3, 8), 0}},
                                         {{1, 0}, {-2 * sign, q(-1, 4), 0}},
                                         {{2, 0}, {2 * sign, 0, 0}},
                                         {{0, 1}, {0, 1, 0}}});
    const LineArcs found = arcs_of(folded, own, {Parameter::r, 0});
    CHECK(!found.incomplete);
    REQUIRE(found.arcs.size() == 2);
    const Rational fold = q(1, 2) - sign * q(1, 4);
    for (const LineArc& arc : found.arcs) {
      const ParameterBox& at_fold = found.ends[sign > 0 ? arc.from : arc.to].box();
      CHECK(contains(at_fold[3], fold));
      CHECK(contains(at_fold[0], q(1, 2)));
    }
    const auto far_u = [&](const LineArc& arc) {
      return found.ends[sign > 0 ? arc.to : arc.from].box()[0].lower;
    };
    CHECK(far_u(found.arcs[0]) != far_u(found.arcs[1]));
  }
}

TEST_CASE("arcs beside each other on one line have hulls that are apart") {
  // r = 0 is (s, 0, 0); the other patch comes there twice, on the lines v = u / 2 + 1/4 and v = u / 2 + 3/8.
  const BezierPatch own = patch_of({{{0, 1}, {1, 0, 0}}, {{1, 0}, {0, 0, 1}}});
  // v² - v (u + 5/8) + (u/2 + 1/4)(u/2 + 3/8)
  const BezierPatch other = patch_of({{{0, 0}, {0, q(3, 32), 0}},
                                      {{1, 0}, {1, q(5, 16), 0}},
                                      {{2, 0}, {0, q(1, 4), 0}},
                                      {{0, 1}, {0, q(-5, 8), 0}},
                                      {{1, 1}, {0, -1, 0}},
                                      {{0, 2}, {0, 1, 0}}});
  const LineArcs found = arcs_of(other, own, {Parameter::r, 0});
  CHECK(!found.incomplete);
  REQUIRE(found.arcs.size() == 2);
  for (const ParameterBox& a : found.arcs[0].hulls)
    for (const ParameterBox& b : found.arcs[1].hulls) CHECK(!meet(a, b));
}

TEST_CASE("the polyline of a common line keeps its bound") {
  random_pairs::Generator generator(7);
  const BezierPatch x = random_pairs::small_rationals(generator).x;
  const BezierPatch y = x.restricted_to(q(1, 3), q(4, 3), q(-1, 4), q(3, 4));
  const ModelScale scale = model_scale(x, y);
  for (const double tolerance : {1e-1, 1e-3, 1e-6}) {
    const LineArcs found = line_arcs(x, y, {Parameter::u, q(1, 2)}, scale, tolerance, {});
    REQUIRE(found.arcs.size() == 1);
    const LineArc& arc = found.arcs[0];
    CHECK(arc.error_bound <= tolerance);
    double farthest = 0;  // of the points in the middle of the chords' parameters from the chords' middles
    for (std::size_t i = 1; i < arc.polyline.size(); ++i) {
      const auto& a = arc.polyline[i - 1];
      const auto& b = arc.polyline[i];
      const Point p = x(q(1, 2), from_double(0.5 * (a.parameters[1] + b.parameters[1])));
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c)
        sum += std::pow(to_double(p[c]) - 0.5 * (a.point[c] + b.point[c]), 2);
      farthest = std::max(farthest, std::sqrt(sum));
    }
    CHECK(farthest <= arc.error_bound);
    CHECK(farthest > 0.1 * arc.error_bound);
  }
}

TEST_CASE("a line that is one point is an arc for every point of the other patch there") {
  const BezierPatch cone = patch_of({{{1, 0}, {1, -1, 0}}, {{1, 1}, {0, 2, 0}}, {{2, 0}, {0, 0, 1}}});
  // (s - 1/2, (2r - 1)² - 1/4, s - 2 s²): the origin at r = 1/4 and at r = 3/4.
  const BezierPatch twice = patch_of({{{0, 0}, {q(-1, 2), q(3, 4), 0}},
                                      {{1, 0}, {0, -4, 0}},
                                      {{2, 0}, {0, 4, 0}},
                                      {{0, 1}, {1, 0, 1}},
                                      {{0, 2}, {0, 0, -2}}});
  const LineArcs found = arcs_of(cone, twice, {Parameter::u, 0});
  CHECK(!found.incomplete);
  REQUIRE(found.arcs.size() == 2);
  for (const LineArc& arc : found.arcs) {
    CHECK(arc.collapsed);
    CHECK(found.ends[arc.from].box()[1].upper == 0);
    CHECK(found.ends[arc.to].box()[1].lower == 1);
    CHECK(arc.inside.sides() == std::vector<Side>{{Parameter::u, 0}});
    const RationalInterval r = arc.inside.box()[2];
    CHECK((r.lower <= q(1, 4) ? q(1, 4) <= r.upper : r.lower <= q(3, 4) && q(3, 4) <= r.upper));
    CHECK((arc.inside.box()[3].lower <= q(1, 2) && q(1, 2) <= arc.inside.box()[3].upper));
  }
  // A side of the other patch there, too: no arc, a square of solutions (common_pole.h).
  const LineArcs pole = arcs_of(cone, cone, {Parameter::u, 0});
  CHECK((!pole.incomplete && pole.arcs.empty()));
  // (2r - 1) (1, s, r): a line inside the other patch, of which nothing is known.
  const BezierPatch inside = patch_of({{{0, 0}, {-1, 0, 0}},
                                       {{1, 0}, {2, 0, -1}},
                                       {{2, 0}, {0, 0, 2}},
                                       {{0, 1}, {0, -1, 0}},
                                       {{1, 1}, {0, 2, 0}}});
  CHECK(arcs_of(cone, inside, {Parameter::u, 0}).incomplete);
}

TEST_CASE("a line through a collapsed line of the other patch") {
  ControlNet collapsed;  // r (1, s, r)
  for (auto& row : collapsed) row.fill(Point{0, 0, 0});
  collapsed[1][0] = {1, 0, 0};
  collapsed[1][1] = {0, 1, 0};
  collapsed[2][0] = {0, 0, 1};
  ControlNet through;  // (u - 1/2, v, 1/3 - u...)
  for (auto& row : through) row.fill(Point{0, 0, 0});
  through[0][0] = {q(-1, 2), q(-1, 2), 0};
  through[1][0] = {1, 1, 0};
  through[2][0] = {0, 0, 0};
  through[0][1] = {0, 0, 1};
  const LineArcs found = arcs_of(BezierPatch::from_power_basis(through),
                                 BezierPatch::from_power_basis(collapsed), {Parameter::v, 0});
  CHECK(found.arcs.empty());
  REQUIRE(found.collapsed.size() == 1);
  CHECK(found.collapsed[0].t.compare(q(1, 2)) == 0);
  CHECK(found.collapsed[0].fixed == Parameter::r);
  CHECK(found.collapsed[0].value.compare(0) == 0);
}

}  // namespace
}  // namespace exsect::line_arcs_test
