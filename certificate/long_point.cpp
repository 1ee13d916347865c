#include "certificate/long_point.h"

#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace exsect::cli {
namespace {

using Numbers = std::vector<Rational>;
using Rows = std::vector<std::vector<double>>;

/// What vanishes at the point: F, and with a normal n also n . F_j for the parameters j that are not known.
/// Its variables are these parameters, then the components of n but for one, which is 1.
class PointSystem {
 public:
  PointSystem(const ExactMap& equation, const Node& node) : equation_(equation) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& [lower, upper] = node.box[i];
      at_[i] = lower;
      if (lower != upper) free_.push_back(i);
    }
    for (const std::size_t i : free_) start_.push_back(from_double(node.approx[i]));
  }

  const Numbers& start() const { return start_; }
  std::size_t unknown() const { return free_.size(); }

  /// Adds a normal to the columns of the parameters that are not known.
  void add_normal() {
    const ExactMap local = equation_.at(place(start_));
    Point n = {};
    for (const std::size_t i : free_)
      for (const std::size_t j : free_)
        if (const Point c = cross(local.slope(i), local.slope(j)); dot(c, c) > dot(n, n)) n = c;
    unit_ = 0;
    for (std::size_t d = 1; d < 3; ++d)
      if (abs(n[d]) > abs(n[*unit_])) unit_ = d;
    for (std::size_t d = 0; d < 3; ++d)
      if (d != *unit_) start_.push_back(n[*unit_] == 0 ? Rational(0) : in_bits(n[d] / n[*unit_], 60));
  }

  Place place(const Numbers& z) const {
    Place w = at_;
    for (std::size_t i = 0; i < free_.size(); ++i) w[free_[i]] = z[i];
    return w;
  }

  Numbers value(const Numbers& z) const {
    if (!unit_) {
      const Point f = equation_.value(place(z));
      return {f[0], f[1], f[2]};
    }
    const ExactMap local = equation_.at(place(z));
    Point n;
    auto next = z.begin() + static_cast<std::ptrdiff_t>(free_.size());
    for (std::size_t d = 0; d < 3; ++d) n[d] = d == *unit_ ? Rational(1) : *next++;
    Numbers result = {local.value(0), local.value(1), local.value(2)};
    for (const std::size_t i : free_) result.push_back(dot(n, local.slope(i)));
    return result;
  }

 private:
  const ExactMap& equation_;
  Place at_;
  std::vector<std::size_t> free_;
  std::optional<std::size_t> unit_;
  Numbers start_;
};

/// The columns of the derivative, by differences.
Rows columns_at(const PointSystem& system, Numbers z) {
  const Rational step = power_of_two(-60);
  const Numbers here = system.value(z);
  Rows result;
  for (Rational& q : z) {
    q += step;
    const Numbers there = system.value(z);
    q -= step;
    std::vector<double>& column = result.emplace_back();
    for (std::size_t d = 0; d < here.size(); ++d) column.push_back(to_double((there[d] - here[d]) / step));
  }
  return result;
}

double scalar_product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t d = 0; d < a.size(); ++d) sum += a[d] * b[d];
  return sum;
}

/// A left inverse of the matrix with these columns, by Gram and Schmidt's method; nothing if they are nearly
/// dependent.
std::optional<Rows> left_inverse(const Rows& columns) {
  const std::size_t size = columns.size();
  Rows q = columns, r(size, std::vector<double>(size));
  for (std::size_t j = 0; j < size; ++j) {
    for (int twice = 0; twice < 2; ++twice) {
      for (std::size_t i = 0; i < j; ++i) {
        const double c = scalar_product(q[i], q[j]);
        r[i][j] += c;
        for (std::size_t d = 0; d < q[j].size(); ++d) q[j][d] -= c * q[i][d];
      }
    }
    r[j][j] = std::sqrt(scalar_product(q[j], q[j]));
    if (!(r[j][j] > 1e-5 * std::sqrt(scalar_product(columns[j], columns[j])))) return std::nullopt;
    for (double& c : q[j]) c /= r[j][j];
  }
  for (std::size_t i = size; i-- > 0;) {
    for (std::size_t j = i + 1; j < size; ++j)
      for (std::size_t d = 0; d < q[i].size(); ++d) q[i][d] -= r[i][j] * q[j][d];
    for (double& c : q[i]) c /= r[i][i];
  }
  return q;
}

std::optional<Place> found_by(const PointSystem& system, int bits) {
  Numbers z = system.start();
  if (z.size() > system.value(z).size()) return std::nullopt;
  const auto inverse = left_inverse(columns_at(system, z));
  if (!inverse) return std::nullopt;
  for (int n = 0; n < bits / 8; ++n) {
    const Numbers f = system.value(z);
    Rational most = 0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      Rational step = 0;
      for (std::size_t d = 0; d < f.size(); ++d) step += from_double((*inverse)[i][d]) * f[d];
      step = in_bits(step, bits + 32);
      most = std::max<Rational>(most, abs(step));
      z[i] -= step;
    }
    if (most > power_of_two(-8)) return std::nullopt;
    if (most < power_of_two(-bits)) return system.place(z);
  }
  return std::nullopt;
}

}  // namespace

Rational in_bits(const Rational& q, int bits) {
  const Rational scaled = q * power_of_two(bits);
  return Rational(numerator(scaled) / denominator(scaled)) * power_of_two(-bits);
}

std::optional<Place> long_point(const ExactMap& equation, const Node& node, int bits) {
  PointSystem system(equation, node);
  std::optional<Place> result = found_by(system, bits);
  if (!result) {
    system.add_normal();
    result = found_by(system, bits);
  }
  const Rational near = power_of_two(1 - bits);
  for (std::size_t i = 0; result && i < 4; ++i)
    if ((*result)[i] < node.box[i].lower - near || (*result)[i] > node.box[i].upper + near)
      return std::nullopt;
  return result;
}

}  // namespace exsect::cli
