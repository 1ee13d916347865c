#include "planar_fit.h"

#include <exsect/algebra/double_matrix.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/rational_matrix.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"

namespace exsect {
namespace {

/// One equation row . c = target of weight `weight` in the sum of squares.
struct Equation {
  std::vector<Rational> row;
  Rational target;
  Rational weight;
};

std::vector<Equation> equations(const PlanarSpace& space, const std::vector<FitSample>& samples,
                                const FitWeights& weights) {
  std::vector<Equation> list;
  for (const FitSample& sample : samples) {
    PlanarSpace::Values values = space.at(sample.x, sample.y);
    list.push_back({std::move(values.value), 0, 1});
    if (sample.normal_x == 0 && sample.normal_y == 0) continue;
    list.push_back({std::move(values.dx), sample.normal_x, weights.w1});
    list.push_back({std::move(values.dy), sample.normal_y, weights.w1});
  }
  return list;
}

/// The normal equations (A' A + w1 (Ax' Ax + Ay' Ay) + w2 H) c = w1 (Ax' nx + Ay' ny) of (10.2).
struct NormalEquations {
  RationalMatrix matrix;
  std::vector<Rational> right;
};

NormalEquations normal_equations(const PlanarSpace& space, const std::vector<Equation>& list,
                                 const Rational& w2) {
  const std::size_t n = space.dimension();
  NormalEquations result{RationalMatrix(n, n), std::vector<Rational>(n, 0)};
  if (w2 != 0) {
    const RationalMatrix tension = space.tension();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) result.matrix(i, j) = w2 * tension(i, j);
  }
  for (const Equation& equation : list) {
    for (std::size_t i = 0; i < n; ++i) {
      if (equation.row[i] == 0) continue;
      const Rational weighted = equation.weight * equation.row[i];
      for (std::size_t j = 0; j < n; ++j)
        if (equation.row[j] != 0) result.matrix(i, j) += weighted * equation.row[j];
      result.right[i] += weighted * equation.target;
    }
  }
  return result;
}

/// A solution of the consistent system: an element of the null space of (matrix, -right) with last component
/// 1.
std::vector<Rational> any_solution(const NormalEquations& equations) {
  const std::size_t n = equations.right.size();
  RationalMatrix extended(n, n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) extended(i, j) = equations.matrix(i, j);
    extended(i, n) = -equations.right[i];
  }
  for (const std::vector<Integer>& vector : null_space(extended)) {
    if (vector[n] == 0) continue;
    std::vector<Rational> solution;
    for (std::size_t i = 0; i < n; ++i) solution.emplace_back(vector[i], vector[n]);
    return solution;
  }
  throw ProofFailure(whole_domain(), "least squares: normal equations without solution");
}

PlanarFit exact_fit(const PlanarSpace& space, const std::vector<Equation>& list, const Rational& w2) {
  const NormalEquations equations = normal_equations(space, list, w2);
  if (auto solution = solve(equations.matrix, equations.right)) return {std::move(*solution), true};
  return {any_solution(equations), false};
}

std::vector<Rational> to_rationals(const std::vector<double>& v) {
  std::vector<Rational> result;
  for (const double c : v) {
    if (!std::isfinite(c)) throw std::domain_error("least squares: the solution is not finite");
    result.push_back(from_double(c));
  }
  return result;
}

/// Rows of R with R' R = w2 H.
DoubleMatrix tension_rows(const PlanarSpace& space, const Rational& w2) {
  const std::size_t n = space.dimension();
  if (w2 == 0) return DoubleMatrix(0, n);
  const RationalMatrix tension = space.tension();
  DoubleMatrix h(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) h(i, j) = to_double(Rational(w2 * tension(i, j)));
  return square_root_rows(h);
}

PlanarFit dense_fit(const PlanarSpace& space, const std::vector<Equation>& list, const Rational& w2) {
  const DoubleMatrix tension = tension_rows(space, w2);
  DoubleMatrix a(list.size(), space.dimension());
  std::vector<double> b(list.size() + tension.rows(), 0.0);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double weight = std::sqrt(to_double(list[i].weight));
    for (std::size_t j = 0; j < list[i].row.size(); ++j) a(i, j) = weight * to_double(list[i].row[j]);
    b[i] = weight * to_double(list[i].target);
  }
  a.append(tension);
  const LeastSquares found = least_squares(a, b);
  return {to_rationals(found.solution), found.is_unique};
}

PlanarFit sparse_fit(const PlanarSpace& space, const std::vector<Equation>& list, const Rational& w2) {
  const NormalEquations equations = normal_equations(space, list, w2);
  const std::size_t n = space.dimension();
  std::vector<SparseEntry> entries;
  std::vector<double> right(n);
  for (std::size_t i = 0; i < n; ++i) {
    right[i] = to_double(equations.right[i]);
    for (std::size_t j = 0; j < n; ++j)
      if (equations.matrix(i, j) != 0) entries.push_back({i, j, to_double(equations.matrix(i, j))});
  }
  const std::vector<double> found = sparse_solution(entries, right);
  if (found.empty())
    throw std::domain_error("least squares: the samples do not determine the spline; more samples or w2 > 0");
  return {to_rationals(found), true};
}

/// floor(2^40 / sqrt(square)) 2^-40 for square > 0 (10.4).
Rational inverse_root(const Rational& square) {
  const Integer scaled = (denominator(square) << 80) / numerator(square);
  return Rational(sqrt(scaled)) * power_of_two(-40);
}

}  // namespace

std::vector<FitSample> fit_samples(const BezierCurve& curve, int count) {
  return in_nearest_rounding([&] {
    if (curve.dimension() != 2) throw std::invalid_argument("least squares: the curve must be planar");
    if (curve.is_point()) throw std::invalid_argument("least squares: all points are equal");
    if (count < 2) throw std::invalid_argument("least squares: at least 2 samples are needed");
    const HomogeneousCurve reduced = homogeneous(curve);
    std::vector<FitSample> samples;
    for (int k = 0; k < count; ++k) {
      const Rational t(k, count - 1);
      const Rational w = reduced.denominator(t);
      const Rational dw = reduced.denominator.derivative()(t);
      std::array<Rational, 2> point, tangent;
      for (std::size_t i = 0; i < 2; ++i) {
        point[i] = reduced.numerators[i](t) / w;
        tangent[i] = (reduced.numerators[i].derivative()(t) - point[i] * dw) / w;
      }
      const Rational square = tangent[0] * tangent[0] + tangent[1] * tangent[1];
      const Rational q = square == 0 ? Rational(0) : inverse_root(square);
      samples.push_back({point[0], point[1], -q * tangent[1], q * tangent[0]});
    }
    return samples;
  });
}

PlanarFit fit_points_and_normals(const PlanarSpace& space, const std::vector<FitSample>& samples,
                                 const FitWeights& weights, Arithmetic arithmetic) {
  return in_nearest_rounding([&]() -> PlanarFit {
    if (weights.w1 <= 0) throw std::invalid_argument("least squares: w1 must be > 0");
    if (weights.w2 < 0) throw std::invalid_argument("least squares: w2 must be >= 0");
    if (samples.empty()) throw std::invalid_argument("least squares: no samples");
    const std::vector<Equation> list = equations(space, samples, weights);
    if (arithmetic == Arithmetic::exact) return exact_fit(space, list, weights.w2);
    return space.is_polynomial() ? dense_fit(space, list, weights.w2) : sparse_fit(space, list, weights.w2);
  });
}

std::vector<Rational> rounded_coefficients(const std::vector<Rational>& coefficients, int digits) {
  const Integer scale = pow(Integer(10), static_cast<unsigned>(digits));
  std::vector<Rational> result;
  for (const Rational& c : coefficients) {
    const Rational shifted = abs(c) * scale + Rational(1, 2);
    const Integer whole = numerator(shifted) / denominator(shifted);
    result.emplace_back(c < 0 ? Integer(-whole) : whole, scale);
  }
  return result;
}

std::optional<int> rounding_digits(const PlanarSpace& space, const std::vector<FitSample>& samples,
                                   const std::vector<Rational>& coefficients) {
  Rational residual = 0, sensitivity = 0;
  for (const FitSample& sample : samples) {
    const std::vector<Rational> values = space.at(sample.x, sample.y).value;
    Rational f = 0, sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      f += coefficients[i] * values[i];
      sum += abs(values[i]);
    }
    residual = std::max<Rational>(residual, abs(f));
    sensitivity = std::max(sensitivity, sum);
  }
  if (residual == 0) return std::nullopt;
  int digits = 6;
  Rational unit = Rational(1, 1000000);
  while (digits < 60 && 32 * unit * sensitivity > residual) {
    ++digits;
    unit /= 10;
  }
  return digits;
}

}  // namespace exsect
