#include "special/common_apex.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>

#include "answer/exact_source.h"
#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "curve/plane_curve.h"
#include "curve/polynomial_vector.h"
#include "side/common_pole.h"
#include "trace/bounded_vertex.h"
#include "trace/enclose.h"
#include "trace/landmark_node.h"
#include "trace/regular_degree.h"

namespace exsect {

namespace {

/// A patch apex + t c(w) with t counted from the side that is the apex.
struct Cone {
  std::array<std::size_t, 2> parameters;  // indices of t and w
  bool reversed;                          // t counts against the parameter
  std::array<Point, 3> rulings;           // control vectors of c

  /// The directions c as polynomials in `w`.
  PolynomialVector direction(const BivariatePolynomial& w) const {
    const std::array<Point, 3> c = {rulings[0], Rational(2) * (rulings[1] - rulings[0]),
                                    rulings[0] - Rational(2) * rulings[1] + rulings[2]};
    const auto term = [](const Rational& factor) { return BivariatePolynomial::constant(factor); };
    PolynomialVector result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = term(c[0][i]) + w * (term(c[1][i]) + w * term(c[2][i]));
    return result;
  }
};

/// Empty if the patch is not linear across the side, which is one point.
std::optional<Cone> cone_from(const BezierPatch& patch, const Side& apex) {
  const std::size_t fixed = index(apex.parameter) % 2;
  const std::size_t first = index(apex.parameter) - fixed;
  Cone cone{{first + fixed, first + 1 - fixed}, apex.value == 1, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](std::size_t across) {
      const std::size_t i = cone.reversed ? 2 - across : across;
      return fixed == 0 ? patch.net()[i][k] : patch.net()[k][i];
    };
    cone.rulings[k] = at(2) - at(0);
    if (!is_zero(at(0) - Rational(2) * at(1) + at(2))) return std::nullopt;
  }
  return cone;
}

class TwoCones {
 public:
  TwoCones(const BezierPatch& x, const BezierPatch& y, const CommonPole& apex, Cone of_x, Cone of_y)
      : x_(x),
        y_(y),
        apex_(apex),
        cones_{std::move(of_x), std::move(of_y)},
        c_(cones_[0].direction(BivariatePolynomial::r())),
        d_(cones_[1].direction(BivariatePolynomial::s())) {}

  std::optional<IntersectResult> run() {
    const PolynomialVector parallel = cross(c_, d_);
    const CommonZeros common = common_zeros({parallel.begin(), parallel.end()});
    const bool many = common.curve.is_zero() || !component_points(squarefree(common.curve)).empty();
    if (many || have_common_zero({c_.begin(), c_.end()}) || have_common_zero({d_.begin(), d_.end()}))
      return std::nullopt;
    const CertifiedPoint inside = pair_on(apex_, Rational(1, 2), Rational(1, 2));
    const int apex = graph_.add_node(pole_node(apex_, inside, node_of(inside)));
    for (const TriangularPoint& at : common.points) add_ruling(at, apex);
    if (graph_.arcs().empty()) graph_.add_isolated(apex);
    return finished(std::move(graph_), {{}, RegularDegree(x_, y_)}, {});
  }

 private:
  Node node_of(const CertifiedPoint& point) const {
    return landmark_node(system_, scale_.frame, enclose<DoubleBall>(point, power_of_two(-50)), point.box(),
                         point.sides());
  }

  BoundedVertex vertex_of(const CertifiedPoint& point) const {
    const auto ball = enclose<DoubleBall>(point, power_of_two(-50));
    return bounded_vertex(ball, system_.taylor_x(ball)[0], scale_.frame);
  }

  /// The pair with these fractions for the parameters counted from the apex.
  CertifiedPoint pair_at(const TriangularPoint& at, std::array<BivariatePolynomial, 2> numerator,
                         const std::array<BivariatePolynomial, 2>& denominator) const {
    const BivariatePolynomial one = BivariatePolynomial::constant(1);
    ExactParameters exact{at, {}, {one, one, one, one}};
    for (const std::size_t k : {0U, 1U}) {
      const auto [across, along] = cones_[k].parameters;
      exact.numerator[across] = cones_[k].reversed ? denominator[k] - numerator[k] : numerator[k];
      exact.denominator[across] = denominator[k];
      exact.numerator[along] = k == 0 ? BivariatePolynomial::r() : BivariatePolynomial::s();
    }
    std::vector<Side> sides;
    for (const Parameter p : all_parameters)
      for (const int value : {0, 1})
        if (takes_value(exact, index(p), RealAlgebraic(value))) sides.push_back({p, value});
    return certified(std::move(exact), sides);
  }

  /// c(v) = f d(s), f > 0: from the apex to u = 1, r = f or u = 1/f, r = 1.
  void add_ruling(const TriangularPoint& at, int apex) {
    std::size_t k = 0;
    while (sign_at(d_[k], at) == 0) ++k;
    if (sign_at(c_[k], at) != sign_at(d_[k], at)) return;
    const BivariatePolynomial zero;
    const BivariatePolynomial one = BivariatePolynomial::constant(1);
    const bool to_first = sign_at(d_[k] - c_[k], at) * sign_at(d_[k], at) >= 0;
    const CertifiedPoint start = pair_at(at, {zero, zero}, {one, one});
    const CertifiedPoint end =
        to_first ? pair_at(at, {one, c_[k]}, {one, d_[k]}) : pair_at(at, {d_[k], one}, {c_[k], one});
    const BoundedVertex from = vertex_of(start);
    const BoundedVertex to = vertex_of(end);
    const bool on_side = std::ranges::any_of(end.sides(), [&](const Side& side) {
      return index(side.parameter) == cones_[0].parameters[1] ||
             index(side.parameter) == cones_[1].parameters[1];
    });
    const PolynomialVector turn = {d_[0].derivative_s(), d_[1].derivative_s(), d_[2].derivative_s()};
    const PolynomialVector normal =
        cross(c_, PolynomialVector{c_[0].derivative_r(), c_[1].derivative_r(), c_[2].derivative_r()});
    const bool touch = sign_at(dot(normal, turn), at) == 0;
    Arc arc{};
    arc.from = apex;
    arc.to = graph_.add_node(node_of(end));
    arc.place = on_side ? ArcPlace::patch_boundary : ArcPlace::interior;
    arc.contact = touch ? Contact::tangential : Contact::transversal;
    arc.polyline = {from.vertex, to.vertex};
    arc.error_bound = larger_bound(from.error, to.error);
    graph_.add_arc(std::move(arc));
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  CommonPole apex_;
  std::array<Cone, 2> cones_;
  PolynomialVector c_;
  PolynomialVector d_;
  ModelScale scale_ = model_scale(x_, y_);
  PairSystem<DoubleBall> system_{x_, y_, scale_.origin, scale_.frame.exponent};
  GraphBuilder graph_;
};

}  // namespace

std::optional<IntersectResult> intersect_cones(const BezierPatch& x, const BezierPatch& y) {
  const std::vector<CommonPole> poles = common_poles(x, y);
  if (poles.size() != 1) return std::nullopt;
  const auto of_x = cone_from(x, poles.front().of_x);
  const auto of_y = cone_from(y, poles.front().of_y);
  if (!of_x || !of_y) return std::nullopt;
  return TwoCones(x, y, poles.front(), *of_x, *of_y).run();
}

}  // namespace exsect
