// The proof by the eliminant of two patches that the known curves are all. Internal to solver/;
// docs/method-doubles.md, section 14.8.
#pragma once

#include <array>
#include <vector>

#include "eliminant/eliminant_proof.h"
#include "filter/line.h"

namespace exsect::filter {

/// Whether the eliminant of a sweep is affordable, for pairs that are not both biquadratic: those have the
/// exact solution.
bool has_eliminant(const RationalPatch& x, const RationalPatch& y);

/// True only if the curves with these stations, for each sweep parameter, are the whole intersection. They
/// are different, all solutions on sides lie on them, each is in one point on a side, and no others are
/// known. False also for pairs that have no eliminant. `trees` are of x and y; `boxes` counts the pairs
/// looked at.
template <class K>
bool proved_by_eliminant(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                         TreesOf<K>& trees, const std::array<std::vector<Stations>, 4>& stations,
                         long& boxes);

}  // namespace exsect::filter
