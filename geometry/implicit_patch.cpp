#include "implicit_patch.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/modular.h>
#include <exsect/algebra/rational_matrix.h>

#include <stdexcept>
#include <utility>

#include "dixon_matrix.h"
#include "vector_algebra.h"

namespace exsect {
namespace {

/// The patch as integer net: the point P of space has integer coordinates (P - shift) scale.
struct IntegerPatch {
  IntegerNet net;
  Point shift;
  Point scale;
};

IntegerPatch integer_patch(const BezierPatch& x) {
  IntegerPatch result{integer_pair(x, x).x, {}, {1, 1, 1}};
  const ControlNet c = x.power_basis();
  result.shift = c[0][0];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        if (i + j > 0 && c[i][j][k] != 0) result.scale[k] = Rational(result.net[i][j][k]) / c[i][j][k];
  return result;
}

bool is_surface(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  std::array<BivariatePolynomial, 3> first, second;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Polynomial> rows;
    for (const auto& row : c) rows.push_back(Polynomial({row[0][k], row[1][k], row[2][k]}));
    const BivariatePolynomial coordinate(std::move(rows));
    first[k] = coordinate.derivative_r();
    second[k] = coordinate.derivative_s();
  }
  const auto normal = cross_over<BivariatePolynomial>(first, second);
  return !(normal[0].is_zero() && normal[1].is_zero() && normal[2].is_zero());
}

/// The values of the monomials at a point of the patch modulo p.
std::vector<Residue> monomials_at(const PrimeField& field, const IntegerNet& c,
                                  const std::vector<Exponents>& exponents, int degree, Residue u, Residue v) {
  std::array<std::vector<Residue>, 3> powers;
  for (std::size_t k = 0; k < 3; ++k) {
    Residue value = field.zero();
    for (std::size_t i = 3; i-- > 0;) {
      Residue row = field.zero();
      for (std::size_t j = 3; j-- > 0;) row = field.add(field.multiply(row, v), field.residue(c[i][j][k]));
      value = field.add(field.multiply(value, u), row);
    }
    powers[k] = {field.one()};
    for (int d = 0; d < degree; ++d) powers[k].push_back(field.multiply(powers[k].back(), value));
  }
  std::vector<Residue> row;
  for (const Exponents& e : exponents) {
    const auto power = [&](std::size_t k) { return powers[k][static_cast<std::size_t>(e[k])]; };
    row.push_back(field.multiply(field.multiply(power(0), power(1)), power(2)));
  }
  return row;
}

/// True only if no equation of this degree vanishes on the patch: as many points of the patch as there are
/// monomials, modulo one prime, on which no combination of the monomials vanishes.
bool has_no_equation(const IntegerNet& c, int degree) {
  const PrimeField field(prime_below(prime_field_limit));
  const std::vector<Exponents> exponents = exponents_up_to(degree);
  std::vector<std::vector<Residue>> reduced;  // row i is zero before its leading column i, where it is one
  reduced.resize(exponents.size());
  const Residue step_u = field.residue(std::int64_t{0x1f123bb5a3c4d7}),
                step_v = field.residue(std::int64_t{0x3a7c52d9e8b641});
  Residue u = step_v, v = step_u;
  std::size_t rank = 0;
  for (std::size_t point = 0; point < exponents.size(); ++point) {
    u = field.add(field.multiply(u, u), step_u);
    v = field.add(field.multiply(v, u), step_v);
    std::vector<Residue> row = monomials_at(field, c, exponents, degree, u, v);
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (row[column] == 0) continue;
      if (reduced[column].empty()) {
        const Residue inverse = field.inverse(row[column]);
        for (Residue& entry : row) entry = field.multiply(entry, inverse);
        reduced[column] = std::move(row);
        ++rank;
        break;
      }
      const Residue factor = row[column];
      for (std::size_t j = column; j < row.size(); ++j)
        row[j] = field.subtract(row[j], field.multiply(factor, reduced[column][j]));
    }
  }
  return rank == exponents.size();
}

/// Coefficient (i,j) of the composition of each monomial: one row for each (i,j), one column for each
/// monomial.
RationalMatrix composition_matrix(const BezierPatch& x, const std::vector<Exponents>& exponents, int degree) {
  const auto side = static_cast<std::size_t>(2 * degree + 1);
  RationalMatrix matrix(side * side, exponents.size());
  for (std::size_t column = 0; column < exponents.size(); ++column) {
    const BivariatePolynomial composed = compose(SpacePolynomial({{exponents[column], 1}}), x);
    for (std::size_t i = 0; i < side; ++i)
      for (std::size_t j = 0; j < side; ++j)
        matrix(i * side + j, column) = composed.coefficient(static_cast<int>(i), static_cast<int>(j));
  }
  return matrix;
}

BezierPatch as_patch(const IntegerNet& net) {
  ControlNet c;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j][k] = net[i][j][k];
  return BezierPatch::from_power_basis(c);
}

}  // namespace

SpacePolynomial affinely_substituted(const SpacePolynomial& f, const Point& shift, const Point& scale) {
  SpacePolynomial::Terms terms = f.terms();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    SpacePolynomial::Terms expanded;
    for (const auto& [e, c] : terms) {
      // c (scale (t - shift))^n
      Rational factor = c;
      for (int m = 0; m < e[axis]; ++m) factor *= scale[axis];
      for (int m = e[axis]; m >= 0; --m, factor *= -shift[axis]) {
        Exponents lower = e;
        lower[axis] = m;
        expanded[lower] += factor * binomial(e[axis], m);
      }
    }
    terms = std::move(expanded);
  }
  return SpacePolynomial(terms);
}

std::vector<SpacePolynomial> vanishing_equations(const BezierPatch& x, int degree) {
  if (degree < 1 || degree > 8)
    throw std::invalid_argument("vanishing_equations: the degree must be 1, ..., 8");
  const IntegerPatch integers = integer_patch(x);
  const std::vector<Exponents> exponents = exponents_up_to(degree);
  std::vector<SpacePolynomial> result;
  for (const std::vector<Integer>& b :
       null_space(composition_matrix(as_patch(integers.net), exponents, degree))) {
    SpacePolynomial::Terms terms;
    for (std::size_t i = 0; i < exponents.size(); ++i) terms[exponents[i]] = b[i];
    result.push_back(
        affinely_substituted(SpacePolynomial(terms), integers.shift, integers.scale).primitive());
  }
  return result;
}

SpacePolynomial implicit_equation(const BezierPatch& x) {
  if (!is_surface(x))
    throw std::domain_error("implicit equation: the patch is a curve or a point, x_u x x_v = 0");
  const IntegerPatch integers = integer_patch(x);
  // An equation of a lower degree, times any polynomial, is one of degree 7: the usual case needs one rank.
  if (!has_no_equation(integers.net, 7)) {
    for (int degree = 1; degree <= 7; ++degree) {
      if (has_no_equation(integers.net, degree)) continue;
      const std::vector<SpacePolynomial> equations = vanishing_equations(x, degree);
      if (!equations.empty()) return equations.front();
    }
  }
  // The degree is 8, which is the number of common points with a line: no base points, a proper
  // parametrisation, and the determinant is the equation.
  return affinely_substituted(determinant(dixon_matrix(integers.net)), integers.shift, integers.scale)
      .primitive();
}

}  // namespace exsect
