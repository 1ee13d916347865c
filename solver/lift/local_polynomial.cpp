#include "lift/local_polynomial.h"

#include <exsect/algebra/binary_order.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>

namespace exsect {
namespace {

/// The powers 0 to count - 1.
std::vector<DoubleBall> powers_of(const DoubleBall& w, std::size_t count) {
  std::vector<DoubleBall> powers = {DoubleBall(1)};
  while (powers.size() < count) powers.push_back(powers.back() * w);
  return powers;
}

}  // namespace

LocalPolynomial::LocalPolynomial(const SpacePolynomial& f, const Point& centre)
    : count_(static_cast<std::size_t>(f.degree()) + 1) {
  const std::size_t n = count_;
  std::vector<Rational> exact(n * n * n);
  for (const auto& [e, c] : f.terms())
    exact[(static_cast<std::size_t>(e[0]) * n + static_cast<std::size_t>(e[1])) * n +
          static_cast<std::size_t>(e[2])] = c;
  const std::array<std::size_t, 3> strides = {n * n, n, 1};
  for (std::size_t axis = 0; axis < 3; ++axis) {  // Taylor's shift by Horner's scheme, one axis at a time
    if (centre[axis] == 0) continue;
    const std::size_t step = strides[axis], next = strides[(axis + 1) % 3], last = strides[(axis + 2) % 3];
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = 0; p + q < n; ++q) {
        Rational* line = exact.data() + p * next + q * last;
        const std::size_t degree = n - 1 - p - q;
        for (std::size_t from = 0; from < degree; ++from)
          for (std::size_t k = degree; k-- > from;) line[k * step] += centre[axis] * line[(k + 1) * step];
      }
  }
  Rational greatest = 0;
  for (std::size_t axis = 0; axis < 3 && n > 1; ++axis)
    greatest = std::max<Rational>(greatest, abs(exact[strides[axis]]));
  for (std::size_t i = 0; greatest == 0 && i < exact.size(); ++i) greatest = abs(exact[i]);
  const Rational scale = greatest == 0 ? Rational(1) : power_of_two(-binary_order(greatest));
  for (const Rational& c : exact) coefficients_.push_back(DoubleBall::enclosing(Rational(scale * c)));
}

SpaceBalls LocalPolynomial::gradient() const {
  if (count_ < 2) return {};
  return {at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)};
}

DoubleBall LocalPolynomial::value_on(const SpaceBalls& w) const {
  const std::vector<DoubleBall> x = powers_of(w[0], count_), y = powers_of(w[1], count_),
                                z = powers_of(w[2], count_);
  DoubleBall sum;
  for (std::size_t i = 0; i < count_; ++i)
    for (std::size_t j = 0; i + j < count_; ++j) {
      DoubleBall row;
      for (std::size_t k = 0; i + j + k < count_; ++k) row += at(i, j, k) * z[k];
      sum += row * x[i] * y[j];
    }
  return sum;
}

SpaceBalls LocalPolynomial::gradient_on(const SpaceBalls& w) const {
  const std::vector<DoubleBall> x = powers_of(w[0], count_), y = powers_of(w[1], count_),
                                z = powers_of(w[2], count_);
  const auto number = [](std::size_t i) { return DoubleBall(static_cast<double>(i)); };
  SpaceBalls sum;
  for (std::size_t i = 0; i < count_; ++i)
    for (std::size_t j = 0; i + j < count_; ++j) {
      DoubleBall row, slope;
      for (std::size_t k = 0; i + j + k < count_; ++k) {
        row += at(i, j, k) * z[k];
        if (k > 0) slope += number(k) * at(i, j, k) * z[k - 1];
      }
      if (i > 0) sum[0] += row * number(i) * x[i - 1] * y[j];
      if (j > 0) sum[1] += row * number(j) * x[i] * y[j - 1];
      sum[2] += slope * x[i] * y[j];
    }
  return sum;
}

// (17.60)
SpaceBalls LocalPolynomial::gradient_beside(const std::array<double, 3>& m, double reach,
                                            const SpaceBalls& d) const {
  std::array<std::vector<DoubleBall>, 3> chord, box;
  for (std::size_t k = 0; k < 3; ++k) {
    chord[k] = powers_of(m[k], count_);
    box[k] = powers_of(DoubleBall(m[k]) * DoubleBall(0, reach) + d[k], count_);
  }
  std::array<std::vector<DoubleBall>, 3> along;
  for (std::vector<DoubleBall>& coefficients : along)
    coefficients.resize(std::max<std::size_t>(count_, 2) - 1);
  std::array<SpaceBalls, 3> second{};
  for (std::size_t i = 0; i < count_; ++i)
    for (std::size_t j = 0; i + j < count_; ++j)
      for (std::size_t k = 0; i + j + k < count_; ++k) {
        const std::array<std::size_t, 3> e = {i, j, k};
        for (std::size_t p = 0; p < 3; ++p) {
          if (e[p] == 0) continue;
          std::array<std::size_t, 3> less = e;
          --less[p];
          const DoubleBall c = at(i, j, k) * DoubleBall(static_cast<double>(e[p]));
          along[p][i + j + k - 1] += c * chord[0][less[0]] * chord[1][less[1]] * chord[2][less[2]];
          for (std::size_t q = p; q < 3; ++q) {
            if (less[q] == 0) continue;
            std::array<std::size_t, 3> least = less;
            --least[q];
            second[p][q] += c * DoubleBall(static_cast<double>(less[q])) * box[0][least[0]] *
                            box[1][least[1]] * box[2][least[2]];
          }
        }
      }
  SpaceBalls sum;
  for (std::size_t p = 0; p < 3; ++p) {
    sum[p] = values_along(along[p], reach);
    for (std::size_t q = 0; q < 3; ++q) sum[p] += second[std::min(p, q)][std::max(p, q)] * d[q];
  }
  return sum;
}

DoubleBall values_along(const std::vector<DoubleBall>& f, double reach) {
  DoubleBall sum = f[0], power = DoubleBall(0, reach);
  const DoubleBall square(reach * reach / 2, reach * reach / 2 * kSlack + kUnderflowLoss);
  for (std::size_t i = 1; i < f.size(); ++i, power *= DoubleBall(0, reach))
    sum += f[i] * (i == 2 ? square : power);
  return sum;
}

std::vector<DoubleBall> LocalPolynomial::along(const std::array<double, 3>& m) const {
  const std::vector<DoubleBall> x = powers_of(m[0], count_), y = powers_of(m[1], count_),
                                z = powers_of(m[2], count_);
  std::vector<DoubleBall> result(count_);
  for (std::size_t i = 0; i < count_; ++i)
    for (std::size_t j = 0; i + j < count_; ++j)
      for (std::size_t k = 0; i + j + k < count_; ++k) result[i + j + k] += at(i, j, k) * x[i] * y[j] * z[k];
  return result;
}

}  // namespace exsect
