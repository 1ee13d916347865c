#include "filter/local_bounds.h"

#include <exsect/algebra/rounding_bounds.h>

#include <cmath>

namespace exsect::filter {

namespace {

template <class K>
double magnitude(const ScalarTableOf<K>& table, std::size_t i, double p, double q) {
  double product = std::fabs(table[i]) + kTinyCoefficient;
  for (std::size_t n = 0; n < i / K::side; ++n) product *= p;
  for (std::size_t n = 0; n < i % K::side; ++n) product *= q;
  return product;
}

/// A bound, but for roundings, of the terms of orders `least` and more, divided by |t|^least, for parameters
/// of sizes p |t| and q |t|, |t| <= reach: p, q >= 2^-11 and reach >= 2^-20, so that no product underflows.
template <class K>
double bound(const ScalarTableOf<K>& table, std::size_t least, const std::array<double, 2>& size,
             double reach) {
  double sum = 0;
  for (std::size_t i = 1; i < K::count; ++i) {
    const std::size_t order = i / K::side + i % K::side;
    if (order >= least) {
      sum += magnitude<K>(table, i, size[0], size[1]) * std::pow(reach, static_cast<double>(order - least));
    }
  }
  return sum;
}

/// Bounds for |c_i| <= k_i |t|, |a_i| <= s_i |t|, |t| <= reach: of the terms of (14.17) beyond order 1 with
/// c, and of a alone, divided by |t|²; of those of g beyond order 2 with c alone, of a alone and, (14.45), of
/// both, divided by |t|³.
struct TermBounds {
  std::array<double, 2> chi;
  std::array<double, 2> eta;
  std::array<double, 2> mixed = {};  // of the terms of chi with c and a
  double normal_x;
  double normal_y;
  double normal_mixed = 0;
};
/// Empty if e0 X or e0 Y may vanish.
template <class K>
std::optional<TermBounds> term_bounds(const LocalFormsOf<K>& f, const std::array<double, 2>& k,
                                      const std::array<double, 2>& s, double reach) {
  TermBounds r;
  for (std::size_t i = 0; i < 2; ++i) {
    r.chi[i] = kSlack * bound<K>(f.x[i], 2, k, reach);
    r.eta[i] = kSlack * bound<K>(f.y[i], 2, s, reach);
  }
  r.normal_x = bound<K>(f.normal_x, 3, k, reach);
  r.normal_y = bound<K>(f.normal_y, 3, s, reach);
  if constexpr (K::weighted) {  // (14.45)
    const double xi = kSlack * bound<K>(f.weight_x, 2, k, reach);
    const double upsilon = kSlack * bound<K>(f.weight_y, 1, s, reach);
    if (!(xi * reach * reach < 0.5 && upsilon * reach < 0.5)) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i) {
      const double value_y = bound<K>(f.y[i], 1, s, reach);
      r.mixed[i] = kSlack * (upsilon * (k[i] + reach * r.chi[i]) + reach * xi * value_y);
      r.chi[i] += r.mixed[i];
    }
    r.normal_mixed = kSlack * (bound<K>(f.normal_x, 2, k, reach) * upsilon +
                               reach * xi * bound<K>(f.normal_y, 2, s, reach));
  }
  return r;
}

}  // namespace

template <class K>
std::optional<LocalBounds> local_bounds(const LocalFormsOf<K>& f, double reach) {
  constexpr double kTotalDegree = K::orders - 1;
  const std::array<double, 2> s = {std::fabs(f.s[0][0]) + std::fabs(f.s[0][1]),
                                   std::fabs(f.s[1][0]) + std::fabs(f.s[1][1])};
  std::array<double, 2> b;
  for (std::size_t i = 0; i < 2; ++i) {
    b[i] = kSlack * (std::fabs(f.bs[i][0]) + std::fabs(f.bs[i][1]) + 2 * f.bs_error[i]);
  }
  LocalBounds r;
  const double margin = 0.125 * (b[0] + b[1]) + 0x1p-10;
  r.k = {1.25 * b[0] + margin, 1.25 * b[1] + margin};
  const auto& k = r.k;
  const auto terms = term_bounds<K>(f, k, s, reach);
  if (!terms) return std::nullopt;
  const auto& [chi, eta, mixed, normal_x, normal_y, normal_mixed] = *terms;
  double steepness = 0;
  double contraction = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!(b[i] + reach * (chi[i] + eta[i]) <= k[i])) return std::nullopt;  // (14.18)
    steepness = larger_bound(steepness, (b[i] + kTotalDegree * reach * (eta[i] + mixed[i])) / k[i]);
    contraction = larger_bound(contraction, kTotalDegree * reach * chi[i] / k[i]);
  }
  if (!(contraction < 0.5)) return std::nullopt;
  const double z = kSlack * steepness / (1 - contraction);             // |c_t| <= z k
  const std::array<double, 2> e = {chi[0] + eta[0], chi[1] + eta[1]};  // |c - B S t| <= e |t|²
  for (std::size_t i = 0; i < 2; ++i) r.turn[i] = kSlack * kTotalDegree * (chi[i] * z + eta[i] + mixed[i]);
  const auto& d = r.turn;
  const double uu = std::fabs(f.normal_x[kQuadratic<K>[0]]) + kTiny;
  const double uv = std::fabs(f.normal_x[kQuadratic<K>[1]]) + kTiny;
  const double vv = std::fabs(f.normal_x[kQuadratic<K>[2]]) + kTiny;
  r.value = kSlack * (uu * e[0] * (k[0] + b[0]) + uv * (e[0] * k[1] + b[0] * e[1]) +
                      vv * e[1] * (k[1] + b[1]) + normal_x + normal_y + normal_mixed);  // (14.19)
  r.slope = kSlack * (2 * uu * (e[0] * z * k[0] + b[0] * d[0]) + 2 * vv * (e[1] * z * k[1] + b[1] * d[1]) +
                      uv * (d[0] * k[1] + b[0] * e[1] + e[0] * z * k[1] + b[0] * d[1]) +
                      kTotalDegree * (z * normal_x + normal_y + (1 + z) * normal_mixed));
  return r;
}

#define EXSECT_INSTANTIATE(K) \
  template std::optional<LocalBounds> local_bounds<K>(const LocalFormsOf<K>&, double);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
