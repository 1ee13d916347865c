#include "shape/injective_rectangle.h"

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::injective_rectangle_test {

namespace {

struct Term {
  std::size_t i;
  std::size_t j;
  Point p;
};

BezierPatch patch(const std::vector<Term>& terms) {
  ControlNet c{};
  for (const Term& term : terms) c[term.i][term.j] = term.p;
  return BezierPatch::from_power_basis(c);
}

constexpr int kWhole = 1;
ParameterRectangle square(const Rational& width) { return {{0, width}, {0, width}}; }

/// u (1, v, v^2): a cone with its tip along u = 0.
const std::vector<Term> cone = {{1, 0, {1, 0, 0}}, {1, 1, {0, 1, 0}}, {1, 2, {0, 0, 1}}};

/// Brute force: equal points of space on a grid of the rectangle, apart from those on u = 0.
int equal_pairs(const BezierPatch& x, const ParameterRectangle& where) {
  constexpr int kCells = 6;
  std::vector<Point> points;
  for (int i = 1; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j)
      points.push_back(
          x(where.u.lower + where.u.width() * i / kCells, where.v.lower + where.v.width() * j / kCells));
  int equal = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) equal += points[i] == points[j] ? 1 : 0;
  return equal;
}

}  // namespace

TEST_CASE("injective rectangles: planes, tips, folds") {
  CHECK(is_injective(patch({{1, 0, {1, 0, 0}}, {0, 1, {0, 1, 0}}}), square(kWhole)));
  CHECK(is_injective(patch(cone), square(kWhole)));
  // u (1, v - 1/2, (v - 1/2)^2 / 4) is a cone; u (1, 0, (v - 1/2)^2) covers a sector twice.
  const Rational half(1, 2);
  const Rational quarter(1, 4);
  CHECK(
      !is_injective(patch({{1, 0, {1, 0, quarter}}, {1, 1, {0, 0, -1}}, {1, 2, {0, 0, 1}}}), square(kWhole)));
  // x_u = 0 along u = 0: (u^2, v, 0); inside: ((u - 1/2)^2, v, 0).
  CHECK(is_injective(patch({{2, 0, {1, 0, 0}}, {0, 1, {0, 1, 0}}}), square(kWhole)));
  const BezierPatch fold =
      patch({{0, 0, {quarter, 0, 0}}, {1, 0, {-1, 0, 0}}, {2, 0, {1, 0, 0}}, {0, 1, {0, 1, 0}}});
  CHECK(!is_injective(fold, square(kWhole)));
  CHECK(is_injective(fold, square(half)));
  CHECK(!is_injective(fold, {{half - power_of_two(-30), half + power_of_two(-30)}, {0, 1}}));
  // The inner line u = 1/2 is one point: (a, a v, 0), a = u - 1/2, on either side of it.
  const BezierPatch cross =
      patch({{0, 0, {-half, 0, 0}}, {1, 0, {1, 0, 0}}, {0, 1, {0, -half, 0}}, {1, 1, {0, 1, 0}}});
  CHECK(!is_injective(cross, square(kWhole)));
  CHECK(!is_injective(cross, square(half)));
  // A curve, and a point.
  CHECK(!is_injective(patch({{1, 0, {1, 0, 0}}, {2, 0, {0, 1, 0}}}), square(kWhole)));
  CHECK(!is_injective(patch({}), square(kWhole)));
}

TEST_CASE("injective rectangles: Whitney's umbrella at a corner") {
  // (u, v^2, u v): x_v = 0 at the origin; (u - a, v^2, (u - a) v) meets itself along u = a.
  CHECK(is_injective(patch({{1, 0, {1, 0, 0}}, {0, 2, {0, 1, 0}}, {1, 1, {0, 0, 1}}}), square(kWhole)));
  const auto shifted = [](const Rational& b) {
    return patch({{1, 0, {1, 0, -b}}, {0, 1, {0, -2 * b, 0}}, {0, 2, {0, 1, 0}}, {1, 1, {0, 0, 1}}});
  };
  CHECK(!is_injective(shifted(Rational(1, 4)), square(1)));
  CHECK(!is_injective(shifted(Rational(1, 4)), square(Rational(1, 2))));
  CHECK(is_injective(shifted(Rational(1, 4)), square(Rational(1, 4))));
  CHECK(is_injective(shifted(Rational(-1, 1000)), square(1)));
}

TEST_CASE("injective rectangles: of small integer nets with a side that is a point") {
  int proved = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    ControlNet net;
    for (auto& row : net)
      for (Point& p : row)
        for (Rational& c : p) c = random_pairs::integer(generator, -2, 2);
    net[0] = {net[0][0], net[0][0], net[0][0]};
    const BezierPatch x(net);
    const InjectiveRectangles found = injective_rectangles(x);
    for (const ParameterRectangle& where : found.rectangles) {
      CHECK(equal_pairs(x, where) == 0);
      ++proved;
    }
  }
  CHECK(proved >= 30);
}

}  // namespace exsect::injective_rectangle_test
