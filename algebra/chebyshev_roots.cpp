#include "chebyshev_roots.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "dyadic_interval.h"

namespace exsect {

namespace {

constexpr std::size_t kUsualCoefficients = 161;
constexpr std::size_t kMostCoefficients = 253;
constexpr int kDeepest = 48;
/// Doubles decide next to nothing on longer intervals.
constexpr int kFirstInDoubles = 2;
/// Sums of at most 2^10 products of doubles that are right to 2^-49 lose less.
constexpr double kSumUp = 1 + 0x1p-38;

/// T_k((t - 1) / 2) = sum_j L_jk T_j(t) (4.16b), and T_k((t + 1) / 2) with the signs (-1)^(j+k). From
/// T_(k+1)(s) = 2 s T_k - T_(k-1) and 2 t T_j = T_(j+1) + T_|j-1|, the numbers 2^k L_jk are integers; as mean
/// values of T_j T_k they are at most 2^(k+1). So every sum of the recursion for k <= 252, a multiple of
/// 2^-252 below 8, is exact with 256 bits, whatever radius it is given.
class Halving {
 public:
  explicit Halving(std::size_t n) : wide_(n), approximations_(n) {
    std::vector<WideBall> before, now = {1.0}, next = {-0.5, 0.5};
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j <= k; ++j) {
        wide_[j].push_back(now[j]);
        approximations_[j].push_back(now[j].approximation());
      }
      before = std::move(now);
      now = std::move(next);
      next = after(before, now);
    }
  }

  /// L_jk for j <= k, and a double that differs from it by at most 2^-49 of it.
  const WideBall& wide(std::size_t j, std::size_t k) const { return wide_[j][k - j]; }
  double approximation(std::size_t j, std::size_t k) const { return approximations_[j][k - j]; }

 private:
  /// T_(k+1) = (t - 1) T_k - T_(k-1).
  static std::vector<WideBall> after(const std::vector<WideBall>& before, const std::vector<WideBall>& now) {
    std::vector<WideBall> next;
    for (std::size_t j = 0; j <= now.size(); ++j) {
      WideBall::Sum sum;
      if (j > 0) sum.add(j == 1 ? now[0] : scaled(now[j - 1], -1));
      if (j + 1 < now.size()) sum.add(scaled(now[j + 1], -1));
      if (j < now.size()) sum.add(-now[j]);
      if (j < before.size()) sum.add(-before[j]);
      next.push_back(sum.rounded().midpoint());
    }
    return next;
  }

  std::vector<std::vector<WideBall>> wide_;
  std::vector<std::vector<double>> approximations_;
};

/// For so many coefficients.
const Halving& halving(std::size_t n) {
  static const Halving usual(kUsualCoefficients);
  if (n <= kUsualCoefficients) return usual;
  static const Halving all(kMostCoefficients);
  return all;
}

double size(double c) { return std::fabs(c); }
double size(const WideBall& c) { return c.magnitude(); }

/// sum c_j T_j(t) + e(t), t in [-1,1] affine on an interval: |e| <= value_error, |e'| <= slope_error.
template <class Number>
struct Piece {
  DyadicInterval where;
  std::vector<Number> c;
  double value_error = 0;
  double slope_error = 0;

  /// |T_j| <= 1 and |T_j'| <= j^2.
  void add_error(std::size_t j, double error) {
    value_error = (value_error + error) * kSumUp;
    slope_error = (slope_error + static_cast<double>(j * j) * error) * kSumUp;
  }
  /// Leaves out the last terms, as long as the error grows by at most a quarter.
  void shorten() {
    double rest = value_error / 4;
    while (c.size() > 1 && size(c.back()) <= rest) {
      rest -= size(c.back());
      add_error(c.size() - 1, size(c.back()));
      c.pop_back();
    }
  }
};

Piece<double> in_doubles(const Piece<WideBall>& piece) {
  Piece<double> result{piece.where, {}, piece.value_error, piece.slope_error};
  for (std::size_t j = 0; j < piece.c.size(); ++j) {
    result.c.push_back(piece.c[j].approximation());
    result.add_error(j,
                     piece.c[j].magnitude() * 0x1p-48 + 0x1p-900);  // outside of the range of approximations
  }
  result.shorten();
  return result;
}

std::array<Piece<WideBall>, 2> halves(const Piece<WideBall>& piece) {
  const std::size_t n = piece.c.size();
  const Halving& table = halving(n);
  Piece<WideBall> left{piece.where.half(0), std::vector<WideBall>(n), piece.value_error,
                       piece.slope_error / 2};
  Piece<WideBall> right = left;
  right.where = piece.where.half(1);
  const auto set = [](Piece<WideBall>& half, std::size_t j, const WideBall& value) {
    half.c[j] = value.midpoint();
    half.add_error(j, value.radius());
  };
  for (std::size_t j = 0; j < n; ++j) {
    WideBall::Sum even, odd;  // by the parity of k - j
    for (std::size_t k = j; k < n; ++k) ((k - j) % 2 == 0 ? even : odd).add(table.wide(j, k), piece.c[k]);
    const WideBall a = even.rounded(), b = odd.rounded();
    set(left, j, a + b);
    set(right, j, a - b);
  }
  return {std::move(left), std::move(right)};
}

std::array<Piece<double>, 2> halves(const Piece<double>& piece) {
  const std::size_t n = piece.c.size();
  const Halving& table = halving(n);
  Piece<double> left{piece.where.half(0), std::vector<double>(n), piece.value_error, piece.slope_error / 2};
  Piece<double> right = left;
  right.where = piece.where.half(1);
  double magnitudes = 0;
  for (const double c : piece.c) magnitudes += std::fabs(c);
  for (std::size_t j = 0; j < n; ++j) {
    double even = 0, odd = 0;
    for (std::size_t k = j; k < n; k += 2) even += table.approximation(j, k) * piece.c[k];
    for (std::size_t k = j + 1; k < n; k += 2) odd += table.approximation(j, k) * piece.c[k];
    left.c[j] = even + odd;
    right.c[j] = even - odd;
    // |L_jk| <= 2.
    const double lost = static_cast<double>(n + 4) * magnitudes * 0x1p-50;
    left.add_error(j, lost);
    right.add_error(j, lost);
  }
  return {std::move(left), std::move(right)};
}

/// The first term outweighs all others and the error.
bool keeps_sign(const std::vector<double>& c, double error) {
  double others = error;
  for (std::size_t j = 1; j < c.size(); ++j) others += std::fabs(c[j]);
  return std::fabs(c[0]) > others * kSumUp;
}

/// (sum c_j T_j)' = sum d_j T_j with d_(j-1) = d_(j+1) + 2 j c_j, d_0 half of that.
std::vector<double> derivative(const std::vector<double>& c) {
  std::vector<double> d(std::max<std::size_t>(c.size(), 2) - 1);
  for (std::size_t j = c.size() - 1; j > 0; --j) {
    d[j - 1] = 2 * static_cast<double>(j) * c[j] + (j + 1 < d.size() ? d[j + 1] : 0);
  }
  d[0] /= 2;
  return d;
}

enum class Verdict { no_root, one_root, open, undecided };

Verdict verdict(const Piece<double>& piece) {
  const std::vector<double>& c = piece.c;
  if (keeps_sign(c, piece.value_error)) return Verdict::no_root;
  double sum = 0, slopes = 0;  // at most 2^-40 of the latter is lost in the derivative
  for (std::size_t j = 0; j < c.size(); ++j) {
    sum += std::fabs(c[j]);
    slopes += static_cast<double>(2 * j * c.size()) * std::fabs(c[j]);
  }
  if (!(piece.value_error < sum) || piece.where.depth >= kDeepest) return Verdict::undecided;
  if (!keeps_sign(derivative(c), piece.slope_error + slopes * 0x1p-40)) return Verdict::open;
  // Strictly monotone: the signs at the ends decide.
  double left = 0, right = 0;
  for (std::size_t j = 0; j < c.size(); ++j) {
    right += c[j];
    left += j % 2 == 0 ? c[j] : -c[j];
  }
  const double error = piece.value_error + sum * 0x1p-38;
  if (!(std::fabs(left) > error) || !(std::fabs(right) > error)) return Verdict::undecided;
  return (left < 0) != (right < 0) ? Verdict::one_root : Verdict::no_root;
}

/// False where the numbers do not decide; `found` may then have some of the roots.
bool isolate(const Piece<double>& piece, std::vector<RationalInterval>& found) {
  switch (verdict(piece)) {
    case Verdict::no_root:
      return true;
    case Verdict::one_root:
      found.push_back(piece.where.interval());
      return true;
    case Verdict::undecided:
      return false;
    case Verdict::open:
      break;
  }
  auto [left, right] = halves(piece);
  left.shorten();
  right.shorten();
  return isolate(left, found) && isolate(right, found);
}

/// Where doubles do not decide, halves are taken with 256 bits, which are again tried in doubles.
bool isolate(const Piece<WideBall>& piece, std::vector<RationalInterval>& found) {
  const std::size_t before = found.size();
  const Piece<double> approximate = in_doubles(piece);
  if (piece.where.depth >= kFirstInDoubles && isolate(approximate, found)) return true;
  found.resize(before);
  double sum = 0;
  for (const WideBall& c : piece.c) sum += c.magnitude();
  if (!(piece.value_error * 0x1p+8 < sum) || piece.where.depth >= kDeepest) return false;
  auto [left, right] = halves(piece);
  left.shorten();
  right.shorten();
  return isolate(left, found) && isolate(right, found);
}

}  // namespace

std::optional<std::vector<RationalInterval>> isolate_chebyshev_roots(const std::vector<WideBall>& c) {
  return in_nearest_rounding([&]() -> std::optional<std::vector<RationalInterval>> {
    if (c.empty() || c.size() > kMostCoefficients)
      throw std::invalid_argument("1 to 253 Chebyshev coefficients");
    Piece<WideBall> all{{}, c, 0, 0};
    for (std::size_t j = 0; j < c.size(); ++j) {
      all.c[j] = c[j].midpoint();
      all.add_error(j, c[j].radius());
    }
    std::vector<RationalInterval> found;
    if (!isolate(all, found)) return std::nullopt;
    return found;
  });
}

}  // namespace exsect
