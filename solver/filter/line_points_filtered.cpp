#include "filter/line_points_filtered.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/solver/line_points.h>

#include <algorithm>
#include <utility>

#include "filter/line.h"
#include "line/line_place.h"
#include "line/point_in_box.h"

namespace exsect {
namespace {

/// Ascending in the parameter `kept`; false if the balls do not tell the order.
bool sort_along(std::vector<filter::Ball>& balls, std::size_t kept) {
  std::ranges::sort(balls, {}, [&](const filter::Ball& ball) { return ball.middle[kept]; });
  return std::ranges::adjacent_find(balls, [&](const filter::Ball& a, const filter::Ball& b) {
           return !(b.middle[kept] - a.middle[kept] >
                    filter::kSlack * (a.radius + b.radius) + filter::kPlaceRounding);
         }) == balls.end();
}

ParameterBox query_box(const filter::Ball& ball, const LineQuery& query) {
  ParameterBox box;
  for (std::size_t j = 0; j < 4; ++j) box[j] = filter::interval(ball, j);
  box[index(query.fixed)] = {query.value, query.value};
  return box;
}

}  // namespace

LinePoints line_points_filtered(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  return in_nearest_rounding([&]() -> LinePoints {
    const LinePlace place = line_place(query);
    const auto pair = filter::make_pair(x, y);
    if (!pair) return line_points(x, y, query);
    const filter::Line line = filter::centred_line(query.fixed, {query.value, query.value});
    filter::PatchTree other(line.fixed < 2 ? pair->y : pair->x);
    long boxes = 0;
    auto balls = filter::points_on_line(*pair, line, {}, other, boxes);
    if (!balls || !sort_along(*balls, index(place.roles.second))) return line_points(x, y, query);
    LinePoints result;
    if (balls->empty()) return result;
    const auto problem = std::make_shared<const LineProblem>(LineProblem{x, y, query});
    for (const filter::Ball& ball : *balls) {
      result.points.push_back(point_in_box(problem, query_box(ball, query)));
    }
    return result;
  });
}

}  // namespace exsect
