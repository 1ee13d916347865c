#include "space_polynomial.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace exsect {
namespace {

int total(const Exponents& e) { return e[0] + e[1] + e[2]; }

/// Descending: total degree, then lexicographic.
bool is_before(const Exponents& a, const Exponents& b) {
  return total(a) != total(b) ? total(a) > total(b) : a > b;
}

std::vector<Rational> powers(const Rational& base, int degree) {
  std::vector<Rational> result = {1};
  for (int i = 0; i < degree; ++i) result.push_back(result.back() * base);
  return result;
}

}  // namespace

SpacePolynomial::SpacePolynomial(const Terms& terms) {
  for (const auto& [e, c] : terms) {
    if (*std::min_element(e.begin(), e.end()) < 0)
      throw std::invalid_argument("SpacePolynomial: an exponent is negative");
    if (c != 0) terms_.emplace(e, c);
  }
}

SpacePolynomial SpacePolynomial::variable(std::size_t axis) {
  Exponents e = {0, 0, 0};
  e.at(axis) = 1;
  return SpacePolynomial(Terms{{e, 1}});
}

Rational SpacePolynomial::coefficient(const Exponents& e) const {
  const auto term = terms_.find(e);
  return term == terms_.end() ? Rational(0) : term->second;
}

int SpacePolynomial::degree() const {
  int degree = -1;
  for (const auto& [e, c] : terms_) degree = std::max(degree, total(e));
  return degree;
}

int SpacePolynomial::degree_in(std::size_t axis) const {
  int degree = -1;
  for (const auto& [e, c] : terms_) degree = std::max(degree, e[axis]);
  return degree;
}

Rational SpacePolynomial::operator()(const Point& p) const {
  std::array<std::vector<Rational>, 3> power;
  for (std::size_t axis = 0; axis < 3; ++axis) power[axis] = powers(p[axis], degree_in(axis));
  Rational value = 0;
  for (const auto& [e, c] : terms_) {
    Rational term = c;
    for (std::size_t axis = 0; axis < 3; ++axis) term *= power[axis][static_cast<std::size_t>(e[axis])];
    value += term;
  }
  return value;
}

SpacePolynomial SpacePolynomial::derivative(std::size_t axis) const {
  SpacePolynomial result;
  for (const auto& [e, c] : terms_) {
    if (e[axis] == 0) continue;
    Exponents lower = e;
    --lower[axis];
    result.terms_.emplace(lower, c * e[axis]);
  }
  return result;
}

SpacePolynomial SpacePolynomial::primitive() const {
  if (is_zero()) return {};
  Integer numerators = 0;
  Integer denominators = 1;
  for (const auto& [e, c] : terms_) {
    numerators = gcd(numerators, numerator(c));
    denominators = lcm(denominators, denominator(c));
  }
  const auto leading = std::min_element(
      terms_.begin(), terms_.end(), [](const auto& a, const auto& b) { return is_before(a.first, b.first); });
  return Rational(sign(leading->second) * denominators, numerators) * *this;
}

SpacePolynomial& SpacePolynomial::operator+=(const SpacePolynomial& other) {
  if (&other == this) return *this = Rational(2) * *this;
  for (const auto& [e, c] : other.terms_) {
    const auto [term, is_new] = terms_.emplace(e, c);
    if (is_new) continue;
    term->second += c;
    if (term->second == 0) terms_.erase(term);
  }
  return *this;
}

SpacePolynomial& SpacePolynomial::operator-=(const SpacePolynomial& other) {
  return *this += Rational(-1) * other;
}

SpacePolynomial operator*(const SpacePolynomial& a, const SpacePolynomial& b) {
  SpacePolynomial::Terms product;
  for (const auto& [e, c] : a.terms_)
    for (const auto& [f, d] : b.terms_) product[{e[0] + f[0], e[1] + f[1], e[2] + f[2]}] += c * d;
  return SpacePolynomial(product);
}

SpacePolynomial operator*(const Rational& c, SpacePolynomial a) {
  if (c == 0) return {};
  for (auto& [e, d] : a.terms_) d *= c;
  return a;
}

std::vector<Exponents> exponents_up_to(int degree) {
  std::vector<Exponents> result;
  for (int d = 0; d <= degree; ++d)
    for (int i = 0; i <= d; ++i)
      for (int j = 0; i + j <= d; ++j) result.push_back({i, j, d - i - j});
  return result;
}

BivariatePolynomial compose(const SpacePolynomial& f, const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  std::array<BivariatePolynomial, 3> coordinate;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Polynomial> rows;
    for (const auto& row : c) rows.push_back(Polynomial({row[0][k], row[1][k], row[2][k]}));
    coordinate[k] = BivariatePolynomial(std::move(rows));
  }
  // Horner's scheme in x, inside it in y, inside it in z. The terms are ordered by x, then y, then z.
  const auto horner = [](std::map<int, BivariatePolynomial> by_exponent, const BivariatePolynomial& at) {
    BivariatePolynomial value;
    for (int e = by_exponent.empty() ? -1 : by_exponent.rbegin()->first; e >= 0; --e) {
      value = value * at;
      const auto term = by_exponent.find(e);
      if (term != by_exponent.end()) value += term->second;
    }
    return value;
  };
  std::map<int, std::map<int, std::map<int, BivariatePolynomial>>> nested;
  for (const auto& [e, coefficient] : f.terms())
    nested[e[0]][e[1]][e[2]] = BivariatePolynomial::constant(coefficient);
  std::map<int, BivariatePolynomial> in_x;
  for (const auto& [i, of_y] : nested) {
    std::map<int, BivariatePolynomial> in_y;
    for (const auto& [j, in_z] : of_y) in_y[j] = horner(in_z, coordinate[2]);
    in_x[i] = horner(in_y, coordinate[1]);
  }
  return horner(in_x, coordinate[0]);
}

}  // namespace exsect
