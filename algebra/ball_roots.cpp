#include "ball_roots.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace exsect {

namespace {

using Ball = DoubleDoubleBall;

constexpr std::size_t kDegree = 16;
constexpr int kDeepestPiece = 40;

/// lcm_i binom(16,i) / binom(16,j).
constexpr std::array<double, kDegree + 1> kMultipliers = {
    720720, 45045, 6006, 1287, 396, 165, 90, 63, 56, 63, 90, 165, 396, 1287, 6006, 45045, 720720};

using BallCoefficients = std::array<Ball, kDegree + 1>;

/// The polynomial over (lower, lower + width), in the Bernstein basis up to a positive factor.
struct BallPiece {
  double lower;  // as width, a dyadic number of at most 40 bits
  double width;
  BallCoefficients b;
};

BallCoefficients bernstein_basis(std::span<const Ball> f) {
  BallCoefficients b;
  for (std::size_t j = 0; j < f.size(); ++j) b[j] = f[j] * Ball(kMultipliers[j]);
  // lasti = sum_j binom(i,j) a_j / binom(16,j)
  for (std::size_t k = 1; k <= kDegree; ++k)
    for (std::size_t i = kDegree; i >= k; --i) b[i] += b[i - 1];
  return b;
}

/// Sign changes of the coefficients, whatever the signs that are not certain: 0, 1, or nothing if there may
/// be more. A coefficient between two of opposite signs may have any sign.
std::optional<int> sign_changes(const BallCoefficients& b) {
  int last = b[0].certain_sign();
  if (last == 0) return std::nullopt;
  int changes = 0;
  std::size_t unknown = 0;
  for (std::size_t i = 1; i <= kDegree; ++i) {
    const int sign = b[i].certain_sign();
    if (sign == 0) {
      ++unknown;
      continue;
    }
    if (unknown > (sign == last ? 0U : 1U)) return std::nullopt;
    if (sign != last && ++changes > 1) return std::nullopt;
    last = sign;
    unknown = 0;
  }
  if (unknown > 0) return std::nullopt;
  return changes;
}

/// De Casteljau's algorithm at the middle: `right` becomes the right half.
BallCoefficients split(BallCoefficients& right) {
  BallCoefficients left;
  left[0] = right[0];
  for (std::size_t k = 1; k <= kDegree; ++k) {
    for (std::size_t i = 0; i + k <= kDegree; ++i) right[i] += right[i + 1];
    left[k] = right[0];
  }
  for (std::size_t k = 1; k <= kDegree; ++k) {
    const Ball scale(std::ldexp(1, -static_cast<int>(k)));  // of the sums in place of means
    left[k] *= scale;
    right[kDegree - k] *= scale;
  }
  return left;
}

/// Approximately, in (0,1): a root of the polynomial in the Bernstein basis, of opposite signs at 0 and 1.
double approximate_root(const BallCoefficients& b) {
  const auto value = [&](double t) {
    std::array<double, kDegree + 1> c;
    for (std::size_t i = 0; i <= kDegree; ++i) c[i] = b[i].approximation();
    for (std::size_t k = 1; k <= kDegree; ++k)
      for (std::size_t i = 0; i + k <= kDegree; ++i) c[i] += t * (c[i + 1] - c[i]);
    return c[0];
  };
  double first = 0;
  double last = 1;
  double at_first = b[0].approximation();
  double at_last = b[kDegree].approximation();
  for (int step = 0; step < 60; ++step) {  // the Illinois method
    const double c = last - at_last * (last - first) / (at_last - at_first);
    const bool close = !(std::fabs(c - last) > 0x1p-50);
    if (close) return c;
    const double at_c = value(c);
    if ((at_c < 0) == (at_last < 0)) {
      at_first /= 2;
    } else {
      first = last;
      at_first = at_last;
    }
    last = c;
    at_last = at_c;
  }
  return last;
}

class BallIsolator {
 public:
  explicit BallIsolator(std::span<const Ball> f) : f_(f) {}

  std::optional<std::vector<Ball>> run() {
    open_.push_back({0, 1, bernstein_basis(f_)});
    while (!open_.empty()) {
      BallPiece piece = open_.back();
      open_.pop_back();
      const std::optional<int> changes = sign_changes(piece.b);
      if (!changes) {
        if (!halve(piece)) return std::nullopt;
      } else if (*changes == 1) {
        const std::optional<Ball> root = refined(piece);
        if (!root) return std::nullopt;
        roots_.push_back(*root);
      }
    }
    return std::move(roots_);
  }

 private:
  /// False if the sign at an end is not certain or the piece is too short.
  bool halve(BallPiece& piece) {
    const bool ends = piece.b.front().certain_sign() != 0 && piece.b.back().certain_sign() != 0;
    if (!ends || piece.width < std::ldexp(1, 1 - kDeepestPiece)) return false;
    const double half = piece.width / 2;
    const BallCoefficients left = split(piece.b);
    open_.push_back({piece.lower + half, half, piece.b});
    open_.push_back({piece.lower, half, left});
    return true;
  }

  /// A small ball around the only root of the piece.
  std::optional<Ball> refined(const BallPiece& piece) const {
    Ball s = piece.lower + piece.width * approximate_root(piece.b);
    double slope = 0;
    for (int step = 0; step < 3; ++step) {
      slope = approximate_slope(s.approximation());
      s = (s - Ball(evaluate(f_, s).approximation() / slope)).midpoint();
    }
    double distance = 4 * evaluate(f_, s).upper_magnitude() / std::fabs(slope) + 0x1p-100;
    for (int attempt = 0; attempt < 3; ++attempt, distance *= 64) {
      const Ball below = (s - Ball(distance)).midpoint();
      const Ball above = (s + Ball(distance)).midpoint();
      if (changes_sign(piece, below, above))
        return s.widened(std::max((s - below).upper_magnitude(), (above - s).upper_magnitude()));
    }
    return std::nullopt;
  }

  double approximate_slope(double t) const {
    double slope = 0;
    for (std::size_t i = f_.size(); i-- > 1;)
      slope = slope * t + static_cast<double>(i) * f_[i].approximation();
    return slope;
  }

  /// True if the polynomial certainly has the signs of the piece's ends at two points inside the piece.
  bool changes_sign(const BallPiece& piece, const Ball& below, const Ball& above) const {
    return (below - Ball(piece.lower)).is_positive() &&
           (Ball(piece.lower + piece.width) - above).is_positive() &&
           evaluate(f_, below).certain_sign() == piece.b.front().certain_sign() &&
           evaluate(f_, above).certain_sign() == piece.b.back().certain_sign();
  }

  std::span<const Ball> f_;
  std::vector<BallPiece> open_;  // the rightmost first
  std::vector<Ball> roots_;
};

}  // namespace

DoubleDoubleBall evaluate(std::span<const DoubleDoubleBall> f, const DoubleDoubleBall& t) {
  return in_nearest_rounding([&] {
    Ball value;
    for (std::size_t i = f.size(); i-- > 0;) value = value * t + f[i];
    return value;
  });
}

std::optional<std::vector<DoubleDoubleBall>> isolate_ball_roots(std::span<const DoubleDoubleBall> f) {
  return in_nearest_rounding([&] {
    if (f.size() > kDegree + 1) throw std::invalid_argument("isolate_ball_roots: the degree exceeds 16");
    return BallIsolator(f).run();
  });
}

}  // namespace exsect
