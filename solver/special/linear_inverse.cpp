#include "special/linear_inverse.h"

#include <exsect/algebra/rational_matrix.h>

#include <algorithm>
#include <utility>

#include "curve/half_space.h"

namespace exsect {
namespace {

using Relation = std::vector<Integer>;
using Functions = std::vector<BivariatePolynomial>;

Functions coordinates(const RationalPatch& x) {
  return {x.component(0), x.component(1), x.component(2), x.component(3)};
}

/// X_i X_j, i <= j.
Functions products(const Functions& x) {
  Functions result;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i; j < x.size(); ++j) result.push_back(x[i] * x[j]);
  return result;
}

BivariatePolynomial combination(const Relation& coefficients, const Functions& functions) {
  BivariatePolynomial sum;
  for (std::size_t i = 0; i < functions.size(); ++i)
    sum += BivariatePolynomial::constant(coefficients[i]) * functions[i];
  return sum;
}

/// A basis of the coefficients with which the sum of the functions is 0.
std::vector<Relation> relations(const Functions& functions) {
  int m = 0, n = 0;
  for (const BivariatePolynomial& f : functions) {
    m = std::max(m, f.degree_r() + 1);
    n = std::max(n, f.degree_s() + 1);
  }
  RationalMatrix matrix(static_cast<std::size_t>(m * n), functions.size());
  for (std::size_t k = 0; k < functions.size(); ++k)
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j)
        matrix(static_cast<std::size_t>(i * n + j), k) = functions[k].coefficient(i, j);
  return null_space(matrix);
}

Rational product(const LinearForm& form, const HomogeneousPoint& x) {
  return form[0] * x[0] + form[1] * x[1] + form[2] * x[2] + form[3] * x[3];
}

std::vector<HomogeneousPoint> control_vectors(const RationalPatch& y) {
  std::vector<HomogeneousPoint> result;
  for (int i = 0; i <= y.degree_u(); ++i)
    for (int j = 0; j <= y.degree_v(); ++j) result.push_back(y.homogeneous(i, j));
  return result;
}

/// The greatest b with form >= b w in the control vectors of positive weight, if the form is positive in all.
std::optional<Rational> least_quotient(const LinearForm& form, const std::vector<HomogeneousPoint>& vectors) {
  std::optional<Rational> least;
  for (const HomogeneousPoint& x : vectors) {
    const Rational value = product(form, x);
    if (!(value > 0)) return std::nullopt;
    if (x[3] > 0 && (!least || value < *least * x[3])) least = value / x[3];
  }
  return least;
}

/// Combinations of three relations at most to be tried: each alone, with both signs, and all together so that
/// the denominators, divided by their greatest values, are positive in the control vectors.
std::vector<Point> combinations(const std::vector<std::vector<Rational>>& denominators) {
  const std::size_t count = denominators.front().size();
  std::vector<Point> result;
  std::vector<std::array<double, 3>> vectors(count);
  Point scale = {1, 1, 1};
  for (std::size_t k = 0; k < denominators.size(); ++k) {
    Rational greatest = 0;
    for (const Rational& d : denominators[k]) greatest = std::max<Rational>(greatest, abs(d));
    if (greatest == 0) continue;
    scale[k] = 1 / greatest;
    for (std::size_t i = 0; i < count; ++i) vectors[i][k] = to_double(denominators[k][i] * scale[k]);
    for (const int sign : {1, -1}) {
      Point alone = {0, 0, 0};
      alone[k] = sign;
      result.push_back(alone);
    }
  }
  if (const auto n = positive_direction(vectors))
    result.push_back({(*n)[0] * scale[0], (*n)[1] * scale[1], (*n)[2] * scale[2]});
  return result;
}

/// (17.23), with `parameter` as a polynomial.
std::optional<ParameterQuotient> quotient(const RationalPatch& y, const BivariatePolynomial& parameter) {
  Functions functions = coordinates(y);
  for (std::size_t k = 0; k < 4; ++k)
    functions.push_back(BivariatePolynomial::constant(-1) * parameter * functions[k]);
  const std::vector<Relation> known = relations(functions);
  if (known.empty() || known.size() > 3) return std::nullopt;
  const std::vector<HomogeneousPoint> vectors = control_vectors(y);
  const auto part = [](const Relation& relation, std::size_t first) {
    return LinearForm{relation[first], relation[first + 1], relation[first + 2], relation[first + 3]};
  };
  std::vector<std::vector<Rational>> denominators;
  for (const Relation& relation : known) {
    denominators.emplace_back();
    for (const HomogeneousPoint& x : vectors) denominators.back().push_back(product(part(relation, 4), x));
  }
  for (const Point& combined : combinations(denominators)) {
    ParameterQuotient result = {};
    for (std::size_t k = 0; k < known.size(); ++k)
      for (std::size_t c = 0; c < 4; ++c) {
        result.numerator[c] += combined[k] * known[k][c];
        result.denominator[c] += combined[k] * known[k][4 + c];
      }
    if (const auto least = least_quotient(result.denominator, vectors)) {
      result.bound = *least / 2;
      return result;
    }
  }
  return std::nullopt;
}

/// The line on which both forms are 0 is on the quadric.
bool contains_axis(const Relation& quadric, const ParameterQuotient& of) {
  RationalMatrix matrix(2, 4);
  for (std::size_t c = 0; c < 4; ++c) {
    matrix(0, c) = of.numerator[c];
    matrix(1, c) = of.denominator[c];
  }
  const std::vector<Relation> axis = null_space(matrix);
  if (axis.size() != 2) return false;
  const auto vanishes_at = [&](const Relation& a, const Relation& b) {
    Functions at;
    for (std::size_t c = 0; c < 4; ++c) at.push_back(BivariatePolynomial::constant(a[c] + b[c]));
    return combination(quadric, products(at)).is_zero();
  };
  return vanishes_at(axis[0], axis[0]) && vanishes_at(axis[1], axis[1]) && vanishes_at(axis[0], axis[1]);
}

}  // namespace

BivariatePolynomial on_patch(const LinearForm& form, const RationalPatch& x) {
  BivariatePolynomial sum;
  for (std::size_t k = 0; k < 4; ++k)
    sum += BivariatePolynomial::constant(form[k]) * x.component(static_cast<int>(k));
  return sum;
}

std::optional<LinearInverse> linear_inverse(const RationalPatch& patch) {
  const RationalPatch& y = patch.reduced();
  const auto of_r = quotient(y, BivariatePolynomial::r());
  const auto of_s = of_r ? quotient(y, BivariatePolynomial::s()) : std::nullopt;
  if (!of_s) return std::nullopt;
  const Functions x = coordinates(y);
  const std::vector<Relation> planes = relations(x);
  if (planes.size() == 1) return LinearInverse{planes.front(), {*of_r, *of_s}};
  const std::vector<Relation> quadrics = relations(products(x));
  if (!planes.empty() || quadrics.size() != 1) return std::nullopt;
  const Relation& quadric = quadrics.front();
  if (!contains_axis(quadric, *of_r) && !contains_axis(quadric, *of_s)) return std::nullopt;
  return LinearInverse{quadric, {*of_r, *of_s}};
}

BivariatePolynomial section_of(const LinearInverse& inverse, const RationalPatch& x) {
  const Functions linear = coordinates(x);
  return combination(inverse.equation, inverse.equation.size() == 4 ? linear : products(linear));
}

}  // namespace exsect
