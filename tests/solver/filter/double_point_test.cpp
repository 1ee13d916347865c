// Touch points and crossings of biquadratic pairs in doubles, against the exact solution.
#include "filter/double_point.h"

#include "filter/filter.h"
#include "intersect_exactly.h"
#include "support/catch.h"
#include "support/families.h"
#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/graph_patches.h"
#include "support/random_pairs.h"

namespace exsect::double_point_test {
namespace {

using random_pairs::Generator;
using random_pairs::integer;
using random_pairs::Pair;

/// c[i][j] belongs to X^i Y^j.
using Quadratic = testing::HeightCoefficients;

Quadratic product(const std::array<Rational, 3>& a, const std::array<Rational, 3>& b) {
  Quadratic c{};  // of p + q X + r Y
  c[0][0] = a[0] * b[0];
  c[1][0] = a[0] * b[1] + a[1] * b[0];
  c[0][1] = a[0] * b[2] + a[2] * b[0];
  c[2][0] = a[1] * b[1];
  c[0][2] = a[2] * b[2];
  c[1][1] = a[1] * b[2] + a[2] * b[1];
  return c;
}

Quadratic sum(const Quadratic& a, const Rational& factor, const Quadratic& b) {
  Quadratic c = a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) c[i][j] += factor * b[i][j];
  return c;
}

BezierPatch graph(const Quadratic& f, const Rational& from, const Rational& to) {
  return testing::graph_patch(f).restricted_to(from, to, from, to);
}

Rational sixteenths(Generator& generator, long largest) {
  return Rational(integer(generator, -largest, largest), 16);
}

/// Near a multiple of the identity, so that rounding errors stay small.
random_pairs::AffineMap upright_map(Generator& generator) {
  random_pairs::AffineMap map{{}, {0, 0, 0}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) map.rows[i][k] = sixteenths(generator, 5) + (i == k ? 1 : 0);
  return map;
}

/// The graphs of f + h and f, the second one larger and sometimes turned over, under an affine map.
Pair graphs(Generator& generator, const Quadratic& h) {
  Quadratic f{};
  for (auto& row : f)
    for (Rational& c : row) c = sixteenths(generator, 6);
  const auto map = upright_map(generator);
  const Rational margin(integer(generator, 1, 4), 16);
  const BezierPatch y = map(graph(f, -margin, 1 + margin));
  return {map(graph(sum(f, 1, h), 0, 1)), integer(generator, 0, 1) == 0 ? y : y.exchanged().reversed_first()};
}

/// A definite or an indefinite form in X and Y minus the centre.
Pair with_double_point(Generator& generator, int sign) {
  const Rational a = Rational(1, 2) + sixteenths(generator, 3);
  const Rational b = Rational(1, 2) + sixteenths(generator, 3);
  const Rational slope(2 * integer(generator, -4, 3) + 1, 16);
  const std::array<Rational, 3> first = {-a - slope * b, 1, slope};
  const std::array<Rational, 3> second = {-b + slope * a, -slope, 1};
  const Rational factor(sign * integer(generator, 4, 15), 16);
  return graphs(generator, sum(product(first, first), factor, product(second, second)));
}
Pair touch(Generator& generator) { return with_double_point(generator, 1); }
Pair crossing(Generator& generator) { return with_double_point(generator, -1); }

/// ((X - 1/4)(Y - 3/4))² + factor (X - Y)²: double points in (1/4,1/4) and (3/4,3/4).
Pair with_two(Generator& generator, const Rational& factor) {
  Quadratic h{};
  const std::array<Rational, 3> x = {Rational(1, 16), Rational(-1, 2), 1};
  const std::array<Rational, 3> y = {Rational(9, 16), Rational(-3, 2), 1};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) h[i][j] = x[i] * y[j];
  return graphs(generator, sum(h, factor, product({0, 1, -1}, {0, 1, -1})));
}

/// True if doubles decide the pair; then the graph is sound and that of the exact solution.
bool agrees(const Pair& pair, const IntersectOptions& options = {}) {
  const auto filtered = intersect_filtered(pair.x, pair.y, options);
  if (!filtered) return false;
  CHECK(filtered->status == Status::complete);
  CHECK(unsound(pair.x, pair.y, *filtered) == "");
  CHECK(compare_with_oracle(pair.x, pair.y, filtered->graph).difference == "");
  const IntersectResult exact = intersect_exactly(pair.x, pair.y, options);
  CHECK(exact.status == Status::complete);
  CHECK(difference(filtered->graph, exact.graph, {}) == "");
  for (const Arc& arc : filtered->graph.arcs) CHECK(arc.error_bound > 0);
  return true;
}

}  // namespace

TEST_CASE("filter double point: touches and crossings as the exact solution finds them") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    decided += agrees(touch(generator)) ? 1 : 0;
    decided += agrees(crossing(generator)) ? 1 : 0;
  }
  CHECK(decided >= 20);
}

TEST_CASE("filter double point: two of them") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    CHECK(agrees(with_two(generator, 1)));
    decided += agrees(with_two(generator, -1)) ? 1 : 0;
  }
  CHECK(decided >= 2);
}

TEST_CASE("filter double point: other tolerances and turning points") {
  Generator generator(5);
  const Pair pair = crossing(generator);
  IntersectOptions options;
  for (const double tolerance : {1e-3, 1e-5, 1e-6}) {
    options.tolerance = tolerance;
    CHECK(agrees(pair, options));
    options.turning = {Parameter::r};
  }
}

TEST_CASE("filter double point: the families") {
  using families::Plane;
  const auto decided = [](const ExactCase& c) {
    IntersectOptions options;
    options.turning = c.turning;
    const auto result = intersect_filtered(c.x, c.y, options);
    if (result) CHECK(difference(*result, c) == "");
    return result.has_value();
  };
  for (const Plane plane : {Plane::larger, Plane::bilinear}) CHECK(decided(families::cap(0, plane)));
  decided(families::cap(0, Plane::quadratic));
  for (const Plane plane : {Plane::larger, Plane::bilinear, Plane::quadratic}) {
    CHECK_FALSE(decided(families::curve_cusp(plane)));
    CHECK_FALSE(decided(families::tangent_branches(plane)));
    CHECK_FALSE(decided(families::tangent_curve(Rational(1, 3), plane)));
  }
}

TEST_CASE("filter double point: no double point is taken where it is none") {
  Generator generator(9);
  Quadratic h = product({Rational(-1, 2), 1, 0}, {Rational(-1, 2), 1, 0});
  h[0][2] = 1;
  h[0][1] = -1;
  h[0][0] += Rational(1, 4);
  const Pair touching = graphs(generator, h);
  h[0][0] += power_of_two(-60);  // away by less than doubles show
  const Pair apart = graphs(generator, h);
  const auto found = [](const Pair& pair) {
    const auto frame = filter::make_pair(pair.x, pair.y);
    return filter::double_point_near<filter::Biquadratic>(pair.x, pair.y, *frame, {0, 0, 0, 0}, 1e-6)
        .has_value();
  };
  CHECK(found(touching));
  CHECK_FALSE(found(apart));
}

}  // namespace exsect::double_point_test
