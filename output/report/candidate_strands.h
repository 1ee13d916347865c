// What pictures and pages draw of a candidate and of the verdict on it.
#pragma once

#include <exsect/geometry/candidate.h>
#include <exsect/verify/verify.h>

#include <array>
#include <set>
#include <vector>

namespace exsect::cli {

/// A candidate curve as drawn in one of its representations: its parameter and what is there.
struct DrawnStrand {
  Representation in;
  std::vector<double> at;
  std::vector<std::array<double, 3>> points;  // of space, or (a, b, 0)
};

/// In each representation that is given: vertices of polylines, at most some thousand; 24 chords for each
/// span of another spline.
std::vector<DrawnStrand> strands(const CandidateCurve& curve);
/// The points of a strand between two of its parameters, and those at its ends if none is between.
std::vector<std::array<double, 3>> part_of(const DrawnStrand& strand, double from, double to);

std::vector<ArcGap> all_gaps(const Verdict& verdict);
std::vector<PolylineVertex> vertices_of(const IntersectionGraph& graph, const ArcGap& gap);
/// Positions of the candidate's points that a difference is about.
std::set<std::size_t> wrong_points(const Verdict& verdict);

}  // namespace exsect::cli
