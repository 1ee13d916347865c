#include "approximate_implicit_patch.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/double_matrix.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/tensor_bernstein.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "implicit_patch.h"

namespace exsect {
namespace {

/// Short coordinates in which the control points are in [-1.1,1.1]^3 and some coordinate exceeds 1/2.
struct Frame {
  Point centre;
  Rational unit;
};

Frame frame(const BezierPatch& x) {
  Point lower = x.net()[0][0], upper = lower;
  for (const auto& row : x.net())
    for (const Point& p : row)
      for (std::size_t k = 0; k < 3; ++k) {
        lower[k] = std::min(lower[k], p[k]);
        upper[k] = std::max(upper[k], p[k]);
      }
  Rational half = 0;
  for (std::size_t k = 0; k < 3; ++k) half = std::max(half, Rational((upper[k] - lower[k]) / 2));
  if (half == 0) throw std::domain_error("approximate equation: all control points are equal");
  Frame result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational middle = (lower[k] + upper[k]) / 2;
    result.centre[k] = simplest_between(middle - half / 20, middle + half / 20);
  }
  result.unit = simplest_between(half, Rational(5, 4) * half);
  return result;
}

BezierPatch in_frame(const BezierPatch& x, const Frame& frame) {
  ControlNet net = x.net();
  for (auto& row : net)
    for (Point& p : row) p = Rational(1 / frame.unit) * (p - frame.centre);
  return BezierPatch(net);
}

/// One column for each monomial: the Bernstein coefficients of its composition with the patch.
DoubleMatrix dokken_matrix(const BezierPatch& x, const std::vector<Exponents>& exponents, int degree) {
  const std::size_t side = 2 * static_cast<std::size_t>(degree) + 1;
  DoubleMatrix matrix(side * side, exponents.size());
  for (std::size_t column = 0; column < exponents.size(); ++column) {
    const auto b =
        tensor_bernstein(compose(SpacePolynomial({{exponents[column], 1}}), x), 2 * degree, 2 * degree);
    for (std::size_t i = 0; i < side; ++i)
      for (std::size_t j = 0; j < side; ++j) matrix(i * side + j, column) = to_double(b[i][j]);
  }
  return matrix;
}

/// The parameters of the points on the six conics, common points once.
std::set<std::pair<Rational, Rational>> conic_points(int degree) {
  std::set<std::pair<Rational, Rational>> points;
  for (const Rational& fixed : {Rational(0), Rational(1, 2), Rational(1)})
    for (int i = 0; i <= 2 * degree; ++i) {
      points.insert({fixed, Rational(i, 2 * degree)});
      points.insert({Rational(i, 2 * degree), fixed});
    }
  return points;
}

/// One row for each point: the values of the monomials.
DoubleMatrix conic_matrix(const BezierPatch& x, const std::vector<Exponents>& exponents, int degree) {
  const auto points = conic_points(degree);
  DoubleMatrix matrix(points.size(), exponents.size());
  std::size_t row = 0;
  for (const auto& [u, v] : points) {
    const Point p = x(u, v);
    for (std::size_t column = 0; column < exponents.size(); ++column) {
      double value = 1;
      for (std::size_t k = 0; k < 3; ++k) value *= std::pow(to_double(p[k]), exponents[column][k]);
      matrix(row, column) = value;
    }
    ++row;
  }
  return matrix;
}

/// The coefficients rounded to multiples of a power of two that is small against the singular value, the
/// largest one positive.
SpacePolynomial rounded(const std::vector<double>& b, const std::vector<Exponents>& exponents,
                        double singular_value) {
  constexpr int most_bits = std::numeric_limits<double>::digits - 1;
  const double wanted = std::ceil(std::log2(1024.0 * static_cast<double>(exponents.size()) / singular_value));
  const int bits = wanted < most_bits ? std::max(10, static_cast<int>(wanted)) : most_bits;
  const auto smaller = [](double a, double c) { return std::fabs(a) < std::fabs(c); };
  const double sign = *std::max_element(b.begin(), b.end(), smaller) < 0 ? -1 : 1;
  SpacePolynomial::Terms terms;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    const double scaled = std::round(std::ldexp(sign * b[i], bits));
    terms[exponents[i]] = from_double(scaled) * power_of_two(-bits);
  }
  return SpacePolynomial(terms);
}

}  // namespace

const char* name(PatchFit method) { return method == PatchFit::dokken ? "dokken" : "conics"; }

ApproximateEquation approximate_equation(const BezierPatch& x, int degree, PatchFit method) {
  return in_nearest_rounding([&]() -> ApproximateEquation {
    const int most = method == PatchFit::dokken ? 7 : 5;
    if (degree < 1 || degree > most)
      throw std::invalid_argument(std::string("approximate equation, method ") + name(method) +
                                  ": the degree must be 1, ..., " + std::to_string(most));
    const Frame local = frame(x);
    const std::vector<SpacePolynomial> exact = vanishing_equations(x, degree);
    if (!exact.empty()) return {exact.front(), 0, local.centre, local.unit, 0};
    const BezierPatch normalised = in_frame(x, local);
    const std::vector<Exponents> exponents = exponents_up_to(degree);
    const DoubleMatrix matrix = method == PatchFit::dokken ? dokken_matrix(normalised, exponents, degree)
                                                           : conic_matrix(normalised, exponents, degree);
    const auto [singular_value, b] = least_singular(matrix);
    if (!std::all_of(b.begin(), b.end(), [](double c) { return std::isfinite(c); }))
      throw std::domain_error("approximate equation: the net exceeds the range of doubles");
    const SpacePolynomial fitted = rounded(b, exponents, singular_value);
    const RationalInterval range = range_bound(compose(fitted, normalised), {}, 2);
    const Rational scale = 1 / local.unit;
    return {affinely_substituted(fitted, local.centre, {scale, scale, scale}),
            std::max(Rational(-range.lower), range.upper), local.centre, local.unit, singular_value};
  });
}

}  // namespace exsect
