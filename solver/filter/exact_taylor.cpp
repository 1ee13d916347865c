#include "filter/exact_taylor.h"

namespace exsect::filter {

namespace {

template <class K>
ExactTaylor<K> control_rows(const ExactPatch<K>& patch) {
  ExactTaylor<K> rows;
  for (std::size_t k = 0; k < K::count; ++k) {
    const Point& p = control_point(patch, k);
    for (std::size_t c = 0; c < 3; ++c) rows[k][c] = p[c];
    if constexpr (K::weighted) rows[k][3] = patch.weights[k];
  }
  return rows;
}

/// Of a curve whose control points are at `first`, `first` + `step`, ...: its Taylor coefficients at t.
template <class K>
void to_taylor(ExactTaylor<K>& c, std::size_t first, std::size_t step, const Rational& t) {
  constexpr std::size_t n = K::degree;
  constexpr std::array<std::array<int, 4>, 4> kBinomial = {
      {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};
  for (std::size_t row = 0; row < K::rows; ++row) {
    const auto at = [&](std::size_t i) -> Rational& { return c[first + step * i][row]; };
    for (std::size_t level = 1; level <= n; ++level)
      for (std::size_t i = n; i >= level; --i) at(i) -= at(i - 1);
    for (std::size_t i = 1; i < n; ++i) at(i) *= kBinomial[n][i];
    for (std::size_t level = 0; level < n; ++level)
      for (std::size_t i = n; i > level; --i) at(i - 1) += t * at(i);
  }
}

}  // namespace

template <class K>
ExactTaylor<K> exact_taylor(const ExactPatch<K>& patch, const Rational& u, const Rational& v) {
  ExactTaylor<K> c = control_rows<K>(patch);
  for (std::size_t i = 0; i < K::side; ++i) to_taylor<K>(c, K::side * i, 1, v);
  for (std::size_t j = 0; j < K::side; ++j) to_taylor<K>(c, j, K::side, u);
  return c;
}

#define EXSECT_INSTANTIATE(K) \
  template ExactTaylor<K> exact_taylor<K>(const ExactPatch<K>&, const Rational&, const Rational&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
