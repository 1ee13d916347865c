#include "self/singular_pairs.h"

#include <exsect/algebra/number_field.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "answer/exact_source.h"
#include "line/exact_tangent.h"

namespace exsect {
namespace {

/// Arithmetic at the common roots of an irreducible polynomial of s and a polynomial of r over its field.
class Residues {
 public:
  Residues(Polynomial of_s, BivariatePolynomial of_r) : of_s_(std::move(of_s)), of_r_(std::move(of_r)) {}

  /// of_r has the leading coefficient 1.
  BivariatePolynomial operator()(const BivariatePolynomial& f) const {
    std::vector<Polynomial> rest;
    for (int i = 0; i <= f.degree_r(); ++i) rest.push_back(divide(f.coefficient(i), of_s_).remainder);
    const int n = of_r_.degree_r();
    for (int i = static_cast<int>(rest.size()) - 1; i >= n; --i)
      for (int k = 0; k <= n; ++k) {
        Polynomial& entry = rest[static_cast<std::size_t>(i - n + k)];
        const Polynomial top = k < n ? rest[static_cast<std::size_t>(i)] : Polynomial();
        entry = k < n ? divide(entry - top * of_r_.coefficient(k), of_s_).remainder : Polynomial();
      }
    return BivariatePolynomial(std::move(rest));
  }

 private:
  Polynomial of_s_;
  BivariatePolynomial of_r_;
};

/// u1 = u2 + d, v2 = v1 + e with the minors proportional to d, d^2, e, e^2; empty where they say nothing.
std::optional<ExactParameters> pair_over(const std::array<BivariatePolynomial, 4>& minors,
                                         const TriangularPoint& at, const Residues& residue) {
  const auto& [k1, k2, k3, k4] = minors;
  ExactParameters pair{at, {}, {}};
  pair.denominator.fill(BivariatePolynomial::constant(1));
  pair.numerator[1] = BivariatePolynomial::s();
  pair.numerator[2] = residue(BivariatePolynomial::r());
  if (sign_at(k1, at) != 0) {  // d = k2/k1, e = d k3/k1
    pair.denominator[0] = k1;
    pair.numerator[0] = residue(BivariatePolynomial::r() * k1 + k2);
    pair.denominator[3] = residue(k1 * k1);
    pair.numerator[3] = residue(BivariatePolynomial::s() * k1 * k1 + k2 * k3);
  } else if (sign_at(k3, at) != 0) {  // d = 0, e = k4/k3
    pair.numerator[0] = pair.numerator[2];
    pair.denominator[3] = k3;
    pair.numerator[3] = residue(BivariatePolynomial::s() * k3 + k4);
  } else {
    return std::nullopt;
  }
  return pair;
}

/// A polynomial of s alone divides f.
bool is_factor(const Polynomial& of_s, const BivariatePolynomial& f) {
  for (int i = 0; i <= f.degree_r(); ++i)
    if (!divide(f.coefficient(i), of_s).remainder.is_zero()) return false;
  return !f.is_zero();
}

bool is_in_square(const ExactParameters& pair) {
  for (const std::size_t j : {0U, 3U}) {
    const int sign = sign_at(pair.denominator[j], pair.at);
    if (sign * sign_at(pair.numerator[j], pair.at) < 0 ||
        sign * sign_at(pair.numerator[j] - pair.denominator[j], pair.at) > 0)
      return false;
  }
  return true;
}

/// Arithmetic with such numbers in a number field would take minutes, which no work cap ends.
bool is_long(const Polynomial& f) {
  constexpr std::size_t most_bits = 4000;
  for (int i = 0; i <= f.degree(); ++i) {
    const Rational c = abs(f.coefficient(i));
    if (c != 0 && std::max(msb(numerator(c)), msb(denominator(c))) > most_bits) return true;
  }
  return false;
}

}  // namespace

std::vector<TurningPair> turning_pairs_over(const BezierPatch& x, const SelfProjection& projection,
                                            const RealAlgebraic& value) {
  BivariatePolynomial q = projection.curve;
  for (int i = 0; i <= q.degree_r(); ++i)
    if (is_long(q.coefficient(i))) return {};
  while (is_factor(value.polynomial(), q)) q = exact_quotient(q, BivariatePolynomial({value.polynomial()}));
  const auto bound = gcd_degree_bound(q, q.derivative_r(), value.polynomial());
  if (!bound || *bound < 1) return {};
  const auto multiple = gcd_modulo(q, q.derivative_r(), value.polynomial());
  if (!multiple || multiple->degree_r() < 1) return {};
  const auto repeated = gcd_modulo(*multiple, multiple->derivative_r(), value.polynomial());
  if (!repeated || repeated->degree_r() > 0) return {};
  const Residues residue(value.polynomial(), *multiple);
  std::array<BivariatePolynomial, 4> minors;
  for (std::size_t k = 0; k < 4; ++k) minors[k] = residue(projection.minors[k]);
  std::vector<TurningPair> result;
  for (const TriangularPoint& at : roots_at(*multiple, value, 0, 1)) {
    const auto pair = pair_over(minors, at, residue);
    if (!pair || !is_in_square(*pair) || (agree(*pair, 0) && agree(*pair, 1))) continue;
    result.push_back({*pair, zero_tangent_components(x, x, *pair)});
  }
  return result;
}

std::vector<ExactParameters> singular_pairs_over(const BezierPatch& x, const SelfProjection& projection,
                                                 const RealAlgebraic& value) {
  std::vector<ExactParameters> result;
  if (is_factor(value.polynomial(), projection.curve)) return result;
  for (const TurningPair& turning : turning_pairs_over(x, projection, value))
    if (std::ranges::count(turning.zero, true) == 4) result.push_back(turning.pair);
  return result;
}

bool has_value(const ExactParameters& point, std::size_t j, const RealAlgebraic& value) {
  const auto near = [&](const Rational& width) {
    const RationalInterval a = value.refined_to(width).interval();
    const RationalInterval b = enclosure(point, j, width);
    return a.lower <= b.upper && b.lower <= a.upper;
  };
  if (!near(power_of_two(-60))) return false;
  const Polynomial& f = value.polynomial();
  BivariatePolynomial sum;  // of f_i numerator^i denominator^(n - i)
  BivariatePolynomial power = BivariatePolynomial::constant(1);
  for (int i = f.degree(); i >= 0; --i) {
    sum = sum * point.numerator[j] + power * Polynomial(f.coefficient(i));
    power = power * point.denominator[j];
  }
  if (sign_at(sum, point.at) != 0) return false;
  if (value.is_rational()) return true;
  for (Rational width = power_of_two(-60); near(width); width *= width) {
    const RationalInterval b = enclosure(point, j, width);
    // The value is the only root of f in its interval.
    if (b.lower >= value.interval().lower && b.upper <= value.interval().upper) return true;
  }
  return false;
}

}  // namespace exsect
