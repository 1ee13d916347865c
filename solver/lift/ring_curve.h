// The curve that a torus without a rational frame has in common with another surface, as two graphs over its
// halves. Internal to solver/; docs/method-equations.md, section 17.14.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lift/lifted_curve.h"
#include "lift/surface_intersection.h"

namespace exsect {

/// A node of one of the halves; those on both sides of a common circle of the halves are one node.
struct RingNode {
  std::size_t half;
  std::size_t below;  // in LiftedCurve::nodes
  int degree;
};

struct RingArc {
  std::size_t half;
  std::size_t below;  // in LiftedCurve::arcs
  std::size_t from;
  std::size_t to;
  std::size_t factor;  // arcs that go on in each other have the same number
};

/// Invariant: as for TorusCurve (torus_curve.h).
struct RingCurve {
  bool is_same = false;
  std::array<LiftedCurve, 2> halves;
  std::vector<RingNode> nodes;
  std::vector<RingArc> arcs;
};

/// The torus in two halves, with two circles about its axis in common; turn > 0 moves these, from where they
/// are opposite for about 1 (17.13). Empty unless the ratio of the minor radius to the major one, or to the
/// length of the axis, is rational.
std::optional<std::array<SurfaceChart, 2>> ring_charts(const SurfaceData& torus, const Rational& turn);

/// Empty where ring_charts() are. Of the surfaces the equations alone are looked at; the other one is no
/// cone.
std::optional<RingCurve> ring_curve(const ImplicitSurface& torus, const ImplicitSurface& other,
                                    const SurfaceRegion& region);

/// Of the circle in the middle of the tube the diameter, for tolerances.
double extent_of(const RingCurve& curve);

/// As for lifted curves: ids are positions, the arcs are those of the curve, each in one of them; is_closed
/// is not set. Circles about the axis and in planes through it are named.
std::vector<SpaceCurve> named_curves(const RingCurve& curve);

}  // namespace exsect
