#include "curve/drawn_patch.h"

#include <exsect/algebra/rounding_bounds.h>
#include <exsect/algebra/tensor_bernstein.h>
#include <exsect/geometry/beyond_doubles.h>
#include <exsect/geometry/bounding_box.h>

#include <algorithm>
#include <cmath>

#include "curve/taylor_shift.h"

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

/// Of a polynomial about the middle of a square of this half width, by its coefficients there. Refers to
/// them.
class TaylorBounds {
 public:
  TaylorBounds(const std::vector<DoubleBall>& c, std::size_t row, double half)
      : c_(c), row_(row), half_(half) {}

  /// An upper bound of the absolute value of the polynomial differentiated a times by u and b times by v.
  double most(int a, int b) const { return sum(a, b) * kSlack + kUnderflowLoss; }
  /// A lower bound of a polynomial that is positive in the middle; not positive or NaN where none is known.
  double least() const {
    if (!c_[0].is_positive()) return 0;
    const double middle = c_[0].lower_magnitude();
    return middle - (sum(0, 0) - c_[0].upper_magnitude() + sum(0, 0) * 0x1p-40 + kUnderflowLoss) * kSlack;
  }

 private:
  /// i (i-1) ... (i - times + 1)
  static double falling(int i, int times) {
    double result = 1;
    for (int t = 0; t < times; ++t) result *= i - t;
    return result;
  }
  double sum(int a, int b) const {
    const int n = static_cast<int>(row_) - 1, m = static_cast<int>(c_.size() / row_) - 1;
    double result = 0;
    for (int i = m; i >= a; --i) {
      double in_v = 0;
      for (int j = n; j >= b; --j)
        in_v = in_v * half_ +
               falling(j, b) *
                   c_[static_cast<std::size_t>(i) * row_ + static_cast<std::size_t>(j)].upper_magnitude();
      result = result * half_ + falling(i, a) * in_v;
    }
    return result;
  }

  const std::vector<DoubleBall>& c_;
  std::size_t row_;
  double half_;
};

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

/// As rates_of(), from Taylor's expansions about the middle of the cell and a point of space next to its
/// image, so that x is small there (17.3b); the rates on the square where that does not keep the weight
/// positive.
PatchRates DrawnPatch::rates_of_cell(int i, int j) const {
  const std::size_t row = static_cast<std::size_t>(n_) + 1;
  std::array<std::vector<DoubleBall>, 4> x = components_;
  for (std::vector<DoubleBall>& f : x)
    shift_to(f, row, DoubleBall((i + 0.5) / kCells), DoubleBall((j + 0.5) / kCells));
  const TaylorBounds weight(x[3], row, 0.5 / kCells);
  const double least = weight.least();
  if (!(least > 0)) return rates_;
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleBall middle(x[k][0].approximation() / x[3][0].approximation());
    for (std::size_t at = 0; at < x[k].size(); ++at) x[k][at] -= middle * x[3][at];
  }
  return rates_from(least, [&](int a, int b) {
    std::array<double, 3> most{};
    for (std::size_t k = 0; k < 3; ++k) most[k] = TaylorBounds(x[k], row, 0.5 / kCells).most(a, b);
    return LengthBounds{length_bound(most[0], most[1], most[2]), weight.most(a, b)};
  });
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
