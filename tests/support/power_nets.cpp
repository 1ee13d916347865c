#include "support/power_nets.h"

#include <algorithm>

namespace exsect::testing {
namespace {

/// The value of the polar form of t^power, of degree n, with i arguments b and n - i arguments a.
Rational polar(std::size_t power, std::size_t n, std::size_t i, const Rational& a, const Rational& b) {
  const auto binomial = [](std::size_t top, std::size_t bottom) {
    Rational value = 1;
    for (std::size_t k = 0; k < bottom; ++k)
      value *= Rational(static_cast<long>(top - k), static_cast<long>(k + 1));
    return value;
  };
  Rational sum = 0;
  for (std::size_t k = 0; k <= std::min(i, power); ++k) {
    if (power - k > n - i) continue;
    Rational term = binomial(i, k) * binomial(n - i, power - k);
    for (std::size_t l = 0; l < k; ++l) term *= b;
    for (std::size_t l = 0; l < power - k; ++l) term *= a;
    sum += term;
  }
  return sum / binomial(n, power);
}

}  // namespace

RationalPatch power_patch(const PowerNet& c, const Rational& from, const Rational& to) {
  const std::size_t m = c.size() - 1;
  const std::size_t n = c[0].size() - 1;
  std::vector<std::vector<HomogeneousPoint>> net(m + 1, std::vector<HomogeneousPoint>(n + 1, {0, 0, 0, 0}));
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t p = 0; p <= m; ++p)
        for (std::size_t q = 0; q <= n; ++q) {
          const Rational factor = polar(p, m, i, from, to) * polar(q, n, j, from, to);
          for (std::size_t k = 0; k < 4; ++k) net[i][j][k] += factor * c[p][q][k];
        }
  return RationalPatch::from_homogeneous(net);
}

RationalPatch power_patch(const std::array<Terms, 3>& coordinates, int degree) {
  const auto side = static_cast<std::size_t>(degree) + 1;
  PowerNet c(side, std::vector<HomogeneousPoint>(side, {0, 0, 0, 0}));
  c[0][0][3] = 1;
  for (std::size_t k = 0; k < 3; ++k)
    for (const auto& [i, value] : coordinates[k])
      if (value != 0) c.at(i.first).at(i.second)[k] += value;
  return power_patch(c, 0, 1);
}

}  // namespace exsect::testing
