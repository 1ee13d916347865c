// The proof that a box around a pair of a self-intersection holds a star. Internal to solver/;
// docs/method.md, section 7.6.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "self/star.h"
#include "self/star_centres.h"

namespace exsect {

/// Boxes around one centre, with fibres over one parameter; refers to its arguments.
class SelfStarProof {
 public:
  /// sweep: u (0) or v (1), of the first point.
  SelfStarProof(const SelfStarProblem& problem, const SelfCentre& centre, std::size_t sweep);

  /// The star in a box of at most this half width, without layers.
  std::optional<SelfStar> run(double halfwidth);

  /// Fills in `count` layers on each side that has ports.
  bool add_layers(SelfStar& star, int count) const;

  /// A box around `inner`, the box of the star, as large as can be proved, in which all pairs are on the
  /// star's arcs and their continuations: they form a star with the same centre.
  ParameterBox surroundings(const ParameterBox& inner);

 private:
  Parameter sweep() const { return static_cast<Parameter>(sweep_); }
  const RationalInterval& near(std::size_t j) const { return centre_.point.box()[j]; }
  bool bound_slab();
  void keep_away(const std::vector<RealAlgebraic>& values);
  double largest_slab(double halfwidth) const;
  void set_box(double halfwidth, double slab);
  bool is_alone() const;
  bool meets_cuspidal_side() const;
  std::optional<std::size_t> cuspidal_points_on_line() const;
  std::optional<std::size_t> orientation() const;
  bool lateral_faces_are_free() const;
  std::optional<std::vector<CertifiedPoint>> oriented(
      std::optional<std::vector<CertifiedPoint>> points) const;
  std::optional<SelfStar> with_ports() const;
  std::optional<SelfStar::FoldedArc> folded_arc(const CertifiedPoint& point, const Rational& value) const;
  bool arcs_are_monotone() const;

  const SelfStarProblem& problem_;
  const SelfValues& known_;
  const SelfCentre& centre_;
  std::size_t sweep_;
  RealAlgebraic at_;
  Rational slab_room_;
  ParameterBox box_;
  bool from_side_ = false;
  std::vector<std::pair<std::size_t, int>> cuspidal_sides_;  // u (0) or v (1), and its value there
};

}  // namespace exsect
