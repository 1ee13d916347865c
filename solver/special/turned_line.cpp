#include "special/turned_line.h"

#include <algorithm>

#include "answer/parameter_box.h"
#include "line/exact_line_points.h"
#include "line/known_tangent.h"
#include "line/line_place.h"
#include "side/boundary_lines.h"

namespace exsect {

bool lies_on(const Node& node, const Side& side) {
  return std::find(node.on.begin(), node.on.end(), side) != node.on.end();
}

namespace {

constexpr const char* kNotToldApart = "the arcs on a side along which a patch is singular are not told apart";

/// The point is an isolated one, or the end of an arc, with a kind that says so.
bool has_singular_kind(const Node& node) {
  return std::any_of(node.kinds.begin(), node.kinds.end(), [](NodeKind kind) {
    return kind == NodeKind::touch || kind == NodeKind::crossing || kind == NodeKind::cusp;
  });
}

}  // namespace

TurnedLine::TurnedLine(const BezierPatch& x, const BezierPatch& y, Side side, const ModelScale& scale,
                       double tolerance, const StopRequest& stop)
    : x_(x),
      y_(y),
      side_(side),
      along_(index(line_place({side.parameter, side.value}).roles.line)),
      isolated_(exact_line_points(x, y, {side.parameter, side.value})) {
  if (!isolated_.on_patch.empty())
    arcs_ = line_arcs(x, y, {side.parameter, side.value}, scale, tolerance, stop, false);
}

std::optional<std::vector<bool>> TurnedLine::arcs_along(const GraphBuilder& graph) const {
  if (isolated_.incomplete || arcs_.incomplete) return std::nullopt;
  std::vector<bool> along(graph.arcs().size(), false);
  if (arcs_.arcs.empty()) return along;
  std::vector<RationalInterval> ranges(graph.arcs().size());
  for (std::size_t i = 0; i < along.size(); ++i) {
    const Arc& arc = graph.arcs()[i];
    const Node& from = graph.node(arc.from);
    const Node& to = graph.node(arc.to);
    along[i] = arc.place == ArcPlace::patch_boundary && lies_on(from, side_) && lies_on(to, side_) &&
               std::all_of(arc.polyline.begin(), arc.polyline.end(), [&](const PolylineVertex& vertex) {
                 return vertex.parameters[index(side_.parameter)] == side_.value;
               });
    ranges[i] = {std::min(from.box[along_].upper, to.box[along_].upper),
                 std::max(from.box[along_].lower, to.box[along_].lower)};
    if (along[i] && !(ranges[i].lower < ranges[i].upper)) return std::nullopt;
  }
  // Every arc on the line is among these, strictly monotone; over no value are there more of them.
  for (std::size_t i = 0; i < along.size(); ++i) {
    if (!along[i]) continue;
    const Rational middle = ranges[i].midpoint();
    const auto candidates = [&] {
      long count = 0;
      for (std::size_t j = 0; j < along.size(); ++j)
        count += along[j] && ranges[j].lower <= middle && middle <= ranges[j].upper ? 1 : 0;
      return count;
    };
    const auto true_arcs = std::count_if(arcs_.arcs.begin(), arcs_.arcs.end(), [&](const LineArc& arc) {
      return arcs_.ends[arc.from].box()[along_].upper < middle &&
             middle < arcs_.ends[arc.to].box()[along_].lower;
    });
    if (candidates() != true_arcs) return std::nullopt;
  }
  return along;
}

bool TurnedLine::is_singular(const Node& node) const {
  std::vector<const CertifiedPoint*> near;
  for (const CertifiedPoint& point : isolated_.points)
    if (meet(point.box(), node.box)) near.push_back(&point);
  return near.size() == 1 && is_known_singular(x_, y_, *near.front());
}

void mark_turned_line(GraphBuilder& graph, std::vector<Incomplete>& undecided, const BezierPatch& x,
                      const BezierPatch& y, Side side, const ModelScale& scale, double tolerance,
                      const StopRequest& stop) {
  if (std::none_of(graph.nodes().begin(), graph.nodes().end(),
                   [&](const Node& n) { return lies_on(n, side); }))
    return;
  const TurnedLine line(x, y, side, scale, tolerance, stop);
  const auto along = line.arcs_along(graph);
  if (!along) {
    Incomplete unknown = {whole_domain(), kNotToldApart};
    unknown.where[index(side.parameter)] = {side.value, side.value};
    undecided.push_back(std::move(unknown));
    return;
  }
  std::vector<std::size_t> degree(graph.nodes().size(), 0);
  std::vector<bool> touching(graph.nodes().size(), false);  // an arc whose points are all singular ends here
  for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
    if ((*along)[i]) graph.set_contact(static_cast<int>(i), Contact::tangential);
    const Arc& arc = graph.arcs()[i];
    for (const int end : {arc.from, arc.to}) {
      ++degree[static_cast<std::size_t>(end)];
      if (arc.contact == Contact::tangential) touching[static_cast<std::size_t>(end)] = true;
    }
  }
  for (std::size_t i = 0; i < graph.nodes().size(); ++i) {
    const Node& node = graph.nodes()[i];
    if (!lies_on(node, side) || touching[i] || !node.free.empty() || has_singular_kind(node)) continue;
    if (line.is_singular(node)) graph.add_kind(node.id, singular_kind(degree[i], false));
  }
}

}  // namespace exsect
