#include "self/pinch_guesses.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "self/pinch_bounds.h"
#include "self/pinch_matrix.h"

namespace exsect {
namespace {

constexpr int kStarts = 8;  // in each parameter
constexpr int kMostSteps = 12;
constexpr double kSettled = 0x1p-30;
/// Guesses that are nearer are one.
constexpr double kDistinct = 0x1p-20;

/// Newton's method for x_u + m x_v = 0 from the slope m for which that is shortest.
std::optional<std::array<double, 2>> settled(const LocalDerivatives& x, double u, double v) {
  std::array<double, 3> y = {u, v, 0};
  for (int step = 0; step < kMostSteps; ++step) {
    const AffineDerivatives d = x.at(y[0], y[1]);
    if (step == 0) {
      const auto across = middle(d[0][1]);
      y[2] = -product(middle(d[1][0]), across) / product(across, across);
      if (!(std::fabs(y[2]) <= 1)) return std::nullopt;
    }
    const DoubleBall m(y[2]);
    const auto rows = approximate_inverse(
        {middle(plus(d[2][0], m, d[1][1])), middle(plus(d[1][1], m, d[0][2])), middle(d[0][1])});
    if (!rows) return std::nullopt;
    const auto value = middle(plus(d[1][0], m, d[0][1]));
    double change = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double by = product((*rows)[i], value);
      y[i] -= by;
      change = std::max(change, std::fabs(by));
    }
    if (!(y[0] > -1 && y[0] < 2 && y[1] > -1 && y[1] < 2)) return std::nullopt;
    if (change < kSettled)
      return y[0] >= 0 && y[0] <= 1 && y[1] >= 0 && y[1] <= 1 ? std::optional(std::array{y[0], y[1]})
                                                              : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::array<double, 2>> pinch_guesses(const RationalPatch& patch) {
  std::vector<std::array<double, 2>> found;
  const Point origin = patch(Rational(1, 2), Rational(1, 2));
  for (const bool exchanged : {false, true}) {
    const LocalDerivatives x(exchanged ? patch.transposed() : patch, origin, 3);
    for (int i = 0; i < kStarts * kStarts; ++i) {
      auto place = settled(x, (i / kStarts + 0.5) / kStarts, (i % kStarts + 0.5) / kStarts);
      if (!place) continue;
      if (exchanged) std::swap((*place)[0], (*place)[1]);
      const bool is_known = std::ranges::any_of(found, [&](const std::array<double, 2>& known) {
        return std::fabs(known[0] - (*place)[0]) < kDistinct && std::fabs(known[1] - (*place)[1]) < kDistinct;
      });
      if (!is_known) found.push_back(*place);
    }
  }
  return found;
}

}  // namespace exsect
