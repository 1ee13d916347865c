#include <algorithm>
#include <utility>

#include "filter_line.h"
#include "line_patch.h"
#include "line_place.h"
#include "parameter_box.h"

namespace exsect {
namespace {

/// The question, kept for refining the points of its answer.
struct Problem {
  BezierPatch x;
  BezierPatch y;
  LineQuery query;
};

/// The only point of the line in a box; anything narrower than the box comes from the exact points.
class PointInBox : public CertifiedPoint::Source {
 public:
  PointInBox(std::shared_ptr<const Problem> problem, ParameterBox box)
      : problem_(std::move(problem)), box_(std::move(box)) {}

  ParameterBox box(const Rational& width) const override {
    const bool narrow =
        std::ranges::all_of(box_, [&](const RationalInterval& side) { return side.width() <= width; });
    return narrow ? box_ : exact().refined_to(width).box();
  }
  int branch() const override { return exact().branch(); }

 private:
  CertifiedPoint exact() const {
    std::vector<CertifiedPoint> candidates = line_points(problem_->x, problem_->y, problem_->query).points;
    for (Rational width = power_of_two(-64);; width *= width) {
      std::erase_if(candidates, [&](const CertifiedPoint& p) { return !meet(p.box(), box_); });
      if (candidates.size() == 1) return candidates.front();
      for (CertifiedPoint& p : candidates) p = p.refined_to(width);
    }
  }

  std::shared_ptr<const Problem> problem_;
  ParameterBox box_;
};

filter::Line centred(const LineQuery& query) {
  const NearestDouble value = nearest_double(query.value - Rational(1, 2));
  return {index(query.fixed), value.value, value.exact ? 0 : 0x1p-54};
}

/// Ascending in the parameter `kept`; false if the balls do not tell the order.
bool sort_along(std::vector<filter::Ball>& balls, std::size_t kept) {
  std::ranges::sort(balls, {}, [&](const filter::Ball& ball) { return ball.middle[kept]; });
  return std::ranges::adjacent_find(balls, [&](const filter::Ball& a, const filter::Ball& b) {
           return !(b.middle[kept] - a.middle[kept] > filter::kSlack * (a.radius + b.radius) + 0x1p-50);
         }) == balls.end();
}

ParameterBox box_of(const filter::Ball& ball, const LineQuery& query) {
  ParameterBox box;
  for (std::size_t j = 0; j < 4; ++j) box[j] = filter::interval(ball, j);
  box[index(query.fixed)] = {query.value, query.value};
  return box;
}

std::vector<Side> sides_of(const LineQuery& query) {
  if (query.value == 0) return {{query.fixed, 0}};
  if (query.value == 1) return {{query.fixed, 1}};
  return {};
}

}  // namespace

LinePoints line_points_filtered(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  const LinePlace place = line_place(query);
  const auto pair = filter::make_pair(x, y);
  if (!pair) return line_points(x, y, query);
  const filter::Line line = centred(query);
  filter::PatchTree other(line.fixed < 2 ? pair->y : pair->x);
  long boxes = 0;
  auto balls = filter::points_on_line(*pair, line, {}, other, boxes);
  if (!balls || !sort_along(*balls, index(place.roles.second))) return line_points(x, y, query);
  LinePoints result;
  if (balls->empty()) return result;
  const auto problem = std::make_shared<const Problem>(Problem{x, y, query});
  for (const filter::Ball& ball : *balls) {
    const ParameterBox box = box_of(ball, query);
    result.points.emplace_back(std::make_shared<PointInBox>(problem, box), box, sides_of(query), 1);
  }
  return result;
}

}  // namespace exsect
