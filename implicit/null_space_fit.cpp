#include "null_space_fit.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/double_matrix.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/rational_matrix.h>
#include <exsect/geometry/homogeneous_composition.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/short_rational.h"

namespace exsect {
namespace {

/// D without the roots of the weights: the row k of D is sqrt(weights[k]) times the row k of `rows`.
struct WeightedMatrix {
  RationalMatrix rows;
  std::vector<Rational> weights;
};

/// (2 t - 1) f.
Polynomial times_centred(const Polynomial& f) { return Polynomial{-1, 2} * f; }

/// Legendre's or Chebyshev's polynomials on [0,1] of degrees 0..n, each 1 at t = 1.
std::vector<Polynomial> orthogonal_polynomials(CurveBasis basis, int n) {
  std::vector<Polynomial> list = {Polynomial(1), times_centred(1)};
  for (int k = 1; k < n; ++k) {
    const Polynomial& last = list[static_cast<std::size_t>(k)];
    const Polynomial& before = list[static_cast<std::size_t>(k - 1)];
    if (basis == CurveBasis::legendre)
      list.push_back(Polynomial(Rational(2 * k + 1, k + 1)) * times_centred(last) -
                     Polynomial(Rational(k, k + 1)) * before);
    else
      list.push_back(Polynomial(2) * times_centred(last) - before);
  }
  list.resize(static_cast<std::size_t>(n) + 1);
  return list;
}

/// Coefficients of f in a basis with one polynomial of each degree.
std::vector<Rational> expansion(Polynomial f, const std::vector<Polynomial>& basis) {
  std::vector<Rational> coefficients(basis.size(), 0);
  while (!f.is_zero()) {
    const auto k = static_cast<std::size_t>(f.degree());
    coefficients[k] = f.leading_coefficient() / basis[k].leading_coefficient();
    f -= Polynomial(coefficients[k]) * basis[k];
  }
  return coefficients;
}

std::vector<Rational> row_weights(CurveBasis basis, int n) {
  std::vector<Rational> weights;
  for (int k = 0; k <= n; ++k) {
    if (basis == CurveBasis::legendre)
      weights.emplace_back(1, 2 * k + 1);
    else
      weights.push_back(basis == CurveBasis::chebyshev && k > 0 ? Rational(1, 2) : Rational(1));
  }
  return weights;
}

std::vector<Rational> values_at_equal_steps(const Polynomial& f, int n) {
  std::vector<Rational> values;
  for (int k = 0; k <= n; ++k) values.push_back(f(n == 0 ? Rational(0) : Rational(k, n)));
  return values;
}

WeightedMatrix collocation(const PlanarSpace& space, const HomogeneousCurve& curve, CurveBasis basis) {
  const int m = space.total_degree();
  const int n = m * curve.degree();
  std::vector<Polynomial> orthogonal;
  if (basis == CurveBasis::legendre || basis == CurveBasis::chebyshev)
    orthogonal = orthogonal_polynomials(basis, n);
  WeightedMatrix result = {RationalMatrix(static_cast<std::size_t>(n) + 1, space.dimension()),
                           row_weights(basis, n)};
  for (std::size_t j = 0; j < space.dimension(); ++j) {
    std::vector<Rational> unit(space.dimension(), 0);
    unit[j] = 1;
    const Polynomial pulled = homogeneous_composition(
        space.combination(unit).polynomial(), curve.numerators[0], curve.numerators[1], curve.denominator, m);
    const std::vector<Rational> column = basis == CurveBasis::bernstein  ? bernstein_coefficients(pulled, n)
                                         : basis == CurveBasis::lagrange ? values_at_equal_steps(pulled, n)
                                                                         : expansion(pulled, orthogonal);
    for (std::size_t i = 0; i < column.size(); ++i) result.rows(i, j) = column[i];
  }
  return result;
}

Rational squared_length(const std::vector<Rational>& b) {
  Rational sum = 0;
  for (const Rational& c : b) sum += c * c;
  return sum;
}

/// |D b|^2.
Rational squared_residual(const WeightedMatrix& d, const std::vector<Rational>& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < d.rows.rows(); ++i) {
    Rational value = 0;
    for (std::size_t j = 0; j < b.size(); ++j) value += d.rows(i, j) * b[j];
    sum += d.weights[i] * value * value;
  }
  return sum;
}

std::vector<Rational> singular_vector(const WeightedMatrix& d) {
  DoubleMatrix m(d.rows.rows(), d.rows.columns());
  for (std::size_t i = 0; i < d.rows.rows(); ++i)
    for (std::size_t j = 0; j < d.rows.columns(); ++j)
      m(i, j) = std::sqrt(to_double(d.weights[i])) * to_double(d.rows(i, j));
  if (!m.is_finite()) throw std::invalid_argument("null space: a coordinate is beyond the range of doubles");
  std::vector<Rational> b;
  for (const double c : least_singular(m).vector) b.push_back(from_double(c));
  return b;
}

/// The number of bits to which a vector of residual |D b|^2 = square is worth keeping.
long useful_bits(const Rational& square) {
  long bits = 64;
  for (Rational q = square; q < 1 && bits < 4096; q *= 4) ++bits;
  return bits;
}

/// Inverse iteration on D'D from the vector of the decomposition: each step multiplies the error by the
/// square of the quotient of the two least singular values.
std::vector<Rational> refined_vector(const WeightedMatrix& d, std::vector<Rational> b) {
  const std::size_t n = d.rows.columns();
  RationalMatrix gram(n, n);
  for (std::size_t k = 0; k < d.rows.rows(); ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) gram(i, j) += d.weights[k] * d.rows(k, i) * d.rows(k, j);
  for (int step = 0; step < 4; ++step) {
    const auto next = solve(gram, b);
    if (!next) throw ProofFailure(whole_domain(), "null space: a singular matrix of full rank");
    const Rational length = root_above(squared_length(*next));
    for (std::size_t i = 0; i < n; ++i) b[i] = (*next)[i] / length;
    const long bits = useful_bits(squared_residual(d, b));
    for (Rational& c : b) {
      const Rational scaled = c * power_of_two(bits);
      c = Rational(Integer(numerator(scaled) / denominator(scaled))) * power_of_two(-bits);
    }
  }
  return b;
}

}  // namespace

const char* name(CurveBasis basis) {
  switch (basis) {
    case CurveBasis::bernstein:
      return "bernstein";
    case CurveBasis::legendre:
      return "legendre";
    case CurveBasis::chebyshev:
      return "chebyshev";
    case CurveBasis::lagrange:
      return "lagrange";
  }
  return "";
}

NullSpaceFit fit_null_space(const PlanarSpace& space, const BezierCurve& curve, CurveBasis basis,
                            Arithmetic arithmetic) {
  return in_nearest_rounding([&]() -> NullSpaceFit {
    if (!space.is_polynomial())
      throw std::invalid_argument("null space: the space must be one of polynomials");
    if (curve.dimension() != 2) throw std::invalid_argument("null space: the curve must be planar");
    if (curve.is_point()) throw std::invalid_argument("null space: all points are equal");
    const WeightedMatrix d = collocation(space, homogeneous(curve), basis);
    const std::vector<std::vector<Integer>> vanishing = null_space(d.rows);
    if (!vanishing.empty())
      return {{vanishing.front().begin(), vanishing.front().end()}, 0, vanishing.size()};
    std::vector<Rational> b = singular_vector(d);
    if (arithmetic == Arithmetic::exact) b = refined_vector(d, std::move(b));
    const double sigma = std::sqrt(to_double(Rational(squared_residual(d, b) / squared_length(b))));
    return {std::move(b), sigma, 0};
  });
}

}  // namespace exsect
