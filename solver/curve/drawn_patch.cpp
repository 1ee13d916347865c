#include "curve/drawn_patch.h"

#include <exsect/algebra/rounding_bounds.h>
#include <exsect/algebra/tensor_bernstein.h>
#include <exsect/geometry/beyond_doubles.h>
#include <exsect/geometry/bounding_box.h>

#include <algorithm>
#include <cmath>

namespace exsect {
namespace {

using Components = std::array<BivariatePolynomial, 4>;

/// An upper bound of the length of (f_1, f_2, f_3) on the square, and of |f_4|.
struct LengthBounds {
  double vector;
  double weight;
};
LengthBounds length_bounds(const Components& f) {
  std::array<double, 4> most{};
  for (std::size_t k = 0; k < 4; ++k) {
    if (f[k].is_zero()) continue;
    const RationalInterval range = range_bound(f[k]);
    most[k] = to_double(std::max<Rational>(abs(range.lower), abs(range.upper)));
  }
  return {length_bound(most[0], most[1], most[2]), most[3] * kSlack};
}

Components derived(const Components& f, bool in_u) {
  Components result;
  for (std::size_t k = 0; k < 4; ++k) result[k] = in_u ? f[k].derivative_r() : f[k].derivative_s();
  return result;
}

/// A lower bound of f on the square; positive if f is.
double least_value(const BivariatePolynomial& f) {
  for (int depth = 0; depth <= 8; ++depth) {
    const Rational lower = range_bound(f, {}, depth).lower;
    if (lower > 0) return to_double(lower) / kSlack;
  }
  return 0;
}

/// From X = w x about the centre by Leibniz's rule: w x_u = X_u - w_u x, and so on. `bounds` of the
/// derivatives of X by numbers of times in u and v; `w`: the least weight.
template <class Bounds>
PatchRates rates_from(double w, const Bounds& bounds) {
  const LengthBounds u = bounds(1, 0), v = bounds(0, 1);
  const double size = bounds(0, 0).vector / w;
  const auto second = [&](const LengthBounds& of, double rate_a, double weight_a, double rate_b,
                          double weight_b) {
    return (of.vector + of.weight * size + rate_a * weight_b + rate_b * weight_a) / w * kSlack;
  };
  PatchRates rates{};
  rates.u = (u.vector + u.weight * size) / w * kSlack;
  rates.v = (v.vector + v.weight * size) / w * kSlack;
  rates.uu = second(bounds(2, 0), rates.u, u.weight, rates.u, u.weight);
  rates.uv = second(bounds(1, 1), rates.u, u.weight, rates.v, v.weight);
  rates.vv = second(bounds(0, 2), rates.v, v.weight, rates.v, v.weight);
  return rates;
}

PatchRates rates_of(const Components& x) {
  return rates_from(least_value(x[3]), [&](int a, int b) {
    Components f = x;
    for (int k = 0; k < a; ++k) f = derived(f, true);
    for (int k = 0; k < b; ++k) f = derived(f, false);
    return length_bounds(f);
  });
}

}  // namespace

DrawnPatch::DrawnPatch(const RationalPatch& patch) {
  const BoundingBox box = bounding_box(patch);
  extent_ = to_double(largest_extent(box));
  Point centre;
  for (std::size_t k = 0; k < 3; ++k) {
    centre_[k] = to_double((box.lower[k] + box.upper[k]) / 2);
    if (!std::isfinite(centre_[k]) || !std::isfinite(extent_))
      throw BeyondDoubles("control points must lie in the range of doubles");
    centre[k] = from_double(centre_[k]);
  }
  Components x;
  for (int k = 0; k < 4; ++k) x[static_cast<std::size_t>(k)] = patch.component(k);
  for (std::size_t k = 0; k < 3; ++k) x[k] -= x[3] * BivariatePolynomial::constant(centre[k]);
  rates_ = rates_of(x);
  cells_.resize(std::size_t{kCells} * kCells);
  m_ = patch.degree_u();
  n_ = patch.degree_v();
  for (std::size_t k = 0; k < 4; ++k)
    for (int i = 0; i <= m_; ++i)
      for (int j = 0; j <= n_; ++j) components_[k].push_back(DoubleBall::enclosing(x[k].coefficient(i, j)));
}

DrawnPoint DrawnPatch::at(const DoubleBall& u, const DoubleBall& v) const {
  std::array<DoubleBall, 4> x;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::vector<DoubleBall>& c = components_[k];
    for (std::size_t i = static_cast<std::size_t>(m_) + 1; i-- > 0;) {
      const std::size_t row = i * (static_cast<std::size_t>(n_) + 1);
      DoubleBall in_v;
      for (std::size_t j = static_cast<std::size_t>(n_) + 1; j-- > 0;) in_v = in_v * v + c[row + j];
      x[k] = x[k] * u + in_v;
    }
  }
  DrawnPoint result{};
  std::array<double, 3> off{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double quotient = x[k].approximation() / x[3].approximation();
    const double lost = (x[k] - x[3] * DoubleBall(quotient)).upper_magnitude() / x[3].lower_magnitude();
    result.point[k] = centre_[k] + quotient;
    const double rounding = std::fabs(result.point[k]) * 2 * kUnitRoundoff + kUnderflowLoss;
    off[k] = lost + rounding;
  }
  result.error = length_bound(off[0], off[1], off[2]) + kUnderflowLoss;
  return result;
}

DoubleBall DrawnPatch::derivative(std::size_t k, int a, int b, const DoubleBall& u,
                                  const DoubleBall& v) const {
  const auto factor = [](int power, int times) {
    double result = 1;
    for (int t = 0; t < times; ++t) result *= power - t;
    return DoubleBall(result);
  };
  DoubleBall result;
  for (int i = m_; i >= a; --i) {
    DoubleBall in_v;
    for (int j = n_; j >= b; --j)
      in_v = in_v * v + factor(j, b) * components_[k][static_cast<std::size_t>(i * (n_ + 1) + j)];
    result = result * u + factor(i, a) * in_v;
  }
  return result;
}

/// As rates_of(), in ball arithmetic; the rates on the square where that does not keep the weight positive.
PatchRates DrawnPatch::rates_of_cell(int i, int j) const {
  const double half = 0.5 / kCells;
  const DoubleBall u = DoubleBall((i + 0.5) / kCells).widened(half),
                   v = DoubleBall((j + 0.5) / kCells).widened(half);
  const auto bounds = [&](int a, int b) {
    std::array<double, 4> most{};
    for (std::size_t k = 0; k < 4; ++k) most[k] = derivative(k, a, b, u, v).upper_magnitude();
    return LengthBounds{length_bound(most[0], most[1], most[2]), most[3]};
  };
  const DoubleBall weight = derivative(3, 0, 0, u, v);
  if (!weight.is_positive()) return rates_;
  return rates_from(weight.lower_magnitude(), bounds);
}

PatchRates DrawnPatch::rates_in(double u0, double u1, double v0, double v1) const {
  if (!(u0 <= u1 && v0 <= v1)) return rates_;
  const auto cell = [](double t) { return static_cast<int>(std::clamp(t * kCells, 0.0, kCells - 1.0)); };
  PatchRates result{};
  for (int i = cell(u0); i <= cell(u1); ++i)
    for (int j = cell(v0); j <= cell(v1); ++j) {
      std::optional<PatchRates>& known = cells_[static_cast<std::size_t>(i * kCells + j)];
      if (!known) known = rates_of_cell(i, j);
      result.u = larger_bound(result.u, known->u);
      result.v = larger_bound(result.v, known->v);
      result.uu = larger_bound(result.uu, known->uu);
      result.uv = larger_bound(result.uv, known->uv);
      result.vv = larger_bound(result.vv, known->vv);
    }
  return result;
}

double chord_bound(const PatchRates& rates, double du, double dv) {
  du = std::fabs(du);
  dv = std::fabs(dv);
  return (rates.uu * du * du + 2 * rates.uv * du * dv + rates.vv * dv * dv) / 8 * kSlack;
}

}  // namespace exsect
