#include "special/intersect_in_pole.h"

#include <vector>

#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "curve/half_space.h"
#include "side/common_pole.h"
#include "trace/enclose.h"
#include "trace/landmark_node.h"

namespace exsect {

namespace {

/// sign (p - pole) for all control points p off the pole.
void add_directions(std::vector<Point>& directions, const BezierPatch& patch, const Point& pole, int sign) {
  for (const auto& row : patch.net())
    for (const Point& p : row)
      if (p != pole) directions.push_back(Rational(sign) * (p - pole));
}

/// d.(x_k - P) > 0 > d.(y_k - P) for all control points but those at P: by their Bernstein polynomials d.x is
/// d.P only where all others are zero (6.1a).
bool is_separated_at(const Point& pole, const BezierPatch& x, const BezierPatch& y) {
  std::vector<Point> directions;
  add_directions(directions, x, pole, 1);
  add_directions(directions, y, pole, -1);
  if (directions.size() != 12) return false;  // the pole's three are not the only control points there
  return lie_in_half_space(directions);
}

}  // namespace

std::optional<IntersectResult> intersect_in_pole(const BezierPatch& x, const BezierPatch& y) {
  const std::vector<CommonPole> poles = common_poles(x, y);
  if (poles.size() != 1) return std::nullopt;
  const CertifiedPoint inside = pair_on(poles.front(), Rational(1, 2), Rational(1, 2));
  const ParameterBox& at = inside.box();
  if (!is_separated_at(x(at[0].lower, at[1].lower), x, y)) return std::nullopt;
  const ModelScale scale = model_scale(x, y);
  const PairSystem<DoubleBall> system(x, y, scale.origin, scale.frame.exponent);
  const auto ball = enclose<DoubleBall>(inside, power_of_two(-50));
  GraphBuilder graph;
  graph.add_isolated(graph.add_node(pole_node(
      poles.front(), inside, landmark_node(system, scale.frame, ball, inside.box(), inside.sides()))));
  return finished(std::move(graph), {}, {});
}

}  // namespace exsect
