#include "intersect_as_curve.h"

#include <memory>
#include <utility>

#include "exchanged_order.h"
#include "special/intersect_by_inverse.h"

namespace exsect {
namespace {

/// By the inverse of the second patch, in one order of the patches: its curve is found once.
class OrderByInverse {
 public:
  explicit OrderByInverse(std::optional<PatchInverse> of_second) : inverse_(std::move(of_second)) {}

  /// Empty if nothing is known, or the curve or the rim of an overlap goes through a pole of the second patch
  /// or does not, other than is asked for.
  std::optional<IntersectResult> result(const RationalPatch& first, const RationalPatch& second,
                                        const Run& run, bool through_pole) {
    if (!is_asked_ && inverse_) curve_ = curve_by_inverse(first, second, *inverse_, run);
    is_asked_ = true;
    const bool is_clear = curve_ && curve_->in_poles.empty() && curve_->rim_poles.empty();
    if (!curve_ || is_clear == through_pole) return std::nullopt;
    auto result = intersect_by_inverse(curve_, run);
    return result && result->status == Status::complete ? std::move(result) : std::nullopt;
  }

 private:
  std::optional<PatchInverse> inverse_;
  std::shared_ptr<const InverseCurve> curve_;
  bool is_asked_ = false;
};

}  // namespace

std::optional<IntersectResult> intersect_as_curve(const RationalPatch& x, const RationalPatch& y,
                                                  const Run& run) {
  const std::optional<PatchInverse> of_x = patch_inverse(x), of_y = patch_inverse(y);
  OrderByInverse by_y(of_y), by_x(of_x);
  const auto in_order = [&](bool through_pole) { return by_y.result(x, y, run, through_pole); };
  const auto exchanged = [&](bool through_pole) {
    return in_exchanged_order(x, y, run,
                              [&](const RationalPatch& first, const RationalPatch& second, const Run& given) {
                                return by_x.result(first, second, given, through_pole);
                              });
  };
  const auto degrees = [](const RationalPatch& patch, const PatchInverse& inverse) {
    return inverse.equation.degree * (patch.degree_u() + patch.degree_v());
  };
  const bool is_exchanged = of_x && of_y && degrees(y, *of_x) < degrees(x, *of_y);
  for (const bool through_pole : {false, true}) {
    auto result = is_exchanged ? exchanged(through_pole) : in_order(through_pole);
    if (!result) result = is_exchanged ? in_order(through_pole) : exchanged(through_pole);
    if (result) return result;
  }
  return std::nullopt;
}

}  // namespace exsect
