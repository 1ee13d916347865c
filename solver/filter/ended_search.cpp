#include "filter/ended_search.h"

#include <algorithm>
#include <cmath>

#include "answer/finished_result.h"
#include "answer/parameter_box.h"
#include "filter/common_normal.h"
#include "filter/tube_newton.h"

namespace exsect::filter {

namespace {

/// Of the parameters: what is called the same place in messages.
constexpr double kNear = 0x1p-16;
/// Of the points of both patches that are called one point.
constexpr double kMeet = 0x1p-30;

/// A component of the tangent that is smaller than this, relative to the greatest one, is called zero.
constexpr double kNearlyStill = 0x1p-8;

/// Why no subdivision decides, and a word about it: what the pair is like at a place, approximately.
struct Ending {
  Reason reason;
  const char* why;
};
template <class K>
Ending ending_at(const PairOf<K>& pair, const Vec4& at) {
  int sides = 0;
  std::size_t side = 4;
  for (std::size_t j = 0; j < 4; ++j) {
    if (!(std::fabs(std::fabs(at[j]) - 0.5) < kNear)) continue;
    ++sides;
    side = j;
  }
  if (sides > 1) return {Reason::corner, "curve through a corner, or along a side, not decided"};
  const Vec4 tangent = first_four<K>(linearise(pair, with_scale(pair, at)).tangent);
  const bool is_still = sides > 0 && std::fabs(tangent[side]) < kNearlyStill * largest(tangent);
  return is_still ? Ending{Reason::tangency, "tangency with a side not decided"}
                  : Ending{Reason::not_decided, "not decided"};
}

bool are_near(const Vec4& a, const Vec4& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double s, double t) { return std::fabs(s - t) < 0.125; });
}

/// The point with T = 0 close by, as far as doubles tell, in the domain.
template <class K>
std::optional<Vec4> singular_near(const PairOf<K>& pair, const Vec4& place) {
  const auto found = common_normal(pair, place);
  if (!found || !(found->distance < kMeet) || !are_near(found->at, place)) return std::nullopt;
  const bool is_inside =
      std::all_of(found->at.begin(), found->at.end(), [](double w) { return std::fabs(w) < 0.5 + kNear; });
  return is_inside ? std::optional(found->at) : std::nullopt;
}

/// The solution on a side near a place on it, if Newton's method finds one close by; else the place.
template <class K>
Vec4 on_side_near(const PairOf<K>& pair, const Vec4& place) {
  for (std::size_t j = 0; j < 4; ++j) {
    if (std::fabs(place[j]) != 0.5) continue;
    Unknowns<K> at = with_scale(pair, place);
    if (!improve(pair, at, j, 20)) continue;
    if (are_near(place, first_four<K>(at))) return first_four<K>(at);
  }
  return place;
}

}  // namespace

template <class K>
IntersectResult ended_at(const PairOf<K>& pair, const Vec4& searched) {
  Vec4 place;
  Ending ending;
  if (const auto singular = singular_near(pair, searched)) {
    place = *singular;
    ending = looks_like_crossing(pair, place) ? Ending{Reason::crossing, "crossing not decided"}
                                              : Ending{Reason::tangency, "tangency not decided"};
  } else {
    place = on_side_near(pair, searched);
    ending = ending_at<K>(pair, place);
  }
  IntersectResult result = undecided(whole_domain(), "the search in doubles ended at a place in it");
  result.incomplete.insert(result.incomplete.begin(),
                           Incomplete{box_around(place, kNear), ending.why, ending.reason});
  return result;
}

#define EXSECT_INSTANTIATE(K) template IntersectResult ended_at<K>(const PairOf<K>&, const Vec4&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
