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
// plus what products of lower ones give.
void expand_arc(Tube& tube) {
  Series a{}, b{}, aa{}, ab{}, bb{}, aab{}, abb{}, aabb{};
  const std::array<Series*, 4> coordinate = {&a, &b, &a, &b};
  for (std::size_t j = 0; j < 4; ++j) {
    (*coordinate[j])[1][j / 2] = tube.slope[j];
  }
  for (std::size_t k = 2; k <= kDegree; ++k) {
    add_product(aa, a, 1, a, 1, k);
    add_product(ab, a, 1, b, 1, k);
    add_product(bb, b, 1, b, 1, k);
    add_product(aab, aa, 2, b, 1, k);
    add_product(abb, bb, 2, a, 1, k);
    add_product(aabb, aa, 2, bb, 2, k);
    for (std::size_t row = 0; row < 3; ++row) {
      double sum = 0;
      for (std::size_t side = 0; side < 2; ++side) {
        const Coefficients& c = side == 0 ? tube.g : tube.h;
        sum += c[6][row] * aa[k][side] + c[4][row] * ab[k][side] + c[2][row] * bb[k][side] +
               c[7][row] * aab[k][side] + c[5][row] * abb[k][side] + c[8][row] * aabb[k][side];
      }
      const std::size_t j = tube.others[row];
      (*coordinate[j])[k][j / 2] = -sum;
      if (k > 2) {
        tube.further[k - 3][row] = -sum;
      }
    }
  }
}

Vec4 arc_offset(const Tube& tube, double tau) {
  Vec4 offset;
  offset[tube.axis] = tau;
  for (std::size_t row = 0; row < 3; ++row) {
    const std::size_t j = tube.others[row];
    double sum = 0;
    for (std::size_t k = tube.further.size(); k-- > 0;) {
      sum = tau * (tube.further[k][row] + sum);
    }
    offset[j] = tau * (tube.slope[j] + tau * (0.5 * tube.second[j] + sum));
  }
  return offset;
}

Vec4 arc_slope(const Tube& tube, double tau) {
  Vec4 slope;
  slope[tube.axis] = 1;
  for (std::size_t row = 0; row < 3; ++row) {
    const std::size_t j = tube.others[row];
    double sum = 0;
    for (std::size_t k = tube.further.size(); k-- > 0;) {
      sum = tau * (static_cast<double>(k + 3) * tube.further[k][row] + sum);
    }
    slope[j] = tube.slope[j] + tau * (tube.second[j] + sum);
  }
  return slope;
}

double arc_second(const Tube& tube, double tau, std::size_t i) {
  const std::size_t row = i < tube.axis ? i : i - 1;
  double sum = 0;
  for (std::size_t k = tube.further.size(); k-- > 0;) {
    sum = tau * (static_cast<double>((k + 3) * (k + 2)) * tube.further[k][row] + sum);
  }
  return tube.second[i] + sum;
}

VertexForms vertex_forms(const Pair& pair, const Tube& tube, double greatest) {
  VertexForms forms;
  for (std::size_t i = 0; i < 9; ++i) {
    std::copy(tube.g[i].begin(), tube.g[i].end(), forms.g[i]);
    std::copy(tube.h[i].begin(), tube.h[i].end(), forms.h[i]);
    std::copy(tube.space[i].begin(), tube.space[i].end(), forms.space[i]);
  }
  for (auto& term : forms.series) {
    std::fill(std::begin(term), std::end(term), 0.0);
  }
  forms.series[0][tube.axis] = 1;
  for (std::size_t row = 0; row < 3; ++row) {
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

void evaluate_vertices(const VertexForms& forms, VertexBlock& block) {
#ifdef __x86_64__
  static const bool lanes = has_vertex_lanes();
  if (lanes) {
    evaluate_vertices_lanes(forms, block);
    return;
  }
#endif
  evaluate_vertices_scalar(forms, block);
}

}  // namespace exsect::filter
