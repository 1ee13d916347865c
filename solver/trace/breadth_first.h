// The search by subdivision, whatever is subdivided and looked for. Internal to solver/; docs/method.md,
// section 5.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "answer/stop_request.h"

namespace exsect {

/// A box of four variables with double ends: u, v, r, s, or those of a chart of pairs.
struct SearchRegion {
  std::array<double, 4> lower;
  std::array<double, 4> upper;
};

struct SearchOutcome {
  /// Boxes that may hold what was looked for and is not known. Empty: the search is complete.
  std::vector<SearchRegion> undecided;
  long boxes = 0;
};

/// Where a search ends undecided.
struct SearchLimits {
  long most_boxes;
  std::size_t most_waiting;
  long boxes_between_looks = 64;  // at the request to stop
};

/// Looks into all of the boxes `waiting`. A Cover has
///   Cell                  a box with what is known of it
///   is_done(cell)         nothing is left to be found in it
///   split(cell, waiting)  appends its parts, which cover it; false, with none, if it cannot be split further
///   region_of(cell)       the box
/// Breadth first: what is left when the limits are reached are small boxes around the difficult places.
template <class Cover>
SearchOutcome search_breadth_first(Cover& cover, std::deque<typename Cover::Cell> waiting,
                                   const SearchLimits& limits, const StopRequest& stop) {
  SearchOutcome outcome;
  while (!waiting.empty()) {
    const typename Cover::Cell cell = std::move(waiting.front());
    waiting.pop_front();
    ++outcome.boxes;
    if (cover.is_done(cell)) continue;
    const bool ends = outcome.boxes > limits.most_boxes || waiting.size() > limits.most_waiting ||
                      (outcome.boxes % limits.boxes_between_looks == 0 && is_stopped(stop));
    if (!ends && cover.split(cell, waiting)) continue;
    outcome.undecided.push_back(cover.region_of(cell));
    if (!ends) continue;
    for (const auto& other : waiting) outcome.undecided.push_back(cover.region_of(other));
    break;
  }
  return outcome;
}

}  // namespace exsect
