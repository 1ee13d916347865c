#include "line/line_carrier.h"

#include <exsect/algebra/algebraic_value.h>
#include <exsect/algebra/rational_matrix.h>
#include <exsect/algebra/resultant.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "line/rational_line.h"

namespace exsect {
namespace {

constexpr int kMostCombinations = 16;

/// The coefficients of t^i of det (C(t), C'(t), X_r, X_s), which vanishes where the tangent of the curve C is
/// in the tangent plane of the patch, or one of them is missing.
std::vector<BivariatePolynomial> contact_determinant(const HomogeneousCurve& c, const ComponentsOfPatch& x) {
  BivariatePolynomial result[7];
  int degree = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Polynomial tangent = c[i] * c[j].derivative() - c[j] * c[i].derivative();
      std::array<std::size_t, 2> others{};
      for (std::size_t k = 0, n = 0; k < 4; ++k)
        if (k != i && k != j) others[n++] = k;
      const BivariatePolynomial minor = jacobian(x[others[0]], x[others[1]]);
      const int sign = (i + j) % 2 == 0 ? -1 : 1;  // of the permutation i, j, others
      for (int k = 0; k <= tangent.degree(); ++k)
        result[k] += minor * Polynomial(sign * tangent.coefficient(k));
      degree = std::max(degree, tangent.degree());
    }
  return {result, result + degree + 1};
}

/// sum f_i a^i b^(n-i), n the number of coefficients less one.
BivariatePolynomial homogenised(const std::vector<BivariatePolynomial>& f, const BivariatePolynomial& a,
                                const BivariatePolynomial& b) {
  BivariatePolynomial sum;
  BivariatePolynomial power = BivariatePolynomial::constant(1);
  for (auto i = f.rbegin(); i != f.rend(); ++i) {
    sum = sum * a + *i * power;
    power = power * b;
  }
  return sum;
}

bool vanishes(const LinearInT& f, const TriangularPoint& p) {
  return sign_at(f.a, p) == 0 && sign_at(f.b, p) == 0;
}

}  // namespace

ComponentsOfPatch components_of(const RationalPatch& patch) {
  return {patch.component(0), patch.component(1), patch.component(2), patch.component(3)};
}

LineCarrier::LineCarrier(const HomogeneousCurve& curve, const ComponentsOfPatch& x)
    : curve_(curve), x_(x), degree_(degree(curve)), fixed_(moving_planes(curve, 0)) {
  for (const MovingPlane& plane : fixed_) equations_.push_back(on_patch(plane[0]));
  if (fixed_.size() >= 2) return;
  moving_ = moving_planes(curve, 1);
  for (const MovingPlane& plane : moving_) linear_.push_back({on_patch(plane[0]), on_patch(plane[1])});
  for (std::size_t i = 0; i < linear_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      equations_.push_back(linear_[i].a * linear_[j].b - linear_[j].a * linear_[i].b);
  if (degree_ == 3 && fixed_.size() == 1) add_plane_cubic();
}

bool LineCarrier::add_positions(const TriangularPoint& p, std::vector<LinePosition>& to) const {
  if (moving_.empty()) return add_on_straight_line(p, to);
  if (std::ranges::all_of(linear_, [&](const LinearInT& f) { return vanishes(f, p); }))
    return add_at_node(p, to);
  for (int k = 0; k < kMostCombinations; ++k) {
    const LinearInT f = combined(k);
    if (vanishes(f, p)) continue;
    if (sign_at(f.b, p) == 0) return true;
    const LineParameter t(BivariatePolynomial() - f.a, f.b, p);
    if (t.compare(0) < 0 || t.compare(1) > 0) return true;
    const BivariatePolynomial contact =
        homogenised(contact_determinant(curve_, x_), BivariatePolynomial() - f.a, f.b);
    to.push_back({t, sign_at(contact, p) != 0});
    return true;
  }
  return false;
}

bool LineCarrier::add_numbers(const TriangularPoint& p, std::vector<RealAlgebraic>& to) const {
  std::vector<LinePosition> found;
  if (!add_positions(p, found)) return false;
  for (const LinePosition& at : found) {
    std::optional<RealAlgebraic> t = at.t.number();
    if (!t) t = number_at(p);
    if (!t) return false;
    to.push_back(*t);
  }
  return true;
}

/// By other combinations of the moving planes than the first that tells t.
std::optional<RealAlgebraic> LineCarrier::number_at(const TriangularPoint& p) const {
  for (int k = 0; k < kMostCombinations && !moving_.empty(); ++k) {
    const LinearInT f = combined(k);
    if (sign_at(f.b, p) == 0) continue;
    if (const auto t = quotient_at(BivariatePolynomial() - f.a, f.b, p)) return t;
  }
  return std::nullopt;
}

std::vector<BivariatePolynomial> LineCarrier::borders() const {
  if (moving_.empty()) return borders_of_segment();
  std::vector<BivariatePolynomial> result;
  for (const LinearInT& f : linear_) {
    result.push_back(f.a);
    result.push_back(f.a + f.b);
  }
  return result;
}

/// In lambda = X_k / X_4: its values at t = 0 and 1, and at the t where C and C' are proportional.
std::vector<BivariatePolynomial> LineCarrier::borders_of_segment() const {
  const std::size_t k = changing_coordinate();
  const auto at = [&](int t) { return Polynomial{curve_[k](t), -curve_[3](t)}; };
  std::vector<Polynomial> in_lambda = {at(0), at(1)};
  if (degree_ > 1) {
    std::vector<Polynomial> of_t, still;
    for (int i = 0; i <= degree_; ++i)
      of_t.push_back(Polynomial{curve_[k].coefficient(i), -curve_[3].coefficient(i)});
    for (const Rational& c : standstill_polynomial(curve_).coefficients()) still.emplace_back(c);
    in_lambda.push_back(resultant_r(BivariatePolynomial(still), BivariatePolynomial(of_t)));
  }
  std::vector<BivariatePolynomial> result;
  for (const Polynomial& f : in_lambda) {
    std::vector<BivariatePolynomial> coefficients;
    for (const Rational& c : f.coefficients()) coefficients.push_back(BivariatePolynomial::constant(c));
    result.push_back(homogenised(coefficients, x_[k], x_[3]));
  }
  return result;
}

std::size_t LineCarrier::changing_coordinate() const {
  std::size_t k = 0;
  while (curve_[k] * curve_[3].derivative() == curve_[k].derivative() * curve_[3]) ++k;
  return k;
}

BivariatePolynomial LineCarrier::on_patch(const std::array<Rational, 4>& plane) const {
  BivariatePolynomial result;
  for (std::size_t k = 0; k < 4; ++k) result += x_[k] * Polynomial(plane[k]);
  return result;
}

/// The sum of k^i times moving plane i: one vanishes at other points of the curve, another k does not.
LinearInT LineCarrier::combined(int k) const {
  LinearInT sum = linear_.front();
  Rational factor = 1;
  for (std::size_t i = 1; i < linear_.size(); ++i) {
    factor *= k;
    sum.a += linear_[i].a * Polynomial(factor);
    sum.b += linear_[i].b * Polynomial(factor);
  }
  return sum;
}

/// The resultants in t of the moving planes of degree 1 and 2: the equation of the cubic.
void LineCarrier::add_plane_cubic() {
  const std::vector<MovingPlane> quadratic = moving_planes(curve_, 2);
  for (const LinearInT& f : linear_)
    for (const MovingPlane& g : quadratic)
      equations_.push_back(on_patch(g[0]) * f.b * f.b - on_patch(g[1]) * f.a * f.b +
                           on_patch(g[2]) * f.a * f.a);
}

/// p is at the only point where all moving planes of degree 1 vanish identically in t. A node belongs to two
/// t, the roots of a quadratic polynomial over Q; at a cusp these are one, and the tangent vector is zero.
bool LineCarrier::add_at_node(const TriangularPoint& p, std::vector<LinePosition>& to) const {
  RationalMatrix planes(2 * moving_.size(), 4);
  for (std::size_t i = 0; i < moving_.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      planes(2 * i, k) = moving_[i][0][k];
      planes(2 * i + 1, k) = moving_[i][1][k];
    }
  const std::vector<Integer> node = null_space(planes).at(0);
  Polynomial common;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      common =
          gcd(common, curve_[i] * Polynomial(Rational(node[j])) - curve_[j] * Polynomial(Rational(node[i])));
  // The determinant is a + b t at the roots of the quadratic polynomial.
  LinearInT contact;
  const std::vector<BivariatePolynomial> determinant = contact_determinant(curve_, x_);
  Polynomial power(1);
  for (const BivariatePolynomial& f : determinant) {
    contact.a += f * Polynomial(power.coefficient(0));
    contact.b += f * Polynomial(power.coefficient(1));
    power = divide(power * Polynomial{0, 1}, common).remainder;
  }
  const bool is_constant = sign_at(contact.b, p) == 0;
  std::optional<RealAlgebraic> zero;
  if (!is_constant) zero = quotient_at(BivariatePolynomial() - contact.a, contact.b, p);
  if (!is_constant && !zero) return false;
  for (const RealAlgebraic& t : real_roots(common, 0, 1))
    to.push_back({t, is_constant ? sign_at(contact.a, p) != 0 : !(*zero == t)});
  return true;
}

/// The line has a coordinate lambda = X_k / X_4, and C_k(t) - lambda C_4(t) = 0.
bool LineCarrier::add_on_straight_line(const TriangularPoint& p, std::vector<LinePosition>& to) const {
  const std::size_t k = changing_coordinate();
  const bool is_transversal = sign_at(jacobian(equations_[0], equations_[1]), p) != 0;
  if (degree_ == 1) {
    const auto combined = [&](int i) {
      return x_[3] * Polynomial(curve_[k].coefficient(i)) - x_[k] * Polynomial(curve_[3].coefficient(i));
    };
    if (sign_at(combined(1), p) == 0) return true;
    const LineParameter t(BivariatePolynomial() - combined(0), combined(1), p);
    if (t.compare(0) >= 0 && t.compare(1) <= 0) to.push_back({t, is_transversal});
    return true;
  }
  const auto lambda = quotient_at(x_[k], x_[3], p);
  if (!lambda) return false;
  std::vector<Polynomial> of_t;
  for (int i = 0; i <= degree_; ++i)
    of_t.push_back(Polynomial{curve_[k].coefficient(i), -curve_[3].coefficient(i)});
  for (const TriangularPoint& t : roots_at(BivariatePolynomial(of_t), *lambda, 0, 1))
    to.push_back({value_at(BivariatePolynomial::r(), t), is_transversal});
  return true;
}

}  // namespace exsect
