// Curves on tori without a rational frame, against the same curves in the charts of the other torus, or on a
// quadric, or with the roles exchanged by an equation.
#include "lift/ring_curve.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/surface_box.h>
#include <exsect/solver/intersect_equations.h>

#include <cmath>
#include <map>
#include <string>

#include "lift/torus_curve.h"
#include "support/catch.h"

namespace exsect::ring_curve_test {
namespace {

using S = ImplicitSurface;
const Point origin = {0, 0, 0}, up = {0, 0, 1}, right = {1, 0, 0}, oblique = {1, 1, 1};

Rational tenth_to(int k) { return k == 0 ? Rational(1) : tenth_to(k - 1) / 10; }
const std::vector<int> near = {3, 6, 10, 20};

IntersectOptions within(double tolerance) {
  IntersectOptions options;
  options.tolerance = tolerance;
  return options;
}

/// In the middle of every eighth chord the distance from the surface, F / |grad F| for small ones, is within
/// the bound.
void check_near(const SpaceArc& arc, const S& surface) {
  const SpacePolynomial& f = surface.equation();
  for (std::size_t k = 0; k + 1 < arc.polyline.size(); k += 8) {
    Point p;
    for (std::size_t c = 0; c < 3; ++c)
      p[c] = (from_double(arc.polyline[k][c]) + from_double(arc.polyline[k + 1][c])) / 2;
    double squared = 0;
    const Rational step = power_of_two(-30);
    for (std::size_t c = 0; c < 3; ++c) {
      Point q = p;
      q[c] += step;
      squared += std::pow(to_double((f(q) - f(p)) / step), 2);
    }
    if (squared > 1) CHECK(std::fabs(to_double(f(p))) <= 1.1 * arc.error_bound * std::sqrt(squared));
  }
}

/// Closed curves by multiplicity, and special nodes.
using Shape = std::map<std::string, int>;
Shape shape(const S& first, const S& second) {
  const SurfaceIntersection result = intersect(first, second, within(1e-3));
  Shape counts;
  counts[result.status != Status::complete ? "incomplete" : result.is_same ? "same" : "complete"] = 1;
  for (const SpaceCurve& curve : result.curves) {
    CHECK(curve.is_closed);
    ++counts["closed " + std::to_string(curve.multiplicity)];
  }
  for (const SpaceNode& node : result.nodes)
    if (node.kind != SpaceNodeKind::joint) ++counts[name(node.kind)];
  for (const SpaceArc& arc : result.arcs)
    for (const S* of : {&first, &second}) check_near(arc, *of);
  for (const SpaceArc& arc : result.arcs)  // on both sides of common circles ends are one point
    for (std::size_t c = 0; c < 3; ++c) {
      const auto at = [&](int node) { return result.nodes[static_cast<std::size_t>(node)].approx[c]; };
      CHECK(std::fabs(arc.polyline.front()[c] - at(arc.from)) < 1e-9);
      CHECK(std::fabs(arc.polyline.back()[c] - at(arc.to)) < 1e-9);
    }
  return counts;
}

double length(const SurfaceIntersection& result) {
  double sum = 0;
  for (const SpaceArc& arc : result.arcs)
    for (std::size_t k = 0; k + 1 < arc.polyline.size(); ++k) {
      const auto &a = arc.polyline[k], &b = arc.polyline[k + 1];
      sum += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    }
  return sum;
}

S by_equation(const S& surface) { return S::polynomial(surface.equation()); }
S skew_torus(const Point& at, const Rational& size) {
  return S::torus(at, oblique, Length::of_squared(12 * size * size), Length::of_squared(3 * size * size));
}

}  // namespace

TEST_CASE("rings: both charts cover the torus, and agree on the circles between them") {
  for (const S& torus : {skew_torus({1, 2, 3}, Rational(5, 7)), S::torus(origin, {1, -2, 0}, 3, 1),
                         S::torus(origin, {2, 1, 2}, Length::of_squared(5), 1)}) {
    const auto charts = ring_charts(*torus.data(), Rational(8, 7)).value();
    for (const SurfaceChart& chart : charts) CHECK(on_chart(torus.equation(), chart).is_zero());
    for (const int side : {0, 1})
      for (const Rational& v : {Rational(1, 3), Rational(1, 2)}) {
        const auto at = [&](const SurfaceChart& chart) {
          const Rational below = chart.denominator(side);
          return chart.origin + chart.height(side) / below * chart.along_u +
                 chart.width(side) / below * (v - chart.middle) * chart.along_v;
        };
        CHECK(at(charts[0]) == at(charts[1]));
        CHECK(charts[0].radicand(side, v) == charts[1].radicand(side, v));
      }
  }
  CHECK(!ring_charts(*S::torus(origin, up, 2, Length::of_squared(2)).data(), 1));
  CHECK(ring_charts(*S::torus(origin, up, Length::of_squared(5), 2).data(), 1));
}

TEST_CASE("rings: a torus with a frame is found alike in its four patches") {
  for (const S& torus : {S::torus(origin, up, 5, 2), S::torus({1, 0, 2}, {2, -2, 1}, 4, 3)})
    for (const S& other : {S::torus({3, 0, 1}, {2, 2, 1}, 4, 1), S::torus({6, 1, 0}, oblique, 5, 2),
                           S::torus({4, 0, 0}, right, 3, 2), by_equation(S::sphere({4, 1, 0}, 3)),
                           by_equation(S::plane({1, 0, 0}, {1, 2, 3}))}) {
      const auto [patches, halves] = in_nearest_rounding([&] {
        return std::pair(torus_curve(torus, other, {}).value(), ring_curve(torus, other, {}).value());
      });
      const auto degrees = [](const auto& nodes) {
        std::map<int, int> counts;
        for (const auto& node : nodes)
          if (node.degree != 2) ++counts[node.degree];
        return counts;
      };
      CHECK(degrees(patches.nodes) == degrees(halves.nodes));
      CHECK(patches.arcs.empty() == halves.arcs.empty());
      std::map<std::size_t, int> parts[2];
      for (const RingArc& arc : halves.arcs) ++parts[0][arc.factor];
      for (const TorusArc& arc : patches.arcs) ++parts[1][arc.factor];
      CHECK(parts[0].size() >= parts[1].size());
    }
}

TEST_CASE("rings: the charts of the other torus show the same") {
  const S torus = S::torus(origin, up, 5, 2);
  for (const S& ring :
       {skew_torus({3, 1, 0}, 1), S::torus({3, 1, 0}, {1, 2, 2}, Length::of_squared(10), 1)}) {
    const Shape found = shape(ring, torus);
    CHECK(found.contains("complete"));
    CHECK(shape(torus, ring) == found);
    CHECK(shape(by_equation(torus), ring) == found);
    CHECK(shape(torus, by_equation(ring)) == found);
    const double all = length(intersect(torus, by_equation(ring), within(1e-4)));
    CHECK(all > 1);
    CHECK(std::fabs(length(intersect(by_equation(torus), ring, within(1e-4))) - all) < 1e-3 * all);
  }
}

TEST_CASE("rings: two tori without frames, crossing, touching and missing") {
  const S first = skew_torus(origin, 1);
  // Beside each other along (1,-1,0), of length sqrt(2): radii sqrt(12) + sqrt(3) = 3 sqrt(3) on each side.
  const Point aside = {1, -1, 0};
  const S wide =
      S::torus(origin, oblique, Length::of_squared(Rational(8, 9)), Length::of_squared(Rational(2, 9)));
  const auto beside = [&](const Rational& d) {
    return shape(wide, S::torus(d * aside, oblique, Length::of_squared(Rational(8, 9)),
                                Length::of_squared(Rational(2, 9))));
  };
  CHECK(beside(2) == Shape{{"complete", 1}, {"touch", 1}});
  for (const int k : near) {
    CHECK(beside(2 + tenth_to(k)) == Shape{{"complete", 1}});
    CHECK(beside(2 - tenth_to(k)) == Shape{{"complete", 1}, {"closed 1", 1}});
  }
  // Symmetric to the plane of x: over one place of the halves' common circles there are points of both signs.
  CHECK(shape(first, skew_torus({0, 2, -2}, 1)).contains("complete"));
  CHECK(shape(first, skew_torus({0, 4, -4}, Rational(2, 3))) ==
        shape(skew_torus({0, 4, -4}, Rational(2, 3)), first));
  const S second = S::torus({2, 0, 1}, {1, 2, 0}, 3, 1);
  const Shape found = shape(first, second);
  CHECK(found.contains("complete"));
  CHECK(found.size() > 1);
  CHECK(shape(second, first) == found);
  CHECK(shape(first, by_equation(second)) == found);
  CHECK(shape(second, by_equation(first)) == found);
  CHECK(shape(first, by_equation(first)) == Shape{{"same", 1}});
}

TEST_CASE("rings: sizes and places change no answer, and polylines keep within tolerances") {
  const auto pair = [&](const Rational& q, const Point& at) {
    return std::pair(
        S::torus(at, Rational(3) * oblique, Length::of_squared(12 * q * q), Length::of_squared(3 * q * q)),
        S::torus(at + q * Point{2, 0, 1}, {1, 2, 0}, Length(Rational(3 * q)), Length(q)));
  };
  const auto [first, second] = pair(1, origin);
  const SurfaceIntersection known = intersect(first, second, within(1e-3));
  // Chords as long as the root of the tolerance allows: 435 are enough, 3000 would be as long as it is.
  std::size_t vertices = 0;
  for (const SpaceArc& arc : known.arcs) vertices += arc.polyline.size();
  CHECK(vertices < 1000);
  for (const Rational& q : {Rational(1, 1000), Rational(127, 5), power_of_two(40)})
    for (const Point& at : {origin, Rational(100000000) * q * Point{1, 2, -1}}) {
      const auto [a, b] = pair(q, at);
      const SurfaceIntersection result = intersect(a, b, within(1e-3));
      REQUIRE(result.status == Status::complete);
      CHECK(result.curves.size() == known.curves.size());
      CHECK(result.arcs.size() == known.arcs.size());
      CHECK(std::fabs(length(result) / to_double(q) - length(known)) < 0.02 * length(known));
      for (const SpaceArc& arc : result.arcs) CHECK(arc.error_bound < 0.011 * to_double(q));
    }
}

TEST_CASE("rings: circles about the axis and in planes through it, and halves in boxes") {
  const S ring = skew_torus(origin, 1);
  const S level = by_equation(S::plane(oblique, oblique));  // at the height sqrt(3): on top
  const SurfaceIntersection top = intersect(ring, level, within(1e-3));
  REQUIRE(top.curves.size() == 1);
  CHECK(top.curves[0].kind == SpaceCurveKind::circle);
  CHECK(top.curves[0].multiplicity == 2);
  CHECK(top.curves[0].point == oblique);
  CHECK(top.curves[0].radius_squared == Rational(12));
  const S cut = by_equation(S::plane(origin, {1, -1, 0}));
  const SurfaceIntersection meridians = intersect(ring, cut, within(1e-3));
  CHECK(meridians.count(SpaceCurveKind::circle) + meridians.count(SpaceCurveKind::general) == 2);
  SurfaceBox box;
  box.sector = AxisSector{{1, 2, -4}, {-1, -2, 4}};
  const S half = boxed(ring, box);
  std::swap(box.sector->from, box.sector->to);
  const S rest = boxed(ring, box), other = S::torus({2, 0, 1}, {1, 2, 0}, 3, 1);
  const double all = length(intersect(ring, other, within(1e-4)));
  CHECK(all > 1);
  CHECK(std::fabs(length(intersect(half, other, within(1e-4))) +
                  length(intersect(rest, other, within(1e-4))) - all) < 1e-3 * all);
}

}  // namespace exsect::ring_curve_test
