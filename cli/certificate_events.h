// Claims in exact numbers: relations between parameters, lines on both patches, points where they touch.
#pragma once

#include <exsect/checker/certificate.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/intersection_graph.h>

#include <array>
#include <optional>
#include <vector>

#include "json_forms.h"

namespace exsect::cli {

using Patches = std::array<BezierPatch, 2>;

/// Directions d such that d . (x - y) depends on one parameter of either patch only.
Json relation_claims(const Patches& patches);

/// The line of parameters between the two nodes, if it solves x = y throughout and their parameters are short
/// rationals.
std::optional<checker::Line> line_between(const Patches& patches, const Node& from, const Node& to);
Json line_claims(const std::vector<checker::Line>& lines);

/// The isolated point, which the patches' tangent planes have in common. Throws NoCertificate if its
/// parameters are no short rationals or no proof is found that it is alone.
checker::Touch touch_at(const Patches& patches, const Node& node);
Json touch_claims(const std::vector<checker::Touch>& touches);

}  // namespace exsect::cli
