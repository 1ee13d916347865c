#include "side/common_pole.h"

#include <array>

#include "answer/exact_source.h"
#include "answer/finished_result.h"
#include "line/line_place.h"
#include "side/collapsed_line.h"
#include "trace/landmark_node.h"

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

}  // namespace exsect
