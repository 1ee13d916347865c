#include "lift/space_projection.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/rational_matrix.h>
#include <exsect/algebra/resultant.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "curve/turning_resultant.h"

namespace exsect {
namespace {

SpacePolynomial in_frame(const SpacePolynomial& f, const SpaceFrame& frame) {
  std::array<std::vector<SpacePolynomial>, 3> powers;
  for (std::size_t k = 0; k < 3; ++k) {
    SpacePolynomial coordinate;
    for (std::size_t column = 0; column < 3; ++column)
      coordinate += frame.columns[column][k] * SpacePolynomial::variable(column);
    powers[k] = {SpacePolynomial::constant(1)};
    for (int i = 0; i < f.degree_in(k); ++i) powers[k].push_back(powers[k].back() * coordinate);
  }
  SpacePolynomial sum;
  for (const auto& [e, c] : f.terms())
    sum += c * (powers[0][static_cast<std::size_t>(e[0])] * powers[1][static_cast<std::size_t>(e[1])] *
                powers[2][static_cast<std::size_t>(e[2])]);
  return sum;
}

/// The polynomial in y, in the place of r, and v, in that of s.
BivariatePolynomial slice_at(const SpacePolynomial& f, const Rational& u) {
  std::vector<std::vector<Rational>> rows(static_cast<std::size_t>(f.degree()) + 1,
                                          std::vector<Rational>(static_cast<std::size_t>(f.degree()) + 1));
  std::vector<Rational> powers = {1};
  for (int i = 0; i < f.degree(); ++i) powers.push_back(powers.back() * u);
  for (const auto& [e, c] : f.terms())
    rows[static_cast<std::size_t>(e[2])][static_cast<std::size_t>(e[1])] +=
        c * powers[static_cast<std::size_t>(e[0])];
  std::vector<Polynomial> coefficients;
  for (const std::vector<Rational>& row : rows) coefficients.emplace_back(row);
  return BivariatePolynomial(std::move(coefficients));
}

/// Resultant, slope and offset with respect to y over one u, as polynomials in v.
std::array<Polynomial, 3> chain_over(const BivariatePolynomial& f, const BivariatePolynomial& g) {
  if (f.degree_r() < g.degree_r()) return chain_over(g, f);
  const std::vector<BivariatePolynomial> chain = subresultants_r(f, g);
  const BivariatePolynomial& linear = g.degree_r() == 1 ? g : chain[1];
  return {chain[0].coefficient(0), linear.coefficient(1), linear.coefficient(0)};
}

/// The polynomial with these values at the nodes, by those of Lagrange; its degree in r is less than their
/// number.
BivariatePolynomial interpolated(const std::vector<Rational>& nodes, const std::vector<Polynomial>& values) {
  BivariatePolynomial sum;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    Polynomial basis = 1;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (i != k) {
        const Rational distance = nodes[k] - nodes[i];
        basis *= Polynomial{-nodes[i] / distance, 1 / distance};
      }
    std::vector<Polynomial> coefficients;
    for (int i = 0; i <= basis.degree(); ++i)
      coefficients.push_back(Polynomial(basis.coefficient(i)) * values[k]);
    sum += BivariatePolynomial(std::move(coefficients));
  }
  return sum;
}

/// The product over the zeros v of `over`, which is monic, of the polynomial of y and v at y = -offset /
/// slope; empty if the slope has one of these zeros.
std::optional<Rational> product_over(const Polynomial& over, const BivariatePolynomial& p,
                                     const Polynomial& slope, const Polynomial& offset) {
  const auto reduced = [&](const Polynomial& f) { return divide(f, over).remainder; };
  const Polynomial s = reduced(slope), t = -reduced(offset);
  const Rational below = resultant(over, s);
  if (below == 0) return std::nullopt;
  if (p.is_zero()) return 0;
  Polynomial sum = reduced(p.coefficient(p.degree_r())), power = 1;
  Rational whole = 1;
  for (int i = p.degree_r() - 1; i >= 0; --i) {
    power = reduced(power * s);
    whole *= below;
    sum = reduced(sum * t + p.coefficient(i) * power);
  }
  return resultant(over, sum) / whole;
}

/// A multiple, other than 0, of the coordinates of points over u on a factor of the shadow, and of 1: as
/// polynomials of v modulo that factor. Empty if the slope is 0 in one of them.
std::optional<std::array<Polynomial, 4>> points_over(const SpaceProjection& projection,
                                                     const Polynomial& factor, const Rational& u) {
  const Polynomial slope = divide(projection.slope.at_r(u), factor).remainder,
                   offset = projection.offset.at_r(u);
  if (gcd(factor, slope).degree() != 0) return std::nullopt;
  const auto& [a, b, c] = projection.frame.columns;
  std::array<Polynomial, 4> x;
  for (std::size_t k = 0; k < 3; ++k)
    x[k] =
        divide(Polynomial{u * a[k], b[k]} * slope - Polynomial(c[k]) * offset, factor).remainder;  // (17.15)
  x[3] = slope;
  return x;
}

SpacePolynomial leading_form(const SpacePolynomial& f) {
  SpacePolynomial::Terms terms;
  for (const auto& [e, c] : f.terms())
    if (e[0] + e[1] + e[2] == f.degree()) terms[e] = c;
  return SpacePolynomial(terms);
}

}  // namespace

SpaceFrame general_frame(int attempt) {
  // Below and above the diagonals of two triangular matrices, whose product is the frame: small ones whose
  // last column and height are in no plane that a cube is symmetric to.
  static const std::array<std::array<int, 6>, general_frames> entries = {{{-1, 0, -2, 0, 2, 3},
                                                                          {-1, 0, -2, 1, 1, 3},
                                                                          {0, -1, -3, -2, 3, -2},
                                                                          {-1, 0, 0, -2, -2, 3},
                                                                          {-3, -1, 1, 1, 1, -2},
                                                                          {-3, 0, -1, 1, -2, -3}}};
  const std::array<int, 6>& m = entries.at(static_cast<std::size_t>(attempt));
  const Point first = {1, m[0], m[1]}, second = {0, 1, m[2]}, third = {0, 0, 1};
  const Point b = Rational(m[3]) * first + second;
  const Point c = Rational(m[4]) * first + Rational(m[5]) * second + third;
  return {{first, b, c}, cross(b, c)};
}

std::optional<SpaceProjection> space_projection(const SpacePolynomial& f, const SpacePolynomial& g,
                                                const SpaceFrame& frame) {
  const SpacePolynomial first = in_frame(f, frame), second = in_frame(g, frame);
  for (const SpacePolynomial* each : {&first, &second})
    if (each->coefficient({0, 0, each->degree()}) == 0) return std::nullopt;
  // No coefficient of the chain has a degree above this one.
  const int degree = first.degree() * second.degree();
  std::array<std::vector<Polynomial>, 3> values;
  std::vector<Rational> nodes;
  for (int u = 0; u <= degree; ++u) {
    interruption_point();
    nodes.emplace_back(u);
    const std::array<Polynomial, 3> chain = chain_over(slice_at(first, u), slice_at(second, u));
    for (std::size_t k = 0; k < 3; ++k) values[k].push_back(chain[k]);
  }
  SpaceProjection result{frame, interpolated(nodes, values[0]), interpolated(nodes, values[1]),
                         interpolated(nodes, values[2])};
  if (result.shadow.total_degree() != result.shadow.degree_s()) return std::nullopt;
  return result;
}

SpaceQuadratic space_quadratic(const SpacePolynomial& f, const SpacePolynomial& g, const SpaceFrame& frame) {
  if (f.degree() < g.degree()) return space_quadratic(g, f, frame);
  const SpacePolynomial first = in_frame(f, frame), second = in_frame(g, frame);
  std::array<std::vector<Polynomial>, 3> values;
  std::vector<Rational> nodes;
  for (int u = 0; u <= f.degree() * g.degree(); ++u) {
    interruption_point();
    nodes.emplace_back(u);
    const BivariatePolynomial over = slice_at(second, u);
    const BivariatePolynomial of = g.degree() == 2 ? over : subresultants_r(slice_at(first, u), over)[2];
    for (int k = 0; k < 3; ++k) values[static_cast<std::size_t>(k)].push_back(of.coefficient(k));
  }
  SpaceQuadratic result;
  for (std::size_t k = 0; k < 3; ++k) result.c[k] = interpolated(nodes, values[k]);
  const SpaceProjection by_middle{frame, {}, BivariatePolynomial::constant(2) * result.c[2], result.c[1]};
  result.along = sign_below(by_middle, turning_form(f, g, cross(frame.columns[0], frame.columns[1])));
  return result;
}

SpacePolynomial turning_form(const SpacePolynomial& f, const SpacePolynomial& g, const Point& height) {
  SpacePolynomial sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    sum += height[k] * (f.derivative(i) * g.derivative(j) - f.derivative(j) * g.derivative(i));
  }
  return sum;
}

Polynomial turning_norm(const SpaceProjection& projection) {
  if (projection.shadow.degree_s() < 1) return 1;
  const Polynomial all = turning_resultant(projection.shadow);
  if (all.is_zero() || projection.slope.total_degree() < 1) return all;
  return exact_quotient(all, resultant_s(projection.shadow, projection.slope));  // (17.16)
}

std::optional<Polynomial> norm_over(const SpaceProjection& projection, const BivariatePolynomial& factor,
                                    const SpacePolynomial& p) {
  const SpacePolynomial in_coordinates = in_frame(p, projection.frame);
  // v and y are O(u) on the points, so the degree is at most this one.
  const int degree = factor.degree_s() * p.degree();
  int exceptions = factor.degree_s() * std::max(projection.slope.total_degree(), 0);
  std::vector<Rational> nodes;
  std::vector<Polynomial> values;
  for (int u = 0; static_cast<int>(nodes.size()) <= degree; ++u) {
    interruption_point();
    const Polynomial over = factor.at_r(u);
    const std::optional<Rational> value =
        product_over(over * Polynomial(1 / over.leading_coefficient()), slice_at(in_coordinates, u),
                     projection.slope.at_r(u), projection.offset.at_r(u));
    if (value) {
      nodes.emplace_back(u);
      values.emplace_back(*value);
    } else if (exceptions-- == 0)
      return std::nullopt;
  }
  return interpolated(nodes, values).exchanged().coefficient(0);
}

std::vector<SpacePolynomial> forms_through(const SpaceProjection& projection,
                                           const BivariatePolynomial& factor, int degree) {
  const std::vector<Exponents> exponents = exponents_up_to(degree);
  const auto count = static_cast<std::size_t>(factor.degree_s());
  RationalMatrix values(count * static_cast<std::size_t>(degree + 1), exponents.size());
  std::size_t row = 0;
  for (int u = 0; row < values.rows(); ++u) {
    interruption_point();
    const Polynomial over = factor.at_r(u);
    const auto x = points_over(projection, over, u);
    if (!x) continue;
    for (std::size_t column = 0; column < exponents.size(); ++column) {
      const auto& [i, j, k] = exponents[column];
      const std::array<int, 4> powers = {i, j, k, degree - i - j - k};
      Polynomial value = 1;
      for (std::size_t which = 0; which < 4; ++which)
        for (int n = 0; n < powers[which]; ++n) value = divide(value * (*x)[which], over).remainder;
      for (std::size_t n = 0; n < count; ++n)
        values(row + n, column) = value.coefficient(static_cast<int>(n));  // (17.19a)
    }
    row += count;
  }
  std::vector<SpacePolynomial> forms;
  for (const std::vector<Integer>& solution : null_space(values)) {
    SpacePolynomial::Terms terms;
    for (std::size_t i = 0; i < solution.size(); ++i) terms[exponents[i]] = Rational(solution[i]);
    forms.emplace_back(terms);
  }
  return forms;
}

BivariatePolynomial sign_below(const SpaceProjection& projection, const SpacePolynomial& p) {
  const SpacePolynomial in_coordinates = in_frame(p, projection.frame);
  const int degree = in_coordinates.degree_in(2);
  const BivariatePolynomial minus = BivariatePolynomial() - projection.offset;
  BivariatePolynomial sum;
  for (const auto& [e, c] : in_coordinates.terms()) {
    BivariatePolynomial term = BivariatePolynomial::constant(c);
    for (int i = 0; i < e[0]; ++i) term = term * BivariatePolynomial::r();
    for (int i = 0; i < e[1]; ++i) term = term * BivariatePolynomial::s();
    for (int i = 0; i < degree + degree % 2; ++i) term = term * (i < e[2] ? minus : projection.slope);
    sum += term;
  }
  return sum;
}

void lower_degrees(SpacePolynomial& f, SpacePolynomial& g) {
  while (!g.is_zero() && f.degree() == g.degree()) {
    const SpacePolynomial of_f = leading_form(f), of_g = leading_form(g);
    const Exponents& first = of_f.terms().begin()->first;
    const Rational factor = of_g.coefficient(first) / of_f.coefficient(first);
    if (factor == 0 || !(of_g == factor * of_f)) return;
    g -= factor * f;
  }
}

}  // namespace exsect
