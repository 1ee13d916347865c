// Claims in exact numbers: relations between parameters, lines on both patches.
#pragma once

#include <exsect/checker/certificate.h>
#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/result.h>

#include <array>
#include <optional>
#include <vector>

#include "certificate/patches.h"
#include "output/text/json_forms.h"

namespace exsect::cli {

/// A point that needs a star: isolated, or where branches meet.
bool is_star(const IntersectionGraph& graph, const Node& node, bool self);
/// Throws NoCertificate for what a certificate cannot say.
void refuse_events(const IntersectResult& result, bool self);

/// The shortest rationals in the node's box, which are its parameters if these are short.
std::array<Rational, 4> short_place(const Node& node);

/// Directions d such that d . (x - y) depends on one parameter of either patch only; none of patches with
/// weights.
std::vector<Point> related_directions(const Patches& patches);

/// w(t) = at[.][0] + at[.][1] t + at[.][2] t^2; w_axis(t) = t.
struct Line {
  std::size_t axis;
  std::array<Point, 4> at;
};
Rational value(const Point& a, const Rational& t);

/// The line of parameters between the two nodes, if F = 0 throughout and their parameters are short
/// rationals.
std::optional<Line> line_between(const ExactMap& equation, const Node& from, const Node& to);
/// The patches touch all along the arc.
bool touches(const Arc& arc);

}  // namespace exsect::cli
