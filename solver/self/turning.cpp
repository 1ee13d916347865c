#include "self/turning.h"

#include <exsect/algebra/resultant.h>

#include <algorithm>

#include "curve/polynomial_vector.h"
#include "shape/injective_rectangle.h"

namespace exsect {
namespace {

using Form = BivariatePolynomial;
using FormVector = PolynomialVector;

FormVector times(const Rational& factor, FormVector f) {
  for (Form& c : f) c *= Polynomial(factor);
  return f;
}

/// The greatest common divisor of the coefficients of the powers of r.
Polynomial content(const Form& f) {
  Polynomial result;
  for (int i = 0; i <= f.degree_r(); ++i) result = gcd(result, f.coefficient(i));
  return result;
}

Form without_content(const Form& f) { return exact_quotient(f, Form({content(f)})); }

/// r or s (fixed: 0 or 1) minus the value of a side.
Form side_factor(std::size_t fixed, int value) {
  return (fixed == 0 ? Form::r() : Form::s()) - Form::constant(value);
}

bool divides(const Form& line, const Form& f) {
  return f.is_zero() || gcd(line, f).degree_r() + gcd(line, f).degree_s() > 0;
}

/// Divides by the line as often as all of them, not all zero, can be.
template <std::size_t N>
void divide_out(std::array<Form, N>& forms, const Form& line) {
  const auto is_zero = [](const Form& f) { return f.is_zero(); };
  while (!std::ranges::all_of(forms, is_zero) &&
         std::ranges::all_of(forms, [&](const Form& f) { return divides(line, f); }))
    for (Form& f : forms)
      if (!f.is_zero()) f = exact_quotient(f, line);
}

/// With irreducible polynomials.
void add_roots(std::vector<RealAlgebraic>& values, const Polynomial& f) {
  if (f.degree() < 1) return;
  for (const PolynomialPower& power : irreducible_factors(f))
    for (const RealAlgebraic& root : real_roots(power.factor, 0, 1)) values.push_back(root);
}

std::vector<RealAlgebraic> ascending(std::vector<RealAlgebraic> values) {
  std::ranges::sort(values, std::less<>());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// Values of s over which all four minors may vanish at a zero of `multiple`; false if they vanish along it.
bool add_zeros_of_minors(std::vector<RealAlgebraic>& values, const Form& multiple,
                         const std::array<Form, 4>& minors) {
  for (const Form& minor : minors) {
    if (minor.is_zero() || gcd(multiple, minor).degree_r() > 0) continue;
    add_roots(values, resultant_r(multiple, minor));
    return true;
  }
  return false;
}

}  // namespace

SelfProjection self_projection(const BezierPatch& x) {
  const FormVector value = coordinates_from(x, {0, 0, 0});
  const FormVector b = derivative_r(value);
  const FormVector a = times(Rational(1, 2), derivative_r(b));
  const FormVector d = times(-1, derivative_s(value));
  const FormVector c = times(Rational(1, 2), derivative_s(d));
  const FormVector dc = cross(d, c);
  const FormVector ba = cross(b, a);
  // The alternating minors of (b a d c).
  SelfProjection result{{dot(a, dc), dot(times(-1, b), dc), dot(ba, c), dot(times(-1, ba), d)}, {}};
  for (const int end : {0, 1})
    if (is_collapsed_side(x, 0, end)) divide_out(result.minors, side_factor(0, end));
  const auto& [k_b, k_a, k_d, k_c] = result.minors;
  result.curve = k_b * k_b * k_c - k_d * k_d * k_a;
  return result;
}

std::optional<std::vector<RealAlgebraic>> self_turning_values(const BezierPatch& x) {
  const SelfProjection projection = self_projection(x);
  const Form& q = projection.curve;
  if (q.is_zero()) return std::nullopt;
  std::vector<RealAlgebraic> values;
  add_roots(values, content(q));
  const Form whole = without_content(q);
  if (whole.degree_r() < 1) return ascending(std::move(values));
  const Form repeated = gcd(whole, whole.derivative_r());
  const Form simple = exact_quotient(whole, repeated);
  const Form multiple = gcd(simple, repeated);
  if (multiple.degree_r() > 0 && !add_zeros_of_minors(values, multiple, projection.minors))
    return std::nullopt;
  add_roots(values, simple.coefficient(simple.degree_r()));
  if (simple.degree_r() > 1) add_roots(values, discriminant_r(simple));
  return ascending(std::move(values));
}

std::optional<std::vector<RealAlgebraic>> cuspidal_values(const BezierPatch& x) {
  const FormVector value = coordinates_from(x, {0, 0, 0});
  FormVector normal = cross(derivative_r(value), derivative_s(value));
  std::vector<RealAlgebraic> values;
  for (const std::size_t fixed : {0, 1})
    for (const int side : {0, 1}) {
      if (!is_cuspidal_side(x, fixed, side)) continue;
      divide_out(normal, side_factor(fixed, side));
      if (fixed == 1) values.emplace_back(side);
    }
  for (std::size_t i = 0; i < 3; ++i)
    for (const int factor : {0, 1, 2}) {
      const Form& first = normal[i];
      const Form second = normal[(i + 1) % 3] + normal[(i + 2) % 3] * Polynomial(factor);
      if (first.is_zero() || second.is_zero()) continue;
      const Polynomial eliminant = resultant_r(first, second);
      if (eliminant.is_zero()) continue;
      add_roots(values, eliminant);
      return values;
    }
  return std::nullopt;
}

SelfValues self_values(const BezierPatch& x) {
  const BezierPatch exchanged = x.exchanged();
  return {{self_turning_values(exchanged), self_turning_values(x)},
          {cuspidal_values(exchanged), cuspidal_values(x)}};
}

}  // namespace exsect
