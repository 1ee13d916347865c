// Boxes of a chart of pairs, and places in which all pairs of a self-intersection are known. Internal to
// solver/.
#pragma once

#include <exsect/solver/parameter.h>

#include <array>
#include <functional>
#include <vector>

#include "self/chart.h"
#include "shape/injective_rectangle.h"
#include "trace/breadth_first.h"

namespace exsect {

/// Of U, V, m, w.
using ChartBox = SearchRegion;

/// u1, v1, u2 and v2 over the pairs of a box of a chart, to within 2^-48: they may lie outside of the square.
SearchRegion pair_bounds(Chart chart, const ChartBox& box);

/// All pairs of the chart: U and V in [0,1], m in [-1,1], w in [0,1/4].
inline constexpr ChartBox whole_chart = {{0, 0, -1, 0}, {1, 1, 1, 0.25}};

/// True only if no point of the box has both U +- t and V +- m t in [0,1] (7.5).
bool outside(const ChartBox& box);

/// Rectangles on which the patch is injective, and boxes of pairs (u1,v1,u2,v2) in which all pairs are known,
/// with double ends that are exact: no pair of two points of one of the rectangles, and none that is in one
/// of the boxes in either order, is looked for.
class KnownPlaces {
 public:
  explicit KnownPlaces(const std::vector<ParameterRectangle>& rectangles,
                       const std::vector<ParameterBox>& boxes = {});

  /// True only if all pairs of the box that are in the square are known.
  bool contain(Chart chart, const ChartBox& box) const;

  /// Asked as well, unless empty: true only if all of them are known.
  std::function<bool(Chart, const ChartBox&)> further;

 private:
  /// Lower and upper ends of u1, v1, u2, v2; infinite on a side of the square.
  struct Place {
    std::array<double, 4> lower;
    std::array<double, 4> upper;
  };
  std::vector<Place> places_;
};

}  // namespace exsect
