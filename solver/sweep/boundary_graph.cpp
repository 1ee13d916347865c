#include "sweep/boundary_graph.h"

#include <algorithm>

#include "answer/parameter_box.h"
#include "line/known_tangent.h"
#include "line/line_place.h"
#include "side/collapsed_line.h"
#include "trace/enclose.h"
#include "trace/landmark_node.h"

namespace exsect {

bool leaves_sides(const StarNeighbourhood& star) {
  return std::any_of(star.ports.begin(), star.ports.end(),
                     [](const Port& port) { return port.point.sides().empty(); });
}

template <class Ball>
void BoundaryGraph<Ball>::incomplete(const ParameterBox& where, const std::string& why) {
  undecided_.push_back({where, why});
}

template <class Ball>
void BoundaryGraph<Ball>::add_arcs() {
  for (const SideArc& arc : sides_.arcs)
    if (!arc.collapsed) add_side_arc(arc);
}

template <class Ball>
void BoundaryGraph<Ball>::contract() {
  for (const SideArc& arc : sides_.arcs)
    if (arc.collapsed) contract_side(arc);
  for (const CommonPole& pole : sides_.poles) contract_pole(pole);
}

/// An arc on a side, split at the stars on it in which other arcs end.
template <class Ball>
void BoundaryGraph<Ball>::add_side_arc(const SideArc& whole) {
  const Side& side = whole.side;
  const std::size_t along = index(line_place({side.parameter, side.value}).roles.line);
  std::vector<std::pair<double, int>> cuts;
  for (std::size_t k = 0; k < stars_.size(); ++k) {
    if (leaves_sides(stars_[k]) && lies_inside(stars_[k].centre, whole, side, along)) {
      cuts.emplace_back(to_double(stars_[k].centre.box()[along].midpoint()), star_nodes_[k]);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<PolylineVertex> polyline = {whole.polyline.front()};
  int from = static_cast<int>(whole.from);
  const auto finish = [&](int to) {
    push_side_arc(from, to, whole, polyline, tangential_at(whole.inside));
    from = to;
  };
  std::size_t cut = 0;
  for (std::size_t i = 1; i < whole.polyline.size(); ++i) {
    for (; cut < cuts.size() && cuts[cut].first <= whole.polyline[i].parameters[along]; ++cut) {
      const Node& node = graph_.node(cuts[cut].second);
      polyline.push_back({node.approx, node.point});
      finish(node.id);
      polyline = {{node.approx, node.point}};
    }
    polyline.push_back(whole.polyline[i]);
  }
  finish(static_cast<int>(whole.to));
}

/// A side that is one point of space: its ends, and the landmarks and stars on it, are one node.
template <class Ball>
void BoundaryGraph<Ball>::contract_side(const SideArc& arc) {
  const Side& side = arc.side;
  const Parameter along = line_place({side.parameter, side.value}).roles.line;
  std::vector<int> nodes = {static_cast<int>(arc.from), static_cast<int>(arc.to)};
  for (std::size_t i = 0; i < sides_.points.size(); ++i) {
    if (lies_inside(sides_.points[i], arc, side, index(along))) {
      nodes.push_back(static_cast<int>(i));
    }
  }
  for (std::size_t k = 0; k < stars_.size(); ++k) {
    if (lies_inside(stars_[k].centre, arc, side, index(along))) {
      nodes.push_back(star_nodes_[k]);
    }
  }
  const auto ball = enclose<Ball>(arc.inside, power_of_two(-50));
  const Node inside = landmark_node(system_, frame_, ball, arc.inside.box(), arc.inside.sides());
  graph_.contract(nodes, collapsed_node(arc.inside, inside, along));
}

/// All landmarks on the pole are one node.
template <class Ball>
void BoundaryGraph<Ball>::contract_pole(const CommonPole& pole) {
  std::vector<int> nodes;
  for (std::size_t i = 0; i < sides_.points.size(); ++i) {
    if (is_on(sides_.points[i], pole)) {
      nodes.push_back(static_cast<int>(i));
    }
  }
  const CertifiedPoint inside = pair_on(pole, Rational(1, 2), Rational(1, 2));
  const Node node =
      landmark_node(system_, frame_, enclose<Ball>(inside, power_of_two(-50)), inside.box(), inside.sides());
  graph_.contract(nodes, pole_node(pole, inside, node));
}

/// The star's centre is a point of the arc, not an end: the only arc on that side that can reach it.
template <class Ball>
bool BoundaryGraph<Ball>::lies_inside(const CertifiedPoint& centre, const SideArc& arc, const Side& side,
                                      std::size_t along) {
  const ParameterBox box = centre.refined_to(power_of_two(-100)).box();
  const auto reaches = [&](const SideArc& other) {
    const auto at = [&](std::size_t end) { return sides_.points[end].box()[along]; };
    return other.inside.on(side) && other.collapsed == arc.collapsed &&
           std::any_of(other.hulls.begin(), other.hulls.end(),
                       [&](const ParameterBox& h) { return meet(box, h); }) &&
           at(other.from).upper < box[along].lower && at(other.to).lower > box[along].upper;
  };
  if (!centre.on(side) || !reaches(arc)) {
    return false;
  }
  if (std::count_if(sides_.arcs.begin(), sides_.arcs.end(), reaches) > 1) {
    incomplete(centre.box(), "arcs on one side lie over the same values of its parameter");
  }
  return true;
}

template <class Ball>
void BoundaryGraph<Ball>::push_side_arc(int from, int to, const SideArc& whole,
                                        const std::vector<PolylineVertex>& polyline, bool tangential) {
  Arc arc{};
  arc.from = from;
  arc.to = to;
  arc.place = ArcPlace::patch_boundary;
  arc.contact = tangential ? Contact::tangential : Contact::transversal;
  arc.polyline = polyline;
  arc.error_bound = 2 * whole.error_bound;  // a node in the middle is within the bound of the chord it splits
  graph_.add_arc(std::move(arc));
}

namespace {

template <class Ball>
bool is_surely_regular(const PairSystem<Ball>& system, const CertifiedPoint& point) {
  const BallPoint<Ball> tangent = Expansion<Ball>(system, enclose<Ball>(point, power_of_two(-200))).tangent();
  return std::any_of(tangent.begin(), tangent.end(), [](const Ball& t) { return t.certain_sign() != 0; });
}

}  // namespace

/// The patches touch along the arc. At one point the tangent vanishes exactly or surely not.
template <class Ball>
bool BoundaryGraph<Ball>::tangential_at(const CertifiedPoint& inside) {
  const Point origin = {from_double(frame_.origin[0]), from_double(frame_.origin[1]),
                        from_double(frame_.origin[2])};
  if (is_surely_regular(system_, inside) ||
      is_surely_regular(PairSystem<ArbBall<256>>(pair_.x, pair_.y, origin, frame_.exponent), inside)) {
    return false;
  }
  if (!is_known_singular(pair_.x, pair_.y, inside)) {
    undecided_.push_back({inside.box(),
                          "whether the patches touch along the arc through this point is not decided",
                          Reason::tangency});
  }
  return true;
}

template class BoundaryGraph<DoubleBall>;
template class BoundaryGraph<DoubleDoubleBall>;
template class BoundaryGraph<ArbBall<256>>;
template class BoundaryGraph<ArbBall<1024>>;

}  // namespace exsect
