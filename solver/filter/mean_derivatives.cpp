#include "filter/mean_derivatives.h"

#include <cmath>

namespace exsect::filter {

namespace {

/// row.(the derivative of order (a,b), a, b <= 1): the coefficient of h^i k^j of it is i^a j^b times that of
/// h^(i+a) k^(j+b) of the patch.
template <class K>
MeanDerivative mean_of_order(const RectangleExpansionOf<K>& x, const Row<K>& row, std::size_t a,
                             std::size_t b) {
  MeanDerivative result{dot(row, x.at_middle[K::side * a + b]), 0};
  double power_of_h = 1;
  for (std::size_t i = a; i < K::side; ++i) {
    double power = power_of_h;
    for (std::size_t j = b; j < K::side; ++j) {
      if (i > a || j > b) {
        const double factor = static_cast<double>((a == 1 ? i : 1) * (b == 1 ? j : 1));
        result.deviation += factor * std::fabs(dot(row, x.at_middle[K::side * i + j])) * power;
      }
      power *= x.half[1];
    }
    power_of_h *= x.half[0];
  }
  return result;
}

}  // namespace

template <class K>
std::optional<RectangleExpansionOf<K>> expand(const PatchOf<K>& patch, const Rectangle& where) {
  std::array<double, 2> middle;
  std::array<double, 2> half;
  for (std::size_t i = 0; i < 2; ++i) {
    middle[i] = 0.5 * (where.lower[i] + where.upper[i]);
    half[i] = kSlack * (0.5 * (where.upper[i] - where.lower[i]) + kSumRounding);
    if (!(std::fabs(middle[i]) + half[i] <= kReach)) {
      return std::nullopt;
    }
  }
  return RectangleExpansionOf<K>{expand(patch, middle[0], middle[1]), half};
}

template <class K>
MeanDerivative mean_first(const RectangleExpansionOf<K>& x, const Row<K>& row) {
  return mean_of_order<K>(x, row, 1, 0);
}

template <class K>
MeanDerivative mean_second(const RectangleExpansionOf<K>& x, const Row<K>& row) {
  return mean_of_order<K>(x, row, 0, 1);
}

template <class K>
MeanDerivative mean_value(const RectangleExpansionOf<K>& x, const Row<K>& row) {
  return mean_of_order<K>(x, row, 0, 0);
}

#define EXSECT_INSTANTIATE(K)                                                                     \
  template std::optional<RectangleExpansionOf<K>> expand<K>(const PatchOf<K>&, const Rectangle&); \
  template MeanDerivative mean_first<K>(const RectangleExpansionOf<K>&, const Row<K>&);           \
  template MeanDerivative mean_second<K>(const RectangleExpansionOf<K>&, const Row<K>&);          \
  template MeanDerivative mean_value<K>(const RectangleExpansionOf<K>&, const Row<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
