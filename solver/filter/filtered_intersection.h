// The stages of the solution in doubles, one after the other. Internal to solver/; docs/method-doubles.md,
// section 14.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "answer/run.h"
#include "eliminant/eliminant_proof.h"
#include "filter/exact_patch.h"

namespace exsect::filter {

/// What doubles decide of a pair.
struct Filtered {
  /// Complete, with the same proof and the same graph as the exact solution; empty if it is not decided.
  std::optional<IntersectResult> result = {};
  /// Where the search ended then, centred; empty also if that is no place of the domain.
  std::optional<Vec4> stuck = {};
  /// It was the one for closed curves, or for turning points of one: all curves with ends were known.
  bool among_closed = false;
  /// What the curves do, for each sweep parameter, if that was asked for.
  std::array<std::vector<Stations>, 4> stations = {};
};

/// Contacts, boundary points, arcs, closed curves, turning points, drawing: after a bounded amount of work.
/// With stations, pairs that share a corner or a part of a side are not decided. Without what is in the
/// boxes (14.95), which have no point in common and ends that are doubles.
template <class K>
Filtered filtered_intersection(const ExactPatch<K>& x, const ExactPatch<K>& y, const Run& run,
                               bool with_stations, std::vector<ParameterBox> boxes = {});

}  // namespace exsect::filter
