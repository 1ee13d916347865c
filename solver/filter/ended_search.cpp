#include "filter/ended_search.h"

#include <algorithm>
#include <cmath>

#include "answer/finished_result.h"
#include "answer/parameter_box.h"
#include "filter/tube_newton.h"

namespace exsect::filter {

namespace {

/// Of the parameters: what is called the same place in messages.
constexpr double kNear = 0x1p-16;

/// Why no subdivision decides: a word about the pair at a place, approximately.
template <class K>
const char* reason_at(const PairOf<K>& pair, const Vec4& at) {
  const auto on_side = [&](std::size_t j) { return std::fabs(std::fabs(at[j]) - 0.5) < kNear; };
  const int sides = on_side(0) + on_side(1) + on_side(2) + on_side(3);
  if (sides > 1) return "curve through a corner, or along a side, not decided";
  const Linearisation<K> here = linearise(pair, with_scale(pair, at));
  double tangent = 0;
  double columns = 1;
  for (std::size_t j = 0; j < 4; ++j) {
    tangent = std::max(tangent, std::fabs(here.tangent[j]));
    columns *= std::sqrt(std::sqrt(dot(here.column[j], here.column[j])));
  }
  if (tangent < kNear * columns * std::sqrt(columns)) return "tangency or crossing not decided";
  return sides > 0 ? "tangency with a side not decided" : "not decided";
}

/// The solution on a side near a place on it, if Newton's method finds one close by; else the place.
template <class K>
Vec4 on_side_near(const PairOf<K>& pair, const Vec4& place) {
  for (std::size_t j = 0; j < 4; ++j) {
    if (std::fabs(place[j]) != 0.5) continue;
    Unknowns<K> at = with_scale(pair, place);
    if (!improve(pair, at, j, 20)) continue;
    const bool close = std::equal(place.begin(), place.end(), at.begin(),
                                  [](double a, double b) { return std::fabs(a - b) < 0.125; });
    if (close) return first_four<K>(at);
  }
  return place;
}

}  // namespace

template <class K>
IntersectResult ended_at(const PairOf<K>& pair, const Vec4& searched) {
  const Vec4 place = on_side_near(pair, searched);
  const char* reason = reason_at<K>(pair, place);
  IntersectResult result = undecided(whole_domain(), "the search in doubles ended at a place in it");
  result.incomplete.insert(result.incomplete.begin(), Incomplete{box_around(place, kNear), reason});
  return result;
}

#define EXSECT_INSTANTIATE(K) template IntersectResult ended_at<K>(const PairOf<K>&, const Vec4&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
