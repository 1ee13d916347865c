#include "line/line_points_in.h"

#include <algorithm>

#include "answer/parameter_box.h"
#include "line/exact_line_points.h"
#include "line/line_place.h"

namespace exsect {

namespace {

bool meets_curve(const LinePoints& line, const LineQuery& query, const ParameterBox& region) {
  const RationalInterval& range = region[index(line_place(query).roles.line)];
  return std::any_of(line.on_patch.begin(), line.on_patch.end(), [&](const AlgebraicInterval& part) {
    return part.from.compare(range.upper) <= 0 && part.to.compare(range.lower) >= 0;
  });
}

}  // namespace

std::optional<CertifiedPoint> decided(CertifiedPoint point, const ParameterBox& region) {
  for (Rational width = power_of_two(-100); meet(point.box(), region) && !lies_in(point.box(), region);
       width *= width) {
    if (width < power_of_two(-2000)) {
      return std::nullopt;
    }
    point = point.refined_to(width);
  }
  return point;
}

bool surely_lies_in(const CertifiedPoint& point, const ParameterBox& region) {
  const auto refined = decided(point, region);
  return refined && lies_in(refined->box(), region);
}

ParameterBox box_apart(CertifiedPoint point, std::size_t own, const std::vector<CertifiedPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    CertifiedPoint other = points[i];
    for (Rational width = power_of_two(-100);
         i != own && meet(point.box(), other.box()) && width > power_of_two(-2000); width *= width) {
      point = point.refined_to(width);
      other = other.refined_to(width);
    }
  }
  return point.box();
}

std::optional<std::vector<CertifiedPoint>> line_points_in(const BezierPatch& x, const BezierPatch& y,
                                                          const LineQuery& query,
                                                          const ParameterBox& region) {
  const LinePoints line = exact_line_points(x, y, query);
  if (line.incomplete || meets_curve(line, query, region)) {
    return std::nullopt;
  }
  std::vector<CertifiedPoint> inside;
  for (const CertifiedPoint& point : line.points) {
    const auto refined = decided(point, region);
    if (!refined) {
      return std::nullopt;
    }
    if (meet(refined->box(), region)) {
      inside.push_back(*refined);
    }
  }
  return inside;
}

}  // namespace exsect
