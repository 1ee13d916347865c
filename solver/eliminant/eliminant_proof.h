// The proof by the turning eliminant that the known curves are the whole intersection. Internal to solver/;
// docs/method-doubles.md, section 14.8.
#pragma once

#include <exsect/solver/parameter.h>

#include <functional>
#include <optional>
#include <vector>

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

/// True: `curves` are the whole intersection. They are different, and all solutions on sides lie on them.
/// `roots` of the turning eliminant are ascending and disjoint: exactly one, a simple one, in each open
/// interval, or the rational in one of width zero; there are no others in [0,1]. False if the enclosures are
/// too wide for a proof, or a fibre is not known. Throws ProofFailure if roots or fibres contradict the
/// curves.
bool no_curve_is_missing(const std::vector<RationalInterval>& roots, const std::vector<Stations>& curves,
                         const FibreCount& fibre, Parameter sweep = Parameter::u);

}  // namespace exsect
