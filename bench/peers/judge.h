// One answer against the proved intersection. Distances are measured in floating point: a report, not a
// proof.
#pragma once

#include "nearest_point.h"
#include "reference.h"

namespace peers {

/// Counts of one pair, or sums over many. With S the size of the pair (PatchPair::size):
struct Verdict {
  int components = 0;         // true curves, connected ones
  int found = 0;              // of these: at least 99 % of the length is covered
  int partly = 0;             // at least 5 %
  int lost = 0;               // less
  int as_points = 0;          // of the lost and partly covered ones: reported as isolated points
  int isolated = 0;           // true isolated points
  int isolated_found = 0;     // a point or vertex is within S/1000
  int invented_curves = 0;    // at least half of the vertices are farther than S/1000 from the truth
  int invented_points = 0;    // farther than S/1000 from the truth, or a residual of more than S/10000
  int wrong_connections = 0;  // curves that jump from one true curve, or passage of it, to another
  double residual = 0;        // largest |x(u,v) - y(r,s)| at a vertex
  double distance = 0;        // largest distance of a vertex from the truth; invented ones left out

  /// Nothing lost, invented or connected wrongly.
  bool right() const;
  Verdict& operator+=(const Verdict& other);
};

/// A curve covers a piece of the truth where its chords are within min(S/1000, an eighth of the extent of the
/// true component) of it and both vertices belong to that component, or may belong to several that are too
/// near each other to tell. In a region of overlap every common point counts as true.
Verdict judge(const PatchPair& pair, const Reference& reference, const Answer& answer);

/// Line queries, triples (v,r,s) for each line: matched within 1e-4 in each parameter.
struct LineVerdict {
  int points = 0;
  int lost = 0;
  int invented = 0;
};
LineVerdict judge_lines(const std::vector<std::vector<Point>>& reference,
                        const std::vector<std::vector<Point>>& answer);

}  // namespace peers
