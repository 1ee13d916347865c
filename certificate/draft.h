// A certificate while it is written: what its parts have to know of each other.
#pragma once

#include <exsect/solver/result.h>

#include <optional>
#include <vector>

#include "certificate/factor.h"
#include "certificate/search.h"
#include "certificate/star.h"
#include "output/text/json_forms.h"

namespace exsect::cli {

/// A node's place in multiples of 2^-bits, within far less than `radius` of it if Newton's method went well.
struct LongPlace {
  Place at;
  Rational radius;
  int bits;
};

struct Draft {
  const IntersectionGraph& graph;
  ExactMap exact;  // F
  NearPair pair;
  bool self;  // of one patch, which is both patches
  Factors factors;

  // What find_special_places finds. Of nodes and arcs of the graph:
  std::vector<int> factor_at = {};         // of each node that is no star, that of its arcs
  std::vector<int> factor_along = {};      // of each arc; -1 for F
  std::vector<bool> on_curve = {};         // nodes that are not only corners of overlaps
  std::vector<bool> in_star = {};          // nodes that are points of stars
  std::vector<std::size_t> claim_of = {};  // the node's number among the claims, those of stars last
  // Claims:
  std::size_t first_star = 0;  // among the nodes claimed
  std::vector<FoundStar> stars = {};
  Json overlaps = Json::array();
  std::vector<int> planes = {};  // their factors
  std::vector<Tube> tubes = {};

  // What node_claims finds, of each node claimed and each star:
  std::vector<std::size_t> tube_of = {};
  std::vector<Parameters> places = {};
  std::vector<std::optional<LongPlace>> long_places = {};  // of nodes that doubles do not tell apart
  std::vector<Json> place_claims = {};

  /// The star of the node claimed under this number, or nothing.
  const FoundStar* star_of(std::size_t node) const {
    return node < first_star ? nullptr : &stars[node - first_star];
  }
  /// What vanishes on the curve with this factor, or without one.
  Equation equation(int factor) const {
    if (factor < 0) return {pair.power, Chart::pair, -1, nullptr, pair.constant};
    const NearFactor& f = factors.found()[static_cast<std::size_t>(factor)];
    return {f.map, Chart::pair, factor, &f};
  }
};

}  // namespace exsect::cli
