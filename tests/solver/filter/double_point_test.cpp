// Touch points and crossings in doubles, against their local equations solved by Newton's method and against
// the exact solution.
#include "filter/double_point.h"

#include <cmath>

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

/// c and its derivatives by t over one t, by Newton's method; and g, its derivatives.
struct Local {
  std::array<double, 2> c;
  std::array<std::array<double, 2>, 2> slope;
  double g;
  std::array<double, 2> g_slope;
};

struct Value {
  double value;
  double first;
  double second;
};
Value evaluate(const filter::ScalarTable& c, std::size_t least, double a, double b) {
  Value v{0, 0, 0};
  for (std::size_t k = 1; k < 9; ++k) {
    const int i = static_cast<int>(k / 3);
    const int j = static_cast<int>(k % 3);
    if (k / 3 + k % 3 < least) continue;
    v.value += c[k] * std::pow(a, i) * std::pow(b, j);
    if (i > 0) v.first += c[k] * i * std::pow(a, i - 1) * std::pow(b, j);
    if (j > 0) v.second += c[k] * j * std::pow(a, i) * std::pow(b, j - 1);
  }
  return v;
}

Local solve(const filter::LocalForms& f, const std::array<double, 2>& t) {
  Local l{};
  const double r = f.s[0][0] * t[0] + f.s[0][1] * t[1];
  const double s = f.s[1][0] * t[0] + f.s[1][1] * t[1];
  std::array<Value, 2> x;
  std::array<Value, 2> y;
  for (int step = 0; step < 50; ++step)
    for (std::size_t i = 0; i < 2; ++i) {
      x[i] = evaluate(f.x[i], 2, l.c[0], l.c[1]);
      y[i] = evaluate(f.y[i], 1, r, s);
      l.c[i] = y[i].value - x[i].value;
    }
  const Value nx = evaluate(f.normal_x, 2, l.c[0], l.c[1]);
  const Value ny = evaluate(f.normal_y, 2, r, s);
  l.g = nx.value - ny.value;
  const double a = 1 + x[0].first, b = x[0].second, c = x[1].first, d = 1 + x[1].second;
  for (std::size_t k = 0; k < 2; ++k) {
    const double p = y[0].first * f.s[0][k] + y[0].second * f.s[1][k];
    const double q = y[1].first * f.s[0][k] + y[1].second * f.s[1][k];
    l.slope[0][k] = (d * p - b * q) / (a * d - b * c);
    l.slope[1][k] = (a * q - c * p) / (a * d - b * c);
    l.g_slope[k] =
        nx.first * l.slope[0][k] + nx.second * l.slope[1][k] - (ny.first * f.s[0][k] + ny.second * f.s[1][k]);
  }
  return l;
}

/// The largest of the quotients of what is bounded by its bound, but for rounding.
double sharpness(const filter::LocalForms& f, const filter::LocalBounds& bounds,
                 const std::array<double, 2>& t) {
  const double size = std::max(std::fabs(t[0]), std::fabs(t[1]));
  const Local l = solve(f, t);
  const double q = f.crossing ? t[0] * t[1] : t[0] * t[0] + t[1] * t[1];
  const std::array<double, 2> slope = {f.crossing ? t[1] : 2 * t[0], f.crossing ? t[0] : 2 * t[1]};
  const double rounding = 1e-13;
  double worst = std::fabs(l.g - q) / (bounds.value * size * size * size + f.rest * size * size + rounding);
  for (std::size_t i = 0; i < 2; ++i) {
    worst = std::max(worst, std::fabs(l.c[i]) / (bounds.k[i] * size + rounding));
    worst = std::max(worst, std::fabs(l.g_slope[i] - slope[i]) /
                                (bounds.slope * size * size + 2 * f.rest * size + rounding));
    for (std::size_t j = 0; j < 2; ++j)
      worst = std::max(worst, std::fabs(l.slope[i][j] - f.bs[i][j]) / (bounds.turn[i] * size + rounding));
  }
  return worst;
}

/// Over all t up to reaches for which there are bounds.
double sharpness(const filter::LocalForms& forms) {
  Generator generator(1);
  const auto unit = [&] { return static_cast<double>(integer(generator, -1000, 1000)) / 1000; };
  double worst = 0;
  for (double reach = 0x1p-2; reach > 0x1p-12; reach *= 0.5) {
    const auto bounds = filter::local_bounds(forms, reach);
    for (int i = 0; bounds && i < 20; ++i)
      worst = std::max(worst, sharpness(forms, *bounds, {unit() * reach, unit() * reach}));
  }
  return worst;
}

/// Random patches, y moved and turned such that both tangent planes at the middle agree.
filter::LocalForms general_double_point(Generator& generator) {
  const auto half = Rational(1, 2);
  const Pair pair = random_pairs::small_rationals(generator);
  const Point n = cross(pair.x.derivative_first(half, half), pair.x.derivative_second(half, half));
  ControlNet y = pair.y.restricted_to(half, Rational(3, 2), half, Rational(3, 2)).power_basis();
  y[0][0] = pair.x(half, half);
  for (Point* tangent : {&y[1][0], &y[0][1]}) *tangent = *tangent - (dot(n, *tangent) / dot(n, n)) * n;
  const BezierPatch moved = BezierPatch::from_power_basis(y).restricted_to(-half, half, -half, half);
  return filter::local_forms(pair.x, moved, {half, half, half, half}).value();
}

}  // namespace

TEST_CASE("filter double point: the bounds hold for the solution of the local equations") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    CHECK(sharpness(general_double_point(generator)) <= 1);
  }
}

TEST_CASE("filter double point: a graph over its tangent plane, where the bounds are sharp") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    Quadratic h{};
    h[2][0] = 1;
    h[0][2] = seed % 2 == 0 ? 1 : -1;
    h[1][2] = 1 + sixteenths(generator, 8);
    h[2][1] = 1 + sixteenths(generator, 8);
    const BezierPatch curved = graph(h, Rational(-1, 2), Rational(1, 2));
    const BezierPatch plane = graph({}, Rational(-1, 2), Rational(1, 2));
    const std::array<Rational, 4> p = {Rational(1, 2), Rational(1, 2), Rational(1, 2), Rational(1, 2)};
    for (const Pair& pair : {Pair{curved, plane}, Pair{plane, curved}}) {
      const double worst = sharpness(filter::local_forms(pair.x, pair.y, p).value());
      CHECK(worst <= 1);
      CHECK(worst > 0.25);
    }
  }
}

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
    return filter::double_point_near(pair.x, pair.y, *frame, {0, 0, 0, 0}, 1e-6).has_value();
  };
  CHECK(found(touching));
  CHECK_FALSE(found(apart));
}

}  // namespace exsect::double_point_test
