// The star of a graph and its plane in the middle of the square.
#pragma once

#include <exsect/solver/line_patch.h>

#include <optional>

#include "star/star_neighbourhood.h"
#include "support/catch.h"
#include "support/graph_patches.h"

namespace exsect::testing {

inline std::vector<CertifiedPoint> points_on_sides(const BezierPatch& x, const BezierPatch& y) {
  std::vector<CertifiedPoint> boundary;
  for (const Parameter p : all_parameters)
    for (const int value : {0, 1})
      for (const CertifiedPoint& point : line_points(x, y, {p, value}).points)
        if (point.sides().front() == Side{p, value}) boundary.push_back(point);
  return boundary;
}

/// The star of G[h] and the plane at u = v = 1/2, over a turning value of the sweep.
inline std::optional<StarNeighbourhood> star_at_centre(const BezierPatch& x, const BezierPatch& y,
                                                       Parameter sweep, double halfwidth) {
  const Rational half(1, 2);
  ExactPair pair(x, y);
  const auto& turning = pair.turning(sweep);
  REQUIRE(turning);
  const std::vector<CertifiedPoint> boundary = points_on_sides(x, y);
  const StarPlaces places = {boundary, Parameter::s, {}};
  const StarQuery query = {pair, places, *turning, halfwidth};
  for (const CertifiedPoint& point : line_points(x, y, {sweep, half}).points) {
    const ParameterBox box = point.box();
    if (box[0].lower <= half && half <= box[0].upper && box[1].lower <= half && half <= box[1].upper)
      return star_neighbourhood(query, point, half);
  }
  return std::nullopt;
}

/// a = u - 1/2 and b = v - 1/2.
inline const Terms kFromMiddleU = {{{1, 0}, 1}, {{0, 0}, Rational(-1, 2)}};
inline const Terms kFromMiddleV = {{{0, 1}, 1}, {{0, 0}, Rational(-1, 2)}};

}  // namespace exsect::testing
