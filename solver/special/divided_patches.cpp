#include "special/divided_patches.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "answer/finished_result.h"
#include "answer/parameter_box.h"
#include "curve/plane_curve.h"
#include "curve/polynomial_vector.h"
#include "shape/special_cusps.h"
#include "side/collapsed_line.h"
#include "trace/regular_degree.h"

namespace exsect {

namespace {

/// The values of a parameter at the ends of pieces, ascending from 0 to 1.
using Ends = std::array<std::vector<Rational>, 4>;

bool contains(const BezierPatch& patch, const Point& point) {
  const PolynomialVector equations = coordinates_from(patch, point);
  return have_common_zero({equations.begin(), equations.end()});
}

/// The lines second = constant inside the square that are one point of `other`. Empty if one is irrational.
std::optional<std::vector<Rational>> lines_on(const BezierPatch& patch, const BezierPatch& other) {
  std::vector<Rational> result;
  for (const RealAlgebraic& line : collapsed_lines(patch)) {
    if (line.compare(0) == 0 || line.compare(1) == 0) continue;
    if (!line.is_rational()) return std::nullopt;
    if (contains(other, patch(0, line.rational()))) result.push_back(line.rational());
  }
  return result;
}

/// Divides the two parameters of a patch, the first of which has the index `first`; false if it cannot.
bool divide(const BezierPatch& patch, const BezierPatch& other, std::size_t first, Ends& ends) {
  const auto across_first = lines_on(patch.exchanged(), other);
  const auto across_second = lines_on(patch, other);
  if (!across_first || !across_second || (!across_first->empty() && !across_second->empty())) return false;
  ends[first].insert(ends[first].end() - 1, across_first->begin(), across_first->end());
  ends[first + 1].insert(ends[first + 1].end() - 1, across_second->begin(), across_second->end());
  return true;
}

std::vector<RationalInterval> intervals_between(const std::vector<Rational>& ends) {
  std::vector<RationalInterval> result;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) result.push_back({ends[i], ends[i + 1]});
  return result;
}

BezierPatch piece(const BezierPatch& patch, const RationalInterval& first, const RationalInterval& second) {
  return patch.restricted_to(first.lower, first.upper, second.lower, second.upper);
}

/// The graph of a piece in the parameters of the whole.
class Lift {
 public:
  explicit Lift(const ParameterBox& over) : over_(over) {}

  ParameterBox operator()(const ParameterBox& box) const {
    ParameterBox result;
    for (std::size_t i = 0; i < 4; ++i) {
      const Rational width = over_[i].width();
      result[i] = {over_[i].lower + width * box[i].lower, over_[i].lower + width * box[i].upper};
    }
    return result;
  }

  std::array<double, 4> operator()(const std::array<double, 4>& at) const {
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < 4; ++i)
      result[i] = to_double(over_[i].lower + over_[i].width() * from_double(at[i]));
    return result;
  }

  bool is_inside(const Side& side) const {
    const RationalInterval& range = over_[index(side.parameter)];
    return side.value == 0 ? range.lower != 0 : range.upper != 1;
  }

  Rational place(const Side& side) const {
    const RationalInterval& range = over_[index(side.parameter)];
    return side.value == 0 ? range.lower : range.upper;
  }

 private:
  const ParameterBox& over_;
};

/// The lines of division that a node lies on.
using Lines = std::vector<std::pair<Parameter, Rational>>;

class Joint {
 public:
  void add(const PairOfPieces& pair, IntersectResult result) {
    const Lift lift(pair.over);
    const int first = static_cast<int>(graph_.nodes().size());
    for (Node& node : result.graph.nodes) add_node(lift, std::move(node));
    for (Arc& arc : result.graph.arcs) {
      for (PolylineVertex& vertex : arc.polyline) vertex.parameters = lift(vertex.parameters);
      arc.from += first;
      arc.to += first;
      graph_.add_arc(std::move(arc));
    }
    for (const int id : result.graph.isolated_points) graph_.add_isolated(first + id);
    for (Incomplete& part : result.incomplete) incomplete_.push_back({lift(part.where), std::move(part.why)});
  }

  IntersectResult finished(const GraphFacts& facts) && {
    for (const auto& [lines, nodes] : on_lines_) join(lines, nodes);
    return exsect::finished(std::move(graph_), facts, std::move(incomplete_));
  }

 private:
  void add_node(const Lift& lift, Node node) {
    Lines lines;
    for (const Side& side : node.on)
      if (lift.is_inside(side)) lines.emplace_back(side.parameter, lift.place(side));
    node.box = lift(node.box);
    node.approx = lift(node.approx);
    std::erase_if(node.on, [&](const Side& side) { return lift.is_inside(side); });
    if (!lines.empty()) {
      node.wrt.clear();
      node.kinds.clear();
      if (!node.on.empty()) node.kinds.push_back(NodeKind::boundary);
      if (is_corner(node.on)) node.kinds.push_back(NodeKind::corner);
    }
    const bool free =
        std::ranges::all_of(lines, [&](const auto& line) { return is_free_along(node, line.first); });
    const int id = graph_.add_node(std::move(node));
    if (!free)
      undecided(id, "a point of a line that is one point of space does not stand for all of the line");
    if (!lines.empty()) on_lines_[lines].push_back(id);
  }

  void undecided(int node, const char* why) { incomplete_.push_back({graph_.node(node).box, why}); }

  static bool is_free_along(const Node& node, Parameter across) {
    return std::ranges::any_of(node.free,
                               [&](Parameter p) { return p != across && index(p) / 2 == index(across) / 2; });
  }

  /// All pieces at a line of division have the same points on it: twice as many pieces for each line. Nodes
  /// with boxes that meet are one, if they are as many as these pieces and meet no other.
  void join(const Lines& lines, const std::vector<int>& nodes) {
    const std::size_t pieces = std::size_t{1} << lines.size();
    std::vector<std::vector<int>> groups;
    for (const int id : nodes) {
      const auto meets_it = [&](int other) { return meet(graph_.node(id).box, graph_.node(other).box); };
      const auto group = std::ranges::find_if(
          groups, [&](const std::vector<int>& g) { return std::ranges::any_of(g, meets_it); });
      if (group == groups.end())
        groups.push_back({id});
      else
        group->push_back(id);
    }
    for (const std::vector<int>& group : groups) {
      if (group.size() == pieces) {
        graph_.contract(group, graph_.node(group.front()));
      } else {
        undecided(group.front(), "points on a line that is one point of space were not told apart");
      }
    }
  }

  GraphBuilder graph_;
  std::map<Lines, std::vector<int>> on_lines_;
  std::vector<Incomplete> incomplete_;
};

}  // namespace

std::optional<std::vector<PairOfPieces>> divided_pair(const BezierPatch& x, const BezierPatch& y) {
  Ends ends;
  ends.fill({0, 1});
  if (!divide(x, y, 0, ends) || !divide(y, x, 2, ends)) return std::nullopt;
  if (std::ranges::all_of(ends, [](const auto& values) { return values.size() == 2; })) return std::nullopt;
  std::array<std::vector<RationalInterval>, 4> ranges;
  for (std::size_t i = 0; i < 4; ++i) ranges[i] = intervals_between(ends[i]);
  std::vector<PairOfPieces> result;
  for (const auto& u : ranges[0])
    for (const auto& v : ranges[1])
      for (const auto& r : ranges[2])
        for (const auto& s : ranges[3]) result.push_back({piece(x, u, v), piece(y, r, s), {u, v, r, s}});
  return result;
}

std::optional<IntersectResult> joined(const std::vector<PairOfPieces>& pieces,
                                      std::vector<IntersectResult> of_pieces, const BezierPatch& x,
                                      const BezierPatch& y, const Run& run) {
  if (std::ranges::any_of(of_pieces, [](const IntersectResult& r) { return !r.graph.overlaps.empty(); }))
    return std::nullopt;
  Joint joint;
  for (std::size_t i = 0; i < pieces.size(); ++i) joint.add(pieces[i], std::move(of_pieces[i]));
  return std::move(joint).finished({run.turning(), RegularDegree(x, y)});
}

}  // namespace exsect
