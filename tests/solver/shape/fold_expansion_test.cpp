#include "shape/fold_expansion.h"

#include <random>

#include "support/catch.h"

namespace exsect::fold_expansion_test {

namespace {

/// H (7.3) at (U,V,m,w), exactly.
Point equation_at(const BezierPatch& x, const Rational& u, const Rational& v, const Rational& m,
                  const Rational& w) {
  const ControlNet c = x.power_basis();
  return x.derivative_first(u, v) + m * x.derivative_second(u, v) +
         w * m * (c[2][1] + 2 * v * c[2][2] + m * (c[1][2] + 2 * u * c[2][2]));
}

Rational small(std::mt19937& generator, int largest = 3) {
  return std::uniform_int_distribution<int>(-largest, largest)(generator);
}

/// x(u,v) with coefficients d_ij of (u - f)^i (v - c)^j.
BezierPatch shifted(const ControlNet& d, const Rational& f, const Rational& c) {
  return BezierPatch::from_power_basis(d).restricted_to(-f, 1 - f, -c, 1 - c);
}

ControlNet random_fold(std::mt19937& generator) {
  ControlNet d{};
  for (auto& row : d)
    for (Point& p : row) p = {small(generator), small(generator), small(generator)};
  d[1][0] = {0, 0, 0};
  return d;
}

/// H - z_2 M_2 - z_3 M_3 is a multiple of M_1 at random places; M_1 z_1 = H for planar folds.
void check_expansion(const BezierPatch& x, const FoldExpansion& fold, std::mt19937& generator) {
  const FoldFactors<Rational> factors(fold);
  for (int i = 0; i < 5; ++i) {
    const Rational p = small(generator) / 7, h = small(generator) / 5, m = small(generator) / 4;
    const Rational w = small(generator) / 9;
    INFO("p, h, m, w = " << p << " " << h << " " << m << " " << w);
    const auto [m1, m2, m3] = factors(p, h, m, w);
    const Point equation = equation_at(x, fold.turn + p, fold.constant + h, m, w);
    if (fold.planar && fold.order > 1) {
      const Rational beta = fold.beta[0] + w * fold.beta[1];
      Rational z1 = p + (fold.alpha[0] + w * fold.alpha[1]) * m;
      Rational power = h;
      for (const Rational& k : fold.turns) {
        z1 += k * power;
        power *= h;
      }
      const Point sum = beta * beta * z1 * Point(m1) + (power + beta * m) * Point(m2) + power * h * Point(m3);
      CHECK(sum == beta * beta * equation);
    } else if (fold.planar) {
      const Rational z1 = p + (fold.alpha[0] + w * fold.alpha[1]) * m;
      const Rational z2 = h + (fold.beta[0] + w * fold.beta[1]) * m;
      CHECK(z1 * Point(m1) + z2 * Point(m2) + m * m * Point(m3) == equation);
    } else {
      Rational z2 = 1;
      for (int k = 0; k < fold.order; ++k) z2 *= h;
      const Point rest = equation - z2 * Point(m2) - m * Point(m3);
      CHECK(is_zero(cross(rest, Point(m1))));
    }
    const auto [a, b, c] = factors(0, 0, 0, w);
    CHECK(determinant(a, b, c) == fold.contact(w));
  }
}

}  // namespace

TEST_CASE("the equation of pairs near a folded line is a combination of three forms") {
  const unsigned seed = 20260;
  std::mt19937 generator(seed);
  for (int i = 0; i < 84; ++i) {
    INFO("seed " << seed << ", net " << i);
    ControlNet d = random_fold(generator);
    const int kind = i % 7;
    const Rational k = small(generator);
    const Rational l = small(generator);
    if (is_zero(d[2][0])) d[2][0] = {1, 0, 0};
    if (kind == 1) d[1][1] = k * d[2][0];  // the lines near it turn on a line
    if (kind == 2) {                       // and on a parabola
      d[1][1] = 2 * k * d[2][0];
      d[1][2] = 2 * k * d[2][1] + 2 * l * d[2][0];
    }
    if (kind >= 5) {  // the tangent plane is constant, and the lines near it turn on a line
      d[1][1] = (kind == 5 ? 2 * k : Rational(0)) * d[2][0];
      d[2][1] = l * d[2][0] + (kind == 6 ? small(generator) : Rational(0)) * d[1][2];
      d[0][1] = small(generator) * d[2][0] + (d[1][2] - (kind == 5 ? 2 * k : Rational(0)) * d[2][1]);
      if (kind == 6) d[0][1] = small(generator) * d[2][0] + 2 * d[1][2];
    } else if (kind >= 3) {  // the tangent plane is constant
      d[0][1] = k * d[2][0] + l * d[1][1];
      d[2][1] = small(generator) * d[2][0] + (kind == 3 ? small(generator) : Rational(0)) * d[1][1];
    }
    const Rational f = (small(generator) + 5) / 11;
    const Rational c = (small(generator) + 4) / 13;
    const BezierPatch x = shifted(d, f, c);
    const auto fold = fold_expansion(x, f, c);
    if (!fold) continue;
    if (kind == 1) CHECK(fold->order >= 2);
    if (kind == 2) CHECK(fold->order >= 3);
    if (kind >= 5) CHECK((fold->planar && fold->order == 2));
    if (kind >= 3 && !is_zero(cross(d[1][1], d[2][0]))) CHECK(fold->planar);
    check_expansion(x, *fold, generator);
  }
}

TEST_CASE("a patch whose lines are all folded has no expansion") {
  // (u - v)^2, v, v^2: every line v = constant turns at u = v.
  ControlNet c{};
  c[2][0] = {1, 0, 0};
  c[1][1] = {-2, 0, 0};
  c[0][2] = {1, 0, 1};
  c[0][1] = {0, 1, 0};
  CHECK_FALSE(fold_expansion(BezierPatch::from_power_basis(c), 0, 0));
  CHECK_FALSE(fold_expansion(BezierPatch::from_power_basis(c), Rational(1, 3), Rational(1, 3)));
}

}  // namespace exsect::fold_expansion_test
