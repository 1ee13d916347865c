// What exact arithmetic knows of turning points that doubles do not decide. Internal to solver/;
// docs/method-doubles.md, section 14.13.
#pragma once

#include <array>
#include <vector>

#include "filter/boundary.h"
#include "filter/exact_patch.h"
#include "filter/turning.h"
#include "shape/coincident_parameters.h"
#include "shape/section.h"

namespace exsect::filter {

/// Of one pair; nothing is computed before the first question.
template <class K>
class ExactTurning {
 public:
  ExactTurning(const ExactPatch<K>& x, const ExactPatch<K>& y) : x_(x), y_(y) {}

  /// Parameters that turn together; those that are constant along the trace, or turn exactly at its ends,
  /// where a patch lies on a plane or a quadric.
  void add_to(KnownTurning<K>& known, const TraceOf<K>& trace, const std::vector<BoundaryPointOf<K>>& points);

 private:
  void ask();
  /// Sets what turns at the point.
  void add_turning_at(const BoundaryPointOf<K>& point, std::array<bool, 4>& turning) const;

  const ExactPatch<K>& x_;
  const ExactPatch<K>& y_;
  bool is_asked_ = false;
  CoincidentParameters coincident_;
  std::vector<Section> sections_;
};

}  // namespace exsect::filter
