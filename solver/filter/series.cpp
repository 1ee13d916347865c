#include "filter/series.h"

#include <algorithm>
#include <cmath>

#include "filter/vertex_scalar.h"

namespace exsect::filter {

namespace {

constexpr std::size_t kDegree = kSeriesDegree;

/// Powers of tau in a product of the offsets (a,b) = (u,v) and (r,s), side by side.
using Series = double[kDegree + 1][2];

/// Adds the coefficient of tau^k of f g, given the lower ones; they begin at tau^m and tau^n.
void add_product(Series& sum, const Series& f, std::size_t m, const Series& g, std::size_t n, std::size_t k) {
  double first = 0;
  double second = 0;
  for (std::size_t i = m; i + n <= k; ++i) {
    first += f[i][0] * g[k - i][0];
    second += f[i][1] * g[k - i][1];
  }
  sum[k][0] = first;
  sum[k][1] = second;
}

}  // namespace

// C F_j is the unit vector of j's row but for rounding, so that the coefficient of C F at tau^k is that of w
// plus what products of lower ones give. Those of a^i b^j: a^2, ..., then times b. The scale's own series
// times that of h comes to this.
template <class K>
void expand_arc(TubeOf<K>& tube) {
  std::array<Series, K::count> product{};  // of a^i b^j at side i + j
  Series& a = product[kFirst<K>];
  Series& b = product[kSecond];
  const std::array<Series*, 4> coordinate = {&a, &b, &a, &b};
  for (std::size_t j = 0; j < 4; ++j) {
    (*coordinate[j])[1][j / 2] = tube.slope[j];
  }
  [[maybe_unused]] std::array<double, kDegree + 1> scale{};
  [[maybe_unused]] std::array<Row<K>, kDegree + 1> h{};  // of h(r,s) - h(0,0)
  if constexpr (K::weighted) {
    scale[1] = tube.slope[4];
    h[1] = tube.slope[2] * tube.h[kFirst<K>] + tube.slope[3] * tube.h[kSecond];
  }
  for (std::size_t k = 2; k <= kDegree; ++k) {
    Row<K> sum{};
    for_each_index<K::count>([&](auto index) EXSECT_INLINE {
      constexpr std::size_t i = index / K::side;
      constexpr std::size_t j = index % K::side;
      if constexpr (i + j >= 2) {
        if constexpr (j == 0) {
          add_product(product[index], product[index - K::side], i - 1, a, 1, k);
        } else {
          add_product(product[index], product[index - 1], i + j - 1, b, 1, k);
        }
        for (std::size_t row = 0; row < K::rows; ++row) {
          sum[row] += tube.g[index][row] * product[index][k][0] + tube.h[index][row] * product[index][k][1];
          if constexpr (K::weighted) {
            h[k][row] += tube.h[index][row] * product[index][k][1];
          }
        }
      }
    });
    if constexpr (K::weighted) {
      for (std::size_t m = 1; m < k; ++m) sum = sum + scale[m] * h[k - m];
    }
    for (std::size_t row = 0; row < K::rows; ++row) {
      const std::size_t j = tube.others[row];
      if (j < 4) {
        (*coordinate[j])[k][j / 2] = -sum[row];
      } else {
        scale[k] = -sum[row];
      }
      if (k > 2) {
        tube.further[k - 3][row] = -sum[row];
      }
    }
    if constexpr (K::weighted) {
      h[k] = h[k] + a[k][1] * tube.h[kFirst<K>] + b[k][1] * tube.h[kSecond];
    }
  }
}

template <class K>
Unknowns<K> arc_offset(const TubeOf<K>& tube, double tau) {
  Unknowns<K> offset;
  offset[tube.axis] = tau;
  for (std::size_t row = 0; row < K::rows; ++row) {
    const std::size_t j = tube.others[row];
    double sum = 0;
    for (std::size_t k = tube.further.size(); k-- > 0;) {
      sum = tau * (tube.further[k][row] + sum);
    }
    offset[j] = tau * (tube.slope[j] + tau * (0.5 * tube.second[j] + sum));
  }
  return offset;
}

template <class K>
Unknowns<K> arc_slope(const TubeOf<K>& tube, double tau) {
  Unknowns<K> slope;
  slope[tube.axis] = 1;
  for (std::size_t row = 0; row < K::rows; ++row) {
    const std::size_t j = tube.others[row];
    double sum = 0;
    for (std::size_t k = tube.further.size(); k-- > 0;) {
      sum = tau * (static_cast<double>(k + 3) * tube.further[k][row] + sum);
    }
    slope[j] = tube.slope[j] + tau * (tube.second[j] + sum);
  }
  return slope;
}

template <class K>
double arc_second(const TubeOf<K>& tube, double tau, std::size_t i) {
  const std::size_t row = i < tube.axis ? i : i - 1;
  double sum = 0;
  for (std::size_t k = tube.further.size(); k-- > 0;) {
    sum = tau * (static_cast<double>((k + 3) * (k + 2)) * tube.further[k][row] + sum);
  }
  return tube.second[i] + sum;
}

template <class K>
VertexFormsOf<K::degree, K::rows> vertex_forms(const PairOf<K>& pair, const TubeOf<K>& tube,
                                               double greatest) {
  VertexFormsOf<K::degree, K::rows> forms;
  for (std::size_t i = 0; i < K::count; ++i) {
    std::copy(tube.g[i].begin(), tube.g[i].end(), forms.g[i]);
    std::copy(tube.h[i].begin(), tube.h[i].end(), forms.h[i]);
    std::copy(tube.space[i].begin(), tube.space[i].end(), forms.space[i]);
  }
  for (auto& term : forms.series) {
    std::fill(std::begin(term), std::end(term), 0.0);
  }
  forms.series[0][tube.axis] = 1;
  for (std::size_t row = 0; row < K::rows; ++row) {
    const std::size_t j = tube.others[row];
    forms.series[0][j] = tube.slope[j];
    forms.series[1][j] = 0.5 * tube.second[j];
    for (std::size_t k = 0; k < tube.further.size(); ++k) {
      forms.series[k + 2][j] = tube.further[k][row];
    }
    forms.others[row] = static_cast<int>(j);
    forms.farthest[row] = tube.halfwidth[j] / kSlack - kPlaceRounding;
  }
  std::copy(tube.centre.begin(), tube.centre.end(), forms.centre);
  std::copy(pair.frame.origin.begin(), pair.frame.origin.end(), forms.origin);
  forms.scale = std::ldexp(1.0, static_cast<int>(pair.frame.exponent));
  forms.greatest = greatest;
  return forms;
}

bool has_vertex_lanes() {
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

template <int Degree, int Rows>
void evaluate_vertices(const VertexFormsOf<Degree, Rows>& forms, VertexBlock& block) {
#ifdef __x86_64__
  static const bool lanes = has_vertex_lanes();
  if (lanes) {
    evaluate_vertices_lanes(forms, block);
    return;
  }
#endif
  evaluate_vertices_scalar(forms, block);
}

#define EXSECT_INSTANTIATE(K)                                                                             \
  template void expand_arc<K>(TubeOf<K>&);                                                                \
  template Unknowns<K> arc_offset<K>(const TubeOf<K>&, double);                                           \
  template Unknowns<K> arc_slope<K>(const TubeOf<K>&, double);                                            \
  template double arc_second<K>(const TubeOf<K>&, double, std::size_t);                                   \
  template VertexFormsOf<K::degree, K::rows> vertex_forms<K>(const PairOf<K>&, const TubeOf<K>&, double); \
  template void evaluate_vertices<K::degree, K::rows>(const VertexFormsOf<K::degree, K::rows>&, VertexBlock&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
