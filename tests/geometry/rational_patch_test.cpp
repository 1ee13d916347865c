#include <exsect/geometry/rational_patch.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::rational_patch_test {
using Catch::Matchers::Contains;

namespace {

using Points = std::vector<std::vector<Point>>;
using Weights = std::vector<std::vector<Rational>>;

struct Net {
  Points points;
  Weights weights;
};

Rational bernstein(int n, int i, const Rational& t) {
  Rational value = n == 3 && (i == 1 || i == 2) ? 3 : n == 2 && i == 1 ? 2 : 1;
  for (int k = 0; k < i; ++k) value *= t;
  for (int k = i; k < n; ++k) value *= 1 - t;
  return value;
}

/// The definition: sum of B_i B_j w_ij P_ij over sum of B_i B_j w_ij.
Point by_definition(const Net& net, const Rational& u, const Rational& v) {
  const int m = static_cast<int>(net.points.size()) - 1, n = static_cast<int>(net.points[0].size()) - 1;
  Point sum = {0, 0, 0};
  Rational below = 0;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) {
      const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
      const Rational w = bernstein(m, i, u) * bernstein(n, j, v) *
                         (net.weights.empty() ? Rational(1) : net.weights[row][column]);
      below += w;
      sum = sum + w * net.points[row][column];
    }
  return Rational(1 / below) * sum;
}

Point by_power_basis(const RationalPatch& patch, const Rational& u, const Rational& v) {
  const Rational w = patch.component(3)(u, v);
  return {patch.component(0)(u, v) / w, patch.component(1)(u, v) / w, patch.component(2)(u, v) / w};
}

Net random_weighted(Random& random, int m, int n) {
  Net net;
  for (int i = 0; i <= m; ++i) {
    net.points.emplace_back();
    net.weights.emplace_back();
    for (int j = 0; j <= n; ++j) {
      net.points.back().push_back(random_point(random));
      net.weights.back().push_back(1 + abs(random_rational(random)));
    }
  }
  return net;
}

/// Nets of every bidegree on which an index error shows; weights of zero, one negative, points far away.
std::vector<Net> specimens(Random& random) {
  std::vector<Net> nets;
  for (int m = 1; m <= 3; ++m)
    for (int n = 1; n <= 3; ++n) {
      nets.push_back(random_weighted(random, m, n));
      nets.push_back({nets.back().points, {}});
    }
  Net inner = random_weighted(random, 3, 2);
  inner.weights[1][1] = 0;
  inner.weights[2][1] = Rational(-1, 4);
  inner.points[0][0] = {power_of_two(400), Rational(1, 3), -power_of_two(-400)};
  nets.push_back(inner);
  return nets;
}

const std::vector<Rational> parameters = {0, 1, Rational(1, 2), Rational(1, 3), Rational(6, 7)};

PatchError refusal(const Points& points, const Weights& weights = {}) {
  try {
    RationalPatch patch(points, weights);
  } catch (const PatchError& error) {
    return error;
  }
  FAIL("accepted");
  throw std::logic_error("unreachable");
}

}  // namespace

TEST_CASE("values agree with the definition and the power basis", "[rational_patch]") {
  const auto seed = 24u;
  INFO("seed " << seed);
  Random random(seed);
  for (const Net& net : specimens(random)) {
    const RationalPatch patch(net.points, net.weights);
    const RationalPatch same = patch;
    CHECK(patch.degree_u() + 1 == static_cast<int>(net.points.size()));
    CHECK(patch.degree_v() + 1 == static_cast<int>(net.points[0].size()));
    const RationalPatch piece = patch.restricted_to(Rational(1, 4), 1, Rational(2, 3), Rational(1, 5));
    for (const Rational& u : parameters) {
      for (const Rational& v : parameters) {
        const Point value = by_definition(net, u, v);
        CHECK(patch(u, v) == value);
        CHECK(by_power_basis(patch, u, v) == value);
        CHECK(patch.transposed()(v, u) == value);
        CHECK(patch.elevated(3, 3)(u, v) == value);
        CHECK(patch.elevated(3, patch.degree_v())(u, v) == value);
        CHECK(patch.reduced()(u, v) == value);
        CHECK(same.reduced()(u, v) == value);
        CHECK(piece(u, v) ==
              by_definition(net, Rational(1, 4) + u * Rational(3, 4), Rational(2, 3) - v * Rational(7, 15)));
      }
    }
    for (int i = 0; i <= patch.degree_u(); ++i)
      for (int j = 0; j <= patch.degree_v(); ++j) {
        const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
        const Rational w = net.weights.empty() ? Rational(1) : net.weights[row][column];
        CHECK(patch.weight(i, j) == w);
        CHECK(patch.point(i, j) == (w == 0 ? Point{0, 0, 0} : net.points[row][column]));
      }
    CHECK(patch.transposed().transposed() == patch);
    CHECK(patch.restricted_to(0, 1, 0, 1) == patch);
    CHECK(patch.is_polynomial() == net.weights.empty());
  }
}

TEST_CASE("common factors and degree elevation are taken out", "[rational_patch]") {
  const auto seed = 25u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 60; ++round) {
    const int m = 1 + round % 2, n = 1 + round / 2 % 2;
    const Net net = random_weighted(random, m, n);
    const RationalPatch patch(net.points, round % 3 == 0 ? Weights{} : net.weights);
    const RationalPatch reduced = patch.reduced();
    REQUIRE((reduced.degree_u() == m && reduced.degree_v() == n));
    // X times a bilinear factor that is positive on the square, in the power basis, then elevated.
    const auto positive = [&] {
      return Polynomial{1 + abs(random_rational(random)), abs(random_rational(random))};
    };
    const BivariatePolynomial factor(std::vector<Polynomial>{positive(), positive()});
    std::vector<std::vector<HomogeneousPoint>> multiplied(static_cast<std::size_t>(m) + 2);
    for (std::size_t i = 0; i < multiplied.size(); ++i) multiplied[i].resize(static_cast<std::size_t>(n) + 2);
    for (int k = 0; k < 4; ++k) {
      const BivariatePolynomial f = patch.component(k) * factor;
      // Bernstein coefficients by the blossom of monomials: b_ij = sum_pq f_pq C(i,p)/C(M,p) C(j,q)/C(N,q).
      const auto binomial = [](std::size_t a, std::size_t b) {
        Rational value = 1;
        for (std::size_t t = 0; t < b; ++t)
          value =
              value * Rational(static_cast<int>(a) - static_cast<int>(t)) / Rational(static_cast<int>(t) + 1);
        return value;
      };
      for (std::size_t i = 0; i < multiplied.size(); ++i)
        for (std::size_t j = 0; j < multiplied[i].size(); ++j) {
          Rational b = 0;
          for (std::size_t p = 0; p <= i; ++p)
            for (std::size_t q = 0; q <= j; ++q)
              b += f.coefficient(static_cast<int>(p), static_cast<int>(q)) * binomial(i, p) /
                   binomial(multiplied.size() - 1, p) * binomial(j, q) /
                   binomial(multiplied[i].size() - 1, q);
          multiplied[i][j][static_cast<std::size_t>(k)] = b;
        }
    }
    const RationalPatch larger = RationalPatch::from_homogeneous(multiplied).elevated(3, 3);
    CHECK(larger.reduced().degree_u() == m);
    CHECK(larger.reduced().degree_v() == n);
    CHECK(larger.is_polynomial() == patch.is_polynomial());
    CHECK(larger.biquadratic() == patch.biquadratic());
    CHECK(larger.reduced().reduced() == larger.reduced());
    for (const Rational& u : parameters)
      for (const Rational& v : parameters) {
        CHECK(larger(u, v) == patch(u, v));
        CHECK(larger.reduced()(u, v) == patch(u, v));
      }
  }
}

TEST_CASE("polynomial patches of bidegree up to (2,2) are today's, whatever their shape",
          "[rational_patch]") {
  const auto seed = 26u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 20; ++round) {
    const BezierPatch x = random_patch(random);
    const RationalPatch embedded = x;
    CHECK(embedded.biquadratic() == x);
    CHECK(embedded.elevated(3, 3).biquadratic() == x);
    const Net net = random_weighted(random, 1, 1 + round % 2);
    CHECK(RationalPatch(net.points).biquadratic() == BezierPatch::elevated(net.points));
    CHECK_FALSE(RationalPatch(net.points, net.weights).biquadratic());
    Weights equal = net.weights;
    for (auto& row : equal) std::fill(row.begin(), row.end(), Rational(3, 7));
    CHECK(RationalPatch(net.points, equal).biquadratic() == BezierPatch::elevated(net.points));
    CHECK_FALSE(RationalPatch(random_weighted(random, 3, 1).points).biquadratic());
  }
}

TEST_CASE("a half circle has a control point at infinity in its true degree", "[rational_patch]") {
  // Weights 1, 1/3, 1/3, 1 and points (1,0), (1,2), (-1,2), (-1,0), extruded along z.
  Points points;
  for (const auto& [x, y] : {std::pair{1, 0}, {1, 2}, {-1, 2}, {-1, 0}})
    points.push_back({{x, y, 0}, {x, y, 5}});
  const Rational third(1, 3);
  const RationalPatch cylinder(points, {{1, 1}, {third, third}, {third, third}, {1, 1}});
  const RationalPatch& reduced = cylinder.reduced();
  CHECK((reduced.degree_u() == 2 && reduced.degree_v() == 1));
  CHECK(reduced.weight(1, 0) == 0);
  CHECK_THROWS_AS(reduced.point(1, 0), std::domain_error);
  CHECK(reduced.elevated(3, 1) == cylinder);
  CHECK(kind_of(cylinder) == "bidegree (2,1) with weights");
  for (const Rational& u : parameters) {
    const Point p = cylinder(u, Rational(1, 2));
    CHECK(p[0] * p[0] + p[1] * p[1] == 1);
  }
  // The axis first: the denominator divides this component, and no other.
  for (auto& row : points)
    for (Point& p : row) p = {p[2], p[0], p[1]};
  const RationalPatch turned(points, {{1, 1}, {third, third}, {third, third}, {1, 1}});
  CHECK(turned.reduced().elevated(3, 1) == turned);
  CHECK(kind_of(turned) == kind_of(cylinder));
}

TEST_CASE("illegal nets are refused with place and statement", "[rational_patch]") {
  Random random(27);
  const Net net = random_weighted(random, 2, 3);
  struct Case {
    PatchError error;
    std::string where;
    const char* reason;
  };
  const auto with_weight = [&](std::size_t i, std::size_t j, const Rational& w) {
    Weights weights = net.weights;
    weights[i][j] = w;
    return weights;
  };
  Points ragged = net.points;
  ragged[1].pop_back();
  Weights short_row = net.weights;
  short_row[2].pop_back();
  Weights short_weights = net.weights;
  short_weights.pop_back();
  const Points row = {net.points[0]};
  const Points five(5, net.points[0]);
  const Points coincident(4, {4, Point{1, 2, 3}});
  // (1 - 3 u)^2 + (1 - 2 v)^2 in Bernstein form: 0 at (1/3, 1/2) only.
  const Weights touching = {{2, 0, 2}, {-1, -3, -1}, {5, 3, 5}};
  Points nine(3, std::vector<Point>(3));
  for (auto& points : nine)
    for (Point& p : points) p = random_point(random);
  const std::vector<Case> cases = {
      {refusal({}), "points", "degree 0"},
      {refusal(row), "points", "degree 0"},
      {refusal(five), "points", "degree 4"},
      {refusal({net.points[0], {}}), "points[1]", "4 elements"},
      {refusal({{{0, 0, 0}}, {{1, 0, 0}}}), "points[0]", "degree 0"},
      {refusal(ragged), "points[1]", "4 elements as in the first row, has 3"},
      {refusal(net.points, short_weights), "weights", "3 rows as the points, has 2"},
      {refusal(net.points, short_row), "weights[2]", "4 weights as the points in a row, has 3"},
      {refusal(net.points, with_weight(0, 0, 0)), "weights", "vanishes at (u,v) = (0, 0)"},
      {refusal(net.points, with_weight(0, 0, -1)), "weights", "negative at (u,v) = (0, 0)"},
      {refusal(net.points, with_weight(2, 3, 0)), "weights", "vanishes at (u,v) = (1, 1)"},
      {refusal(net.points, with_weight(1, 1, -1000)), "weights", "vanishes at (u,v) = (0."},
      {refusal(nine, touching), "weights", "vanishes at (u,v) = (1/3, 1/2)"},
      {refusal(coincident), "points", "coincide"},
      {refusal({{{1, 2, 3}, {1, 2, 3}}, {{1, 2, 3}, {1, 2, 3}}}, {{1, 2}, {3, 4}}), "points", "coincide"},
  };
  for (const Case& c : cases) {
    INFO(c.error.what());
    CHECK(c.error.where() == c.where);
    CHECK_THAT(c.error.reason(), Contains(c.reason));
  }
  CHECK_NOTHROW(RationalPatch({{{1, 2, 3}, {1, 2, 3}}, {{1, 2, 3}, {1, 2, 3}}}));  // solved as BezierPatch
  const RationalPatch good(net.points, net.weights);
  CHECK_THROWS_AS(good.elevated(1, 3), std::invalid_argument);
  CHECK_THROWS_AS(good.elevated(2, 4), std::invalid_argument);
  CHECK_THROWS_AS(good.restricted_to(0, 2, 0, 1), std::invalid_argument);
}

}  // namespace exsect::rational_patch_test
