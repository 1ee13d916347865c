// Arcs of a circle between exact directions. Internal to solver/; docs/method-equations.md, section 17.12.
#pragma once

#include <exsect/algebra/rational.h>

#include <array>
#include <vector>

namespace exsect {

using PlaneDirection = std::array<Rational, 2>;

/// Counter-clockwise from one direction to the other, both included; they agree in a point.
struct CircleArc {
  PlaneDirection from;
  PlaneDirection to;
  bool is_point() const;
};

/// The angle of b beyond that of a, in [0, 2 pi), is less than that of c.
bool comes_before(const PlaneDirection& a, const PlaneDirection& b, const PlaneDirection& c);

/// The connected parts of what two arcs share: two at most.
std::vector<CircleArc> shared_arcs(const CircleArc& one, const CircleArc& other);
/// Those of what all arcs share; none if there is no arc.
std::vector<CircleArc> parts_of_all(const std::vector<CircleArc>& arcs);

}  // namespace exsect
