// The search for stars: points where half branches of the curve meet.
#pragma once

#include <exsect/checker/certificate.h>
#include <exsect/checker/factors.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "certificate/algebraic.h"
#include "certificate/search.h"

namespace exsect::cli {

/// A star, `rows` and `axes` chosen so that its maps are near 1, with a tube for each half branch.
struct FoundStar {
  checker::Star claim;                      // without its charts
  std::array<std::string, 8> subdivisions;  // of its charts
  std::vector<Tube> tubes;
  const std::vector<NearFactor>& factors;
  std::array<bool, 4> constant;  // where F vanishes
  // Of F (-1) and factors in each chart; of F without columns.
  std::map<std::pair<int, std::size_t>, checker::FactorMaps<double>> maps;
};

/// How many claims there are before those of a star.
struct ClaimNumbers {
  std::size_t star;
  std::size_t tube;
};

/// The star at the node, smaller than `size` in each parameter. `factors`: those of which half branches may
/// be tubes. Throws NoCertificate if the parameters are in no number field that is found, or the quadratic
/// terms are degenerate.
FoundStar star_at(const SingularSearch& search, const Node& node, const ClaimNumbers& first, double size,
                  const std::vector<NearFactor>& factors);
Json star_claims(const std::vector<FoundStar>& stars);

/// The point of the tube's curve at t, in the star's chart, and as parameters.
Parameters on_half_branch(const FoundStar& star, const Tube& tube, double t);
Parameters parameters_of(const FoundStar& star, const Tube& tube, const Parameters& z);
/// t in the chart in which the place is; above 1 beyond the star.
double distance_from_point(const checker::Star& star, const Parameters& w);

}  // namespace exsect::cli
