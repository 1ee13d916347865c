#include "answer/certified_point.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace exsect {

CertifiedPoint::CertifiedPoint(std::shared_ptr<const Source> source, const Rational& width,
                               std::vector<Side> sides, int multiplicity, int branch)
    : source_(std::move(source)),
      box_(source_->box(width)),
      sides_(std::move(sides)),
      multiplicity_(multiplicity),
      branch_(branch) {}

CertifiedPoint::CertifiedPoint(std::shared_ptr<const Source> source, ParameterBox box,
                               std::vector<Side> sides, int multiplicity)
    : source_(std::move(source)),
      box_(std::move(box)),
      sides_(std::move(sides)),
      multiplicity_(multiplicity) {}

int CertifiedPoint::Source::branch() const {
  throw std::invalid_argument("certified point: the branch is not known");
}

CertifiedPoint CertifiedPoint::refined_to(const Rational& width) const {
  const ParameterBox finer = source_->box(width);
  CertifiedPoint result = *this;
  for (std::size_t i = 0; i < finer.size(); ++i)
    result.box_[i] = {std::max(box_[i].lower, finer[i].lower), std::min(box_[i].upper, finer[i].upper)};
  return result;
}

bool CertifiedPoint::on(Side side) const { return std::ranges::find(sides_, side) != sides_.end(); }

}  // namespace exsect
