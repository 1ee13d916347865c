#include "curve/region_outline.h"

#include <array>
#include <cmath>

#include "algebra/random_numbers.h"
#include "curve/curve_place.h"
#include "support/catch.h"

namespace exsect::region_outline_test {
namespace {

BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }
const BivariatePolynomial u = BivariatePolynomial::r(), v = BivariatePolynomial::s();
const BivariatePolynomial a = u - number(Rational(1, 2)), b = v - number(Rational(1, 2));
const BivariatePolynomial disc = number(Rational(1, 9)) - a * a - b * b, minus = number(-1);

CurveRegion region(std::vector<BivariatePolynomial> bounds, std::vector<std::vector<std::size_t>> clauses) {
  CurveRegion result;
  result.bounds = std::move(bounds);
  result.clauses = std::move(clauses);
  return result;
}
CurveRegion all_of(const std::vector<BivariatePolynomial>& bounds) {
  std::vector<std::vector<std::size_t>> clauses;
  for (std::size_t i = 0; i < bounds.size(); ++i) clauses.push_back({i});
  return region(bounds, clauses);
}
CurveRegion any_of(const BivariatePolynomial& g, const BivariatePolynomial& h) {
  return region({g, h}, {{0, 1}});
}

/// Parts, chains, arcs of chains, further arcs, further points. All chains are closed.
using Shape = std::array<std::size_t, 5>;
Shape shape(const RegionOutline& of) {
  Shape counts = {of.parts.size(), 0, 0, of.curves.size(), of.points.size()};
  const auto ends = [&](const OutlineArc& at) {
    const CurveBranch& arc = of.graph.arcs[at.arc];
    return at.is_reversed ? std::array{arc.to, arc.from} : std::array{arc.from, arc.to};
  };
  for (const RegionPart& part : of.parts)
    for (const std::vector<OutlineArc>& chain : part.chains) {
      ++counts[1];
      counts[2] += chain.size();
      for (std::size_t k = 0; k < chain.size(); ++k)
        CHECK(ends(chain[k])[1] == ends(chain[(k + 1) % chain.size()])[0]);
    }
  return counts;
}
Shape shape(const CurveRegion& of) { return shape(outline(of)); }

TEST_CASE("outline: the square, nothing, halves, and parts that meet in a point") {
  CHECK(shape(CurveRegion()) == Shape{1, 1, 4, 0, 0});
  CHECK(shape(number(1)) == Shape{1, 1, 4, 0, 0});
  CHECK(shape(number(-1)) == Shape{0, 0, 0, 0, 0});
  CHECK(shape(number(0)) == Shape{1, 1, 4, 0, 0});
  CHECK(shape(a) == Shape{1, 1, 4, 0, 0});
  CHECK(shape(minus * b) == Shape{1, 1, 4, 0, 0});
  CHECK(shape(a * a) == Shape{1, 1, 6, 0, 0});
  CHECK(shape(a * a * b) == Shape{1, 1, 6, 1, 0});  // and the rest of the line a = 0
  CHECK(shape(a * b) == Shape{2, 2, 8, 0, 0});
  CHECK(shape(any_of(a, b)) == Shape{1, 1, 8, 0, 0});
  CHECK(shape(any_of(a, minus * a)) == Shape{1, 1, 6, 0, 0});
  CHECK(shape((a - b) * (a + b)) == Shape{2, 2, 6, 0, 0});
  CHECK(shape((u - number(Rational(1, 4))) * (u - number(Rational(3, 4)))) == Shape{2, 2, 8, 0, 0});
  CHECK(shape((v - number(Rational(1, 4))) * (v - number(Rational(3, 4)))) == Shape{2, 2, 8, 0, 0});
}

TEST_CASE("outline: discs, holes and rings") {
  CHECK(shape(disc) == Shape{1, 1, 2, 0, 0});
  CHECK(shape(minus * disc) == Shape{1, 2, 6, 0, 0});
  const BivariatePolynomial inner = number(Rational(1, 25)) - a * a - b * b;
  CHECK(shape(all_of({disc, minus * inner})) == Shape{1, 2, 4, 0, 0});
  CHECK(shape(any_of(inner, minus * disc)) == Shape{2, 3, 8, 0, 0});
  CHECK(shape(minus * inner * disc) == Shape{1, 2, 4, 0, 0});
  CHECK(shape(inner * disc) == Shape{2, 3, 8, 0, 0});
  CHECK(shape(disc * disc) == Shape{1, 1, 4, 0, 0});
  // Two discs side by side, apart, touching and overlapping.
  const auto pair = [&](const Rational& d) {
    const BivariatePolynomial p = a - number(d), q = a + number(d), room = number(Rational(1, 25)) - b * b;
    return shape(any_of(room - p * p, room - q * q));
  };
  CHECK(pair(Rational(1, 4)) == Shape{2, 2, 4, 0, 0});
  CHECK(pair(Rational(1, 5)) == Shape{2, 2, 4, 0, 0});
  CHECK(pair(Rational(1, 6))[0] == 1);
  CHECK(pair(Rational(1, 6))[1] == 1);
}

TEST_CASE("outline: what has no inner points") {
  CHECK(shape(all_of({a, minus * a})) == Shape{0, 0, 0, 1, 0});
  CHECK(shape(all_of({b, minus * b})) == Shape{0, 0, 0, 1, 0});
  CHECK(shape(all_of({a, minus * a, b, minus * b})) == Shape{0, 0, 0, 0, 1});
  CHECK(shape(minus * u) == Shape{0, 0, 0, 1, 0});
  CHECK(shape(minus * (u + v)) == Shape{0, 0, 0, 0, 1});
  CHECK(shape(u + v) == Shape{1, 1, 4, 0, 0});
  CHECK(shape(minus * (a * a + b * b)) == Shape{0, 0, 0, 0, 1});
  CHECK(shape(a * a + b * b) == Shape{1, 1, 4, 0, 0});
  CHECK(shape(all_of({disc, minus * disc})) == Shape{0, 0, 0, 2, 0});
}

/// The area to the left of the chains, by midpoints of their arcs over many u.
double area(const RegionOutline& of) {
  constexpr int kSteps = 30;
  double sum = 0;
  const Rational fine = power_of_two(-40);
  for (const RegionPart& part : of.parts)
    for (const std::vector<OutlineArc>& chain : part.chains)
      for (const OutlineArc& at : chain) {
        const CurveBranch& arc = of.graph.arcs[at.arc];
        const double from = to_double(place_of(of.graph, arc.from, fine)[0].midpoint()),
                     to = to_double(place_of(of.graph, arc.to, fine)[0].midpoint());
        if (!(to > from)) continue;
        int found = 0;
        double heights = 0;
        for (int k = 0; k < kSteps; ++k) {
          const Rational x = from_double(from + (to - from) * (k + 0.5) / kSteps);
          const auto y = arc_over(of.graph, at.arc, x, fine);
          found += y ? 1 : 0;
          heights += y ? to_double(y->midpoint()) : 0;
        }
        sum += (at.is_reversed ? 1 : -1) * (to - from) * heights / std::max(found, 1);
      }
  return sum;
}

TEST_CASE("outline: areas of random regions are those of the grid's points in them") {
  const std::uint64_t seed = 70213;
  INFO("seed " << seed);
  test::Random random(seed);
  const auto small = [&](int parts) { return number(Rational(random.integer(-6, 6), parts)); };
  for (int round = 0; round < 5; ++round) {
    std::vector<BivariatePolynomial> bounds;
    for (int i = 0; i < 3; ++i)
      bounds.push_back(small(4) * a + small(4) * b + small(40) +
                       (i == 0 ? small(3) * a * b - small(3) * a * a : small(9) * a * b));
    const CurveRegion part = region(bounds, {{0, 1}, {2}});
    constexpr int kCells = 60;
    int inside = 0;
    for (int i = 0; i < kCells; ++i)
      for (int j = 0; j < kCells; ++j) {
        const Rational x(2 * i + 1, 2 * kCells), y(2 * j + 1, 2 * kCells);
        const auto holds = [&](std::size_t k) { return bounds[k](x, y) >= 0; };
        inside += (holds(0) || holds(1)) && holds(2) ? 1 : 0;
      }
    CHECK(std::fabs(area(outline(part)) - inside / double{kCells * kCells}) < 0.04);
    shape(part);
  }
}

}  // namespace
}  // namespace exsect::region_outline_test
