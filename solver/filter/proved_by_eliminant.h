// The proof by the eliminant of two patches that the known curves are all. Internal to solver/;
// docs/method-doubles.md, section 14.8.
#pragma once

#include <array>
#include <vector>

#include "eliminant/eliminant_proof.h"
#include "filter/graph.h"
#include "filter/line.h"

namespace exsect::filter {

/// Whether the eliminant of a sweep is affordable, for pairs that are not both biquadratic: those have the
/// exact solution.
bool has_eliminant(const RationalPatch& x, const RationalPatch& y);

/// What is known of the curves, for each sweep parameter.
struct KnownStations {
  /// All curves but those of the contacts; an isolated point as one that ends where it begins.
  std::array<std::vector<Stations>, 4> curves;
  /// Places of different singular points inside the domain of the parameter.
  std::array<std::vector<RationalInterval>, 4> singular;
};

/// Of traced curves with all of their turning points, which lead to the centres, of isolated boundary points,
/// and of double points: those that are centres, and those on sides, of which crossings are among the former.
/// `coincident` as in find_turning_points().
template <class K>
KnownStations known_stations(const std::vector<AnalysedTraceOf<K>>& curves,
                             const std::vector<BoundaryPointOf<K>>& points,
                             const std::vector<CentreOf<K>>& centres,
                             const std::vector<DoublePointOf<K>>& double_points,
                             const std::vector<DoublePointOf<K>>& on_sides,
                             const std::array<std::size_t, 4>& coincident);

/// True only if these curves, the contacts and the singular points are the whole intersection. They are
/// different, and all solutions on sides are among them. False also for pairs that have no eliminant. `trees`
/// are of x and y; `boxes` counts the pairs looked at.
template <class K>
bool proved_by_eliminant(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                         const ContactsOf<K>& contacts, const KnownStations& known, TreesOf<K>& trees,
                         long& boxes);

}  // namespace exsect::filter
