#include "intersect_rational.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/proof.h"
#include "answer/run.h"
#include "eliminant/weighted_eliminant.h"
#include "exchanged_order.h"
#include "filter/exact_patch.h"
#include "filter/filter.h"
#include "intersect.h"
#include "intersect_as_curve.h"
#include "intersect_at_pole.h"
#include "intersect_within.h"
#include "overlap/rational_pieces.h"
#include "self/self_intersect.h"
#include "self/self_intersect_in_doubles.h"
#include "signs_beside.h"
#include "special/polynomial_images.h"

namespace exsect {

namespace {

/// Doubles may decide in one order of the patches what they do not in the other one.
IntersectResult intersect_in_either_order(const RationalPatch& x, const RationalPatch& y, const Run& run) {
  IntersectResult result = intersect_in_doubles(x, y, run);
  if (result.status == Status::complete || run.out_of_time()) return result;
  auto other = in_exchanged_order(x, y, run, intersect_in_doubles);
  return other ? *std::move(other) : result;
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
