// The proof by the turning eliminant that the known curves are the whole intersection. Internal to solver/;
// docs/method.md, section 14.8.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "critical_values.h"

namespace exsect {

/// A curve of the intersection: enclosures of the sweep parameter at its turning points with respect to it,
/// in order, those of an open curve between its two ends. From one to the next the parameter is strictly
/// monotone, for a closed curve also from the last to the first.
struct Stations {
  std::vector<RationalInterval> at;
  bool closed;
};

/// The number of points on the line where the sweep parameter has this value; empty: not known, or points
/// that are not isolated.
using FibreCount = std::function<std::optional<std::size_t>(const Rational&)>;

/// True: every closed curve of the intersection and every singular point is on one of `curves`. These are
/// different, and all solutions on sides lie on them. False if that is not proved, in particular for roots
/// that are not simple. Throws std::logic_error if E or a fibre contradicts the curves.
bool no_curve_is_missing(const TurningValues& turning, const std::vector<Stations>& curves,
                         const FibreCount& fibre);

}  // namespace exsect
