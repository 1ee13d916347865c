// Closed curves of a self-intersection, and the proof that there is nothing else. Internal to solver/;
// docs/method.md, section 7.3.
#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "self/known_places.h"
#include "self/places.h"

namespace exsect {

/// How much work the search for further pairs may be. A short one ends at most places where a star is wanted,
/// in a small part of the time.
enum class SearchEffort { brief, whole };

/// Takes a closed curve that was traced, or why it could not be: true if it is a curve of `found` now.
template <class Ball>
using LoopHandler = std::function<bool(std::variant<Trace<Ball>, TraceFailure>)>;

/// Searches both charts for pairs that are on no curve of `found`: closed curves are given to `add`. Returns
/// where that is not settled; empty: `found`, the known places and exact.folds are all pairs. The boxes are
/// taken in doubles first (`charts`), whatever the arithmetic of the curves. `direction`: search_chart.
template <class Ball>
std::vector<ParameterBox> search_closed_curves(const SelfSystem<Ball>& system,
                                               const Charts<DoubleBall>& charts, const ExactPlaces& exact,
                                               const KnownPlaces& places,
                                               const std::array<double, 2>& direction, SearchEffort effort,
                                               SelfCurves<Ball>& found, const LoopHandler<Ball>& add,
                                               const StopRequest& stop);

}  // namespace exsect
