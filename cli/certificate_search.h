// The search for the claims of a certificate, in doubles: nothing here proves anything. What is found is only
// worth something once checker/ has replayed it.
#pragma once

#include <exsect/checker/curve_bounds.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/line_patch.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace exsect::cli {

/// There is no certificate for this result; what() names the event that has none.
class NoCertificate : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using Tube = checker::Tube<double>;
using Parameters = std::array<double, 4>;

/// x and -y translated, divided by `scale`, a power of two, and rounded to doubles.
struct NearPair {
  std::array<ControlNet, 2> nets;  // translated, exact
  checker::Pair<double> power;
  std::array<checker::Net<double>, 2> control;  // of x and y
  double scale;
};
NearPair near_pair(const BezierPatch& x, const BezierPatch& y);

/// T, the kernel of DF at w (method (5.1)).
Parameters tangent(const NearPair& pair, const Parameters& w);
/// Newton's method for F = 0 with the parameter `fixed` held.
Parameters on_curve(const NearPair& pair, Parameters w, std::size_t fixed);
/// The zero of dw_i/dw_axis near w on the curve.
Parameters turning_point(const NearPair& pair, Parameters w, std::size_t axis, std::size_t i);

/// A large tube around w that should satisfy everything the check asks of tubes. Throws NoCertificate.
Tube tube_at(const NearPair& pair, const Parameters& w, std::size_t axis);
checker::CurveBounds<double> bounds_in(const NearPair& pair, const Tube& tube);
/// A bound for the distance from w to the curve.
double distance(const NearPair& pair, const Tube& tube, const Parameters& w);

struct TracedPoint {
  Parameters at;
  int vertex;  // of the polyline, or -1
};
struct TracedPiece {
  std::size_t tube;
  std::size_t last;
};
/// An arc as a chain of tubes, from the tube of its first node to that of its last one.
struct TracedArc {
  std::vector<TracedPoint> points;
  std::vector<TracedPiece> pieces;
};
/// Adds the tubes it needs. `points`: the polyline's vertices, the first and the last one at the nodes.
TracedArc chain(const NearPair& pair, const std::vector<Parameters>& points, std::size_t first_tube,
                std::size_t last_tube, std::vector<Tube>& tubes);

/// The subdivision of [0,1]^4, or of its part on the line, in preorder: "u", "t5", "3 -1 2".
std::vector<std::string> cover(const NearPair& pair, const std::vector<Tube>& tubes,
                               const std::optional<LineQuery>& line = {});

}  // namespace exsect::cli
