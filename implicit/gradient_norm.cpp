#include "gradient_norm.h"

#include <exsect/algebra/double_matrix.h>
#include <exsect/algebra/nearest_rounding.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "planar_fit.h"

namespace exsect {
namespace {

/// Nodes and weights of Gauss' rule with five points on [-1,1].
constexpr std::array<double, 5> nodes = {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
                                         0.9061798459386640};
constexpr std::array<double, 5> node_weights = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                                0.4786286704993665, 0.2369268850561891};
constexpr int panels = 64;

using Table = std::vector<std::vector<double>>;

Table in_doubles(const BivariatePolynomial& f) {
  Table table;
  for (int i = 0; i <= f.degree_r(); ++i) {
    table.emplace_back();
    for (const Rational& c : f.coefficient(i).coefficients()) table.back().push_back(to_double(c));
  }
  return table;
}

double value(const Table& f, double x, double y) {
  double sum = 0;
  for (auto row = f.rbegin(); row != f.rend(); ++row) {
    double inner = 0;
    for (auto c = row->rbegin(); c != row->rend(); ++c) inner = inner * y + *c;
    sum = sum * x + inner;
  }
  return sum;
}

/// The quadrature points of one side.
struct Rule {
  std::vector<double> at;
  std::vector<double> weight;
};

Rule rule(const RationalInterval& side) {
  const double from = to_double(side.lower), step = to_double(side.width()) / panels;
  Rule result;
  for (int k = 0; k < panels; ++k) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      result.at.push_back(from + step * (k + 0.5 * (1 + nodes[i])));
      result.weight.push_back(0.5 * step * node_weights[i]);
    }
  }
  return result;
}

/// x^i y^j, i + j <= degree, ordered by i + j, then by j.
void set_monomials(std::vector<double>& values, int degree, double x, double y) {
  std::size_t k = 0;
  for (int total = 0; total <= degree; ++total)
    for (int j = 0; j <= total; ++j) values[k++] = std::pow(x, total - j) * std::pow(y, j);
}

double largest_magnitude(const std::vector<double>& c) {
  double largest = 0;
  for (const double e : c) largest = std::max(largest, std::fabs(e));
  return largest;
}

BivariatePolynomial from_monomials(const std::vector<double>& c, int degree) {
  const double largest = largest_magnitude(c);
  const int digits = 9 - static_cast<int>(std::ceil(std::log10(largest)));
  const Rational scale = digits >= 0 ? Rational(pow(Integer(10), static_cast<unsigned>(digits)))
                                     : Rational(1, pow(Integer(10), static_cast<unsigned>(-digits)));
  std::vector<Rational> scaled;
  for (const double e : c) scaled.push_back(from_double(e) * scale);
  scaled = rounded_coefficients(scaled, 0);
  BivariatePolynomial f;
  std::size_t k = 0;
  for (int total = 0; total <= degree; ++total) {
    for (int j = 0; j <= total; ++j) {
      std::vector<Polynomial> rows(static_cast<std::size_t>(total - j) + 1);
      std::vector<Rational> row(static_cast<std::size_t>(j) + 1, 0);
      row.back() = scaled[k++] / scale;
      rows.back() = Polynomial(row);
      f += BivariatePolynomial(rows);
    }
  }
  return f;
}

}  // namespace

BivariatePolynomial fitted_gradient_norm(const BivariatePolynomial& f, const PlanarBox& box, int degree,
                                         const Rational& epsilon) {
  return in_nearest_rounding([&]() -> BivariatePolynomial {
    if (degree < 0 || degree > 8)
      throw std::invalid_argument("gradient norm: the degree must be from 0 to 8");
    if (epsilon <= 0) throw std::invalid_argument("gradient norm: epsilon must be > 0");
    if (f.total_degree() < 1) throw std::invalid_argument("gradient norm: f is constant");
    if (box.x.lower >= box.x.upper || box.y.lower >= box.y.upper)
      throw std::invalid_argument("gradient norm: the box must have positive sides");
    const Table values = in_doubles(f), dx = in_doubles(f.derivative_r()), dy = in_doubles(f.derivative_s());
    const Rule in_x = rule(box.x), in_y = rule(box.y);
    const double e = to_double(epsilon);
    const std::size_t n = static_cast<std::size_t>((degree + 1) * (degree + 2) / 2);
    DoubleMatrix gram(n, n);
    std::vector<double> right(n, 0.0), basis(n);
    for (std::size_t i = 0; i < in_x.at.size(); ++i) {
      for (std::size_t j = 0; j < in_y.at.size(); ++j) {
        const double x = in_x.at[i], y = in_y.at[j];
        const double at = value(values, x, y);
        const double weight = in_x.weight[i] * in_y.weight[j] / (at * at + e);
        set_monomials(basis, degree, x, y);
        const double target = weight * std::hypot(value(dx, x, y), value(dy, x, y));
        for (std::size_t k = 0; k < n; ++k) {
          for (std::size_t l = 0; l <= k; ++l) gram(k, l) += weight * basis[k] * basis[l];
          right[k] += target * basis[k];
        }
      }
    }
    const std::vector<double> c = symmetric_solution(gram, right);
    const bool is_finite = std::all_of(c.begin(), c.end(), [](double k) { return std::isfinite(k); });
    if (!is_finite || largest_magnitude(c) == 0)
      throw std::invalid_argument("gradient norm: f is beyond the range of doubles");
    return from_monomials(c, degree);
  });
}

}  // namespace exsect
