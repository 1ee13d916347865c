#include "intersect_rational.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/parameter_names.h"
#include "answer/proof.h"
#include "answer/run.h"
#include "eliminant/weighted_eliminant.h"
#include "filter/exact_patch.h"
#include "filter/filter.h"
#include "intersect.h"
#include "intersect_at_pole.h"
#include "intersect_within.h"
#include "overlap/rational_pieces.h"
#include "self/self_intersect.h"
#include "self/self_intersect_in_doubles.h"
#include "signs_beside.h"
#include "special/intersect_by_inverse.h"
#include "special/polynomial_images.h"

namespace exsect {

namespace {

/// What `solve` finds of y and x, if it does, as a result of x and y.
template <class Solve>
std::optional<IntersectResult> in_exchanged_order(const RationalPatch& x, const RationalPatch& y,
                                                  const Run& run, const Solve& solve) {
  const OtherRun exchanged = [](const Run& given) {
    std::vector<Parameter> turning;
    for (const Parameter p : given.turning()) turning.push_back(all_parameters[(index(p) + 2) % 4]);
    return given.with_turning(std::move(turning));
  };
  std::optional<IntersectResult> other = solve(y, x, exchanged(run));
  if (!other || other->status != Status::complete) return std::nullopt;
  const auto rename = [](IntersectResult& renamed, const Run&) {
    rename_parameters(renamed, {Parameter::r, Parameter::s, Parameter::u, Parameter::v});
  };
  return changed(*std::move(other), run, rename, exchanged);
}

/// Doubles may decide in one order of the patches what they do not in the other one.
IntersectResult intersect_in_either_order(const RationalPatch& x, const RationalPatch& y, const Run& run) {
  IntersectResult result = intersect_in_doubles(x, y, run);
  if (result.status == Status::complete || run.out_of_time()) return result;
  auto other = in_exchanged_order(x, y, run, intersect_in_doubles);
  return other ? *std::move(other) : result;
}

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

/// By an equation on one of them, if the other one has an inverse; empty where that decides nothing. The
/// curve of less degree first, those that go through a pole of the patch with the inverse last.
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

/// By polynomial patches, if x and y are images of some (14.20); empty otherwise.
std::optional<IntersectResult> intersect_as_polynomials(const RationalPatch& x, const RationalPatch& y,
                                                        const Run& run) {
  const auto images = polynomial_images(x, y);
  if (!images) return std::nullopt;
  std::vector<Point> points;
  for (const RationalPatch* patch : {&x, &y})
    std::ranges::copy(affine_points(patch->reduced()), std::back_inserter(points));
  const double extent = to_double(model_extent(points));
  const double grown = growth(*images, points) * to_double(model_extent(images->x, images->y));
  const OtherRun of_images = [extent, grown](const Run& given) {
    return given.with_tolerance(given.tolerance(extent) / grown);
  };
  const ResultChange change = [images, extent](IntersectResult& result, const Run& given) {
    put_back(*images, result);
    result.coarse = coarse_drawing(result.graph, given.tolerance(extent));
  };
  return changed(intersect_in_place(of_images(run), images->x, images->y), run, change, of_images);
}

/// In doubles, or by what is behind them for polynomial patches.
IntersectResult intersect_any(const RationalPatch& x, const RationalPatch& y, const Run& run) {
  IntersectResult result = intersect_in_either_order(x, y, run);
  if (result.status == Status::complete || run.out_of_time()) return result;
  // Polynomial patches first: an image of a pair then has the nodes of the pair itself.
  auto as_polynomials = intersect_as_polynomials(x, y, run);
  if (as_polynomials && as_polynomials->status == Status::complete) return *std::move(as_polynomials);
  if (auto as_curve = intersect_as_curve(x, y, run)) return *std::move(as_curve);
  if (auto at_pole = intersect_at_pole(x, y, run, intersect_any)) return *std::move(at_pole);
  if (as_polynomials) return *std::move(as_polynomials);
  if (run.exact()) return result;
  IntersectResult pieces = intersect_rational_pieces(x, y, run);
  if (pieces.status != Status::complete) return result;
  run.count("filtered", 1);
  return pieces;
}

/// Of any pair, whatever it is like beside that.
bool has_exact_method(const RationalPatch& x, const RationalPatch& y) {
  return !eliminant_sweeps(x, y).empty() || polynomial_images(x, y).has_value();
}

}  // namespace

IntersectResult intersect(const RationalPatch& x, const RationalPatch& y, const IntersectOptions& options) {
  const auto first = x.biquadratic();
  const auto second = y.biquadratic();
  if (first && second) return intersect(*first, *second, options);
  return in_nearest_rounding([&]() -> IntersectResult {
    const Run run(options);
    IntersectResult result = with_signs_beside(x, y, run, [&](const Run& part) {
      return answered(part, [&] { return intersect_any(x, y, part); });
    });
    if (result.status != Status::complete && options.exact && !has_exact_method(x, y) && !run.out_of_time())
      throw NotSupported("exact arithmetic for " + kind_of(x) + " and " + kind_of(y));
    if (result.status != Status::complete && !options.exact) run.count("filtered", 1);
    const auto again = [x, y](const IntersectOptions& other) { return intersect(x, y, other); };
    return answer_to(options, run.finished(std::move(result)), again);
  });
}

IntersectResult self_intersect(const RationalPatch& x, const IntersectOptions& options) {
  const auto patch = x.biquadratic();
  if (patch) return self_intersect(*patch, options);
  if (options.exact) throw NotSupported(x);
  return in_nearest_rounding([&]() -> IntersectResult {
    const Run run(options);
    IntersectResult result = answered(run, [&] {
      run.count("filtered", 1);
      return self_intersect_in_doubles(x, run);
    });
    const auto again = [x](const IntersectOptions& other) { return self_intersect(x, other); };
    return answer_to(options, run.finished(std::move(result)), again);
  });
}

}  // namespace exsect
