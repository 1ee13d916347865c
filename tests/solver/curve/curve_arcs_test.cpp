#include <exsect/solver/curve_arcs.h>

#include <algorithm>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::curve_arcs_test {
namespace {

const BivariatePolynomial u = BivariatePolynomial::r();
const BivariatePolynomial v = BivariatePolynomial::s();
BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }

BivariatePolynomial circle(const Rational& a, const Rational& b, const Rational& squared_radius) {
  return (u - number(a)) * (u - number(a)) + (v - number(b)) * (v - number(b)) - number(squared_radius);
}

struct Counts {
  int open = 0, closed = 0, branched = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};
std::ostream& operator<<(std::ostream& out, const Counts& c) {
  return out << c.open << " open, " << c.closed << " closed, " << c.branched << " branched";
}

Counts counts(const CurveArcs& curve) {
  Counts result;
  for (const CurveComponent& c : components(curve, std::vector<bool>(curve.arcs.size(), true)))
    ++(c.branched ? result.branched : c.closed ? result.closed : result.open);
  return result;
}
Counts counts(const BivariatePolynomial& f) { return counts(curve_arcs(f)); }

const Rational half(1, 2);

TEST_CASE("curves without arcs, and bad input") {
  CHECK(counts(number(1)) == Counts{0, 0, 0});
  CHECK(counts(u * u + v * v + number(1)) == Counts{0, 0, 0});
  CHECK_THROWS_AS(curve_arcs({}), std::domain_error);
  CHECK_THROWS_AS(curve_arcs((u - v) * (u - v)), std::domain_error);
  CHECK_THROWS_AS(curve_arcs(v), std::domain_error);
  const CurveArcs lines = curve_arcs((u - number(half)) * (u * u - number(Rational(1, 3))));
  CHECK(lines.vertical.size() == 2);
  CHECK(lines.arcs.empty());
}

TEST_CASE("lines, circles and their crossings") {
  CHECK(counts(v - number(half)) == Counts{1, 0, 0});
  CHECK(counts(u - v) == Counts{1, 0, 0});
  CHECK(counts(circle(half, half, Rational(1, 16))) == Counts{0, 1, 0});
  CHECK(counts(circle(half, half, Rational(1, 4))) == Counts{0, 1, 0});  // touches all four sides
  CHECK(counts(circle(half, half, Rational(1, 3))) == Counts{4, 0, 0});
  CHECK(counts(circle(0, 0, half)) == Counts{1, 0, 0});
  CHECK(counts(circle(Rational(1, 3), Rational(1, 3), Rational(1, 100)) *
               circle(Rational(2, 3), Rational(2, 3), Rational(1, 100))) == Counts{0, 2, 0});
  // a crossing at a rational point is exact, others stay unresolved: branched either way
  CHECK(counts((u - v) * (u + v - number(1))) == Counts{0, 0, 1});
  CHECK(counts((u - v) * circle(half, half, Rational(1, 17))) == Counts{0, 0, 1});
  // several loops over the same u
  CHECK(counts(circle(half, Rational(1, 4), Rational(1, 100)) *
               circle(half, Rational(3, 4), Rational(1, 100))) == Counts{0, 2, 0});
}

TEST_CASE("cusps, nodes and sides met by several arcs") {
  const BivariatePolynomial x = number(2) * u - number(1), y = number(2) * v - number(1);
  CHECK(counts(y * y - x * x * x) == Counts{1, 0, 0});                     // cusp
  CHECK(counts(y * y - x * x * (x + number(half))) == Counts{0, 0, 1});    // node
  CHECK(counts(y * y - (u - number(Rational(1, 3)))) == Counts{1, 0, 0});  // a parabola
  // two arcs leave through v = 0 and v = 1 at the same irrational u
  const BivariatePolynomial steep = u * u - number(half) + number(3) * (v - v * v);
  CHECK(counts(steep).branched == 0);
}

TEST_CASE("meetings and events hang together") {
  const std::uint64_t seed = 20260117;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int round = 0; round < 15; ++round) {
    std::vector<Polynomial> rows;
    for (int i = 0; i <= 3; ++i) rows.push_back(random.polynomial(3, 20));
    const BivariatePolynomial f(rows);
    const CurveArcs curve = curve_arcs(f);
    REQUIRE(curve.events.size() == curve.gaps.size() + 1);
    std::vector<int> left(curve.arcs.size(), 0), right(curve.arcs.size(), 0);
    for (std::size_t i = 0; i < curve.events.size(); ++i)
      for (const CurveMeeting& meeting : curve.events[i].meetings) {
        for (const std::size_t arc : meeting.left) {
          CHECK(curve.arcs[arc].gap + 1 == i);
          ++right[arc];
        }
        for (const std::size_t arc : meeting.right) {
          CHECK(curve.arcs[arc].gap == i);
          ++left[arc];
        }
      }
    CHECK(std::all_of(left.begin(), left.end(), [](int n) { return n == 1; }));
    CHECK(std::all_of(right.begin(), right.end(), [](int n) { return n == 1; }));
    // The number of roots is that of the gap anywhere in it.
    for (std::size_t i = 0; i + 1 < curve.events.size(); ++i) {
      const Rational from = curve.events[i].u.upper, to = curve.events[i + 1].u.lower;
      for (const Rational& t : {Rational(1, 7), Rational(1, 2), Rational(6, 7)})
        CHECK(real_roots(f.at_r(from + t * (to - from)), 0, 1).size() == curve.gaps[i].arcs.size());
    }
    // Exchanging u and v keeps the components.
    CHECK(counts(curve) == counts(f.exchanged()));
  }
}

TEST_CASE("extra events split arcs and nothing else") {
  const BivariatePolynomial f = circle(half, half, Rational(1, 16));
  const CurveArcs curve = curve_arcs(f, {{Rational(9, 20), Rational(91, 200)}});
  CHECK(curve.arcs.size() == 4);
  CHECK(counts(curve) == Counts{0, 1, 0});
  CHECK_FALSE(std::any_of(curve.events.begin(), curve.events.end(),
                          [](const CurveEvent& e) { return e.is_crowded; }));
  // an interval around the whole circle
  const CurveArcs crowded = curve_arcs(f, {{Rational(1, 5), Rational(4, 5)}});
  CHECK(std::any_of(crowded.events.begin(), crowded.events.end(),
                    [](const CurveEvent& e) { return e.is_crowded; }));
  std::vector<bool> kept = {true, false, true, false};
  const std::vector<CurveComponent> lower = components(curve, kept);
  REQUIRE(lower.size() == 1);
  CHECK_FALSE(lower[0].closed);
}

}  // namespace
}  // namespace exsect::curve_arcs_test
