// One candidate held against one exact result, step by step. Internal to verify/; docs/method-verify.md,
// section 15.
#pragma once

#include <exsect/verify/verdict.h>

#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "candidate_chain.h"
#include "compared_side.h"
#include "interval_lists.h"
#include "walks.h"

namespace exsect {

/// One representation of a candidate curve.
struct Strand {
  Representation representation;
  Chain chain;
  std::vector<Walk> walks;
};

/// A candidate curve in all its representations.
struct CurveData {
  std::vector<Strand> strands;
};

/// What is held against what; candidate and result must outlive it.
struct ComparedPair {
  std::array<ComparedSurface, 2> surfaces;
  const Candidate& candidate;
  const IntersectResult& exact;
  /// By isolated point, how far it may be from Node::point; needed where no surface is a patch.
  std::vector<double> point_bounds;
  double tolerance;  // a length
  StopRequest stop;
};

/// Of one pair, which must outlive it; called once.
class Verifier {
 public:
  explicit Verifier(const ComparedPair& pair);
  /// What is proved when `stop` ends it; the rest is undecided.
  Verdict operator()();

 private:
  // The true points: the curve and the isolated points.

  /// Of the places that patches give, of distances between them, and between places of space.
  double rounding_of_places() const;
  /// Isolated points as chains of one piece of length 0.
  void add_points();
  Chain isolated_point(std::size_t k) const;

  /// Of a side whose parameters the candidate states.
  const PatchInDoubles& patch(std::size_t side) const { return *sides_[side].patch(); }
  void judge();
  void without_bounds();

  // Candidate curves: curves.cpp

  void read_curves();
  void judge_curve(std::size_t c);
  /// How much of a walk, from 0 to 1, the curves before cover.
  double covered_share(const Walk& walk) const;
  /// How far the stated parameters at t are from those of a place of the truth, in floating point; 0 where
  /// none are stated.
  double parameters_apart(const CandidateCurve& curve, double t, std::size_t arc, double position) const;
  void find_spurious(std::size_t c, const Strand& strand, CurveFinding& finding);
  /// Far from the curves and isolated points; where that is not the whole truth, from one of the surfaces.
  bool is_off(const Chain& chain, const Interval& part) const;
  bool is_off_a_surface(const SpacePoint& p, double bound) const;
  /// An arc is covered by a curve where all of the curve's representations cover it.
  void note_coverage(std::size_t c, CurveFinding& finding);
  /// More than a joint of two walks, and no other part of the truth near that one of them could belong to.
  void note_repetition(std::size_t arc, const Interval& a, const Interval& b, std::size_t other,
                       std::size_t c);

  // Candidate points: points.cpp

  std::vector<SpacePoint> places(const CandidatePoint& point) const;
  void judge_points();
  void judge_point(std::size_t i, std::vector<int>& claims);

  // True arcs and components: arcs.cpp

  std::string arc_name(std::size_t arc) const;
  std::vector<int> components_of(std::size_t arc) const;
  void judge_arcs();
  /// Of all arcs of the components from the candidate.
  DistanceEnclosure distance_of(const std::vector<int>& components) const;
  /// The parameter that changes most over the part tells where it is.
  ArcGap gap(std::size_t arc, const Interval& part) const;
  void judge_components();
  void report_component(const Component& component, const ComponentFinding& finding);
  void report_gaps(const ArcFinding& arc, const std::vector<int>& components);
  /// Claimed points that are as near to a missing component as to any other one, and nearer than its extent.
  void report_points_instead(const Component& component, const std::string& what);

  // How curves connect and touch: connections.cpp

  void judge_connections();
  /// The component of a walk if that is certain: at one of its vertices no other one is within the tolerance.
  std::optional<int> certain_component(const Strand& strand, const Walk& walk) const;
  void judge_join(std::size_t c, const Strand& strand, const Walk& before, const Walk& after);
  /// Along the true curve both ways from the first to the second walk, where there are any, lead farther away
  /// from the bridge between them than it is long.
  bool is_shortcut(const Chain& chain, const Walk& before, const Walk& after) const;
  /// The largest distance of a vertex on the way from the end of one leg to the start of another; empty where
  /// the way in this direction ends or branches before.
  std::optional<double> farthest_between(const PieceTree& tree, const Leg& from, const Leg& to,
                                         int direction) const;
  /// A gap with covered places on both sides of it along the component.
  void judge_split(const ComponentFinding& finding);
  /// Whether a simple component runs through the arc from its end `to`.
  bool is_reversed(const Component& component, int id) const;
  void judge_contacts();
  /// A curve that is on one arc and has the parameters of another one within the tolerance: agreement is then
  /// not claimed.
  void doubt_parameters();

  // The verdict.

  void conclude();
  Difference& differ(DifferenceKind kind, std::string text);

  const Candidate& candidate_;
  const IntersectionGraph& graph_;
  double tolerance_;
  StopRequest stop_;
  std::array<ComparedSide, 2> sides_;
  std::vector<double> point_bounds_;
  TrueCurve truth_;
  double rounding_;
  std::vector<Chain> everything_;  // the arcs, then the isolated points
  std::optional<PieceTree> near_;
  std::vector<CurveData> curves_;
  std::vector<Chain> strands_;
  std::optional<PieceTree> claimed_;
  std::vector<IntervalSet> covered_;                                   // by arc
  std::vector<std::vector<std::pair<std::size_t, Interval>>> kernel_;  // by arc, with the curve
  std::vector<IntervalIndex> kernel_index_;                            // the same intervals
  std::set<std::size_t> not_followed_;                                 // curves that leave the truth
  Verdict verdict_;
};

/// A number in words: without trailing zeros.
std::string decimal(double x);

/// The verdict from one exact result, of models of every size; errors are those of verify() (verify.h).
Verdict judged(const ComparedPair& pair);

}  // namespace exsect
