#include "intersect_rational.h"

#include "intersect.h"
#include "self/self_intersect.h"

namespace exsect {
namespace {

BezierPatch biquadratic(const RationalPatch& patch) {
  const std::optional<BezierPatch> result = patch.biquadratic();
  if (!result) throw NotSupported(patch);
  return *result;
}

}  // namespace

IntersectResult intersect(const RationalPatch& x, const RationalPatch& y, const IntersectOptions& options) {
  return intersect(biquadratic(x), biquadratic(y), options);
}

IntersectResult self_intersect(const RationalPatch& x, const IntersectOptions& options) {
  return self_intersect(biquadratic(x), options);
}

}  // namespace exsect
