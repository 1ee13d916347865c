#include "self/known_places.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace exsect {

/// Sums of two doubles and products of at most three: the relative slack covers their rounding.
bool outside(const ChartBox& box) {
  const double w = box.lower[3] * kReduced;
  const double least_m = box.lower[2] > 0 ? box.lower[2] : box.upper[2] < 0 ? -box.upper[2] : 0;
  const auto reach2 = [](double lower, double upper) {
    const double reach = std::max(0.0, std::min(upper, 1 - lower));
    return reach * reach * kSlack + kUnderflowLoss;
  };
  return reach2(box.lower[0], box.upper[0]) < w ||
         reach2(box.lower[1], box.upper[1]) < least_m * least_m * w || box.upper[3] < 0;
}

KnownPlaces::KnownPlaces(const std::vector<ParameterRectangle>& rectangles,
                         const std::vector<ParameterBox>& boxes) {
  const auto add = [&](const ParameterBox& box) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Place place{};
    for (std::size_t j = 0; j < 4; ++j) {
      place.lower[j] = box[j].lower == 0 ? -kFar : to_double(box[j].lower);
      place.upper[j] = box[j].upper == 1 ? kFar : to_double(box[j].upper);
    }
    places_.push_back(place);
  };
  for (const auto& [u, v] : rectangles) add({u, v, u, v});
  for (const ParameterBox& box : boxes) {
    add(box);
    add({box[2], box[3], box[0], box[1]});
  }
}

SearchRegion pair_bounds(Chart chart, const ChartBox& box) {
  const double t0 = std::sqrt(std::max(0.0, box.lower[3])) * kReduced;
  const double t1 = std::sqrt(std::max(0.0, box.upper[3])) * kSlack;
  const auto products = {box.lower[2] * t0, box.lower[2] * t1, box.upper[2] * t0, box.upper[2] * t1};
  const double least = std::min(products);
  const double most = std::max(products);
  // U + t, V + m t, U - t, V - m t; a relative error of 2^-50 for each product and sum.
  SearchRegion pairs = {{box.lower[0] + t0, box.lower[1] + least, box.lower[0] - t1, box.lower[1] - most},
                        {box.upper[0] + t1, box.upper[1] + most, box.upper[0] - t0, box.upper[1] - least}};
  if (chart == Chart::second) {
    for (const std::size_t j : {0U, 2U}) {
      std::swap(pairs.lower[j], pairs.lower[j + 1]);
      std::swap(pairs.upper[j], pairs.upper[j + 1]);
    }
  }
  return pairs;
}

bool KnownPlaces::contain(Chart chart, const ChartBox& box) const {
  if (further && further(chart, box)) return true;
  if (places_.empty()) return false;
  const SearchRegion pairs = pair_bounds(chart, box);
  return std::ranges::any_of(places_, [&](const Place& place) {
    for (std::size_t j = 0; j < 4; ++j)
      if (!(pairs.lower[j] - 0x1p-48 >= place.lower[j] && pairs.upper[j] + 0x1p-48 <= place.upper[j]))
        return false;
    return true;
  });
}

}  // namespace exsect
