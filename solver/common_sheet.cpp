#include "common_sheet.h"

#include <algorithm>
#include <cmath>

// Notation: (u,v) = c + a in A, |a_i| <= reach_i; (r,s) = w0 + b, |b_k| <= width_k. C is any 2 x 3 matrix
// near the left inverse of (y_r, y_s)(w0). For fixed a the map b -> b + C(x(c + a) - y(w0 + b)) has the
// derivative -E, E = C y' - 1, and moves b = 0 by C(x(c + a) - y(w0)).

namespace exsect {

namespace {

using Net = TaylorNet<DoubleBall>;
using Matrix = std::array<std::array<double, 3>, 2>;
using Pair = std::array<double, 2>;

constexpr double kSlack = 1 + 0x1p-40;  // covers the rounding of sums of fewer than 100 nonnegative terms
constexpr double kSameSheet = 1e-6;     // filters only: what is worth a proof
constexpr double kFarthest = 0.5;

double upper(const DoubleBall& b) { return b.upper_magnitude(); }

BallVector<double> approximations(const BallVector<DoubleBall>& v) {
  return {v[0].approximation(), v[1].approximation(), v[2].approximation()};
}

/// The rows that take y_r, y_s to the unit vectors and the normal to zero; empty if they are dependent.
std::optional<Matrix> left_inverse(const Net& y) {
  const auto a = approximations(y[3]);
  const auto b = approximations(y[1]);
  const BallVector<double> n = cross(a, b);
  const double length2 = dot(n, n);
  if (!(length2 > 1e-40)) return std::nullopt;
  const BallVector<double> first = cross(b, n);
  const BallVector<double> second = cross(n, a);
  Matrix c{};
  for (std::size_t k = 0; k < 3; ++k) {
    c[0][k] = first[k] / length2;
    c[1][k] = second[k] / length2;
  }
  return c;
}

DoubleBall row(const Matrix& c, std::size_t k, const BallVector<DoubleBall>& v) {
  return DoubleBall(c[k][0]) * v[0] + DoubleBall(c[k][1]) * v[1] + DoubleBall(c[k][2]) * v[2];
}

/// |coefficients| of row k of C times the net.
std::array<double, 9> magnitudes(const Matrix& c, std::size_t k, const Net& net) {
  std::array<double, 9> m{};
  for (std::size_t i = 0; i < 9; ++i) m[i] = upper(row(c, k, net[i]));
  return m;
}

/// Bound of the deviation of the two first derivatives from their values at the centre over |a_i| <= h_i.
Pair variation(const std::array<double, 9>& m, const Pair& h) {
  return {kSlack * (2 * m[6] * h[0] + m[4] * h[1] + 2 * m[7] * h[0] * h[1] + m[5] * h[1] * h[1] +
                    2 * m[8] * h[0] * h[1] * h[1]),
          kSlack * (2 * m[2] * h[1] + m[4] * h[0] + 2 * m[5] * h[0] * h[1] + m[7] * h[0] * h[0] +
                    2 * m[8] * h[0] * h[0] * h[1])};
}

/// Bound of the deviation of the value.
double deviation(const std::array<double, 9>& m, const Pair& h) {
  double sum = 0;
  double power0 = 1;
  for (std::size_t i = 0; i < 3; ++i, power0 *= h[0]) {
    double power = power0;
    for (std::size_t j = 0; j < 3; ++j, power *= h[1])
      if (i + j > 0) sum += m[3 * i + j] * power;
  }
  return kSlack * sum;
}

double on_grid(double value, double grid) { return grid * std::round(value / grid); }

/// One region: centre c and half widths of A, centre of the region in (r,s).
struct Attempt {
  Pair c;
  Pair reach;
  Pair middle;
  Pair half;
  Net x{};
  Net y{};
  Matrix inverse{};
  Pair w0{};
  Pair width{};
  Pair image{};             // bounds of |w(a) - w0|
  std::array<Pair, 2> e{};  // bounds of |E|

  explicit Attempt(const SearchRegion& region) {
    for (std::size_t k = 0; k < 2; ++k) {
      c[k] = 0.5 * (region.lower[k] + region.upper[k]);
      reach[k] = kSlack * 0.5 * (region.upper[k] - region.lower[k]);
      middle[k] = 0.5 * (region.lower[k + 2] + region.upper[k + 2]);
      half[k] = kSlack * 0.5 * (region.upper[k + 2] - region.lower[k + 2]);
    }
  }

  BallPoint<DoubleBall> centre() const { return {c[0], c[1], w0[0], w0[1]}; }

  /// Approximate Newton steps from the middle of the region towards x(c) = y(w0) in y's tangent plane.
  bool find_centre(const PairSystem<DoubleBall>& system) {
    w0 = middle;
    x = system.taylor_x(centre());
    for (int i = 0; i < 4; ++i) {
      y = system.taylor_y(centre());
      const auto inv = left_inverse(y);
      if (!inv) return false;
      const BallVector<DoubleBall> d = {x[0][0] - y[0][0], x[0][1] - y[0][1], x[0][2] - y[0][2]};
      for (std::size_t k = 0; k < 2; ++k) {
        w0[k] += row(*inv, k, d).approximation();
        if (!(std::fabs(w0[k] - middle[k]) <= kFarthest)) return false;
      }
    }
    y = system.taylor_y(centre());
    const auto inv = left_inverse(y);
    if (!inv) return false;
    inverse = *inv;
    return true;
  }

  bool is_near() const {
    const BallVector<DoubleBall> d = {x[0][0] - y[0][0], x[0][1] - y[0][1], x[0][2] - y[0][2]};
    return std::max({upper(d[0]), upper(d[1]), upper(d[2])}) < kSameSheet;
  }

  /// The map of the box |b_k| <= width_k goes into its interior and is a contraction.
  bool contracts() {
    Pair residual{};
    for (std::size_t k = 0; k < 2; ++k) {
      residual[k] = kSlack * (upper(row(inverse, k, x[0]) - row(inverse, k, y[0])) +
                              deviation(magnitudes(inverse, k, x), reach));
      const double needed = kSlack * (std::fabs(w0[k] - middle[k]) + half[k]);
      width[k] = std::max(needed, 1.5 * residual[k]);
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const Pair change = variation(magnitudes(inverse, k, y), width);
      const std::array<std::size_t, 2> column = {3, 1};
      for (std::size_t l = 0; l < 2; ++l)
        e[k][l] = kSlack * (upper(row(inverse, k, y[column[l]]) - DoubleBall(k == l ? 1 : 0)) + change[l]);
      image[k] = kSlack * (residual[k] + e[k][0] * width[0] + e[k][1] * width[1]);
      if (!(image[k] < width[k])) return false;
    }
    return true;
  }

  /// In the norm max |b_k| / width_k.
  double contraction() const {
    double result = 0;
    for (std::size_t k = 0; k < 2; ++k)
      result = std::max(result, kSlack * (e[k][0] * width[0] + e[k][1] * width[1]) / width[k]);
    return result;
  }

  /// Over a range half as far from w(A) as from the ends of the box.
  std::optional<SheetGraph> graph() const {
    SheetGraph result{{}, inverse, width, kSlack * contraction()};
    for (std::size_t k = 0; k < 2; ++k) {
      const double reach_out = 0.5 * (image[k] + width[k]);
      const Pair ends = {w0[k] - reach_out, w0[k] + reach_out};
      for (const double end : ends)
        if (!(std::fabs(end - w0[k]) > kSlack * image[k] && kSlack * std::fabs(end - w0[k]) < width[k]))
          return std::nullopt;
      result.range[k] = {from_double(ends[0]), from_double(ends[1])};
    }
    return result.contraction < 1 ? std::optional(result) : std::nullopt;
  }

  /// w(A) and the region's last two intervals are disjoint.
  bool leaves_region() const {
    for (std::size_t k = 0; k < 2; ++k)
      if (std::fabs(w0[k] - middle[k]) > kSlack * (image[k] + half[k])) return true;
    return false;
  }

  /// C x' over A: row r or s, column u or v.
  std::array<std::array<DoubleBall, 2>, 2> first_derivatives() const {
    std::array<std::array<DoubleBall, 2>, 2> d;
    for (std::size_t k = 0; k < 2; ++k) {
      const Pair change = variation(magnitudes(inverse, k, x), reach);
      d[k] = {row(inverse, k, x[3]).widened(change[0]), row(inverse, k, x[1]).widened(change[1])};
    }
    return d;
  }

  /// x is regular on A: C x' is, so x' has rank 2.
  bool is_regular() const {
    const auto d = first_derivatives();
    return (d[0][0] * d[1][1] - d[0][1] * d[1][0]).certain_sign() != 0;
  }

  /// w' = (C y')^-1 C x': with |w'_k| <= width_k m and |E| m as error.
  Sheet sheet() const {
    Sheet result{first_derivatives()};
    for (std::size_t l = 0; l < 2; ++l) {
      const double largest =
          std::max(upper(result.derivative[0][l]) / width[0], upper(result.derivative[1][l]) / width[1]);
      const double m = kSlack * largest / (1 - contraction());
      for (std::size_t k = 0; k < 2; ++k)
        result.derivative[k][l] =
            result.derivative[k][l].widened(kSlack * m * (e[k][0] * width[0] + e[k][1] * width[1]));
    }
    return result;
  }

  /// A point of W in the box, on the line u = c_0 or on one nearby: the former may be straight, the others
  /// not.
  bool meets(const CommonSurface& surface) const {
    return meets_on_line(surface, 0) || meets_on_line(surface, 0.25 * reach[0]);
  }

  /// On the line u = c_0 + a: near the middle of its image, with a short r or s.
  bool meets_on_line(const CommonSurface& surface, double a) const {
    const Pair across = {row(inverse, 0, x[3]).approximation(), row(inverse, 1, x[3]).approximation()};
    const Pair along = {row(inverse, 0, x[1]).approximation(), row(inverse, 1, x[1]).approximation()};
    const std::size_t fixed = std::fabs(along[1]) * width[0] >= std::fabs(along[0]) * width[1] ? 1 : 0;
    const double step = std::fabs(along[fixed]) * reach[1] / 16;
    if (!(step > 1e-12)) return false;
    const double value = on_grid(w0[fixed] + across[fixed] * a, std::ldexp(1, std::ilogb(step)));
    const double middle_of_other = w0[1 - fixed] + across[1 - fixed] * a;
    const double radius = 0.5 * width[1 - fixed];
    const RationalInterval v = {from_double(c[1] - 0.5 * reach[1]), from_double(c[1] + 0.5 * reach[1])};
    const RationalInterval other = {from_double(middle_of_other - radius),
                                    from_double(middle_of_other + radius)};
    if (!(std::fabs(value - w0[fixed]) < width[fixed] &&
          std::fabs(across[1 - fixed] * a) + radius < width[1 - fixed]))
      return false;
    const Rational u = from_double(c[0] + a);
    return fixed == 1 ? surface.has_point(u, from_double(value), other, v)
                      : surface.has_point_at_r(u, from_double(value), other, v);
  }
};

}  // namespace

std::optional<SheetGraph> graph_over(const PairSystem<DoubleBall>& system, const SearchRegion& region) {
  Attempt attempt(region);
  if (!attempt.find_centre(system) || !attempt.contracts()) return std::nullopt;
  return attempt.graph();
}

std::optional<Sheet> CommonSheets::certify(const SearchRegion& region) const {
  Attempt attempt(region);
  if (!attempt.find_centre(system_) || !attempt.is_near() || !attempt.contracts()) return std::nullopt;
  if (!attempt.is_regular()) return std::nullopt;
  if (!surface_.planar() && !attempt.meets(surface_)) return std::nullopt;
  return attempt.sheet();
}

bool CommonSheets::settles(const SearchRegion& region) const {
  Attempt attempt(region);
  if (attempt.find_centre(system_) && attempt.contracts() && attempt.leaves_region()) return true;
  return certify(region).has_value();
}

}  // namespace exsect
