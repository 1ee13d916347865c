#include "eliminant/special_eliminant.h"

#include <exsect/algebra/modular.h>
#include <exsect/algebra/resultant.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "curve/mahler_measure.h"
#include "eliminant/fibre_projection.h"

namespace exsect {

namespace {

std::size_t degree(const FibrePolynomial& trimmed) { return trimmed.coefficients.size() - 1; }

std::size_t degree_u(const FibrePolynomial& f) {
  int degree = 0;
  for (const auto& c : f.coefficients) degree = std::max(degree, c.degree());
  return static_cast<std::size_t>(degree);
}

const Polynomial& leading(const FibrePolynomial& trimmed) { return trimmed.coefficients.back(); }

double log2_norm(const FibrePolynomial& f) { return log2_norm_upper(integer_coefficients(f)); }

double measure(const Polynomial& f) { return *measure_lower(integer_coefficients({{f}})); }

/// A polynomial in Z[u][s] modulo a prime.
class ModularForm {
 public:
  ModularForm(const PrimeField& field, const FibrePolynomial& f) : field_(field) {
    for (const auto& polynomial : f.coefficients) {
      coefficients_.emplace_back();
      for (const auto& c : integer_coefficients({{polynomial}}))
        coefficients_.back().push_back(field.residue(c));
    }
  }
  /// The coefficients of the polynomial in s at this u.
  std::vector<Residue> at(Residue u) const {
    std::vector<Residue> result;
    for (const auto& c : coefficients_) result.push_back(evaluate(field_, c, u));
    return result;
  }

 private:
  PrimeField field_;
  std::vector<std::vector<Residue>> coefficients_;
};

/// Values of (4.18), which is (4.9): (l_s l_r)^3 prod R'(s_i)/S1(s_i) over the roots s_i of `points.finite`,
/// where l_s and l_r are the leading coefficients of the finite parts of the two projections.
std::vector<ResidueFraction> norm_values(const PrimeField& field, const FibreProjection& points,
                                         const FibreProjection& other, Residue first, std::size_t count) {
  const ModularForm finite(field, points.finite);
  const ModularForm r_derivative(field, derivative(points.r));
  const ModularForm s1(field, points.s1);
  const ModularForm other_leading(field, {{leading(other.finite)}});
  std::vector<ResidueFraction> values;
  for (std::size_t i = 0; i < count; ++i, first = field.add(first, field.one())) {
    const auto f = finite.at(first);
    const auto g = r_derivative.at(first);
    const auto h = s1.at(first);
    const Residue l = f.back();  // res(f,g) = l^deg g prod g(s_i)
    const Residue cube = field.power(field.multiply(l, other_leading.at(first)[0]), 3);
    values.push_back(
        {field.multiply(field.multiply(cube, field.power(l, h.size() - 1)), resultant(field, f, g)),
         field.multiply(field.power(l, g.size() - 1), resultant(field, f, h))});
  }
  return values;
}

/// log2 of a bound of the coefficients of (4.18), by (4.15) and (4.19).
std::size_t norm_height(const FibreCoefficients<Polynomial>& f, const FibreProjection& points,
                        const FibreProjection& other, std::size_t degree_bound) {
  const auto count = static_cast<double>(degree(points.finite));
  const double norms = log2_norm(points.finite) + log2_norm(other.finite);
  const SpaceVector<Polynomial> n = cross_product(f.a[1], f.a[2]);
  const auto forms = turning_forms(f);
  std::optional<double> jacobian;  // of |J| / (max(1,|r|) max(1,|s|))^5 for a conic line
  for (std::size_t k = 0; k < 3; ++k) {
    if (n[k].is_zero()) continue;
    const double log2_six = 2.585;
    const double bound = log2_six + log2_norm({forms[k]}) - measure(n[k]);
    jacobian = jacobian ? std::min(*jacobian, bound) : bound;
  }
  const double m = jacobian ? count * *jacobian + 5 * norms -
                                  2 * (measure(leading(points.finite)) + measure(leading(other.finite)))
                            : count * (2 + log2_norm({normal_form(f, f.a[1])})) + 3 * norms;
  return static_cast<std::size_t>(std::ceil(std::max(m, 0.0))) + degree_bound + 1;
}

Polynomial special_norm(const FibreCoefficients<Polynomial>& f, const FibreProjection& points,
                        const FibreProjection& other) {
  if (degree(points.finite) == 0) return 1;
  const std::size_t degree_bound =  // (4.11)
      2 * degree(points.finite) + 3 * (degree_u(points.finite) + degree_u(other.finite));
  const std::vector<Integer> e =
      interpolate_integer_polynomial(degree_bound, norm_height(f, points, other, degree_bound),
                                     [&](const PrimeField& field, Residue first, std::size_t count) {
                                       return norm_values(field, points, other, first, count);
                                     });
  return Polynomial(std::vector<Rational>(e.begin(), e.end()));
}

/// The square of the product of the distinct prime factors of the two contents: at their roots the whole
/// fibre may degenerate.
Polynomial content_factor(const FibreProjection& a, const FibreProjection& b) {
  const Polynomial radical = squarefree_part(a.content * b.content);
  return radical * radical;
}

/// Why (4.18) cannot be used with this projection; empty if it can.
std::string obstacle(const FibreProjection& points) {
  if (!points.complete) return "points of every fibre at infinity cannot be told from finite ones";
  if (degree(points.finite) == 0) return {};
  if (is_zero(points.s1) || !coprime(points.finite, points.s1))
    return "two points of every fibre have the same parameter";
  return {};
}

/// (4.20): the simple points of the fibre give (4.18), the multiple ones the discriminant of their factor.
TurningEliminant touching_eliminant(const FibreCoefficients<Polynomial>& f, const FibreProjection& points,
                                    const FibreProjection& other) {
  const FibreFactors factors = split_multiple(points.finite);
  FibreProjection simple = points;
  simple.finite = factors.simple;
  Polynomial events = content_factor(points, other) * leading(factors.multiple);
  if (degree(factors.multiple) > 1)
    events = events * discriminant_r(BivariatePolynomial(factors.multiple.coefficients));
  const Polynomial e = special_norm(f, simple, other) * events;
  return {primitive_with_positive_lead(e), {}, true, std::move(events)};
}

/// l disc of the squarefree part: where roots meet or go to infinity.
Polynomial events_of(const FibrePolynomial& f) {
  if (degree(f) == 0) return leading(f);
  const FibreFactors factors = split_multiple(f);
  const FibrePolynomial squarefree = factors.simple * factors.multiple;
  const Polynomial e = leading(squarefree);
  return degree(squarefree) > 1 ? e * discriminant_r(BivariatePolynomial(squarefree.coefficients)) : e;
}

/// (4.21): no matter how many points of a fibre have the same r or the same s.
TurningEliminant unseparated_eliminant(const FibreProjection& to_s, const FibreProjection& to_r) {
  const Polynomial e = primitive_with_positive_lead(content_factor(to_s, to_r) * events_of(to_s.finite) *
                                                    events_of(to_r.finite));
  return {e, {}, true, e};
}

bool vanishes(const SpaceVector<Polynomial>& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

/// Why the pair has no fibres of finitely many points as (4.18) needs them; empty if it may have.
std::string shape_obstacle(const FibreCoefficients<Polynomial>& f) {
  if (vanishes(f.a[1]) && vanishes(f.a[2])) return "x is a curve: it does not depend on v";
  if (vanishes(cross_product(f.a[1], f.a[2])) && !vanishes(f.a[2]))
    return "the lines u = const of x are straight but not run through uniformly";
  const auto no_normal = [&](std::size_t k) {
    SpaceVector<Polynomial> axis;
    axis[k] = 1;
    return is_zero(FibrePolynomial{normal_form(f, axis)});
  };
  if (no_normal(0) && no_normal(1) && no_normal(2))
    return "y is a curve: y_r and y_s are parallel everywhere";
  return {};
}

}  // namespace

TurningEliminant special_eliminant(const IntegerPair& pair) {
  const FibreCoefficients<Polynomial> f = symbolic_fibre(pair);
  if (const std::string why = shape_obstacle(f); !why.empty()) return {std::nullopt, why, false};
  const FibreProjection to_s = project_fibre(f);
  const FibreProjection to_r = project_fibre(f.exchanged());
  if (is_zero(to_s.r) || is_zero(to_r.r))
    return {std::nullopt, "R vanishes identically: the fibres are not finite", false};
  const std::string why = obstacle(to_s);
  const bool use_s = why.empty();
  if (!use_s && !obstacle(to_r).empty()) return unseparated_eliminant(to_s, to_r);
  const FibreProjection& points = use_s ? to_s : to_r;
  const FibreProjection& other = use_s ? to_r : to_s;
  if (degree(points.finite) > 0 && !coprime(points.finite, derivative(points.finite)))
    return touching_eliminant(f, points, other);
  const Polynomial e = special_norm(f, points, other) * content_factor(points, other);
  return {primitive_with_positive_lead(e), {}, false};
}

Polynomial primitive_with_positive_lead(const Polynomial& f) {
  const Polynomial e = f.primitive();
  return sign(e.leading_coefficient()) < 0 ? -e : e;
}

}  // namespace exsect
