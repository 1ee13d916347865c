// Where the next vertex of a polyline is looked for between two points of an arc in space: on the arc's
// shadow. Internal to solver/; docs/method-equations.md, section 17.6.
#pragma once

#include <exsect/algebra/double_double_ball.h>

#include <array>
#include <optional>

#include "curve/plane_zeros.h"
#include "lift/lifted_curve.h"

namespace exsect {

/// About nodes, and about v over a rational u.
const Rational& fine_width();

/// An arc to draw, and what both arithmetics need of it.
struct DrawnArc {
  const LiftedCurve& curve;
  std::size_t arc;
  double tolerance;

  const LiftedArc& lifted() const { return curve.arcs[arc]; }
  const CurveBranch& branch() const { return curve.below.arcs[lifted().below]; }
  bool is_vertical() const { return curve.below.nodes[branch().from].u == curve.below.nodes[branch().to].u; }
  /// The sign of the shadow's polynomial next below the arc.
  int sign_below() const;
  /// v over a u that the arc passes over; `range` contains it. Empty in the interval of a critical value.
  std::optional<RationalInterval> over(const Rational& u, const RationalInterval& range) const;
};

/// Where the next vertex between two is looked for. Empty: these numbers do not lead further.
template <class Interval>
class MiddlePlaces;

/// By rational numbers of few bits.
template <>
class MiddlePlaces<RationalInterval> {
 public:
  explicit MiddlePlaces(const DrawnArc& arc) : arc_(arc) {}

  /// About at this share of the way between two closed intervals.
  std::optional<RationalInterval> between(const RationalInterval& a, const RationalInterval& b,
                                          double share) const;

  /// The arc over about this u between those of the ends, v in this range; u moves towards the end where it
  /// has to.
  std::optional<std::array<RationalInterval, 2>> on_arc(const RationalInterval& u,
                                                        const RationalInterval& range,
                                                        const RationalInterval& end) const;

 private:
  const DrawnArc& arc_;
};

/// By doubles.
template <>
class MiddlePlaces<DoubleBall> {
 public:
  explicit MiddlePlaces(const DrawnArc& arc)
      : arc_(arc), swept_(arc.curve.below.swept), exchanged_(arc.curve.below.swept.exchanged()) {}

  std::optional<DoubleBall> between(const DoubleBall& a, const DoubleBall& b, double share) const;

  /// The arc over a u between those of its ends, v in this range.
  std::optional<std::array<DoubleBall, 2>> on_arc(const DoubleBall& u, const DoubleBall& range) const;
  /// The arc over a v between those of its ends, u in this range.
  std::optional<std::array<DoubleBall, 2>> beside(const DoubleBall& v, const DoubleBall& range) const;
  /// As on_arc(), v as near as doubles are: by sums of two doubles, and exactly where they do not prove that
  /// the zero is the only one. u is of radius 0.
  std::optional<std::array<DoubleBall, 2>> nearest_on_arc(const DoubleBall& u, const DoubleBall& range) const;

 private:
  const DrawnArc& arc_;
  PlaneZeros<DoubleBall> swept_;
  PlaneZeros<DoubleBall> exchanged_;
  mutable std::optional<PlaneZeros<DoubleDoubleBall>> swept_in_pairs_;  // once it was asked for
  mutable int below_ = 0;                                               // arc_.sign_below(), once asked for
};

}  // namespace exsect
