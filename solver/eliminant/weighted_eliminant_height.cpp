#include "eliminant/weighted_eliminant_height.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "eliminant/circle_means.h"
#include "eliminant/forms_of_kind.h"

namespace exsect {

namespace {

/// Complex or Majorant as the arithmetic of FibreResultants. On the way from a number to a coefficient of R
/// of WeightedEliminantForms are at most 126 roundings: 3 in a_j, 2 in a_i ^ a_j, 4 in y_i ^ y_j, 6 in a
/// pairing, so 18 for it; then 17 in pol, 19 and 1 in R, which is of degree 4 in the pairings. Products have
/// 8 numbers of x, with u or u^2 at each, and 8 of y; majorants are below 2^51: what circle_means.h asks for.
/// With straight lines they are 22 in each of three factors, 4 in a_j, 2 in a_0 ^ a_1, 5 in y_i ^ y_j, 7 in
/// b_pq, then 14 in a minor, 21 in R; products have 6 numbers of x and 6 of y, majorants are below 2^44.
template <class T>
struct CircleArithmetic {
  using Residue = T;
  struct Sum {
    T value = {};
    Sum() = default;
    Sum(const T& a, const T& b) : value(a * b) {}
    void add(const T& a, const T& b) { value = value + a * b; }
  };
  static T reduce(const Sum& sum) { return sum.value; }
  static T reduce_few(const Sum& sum) { return sum.value; }
  static T add(const T& a, const T& b) { return a + b; }
  static T negate(const T& a) { return T() - a; }
  static T multiply(const T& a, const T& b) { return a * b; }
};

template <class Net, class T>
Net numbers(const ScaledPair<4>::Net& net, const T& u, bool exchanged) {
  Net result = {};
  for (std::size_t i = 0; i < net.size(); ++i)
    for (std::size_t j = 0; j < net[i].size(); ++j)
      for (std::size_t k = 0; k < 4; ++k) {
        auto& c = exchanged ? result.c[j][i].c[k] : result.c[i][j].c[k];
        c = as(u, net[i][j][k]);
      }
  return result;
}

/// R over u, in powers of s, or of r for the Kind of y with its parameters exchanged.
template <class Kind, class T>
std::vector<T> resultant_at(const ScaledPair<4>& pair, const T& u, bool exchanged) {
  using Forms = FormsOf<CircleArithmetic<T>, Kind>;
  const typename Forms::SmallNumbers small = {};
  const Forms forms({}, numbers<typename Forms::FirstNet>(pair.x, u, false),
                    numbers<typename Forms::SecondNet>(pair.y, u, exchanged), small);
  const typename Forms::Fibre fibre = forms.fibre(u);
  return {std::begin(fibre.r), std::end(fibre.r)};
}

/// m||R_s|| and m||R_r||, without the scales.
template <class Kind, class Exchanged>
std::array<double, 2> resultant_means(const ScaledPair<4>& pair) {
  return log2_mean_norms([&](const auto& u) {
    return std::array{resultant_at<Kind>(pair, u, false), resultant_at<Exchanged>(pair, u, true)};
  });
}

Integer minor(const WeightedPair::Vector& a, const WeightedPair::Vector& b, std::size_t i, std::size_t j) {
  return a[i] * b[j] - a[j] * b[i];
}

/// Coordinate k, up to its sign, of a ^ b ^ c.
Integer triple(const WeightedPair::Vector& a, const WeightedPair::Vector& b, const WeightedPair::Vector& c,
               std::size_t k) {
  const std::size_t i = k == 0 ? 1 : 0, j = k <= 1 ? 2 : 1, l = k == 3 ? 2 : 3;
  return minor(a, b, i, j) * c[l] - minor(a, b, i, l) * c[j] + minor(a, b, j, l) * c[i];
}

/// The coefficients of coordinate k of N = Y ^ Y_r ^ Y_s (16.8): those of r^5 and s^5 are zero.
std::vector<Integer> normal(const WeightedPair::Net& y, std::size_t k) {
  std::vector<Integer> result(36);
  for (std::size_t a = 0; a < 9; ++a)
    for (std::size_t b = 3; b < 9; ++b)
      for (std::size_t c = 0; c < 9; ++c) {
        if (c % 3 == 0) continue;
        const std::size_t r = a / 3 + b / 3 + c / 3 - 1, s = a % 3 + b % 3 + c % 3 - 1;
        result[6 * r + s] +=
            static_cast<long>(b / 3 * (c % 3)) * triple(y[a / 3][a % 3], y[b / 3][b % 3], y[c / 3][c % 3], k);
      }
  return result;
}

/// log2 of the 2-norm of N with coordinate k times 2^exponent[k] (16.10).
double log2_normal(const WeightedPair& pair, const std::array<long, 4>& exponent) {
  std::vector<Integer> all;
  const long least = *std::min_element(exponent.begin(), exponent.end());
  for (std::size_t k = 0; k < 4; ++k)
    for (Integer& c : normal(pair.y, k)) {
      all.push_back(std::move(c));
      all.back() <<= static_cast<unsigned long>(exponent[k] - least);
    }
  if (std::all_of(all.begin(), all.end(), [](const Integer& c) { return c == 0; }))
    throw std::domain_error("eliminant_height: the normal of y vanishes identically");
  return log2_norm_upper(all) + static_cast<double>(least);
}

/// Half of log2 2 (4 ||a_0||^2 + ||a_1||^2 + 4 ||a_2||^2), coordinate k of them times 2^-exponent[k] (16.10).
double log2_derivative(const WeightedPair& pair, const std::array<long, 4>& exponent) {
  std::vector<Integer> all;
  const long most = *std::max_element(exponent.begin(), exponent.end());
  for (const auto& row : pair.x)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 4; ++k) {
        all.push_back(j == 1 ? row[j][k] : Integer(2 * row[j][k]));
        all.back() <<= static_cast<unsigned long>(most - exponent[k]);
      }
  if (std::all_of(all.begin(), all.end(), [](const Integer& c) { return c == 0; }))
    throw std::domain_error("eliminant_height: x vanishes identically");
  return 0.5 + log2_norm_upper(all) - static_cast<double>(most);
}

double log2_scale(const ScaledPair<4>& pair) {
  double scale = 0;
  for (const long exponent : pair.exponent) {
    if (exponent == std::numeric_limits<long>::min())
      throw std::domain_error("eliminant_height: a coordinate vanishes identically");
    scale += static_cast<double>(exponent);
  }
  return scale;
}

/// m(E) by (16.11), and (16.12).
double log2_height(const WeightedPair& pair, const ScaledPair<4>& scaled, WeightedKind) {
  const auto [r_s, r_r] = resultant_means<WeightedKind, WeightedKind>(scaled);
  const double log2_five = 2.322;
  const double at_point =
      log2_five + log2_normal(pair, scaled.exponent) + log2_derivative(pair, scaled.exponent);
  const double log2_binomial = 156;  // binom(160,80) < 2^156
  return 16 * at_point + 4 * (r_s + r_r + 8 * log2_scale(scaled)) + log2_binomial;
}

/// log2 of the sum of all moduli.
double log2_sum(const ScaledPair<4>::Net& net) {
  double sum = 0x1p-400;
  for (const auto& row : net)
    for (const auto& c : row)
      for (const double coordinate : c) sum += std::abs(coordinate);
  return log2_upper(sum * kSlack);
}

/// By (16.18): all terms scale with the product of the scales, R with its power m or n.
template <std::size_t m, std::size_t n>
double log2_height(const WeightedPair& pair, const ScaledPair<4>& scaled, RuledKind<m, n>) {
  using Kind = RuledKind<m, n>;
  const auto [r_s, r_r] = resultant_means<Kind, RuledKind<n, m>>(scaled);
  const double scale = log2_scale(scaled);
  const double at_point = scale + 2 * (log2_sum(scaled.x) - 1) + std::log2(m * n) + 2 * log2_sum(scaled.y);
  const double log2_binomial = static_cast<double>(Kind::degree(pair.x.size() - 1));
  return Kind::points * at_point + Kind::lead_power * (r_r + n * scale) + (2 * n - 2) * (r_s + m * scale) +
         log2_binomial;
}

}  // namespace

std::size_t eliminant_height_bound(const WeightedPair& pair) {
  const ScaledPair<4> scaled(pair);
  const double bits = by_kind(pair, [&](const auto& kind) { return log2_height(pair, scaled, kind); });
  // The sum of these doubles, each below 2^40, is rounded by less than 1.
  return static_cast<std::size_t>(std::ceil(std::max(bits, 0.0))) + 1;
}

}  // namespace exsect
