// A certificate while it is written: what its parts have to know of each other.
#pragma once

#include <exsect/solver/result.h>

#include <map>
#include <set>
#include <vector>

#include "certificate_events.h"
#include "certificate_search.h"
#include "certificate_star.h"
#include "intersection_json.h"

namespace exsect::cli {

struct Draft {
  Patches patches;
  const PatchNames& names;
  const IntersectionGraph& graph;
  NearPair pair;
  bool self;  // of one patch, which is both patches

  // What find_special_places finds. Of nodes and arcs of the graph:
  std::vector<OnLine> line_of = {};            // of each node, if its arc runs along one
  std::vector<OnLine> line_along = {};         // of each arc
  std::vector<bool> on_curve = {};             // nodes that are not only corners of overlaps
  std::vector<std::size_t> claim_of = {};      // the node's number among the claims, those of stars last
  std::map<int, std::size_t> along_seam = {};  // the tube of each arc along which the patches touch
  std::map<int, std::size_t> seam_tube = {};   // of each node where one ends
  // Claims:
  std::vector<checker::Line> lines = {};
  std::vector<bool> touching = {};  // of each of the lines
  std::size_t first_star = 0;       // among the nodes claimed
  std::vector<FoundStar> stars = {};
  std::vector<FoundSeam> seams = {};  // those of overlaps first
  Json overlaps = Json::array();
  std::vector<Tube> tubes = {};

  // What node_claims finds, of each node claimed and each star:
  std::vector<std::size_t> tube_of = {};
  std::vector<Parameters> places = {};
  std::vector<Json> place_claims = {};

  /// The star of the node claimed under this number, or nothing.
  const FoundStar* star_of(std::size_t node) const {
    return node < first_star ? nullptr : &stars[node - first_star];
  }
  /// The point of the tube's line at the value of its axis.
  Parameters on_line(const Tube& tube, const Rational& t) const;
};

/// The patches touch all along the arc.
bool touches(const Arc& arc);

/// Lines, overlaps, stars and seams, and the order of the nodes.
void find_special_places(Draft& draft);
/// After that: of the nodes that are no stars.
Json node_claims(Draft& draft);
/// After that.
Json arc_claims(Draft& draft);

}  // namespace exsect::cli
