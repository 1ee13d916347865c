// A pair of surfaces in doubles, for the search for claims.
#pragma once

#include <exsect/checker/pairs_of_points.h>
#include <exsect/checker/section.h>

#include <optional>

#include "certificate/patches.h"

namespace exsect::cli {

using Map = checker::Map<double>;

/// x and y translated, their coordinates and weights divided by powers of two, so that F is divided by
/// `scale`, component by component, and rounded to doubles; with an equation its F_1 alone is divided.
struct NearPair {
  Map power;                                            // F
  std::array<checker::PairChart<double>, 2> charts;     // of one patch, and of it with exchanged parameters
  std::array<checker::WeightedNet<double>, 2> control;  // of x and y
  std::optional<checker::SectionNet<double>> section = {};  // of an equation: F_1
  std::array<double, 3> scale;
  std::array<bool, 4> constant = {};  // parameters that are constant where F vanishes and is regular
};
/// `self`: the patches are one.
NearPair near_pair(const Patches& patches, bool self = false);
/// The same of f(x(u,v)) = 0.
NearPair near_section(const SpacePolynomial& f, const RationalPatch& x);

}  // namespace exsect::cli
