#include "filter/exact_taylor.h"

namespace exsect::filter {

namespace {

template <class Number>
Number number(const Rational& q) {
  if constexpr (std::is_same_v<Number, LongBall>)
    return LongBall::enclosing(q);
  else
    return q;
}

template <class K, class Number>
ExactTaylorOf<K, Number> control_rows(const ExactPatch<K>& patch) {
  ExactTaylorOf<K, Number> rows;
  for (std::size_t k = 0; k < K::count; ++k) {
    const Point& p = control_point(patch, k);
    for (std::size_t c = 0; c < 3; ++c) rows[k][c] = number<Number>(p[c]);
    if constexpr (K::weighted) rows[k][3] = number<Number>(patch.weights[k]);
  }
  return rows;
}

/// Of a curve whose control points are at `first`, `first` + `step`, ...: its Taylor coefficients at t.
template <class K, class Number>
void to_taylor(ExactTaylorOf<K, Number>& c, std::size_t first, std::size_t step, const Number& t) {
  constexpr std::size_t n = K::degree;
  constexpr std::array<std::array<int, 4>, 4> kBinomial = {
      {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};
  for (std::size_t row = 0; row < K::rows; ++row) {
    const auto at = [&](std::size_t i) -> Number& { return c[first + step * i][row]; };
    for (std::size_t level = 1; level <= n; ++level)
      for (std::size_t i = n; i >= level; --i) at(i) -= at(i - 1);
    for (std::size_t i = 1; i < n; ++i) at(i) *= Number(kBinomial[n][i]);
    for (std::size_t level = 0; level < n; ++level)
      for (std::size_t i = n; i > level; --i) at(i - 1) += t * at(i);
  }
}

}  // namespace

template <class K, class Number>
ExactTaylorOf<K, Number> exact_taylor(const ExactPatch<K>& patch, const Number& u, const Number& v) {
  ExactTaylorOf<K, Number> c = control_rows<K, Number>(patch);
  for (std::size_t i = 0; i < K::side; ++i) to_taylor<K>(c, K::side * i, 1, v);
  for (std::size_t j = 0; j < K::side; ++j) to_taylor<K>(c, j, K::side, u);
  return c;
}

#define EXSECT_INSTANTIATE_FOR(K, Number)                                                        \
  template ExactTaylorOf<K, Number> exact_taylor<K, Number>(const ExactPatch<K>&, const Number&, \
                                                            const Number&);
#define EXSECT_INSTANTIATE(K)            \
  EXSECT_INSTANTIATE_FOR(K, Rational)    \
  EXSECT_INSTANTIATE_FOR(K, FieldNumber) \
  EXSECT_INSTANTIATE_FOR(K, LongBall)
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE
#undef EXSECT_INSTANTIATE_FOR

}  // namespace exsect::filter
