#include "line/point_in_box.h"

#include <algorithm>
#include <utility>

#include "answer/parameter_box.h"
#include "line/exact_line_points.h"

namespace exsect {
namespace {

class PointInBox : public CertifiedPoint::Source {
 public:
  PointInBox(std::shared_ptr<const LineProblem> problem, ParameterBox box)
      : problem_(std::move(problem)), box_(std::move(box)) {}

  ParameterBox box(const Rational& width) const override {
    const bool narrow =
        std::ranges::all_of(box_, [&](const RationalInterval& side) { return side.width() <= width; });
    return narrow ? box_ : exact().refined_to(width).box();
  }
  int branch() const override { return exact().branch(); }
  std::optional<ExactParameters> exact_parameters() const override { return exact().exact(); }

 private:
  CertifiedPoint exact() const {
    std::vector<CertifiedPoint> candidates =
        exact_line_points(problem_->x, problem_->y, problem_->query).points;
    for (Rational width = power_of_two(-64);; width *= width) {
      std::erase_if(candidates, [&](const CertifiedPoint& p) { return !meet(p.box(), box_); });
      if (candidates.size() == 1) return candidates.front();
      for (CertifiedPoint& p : candidates) p = p.refined_to(width);
    }
  }

  std::shared_ptr<const LineProblem> problem_;
  ParameterBox box_;
};

std::vector<Side> sides_of(const LineQuery& query) {
  if (query.value == 0) return {{query.fixed, 0}};
  if (query.value == 1) return {{query.fixed, 1}};
  return {};
}

}  // namespace

CertifiedPoint point_in_box(const std::shared_ptr<const LineProblem>& problem, const ParameterBox& box) {
  return {std::make_shared<PointInBox>(problem, box), box, sides_of(problem->query), 1};
}

}  // namespace exsect
