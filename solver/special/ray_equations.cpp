#include "special/ray_equations.h"

#include <exsect/algebra/double_matrix.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace exsect {
namespace {

const Rational kRatioMargin(1, 4);  // of ratios, by their width
const Rational kBoxMargin(1, 8);    // of them, times their size, by the width of the box

/// A polynomial over a rectangle: f, and its derivatives by the first parameter and the one along the side.
struct RangeJet {
  RangeJet(const BivariatePolynomial& f, const Rectangle& on)
      : value(range_on(f, on)), a(range_on(f.derivative_r(), on)), t(range_on(f.derivative_s(), on)) {}
  DoubleBall value, a, t;
};
/// The same with second derivatives.
struct RangeJet2 : RangeJet {
  RangeJet2(const BivariatePolynomial& f, const Rectangle& on)
      : RangeJet(f, on),
        aa(range_on(f.derivative_r().derivative_r(), on)),
        at(range_on(f.derivative_r().derivative_s(), on)),
        tt(range_on(f.derivative_s().derivative_s(), on)) {}
  DoubleBall aa, at, tt;
};

/// c^n and its first two derivatives, n = 1 or 2.
struct Power {
  Power(const DoubleBall& c, int n)
      : value(n == 2 ? c * c : c), rate(n == 2 ? c + c : DoubleBall(1)), bend(n == 2 ? 2 : 0) {}
  DoubleBall value, rate, bend;
};

DoubleBall half_width(const RationalInterval& at) { return DoubleBall::enclosing(at.width() / 2); }

/// 1 / x; of infinite radius where x may be 0.
DoubleBall inverse(const DoubleBall& x) {
  if (x.certain_sign() == 0) return {0, HUGE_VAL};
  const RationalInterval at = x.interval();
  return DoubleBall::enclosing(RationalInterval{1 / at.upper, 1 / at.lower});
}

}  // namespace

RayEquations::RayEquations(Blowup& first, Blowup& second) : first_(first), second_(second) {
  std::vector<Point> directions = directions_in_pole(first.direction);
  std::ranges::copy(directions_in_pole(second.direction), std::back_inserter(directions));
  const Point normal = common_normal(directions);
  std::array<Point, 3> rows = {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  has_normal_ = !is_zero(normal);
  if (has_normal_) rows = {normal, directions[0], cross(normal, directions[0])};
  for (std::size_t i = 0; i < 3; ++i)
    rows_[i] = {dot(rows[i], first.direction), dot(rows[i], second.direction), 1};
  if (!has_normal_) return;
  first.height = divided_by_first(rows_[0].f);
  second.height = divided_by_first(rows_[0].g);
  rows_[0] = {first.height, second.height, 2};
}

Point RayEquations::steady_row(const Rectangle& box) const {
  const Rational s = box.s.midpoint();
  const Point e = value(second_.direction, 0, s), e_s = value(derivative_s(second_.direction), 0, s);
  const Rational square = dot(e_s, e_s);
  const Point row = square == 0 ? e : e - Rational(dot(e, e_s) / square) * e_s;
  return is_zero(row) ? e : row;
}

std::optional<RationalInterval> RayEquations::ratio_on(const Rectangle& box) const {
  const Rectangle x = first_.over(box.r), y = second_.over(box.s);
  const Point row = steady_row(box);
  const DoubleBall above = range_on(dot(row, first_.direction), x) * range_on(second_.weight, y);
  const DoubleBall below = range_on(dot(row, second_.direction), y) * range_on(first_.weight, x);
  if (!above.is_positive() || !below.is_positive()) return std::nullopt;
  const RationalInterval p = above.interval(), q = below.interval();
  const Rational least = p.lower / q.upper, most = p.upper / q.lower;
  const Rational margin =
      kRatioMargin * (most - least) + kBoxMargin * (box.r.width() + box.s.width()) * least;
  if (least <= margin) return std::nullopt;
  return RationalInterval{least - margin, most + margin};
}

Rectangle RayEquations::on_second(const Rectangle& box, const RationalInterval& ratio) const {
  return {{0, std::min<Rational>(second_.reach, first_.reach * ratio.upper)}, box.s};
}

RayColumns RayEquations::columns_on(const Rectangle& box, const RationalInterval& ratio) const {
  const Rectangle x = first_.over(box.r), y = on_second(box, ratio);
  const RangeJet w(first_.weight, x), omega(second_.weight, y);
  const DoubleBall c = DoubleBall::enclosing(ratio);
  RayColumns result;
  for (std::size_t i = 0; i < 3; ++i) {
    const RangeJet f(rows_[i].f, x), g(rows_[i].g, y);
    const Power power(c, rows_[i].power);
    const DoubleBall by_b = omega.a * f.value - power.value * w.value * g.a;
    result.t[i] = omega.value * f.t - power.value * w.t * g.value;
    result.s[i] = omega.t * f.value - power.value * w.value * g.t;
    result.c[i] = all_a() * by_b - power.rate * w.value * g.value;
    result.a[i] = omega.value * f.a - power.value * w.a * g.value + c * by_b;
  }
  return result;
}

/// For a = 0.
EnclosedVector RayEquations::value_at(const Rational& t, const Rational& s, const Rational& c) const {
  EnclosedVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Row& row = rows_[i];
    const Rational power = row.power == 2 ? Rational(c * c) : c;
    result[i] =
        DoubleBall::enclosing(second_.weight(0, s) * row.f(0, t) - power * first_.weight(0, t) * row.g(0, s));
  }
  return result;
}

bool RayEquations::has_solution(const Rectangle& box, const RationalInterval& ratio,
                                const RayColumns& columns) const {
  const std::array<const EnclosedVector*, 3> column = {&columns.t, &columns.s, &columns.c};
  std::array<Row3, 3> middle;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) middle[k][i] = (*column[k])[i].approximation();
  const auto inverse = approximate_inverse(middle);
  if (!inverse) return false;
  const EnclosedVector value = value_at(box.r.midpoint(), box.s.midpoint(), ratio.midpoint());
  const std::array<RationalInterval, 3> sides = {box.r, box.s, ratio};
  for (std::size_t k = 0; k < 3; ++k) {
    const EnclosedVector row = {(*inverse)[k][0], (*inverse)[k][1], (*inverse)[k][2]};
    DoubleBall moved = DoubleBall(dot_over(row, value).upper_magnitude());
    for (std::size_t j = 0; j < 3; ++j) {
      const DoubleBall off = dot_over(row, *column[j]) - DoubleBall(k == j ? 1 : 0);
      moved += DoubleBall(off.upper_magnitude()) * half_width(sides[j]);
    }
    if (!(half_width(sides[k]) - moved).is_positive()) return false;
  }
  return true;
}

std::array<DoubleBall, 6> RayEquations::bend_on(std::size_t i, const Rectangle& box,
                                                const RationalInterval& ratio) const {
  const Row& row = rows_[i];
  const Rectangle x = first_.over(box.r), y = on_second(box, ratio);
  const RangeJet2 w(first_.weight, x), omega(second_.weight, y), f(row.f, x), g(row.g, y);
  const Power c(DoubleBall::enclosing(ratio), row.power);
  const DoubleBall a = all_a();
  const DoubleBall by_tb = omega.a * f.t - c.value * w.t * g.a;
  const DoubleBall by_sb = omega.at * f.value - c.value * w.value * g.at;
  const DoubleBall by_bb = omega.aa * f.value - c.value * w.value * g.aa;
  return {omega.value * f.tt - c.value * w.tt * g.value,
          omega.t * f.t - c.value * w.t * g.t,
          a * by_tb - c.rate * w.t * g.value,
          omega.tt * f.value - c.value * w.value * g.tt,
          a * by_sb - c.rate * w.value * g.t,
          a * (a * by_bb - DoubleBall(2) * c.rate * w.value * g.a) - c.bend * w.value * g.value};
}

bool RayEquations::isolates_contact(const Rectangle& box, const RationalInterval& ratio,
                                    const RayColumns& columns) const {
  const auto& [t, s, c, a] = columns;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const DoubleBall over = inverse(s[j] * c[k] - s[k] * c[j]);
    const DoubleBall to_s = -over * (t[j] * c[k] - t[k] * c[j]);  // of another zero, by t
    const DoubleBall to_c = -over * (s[j] * t[k] - s[k] * t[j]);
    std::array<DoubleBall, 3> factor;  // of the rows, so that the sum of their derivatives is 0
    factor[i] = 1;
    factor[j] = -over * (s[i] * c[k] - c[i] * s[k]);
    factor[k] = -over * (c[i] * s[j] - s[i] * c[j]);
    DoubleBall sum = 0;
    for (std::size_t row = 0; row < 3; ++row) {
      const auto bend = bend_on(row, box, ratio);
      sum += factor[row] * (bend[0] + to_s * to_s * bend[3] + to_c * to_c * bend[5] +
                            DoubleBall(2) * (to_s * bend[1] + to_c * bend[2] + to_s * to_c * bend[4]));
    }
    if (sum.certain_sign() != 0) return true;
  }
  return false;
}

bool RayEquations::begins_at(const std::optional<Rational>& t, const std::optional<Rational>& s,
                             const Rectangle& box) const {
  // Polynomials in t or s alone, that of y where t is given; constants where both are.
  const auto of_x = [&](const BivariatePolynomial& f) {
    const Polynomial first = f.coefficient(0);
    return t ? Polynomial(first(*t)) : first;
  };
  const auto of_y = [&](const BivariatePolynomial& f) {
    const Polynomial first = f.coefficient(0);
    return s ? Polynomial(first(*s)) : first;
  };
  std::array<Polynomial, 3> d, e;
  for (std::size_t c = 0; c < 3; ++c) {
    d[c] = of_x(first_.direction[c]);
    e[c] = of_y(second_.direction[c]);
  }
  const auto square = [](const std::array<Polynomial, 3>& v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  };
  Polynomial common;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t n = (c + 1) % 3;
    common = gcd(common, d[c] * e[n] - d[n] * e[c]);
  }
  if (has_normal_)
    common = gcd(common, of_x(first_.weight) * of_x(first_.height) * square(e) -
                             of_y(second_.weight) * of_y(second_.height) * square(d));
  if (t && s) return common.is_zero();
  const RationalInterval& free = t ? box.s : box.r;
  return common.is_zero() || (common.degree() > 0 && !real_roots(common, free.lower, free.upper).empty());
}

}  // namespace exsect
