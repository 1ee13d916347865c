#include "filter/filter.h"

#include <algorithm>

#include "answer/finished_result.h"
#include "answer/parameter_box.h"
#include "answer/parameter_names.h"
#include "answer/placed_result.h"
#include "answer/proof.h"
#include "filter/affine_parameters.h"
#include "filter/ended_search.h"
#include "filter/filtered_intersection.h"
#include "filter/magnified_box.h"

namespace exsect {

namespace {

using filter::ExactPatch;

/// Boxes that are tried in one pair, and boxes in boxes, of a width of 2^-12 each.
constexpr int kMostMagnified = 4;
constexpr int kDeepestMagnified = 6;

IntersectResult intersect_pieces(const RationalPatch& x, const RationalPatch& y, const Run& run, int depth);

/// With the solutions near the places at which the search for closed curves ends; empty if these, or others,
/// are not decided.
template <class K>
std::optional<IntersectResult> with_magnified_boxes(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                    double extent, filter::Filtered known, const Run& run,
                                                    int depth) {
  if (depth == kDeepestMagnified) return std::nullopt;
  const RationalPatch first = filter::rational_patch(x), second = filter::rational_patch(y);
  const auto solve = [depth](const RationalPatch& a, const RationalPatch& b, const Run& part) {
    return intersect_pieces(a, b, part, depth + 1);
  };
  std::vector<filter::MagnifiedBox> boxes;
  for (int tries = 0; tries < kMostMagnified && known.stuck && known.among_closed; ++tries) {
    const auto inside = [&](ParameterBox where) {
      const auto becomes_part = [&where](const filter::MagnifiedBox& box) {
        const bool is_near = meet(box.where, where);
        if (is_near) where = hull(box.where, where);
        return is_near;
      };
      while (std::erase_if(boxes, becomes_part) > 0) continue;
      return filter::magnified(first, second, where, extent, run, solve);
    };
    auto box = inside(filter::box_to_magnify(*known.stuck));
    if (box && box->meets_side) box = inside(filter::widened(box->where));
    if (!box || box->meets_side) return std::nullopt;
    boxes.push_back(*std::move(box));
    std::vector<ParameterBox> all;
    for (const filter::MagnifiedBox& each : boxes) all.push_back(each.where);
    known = filter::filtered_intersection<K>(x, y, run, false, std::move(all));
    if (known.result) return filter::joined(*std::move(known.result), std::move(boxes), extent, run);
  }
  return std::nullopt;
}

template <class K>
IntersectResult solved_pair(const ExactPatch<K>& x, const ExactPatch<K>& y, const Run& run, int depth) {
  filter::Filtered known = filter::filtered_intersection<K>(x, y, run, false);
  if (known.result) return *std::move(known.result);
  if (run.out_of_time()) return undecided(whole_domain(), "the work cap was reached", Reason::time);
  const auto pair = filter::make_pair_of<K>(x, y);
  const auto solve = [&](const ExactPatch<K>& other) {
    return filter::filtered_intersection<K>(x, other, run, false).result;
  };
  if (pair)
    if (auto found = filter::in_affine_parameters<K>(x, y, *pair, run, solve)) return *std::move(found);
  if (pair && !run.exact())
    if (auto found = with_magnified_boxes<K>(x, y, pair->extent, known, run, depth)) return *std::move(found);
  if (pair && known.stuck) return filter::ended_at<K>(*pair, *known.stuck);
  return undecided(whole_domain(),
                   run.exact() ? "not decided by an eliminant, as where the patches touch along a curve"
                               : "not decided in doubles");
}

/// As it is, and moved and scaled where that helps.
template <class K>
IntersectResult intersect_elevated(ExactPatch<K> x, ExactPatch<K> y, const Run& run, int depth) {
  IntersectResult result = solved_pair<K>(x, y, run, depth);
  if (result.status == Status::complete) return result;
  std::vector<Point> points = filter::affine_points(x);
  const std::vector<Point> others = filter::affine_points(y);
  points.insert(points.end(), others.begin(), others.end());
  const auto place = Placement::of(points);
  if (!place) return result;
  for (ExactPatch<K>* patch : {&x, &y}) *patch = filter::placed(*patch, *place);
  return solved_in_place(place, to_double(model_extent(points)), run,
                         [&](const Run& about_origin) { return solved_pair<K>(x, y, about_origin, depth); });
}

IntersectResult intersect_pieces(const RationalPatch& x, const RationalPatch& y, const Run& run, int depth) {
  return filter::in_smallest_kind(
      x, y, [&]<class K>(K, const RationalPatch& first, const RationalPatch& second) {
        return intersect_elevated<K>(filter::elevated<K>(first), filter::elevated<K>(second), run, depth);
      });
}

}  // namespace

std::optional<IntersectResult> intersect_filtered(const BezierPatch& x, const BezierPatch& y,
                                                  const Run& run) {
  return filter::filtered_intersection<filter::Biquadratic>(x, y, run, false).result;
}

IntersectResult intersect_in_doubles(const RationalPatch& x, const RationalPatch& y, const Run& run) {
  return intersect_pieces(x, y, run, 0);
}

std::optional<FilteredCurves> filtered_curves(const BezierPatch& x, const BezierPatch& y, const Run& run) {
  filter::Filtered known = filter::filtered_intersection<filter::Biquadratic>(x, y, run, true);
  if (!known.result) return std::nullopt;
  return FilteredCurves{*std::move(known.result), std::move(known.stations)};
}

}  // namespace exsect
