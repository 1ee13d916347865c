#include "common_pole.h"

#include <algorithm>

#include "collapsed_line.h"
#include "exact_source.h"
#include "graph_builder.h"
#include "half_space.h"
#include "landmark_node.h"
#include "line_place.h"
#include "model_scale.h"
#include "traced_curves.h"

namespace exsect {

namespace {

struct CollapsedSide {
  Side side;
  Point point;
};

std::vector<CollapsedSide> collapsed_sides(const BezierPatch& patch, bool of_x) {
  const std::array<Parameter, 2> own =
      of_x ? std::array{Parameter::u, Parameter::v} : std::array{Parameter::r, Parameter::s};
  std::vector<CollapsedSide> result;
  for (const std::size_t fixed : {0U, 1U})
    for (const int value : {0, 1}) {
      const auto point = [&](std::size_t k) {
        const std::size_t end = value == 0 ? 0 : 2;
        return fixed == 0 ? patch.net()[end][k] : patch.net()[k][end];
      };
      if (point(0) == point(1) && point(1) == point(2)) result.push_back({{own[fixed], value}, point(0)});
    }
  return result;
}

Parameter along(const Side& side) { return line_place({side.parameter, side.value}).roles.line; }

/// sign (p - pole) for all control points p off the pole.
void add_directions(std::vector<Point>& directions, const BezierPatch& patch, const Point& pole, int sign) {
  for (const auto& row : patch.net())
    for (const Point& p : row)
      if (p != pole) directions.push_back(Rational(sign) * (p - pole));
}

/// d.(x_k - P) > 0 > d.(y_k - P) for all control points but those at P: by their Bernstein polynomials d.x is
/// d.P only where all others are zero.
bool is_separated_at(const Point& pole, const BezierPatch& x, const BezierPatch& y) {
  std::vector<Point> directions;
  add_directions(directions, x, pole, 1);
  add_directions(directions, y, pole, -1);
  if (directions.size() != 12) return false;  // the pole's three are not the only control points there
  return lie_in_half_space(directions);
}

}  // namespace

std::vector<CommonPole> common_poles(const BezierPatch& x, const BezierPatch& y) {
  std::vector<CommonPole> result;
  for (const CollapsedSide& a : collapsed_sides(x, true))
    for (const CollapsedSide& b : collapsed_sides(y, false))
      if (a.point == b.point) result.push_back({a.side, b.side});
  return result;
}

bool is_on(const CertifiedPoint& point, const CommonPole& pole) {
  return point.on(pole.of_x) && point.on(pole.of_y);
}

CertifiedPoint pair_on(const CommonPole& pole, const Rational& along_x, const Rational& along_y) {
  std::array<Rational, 4> at;
  at[index(pole.of_x.parameter)] = pole.of_x.value;
  at[index(pole.of_y.parameter)] = pole.of_y.value;
  at[index(along(pole.of_x))] = along_x;
  at[index(along(pole.of_y))] = along_y;
  const BivariatePolynomial one = BivariatePolynomial::constant(1);
  ExactParameters exact{
      TriangularPoint(RealAlgebraic(0), BivariatePolynomial::r(), {0, 0}), {}, {one, one, one, one}};
  std::vector<Side> sides;
  for (const Parameter p : all_parameters) {
    exact.numerator[index(p)] = BivariatePolynomial::constant(at[index(p)]);
    for (const int value : {0, 1})
      if (at[index(p)] == value) sides.push_back({p, value});
  }
  return certified(std::move(exact), sides);
}

Node pole_node(const CommonPole& pole, const CertifiedPoint& inside, const Node& at_inside) {
  Node node = collapsed_node(inside, at_inside, along(pole.of_x));
  node.box[index(along(pole.of_y))] = {0, 1};
  node.free.push_back(along(pole.of_y));
  return node;
}

std::optional<IntersectResult> intersect_in_pole(const BezierPatch& x, const BezierPatch& y) {
  const std::vector<CommonPole> poles = common_poles(x, y);
  if (poles.size() != 1) return std::nullopt;
  const CertifiedPoint inside = pair_on(poles.front(), Rational(1, 2), Rational(1, 2));
  const ParameterBox& at = inside.box();
  if (!is_separated_at(x(at[0].lower, at[1].lower), x, y)) return std::nullopt;
  const ModelScale scale = model_scale(x, y);
  const PairSystem<DoubleBall> system(x, y, scale.origin, scale.frame.exponent);
  const auto ball = enclose<DoubleBall>(inside, power_of_two(-50));
  IntersectResult result{};
  result.graph.nodes = {pole_node(poles.front(), inside,
                                  landmark_node(system, scale.frame, ball, inside.box(), inside.sides()))};
  result.graph.isolated_points = {result.graph.nodes.front().id};
  finish_components(result.graph);
  result.status = Status::complete;
  return result;
}

}  // namespace exsect
