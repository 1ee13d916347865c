#include "side/collapsed_line.h"

#include <algorithm>
#include <cmath>

#include "answer/parameter_box.h"
#include "curve/plane_curve.h"
#include "curve/polynomial_vector.h"
#include "line/half_rational_point.h"
#include "line/line_place.h"

namespace exsect {

namespace {

/// Whether a whole curve of the patch's parameters, apart from its sides, is mapped to the point.
bool has_curve_at(const BezierPatch& patch, const Point& point) {
  const PolynomialVector equations = coordinates_from(patch, point);
  BivariatePolynomial curve = common_zeros({equations.begin(), equations.end()}).curve;
  if (curve.is_zero()) return true;
  curve = squarefree(curve);
  for (const BivariatePolynomial& parameter : {BivariatePolynomial::r(), BivariatePolynomial::s()})
    for (const int side : {0, 1})
      curve = exact_quotient(curve, gcd(curve, parameter - BivariatePolynomial::constant(side)));
  return !component_points(curve).empty();
}

std::vector<PolylineVertex> straight_polyline(const CertifiedPoint& from, const CertifiedPoint& to,
                                              const Point& point) {
  std::vector<PolylineVertex> polyline;
  for (const CertifiedPoint* end : {&from, &to}) {
    PolylineVertex vertex{};
    for (std::size_t j = 0; j < 4; ++j) vertex.parameters[j] = to_double(end->box()[j].midpoint());
    for (std::size_t k = 0; k < 3; ++k) vertex.point[k] = to_double(point[k]);
    polyline.push_back(vertex);
  }
  return polyline;
}

}  // namespace

LineArcs arcs_of_collapsed_line(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  const LineAndPatch problem = line_and_patch(x, y, query);
  const Point& point = problem.line.a[0];
  LineArcs result;
  if (has_curve_at(problem.patch, point)) {
    result.incomplete = "the line is a single point, and so is a curve of the other patch's parameters";
    return result;
  }
  const bool of_x = index(query.fixed) < 2;
  const auto points_at = [&](const Rational& along) {
    std::array<Rational, 2> at = {query.value, query.value};
    at[index(line_place(query).roles.line) % 2] = along;
    return half_rational_points(x, y, of_x, at);
  };
  // The same equations three times, so the same zeros in the same order.
  const auto lower = points_at(0);
  const auto middle = points_at(Rational(1, 2));
  const auto upper = points_at(1);
  double rounding = 0;
  for (const Rational& a : point) rounding += std::fabs(to_double(a)) * 0x1p-52;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    result.ends.push_back(lower[i].point);
    result.ends.push_back(upper[i].point);
    result.arcs.push_back({2 * i,
                           2 * i + 1,
                           middle[i].point,
                           straight_polyline(lower[i].point, upper[i].point, point),
                           rounding,
                           {hull(lower[i].point.box(), upper[i].point.box())},
                           true});
  }
  return result;
}

bool is_corner(const std::vector<Side>& on) {
  std::array<int, 2> sides_of_patch{};
  for (const Side& side : on) ++sides_of_patch[index(side.parameter) / 2];
  return sides_of_patch[0] == 2 || sides_of_patch[1] == 2;
}

Node collapsed_node(const CertifiedPoint& inside, const Node& at_inside, Parameter along) {
  Node node = at_inside;
  node.kinds = {NodeKind::boundary};
  node.on = inside.sides();
  if (is_corner(node.on)) node.kinds.push_back(NodeKind::corner);
  node.box = inside.box();
  node.box[index(along)] = {0, 1};
  node.free = {along};
  return node;
}

}  // namespace exsect
