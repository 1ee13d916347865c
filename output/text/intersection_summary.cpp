#include "output/text/intersection_summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "output/text/node_place.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

std::string ids(const std::vector<int>& numbers) {
  std::vector<std::string> texts;
  for (int number : numbers) texts.push_back(std::to_string(number));
  return joined(texts, " ");
}

std::string shapes_text(const IntersectionGraph& graph) {
  std::vector<std::string> parts;
  for (ComponentShape shape : {ComponentShape::open, ComponentShape::closed, ComponentShape::branched}) {
    if (graph.count(shape) > 0) parts.push_back(fmt::format("{} {}", graph.count(shape), name(shape)));
  }
  return parts.empty() ? "" : " (" + joined(parts, ", ") + ")";
}

std::string headline(const IntersectResult& result, const PatchNames& names) {
  const IntersectionGraph& graph = result.graph;
  std::string text = fmt::format("{} with {}: {}, proved: {}{}", printable(names.first),
                                 names.parameters == self_names ? "itself" : printable(names.second),
                                 result.status == Status::complete ? "complete" : "incomplete",
                                 counted(graph.components.size(), "component"), shapes_text(graph));
  if (!graph.isolated_points.empty()) text += ", " + counted(graph.isolated_points.size(), "isolated point");
  if (!graph.overlaps.empty()) text += ", " + counted(graph.overlaps.size(), "overlap");
  return text + "\n";
}

std::string turning_text(const IntersectionGraph& graph, const ParameterNames& names) {
  std::vector<std::string> counts;
  for (Parameter p : named_parameters(names))
    counts.push_back(fmt::format("{} in {}", graph.turning_points(p), name(p, names)));
  return fmt::format("{} on the boundary; turning points: {}\n",
                     counted(static_cast<std::size_t>(graph.boundary_points()), "point"),
                     joined(counts, ", "));
}

std::string components_text(const IntersectionGraph& graph) {
  std::vector<std::vector<std::string>> rows;
  for (const Component& component : graph.components) {
    rows.push_back({std::to_string(component.id), name(component.shape), ids(component.arcs)});
  }
  return table({"component", "shape", "arcs"}, rows);
}

std::vector<std::string> node_words(const Node& node, const ParameterNames& names) {
  std::vector<std::string> kinds;
  for (NodeKind kind : node.kinds) kinds.push_back(name(kind));
  std::vector<std::string> places;
  for (Side side : node.on) places.push_back(side_name(side, names));
  places.insert(places.end(), node.bounds.begin(), node.bounds.end());
  std::vector<std::string> wrt;
  for (Parameter p : node.wrt) wrt.push_back(name(p, names));
  return {std::to_string(node.id), joined(kinds, ", "), joined(places, " "), joined(wrt, " ")};
}

std::vector<ParameterBox> node_boxes(const IntersectionGraph& graph) {
  std::vector<ParameterBox> boxes;
  for (const Node& node : graph.nodes) boxes.push_back(node.box);
  return boxes;
}

/// `places`: what place_rows gives for the nodes.
std::string nodes_text(const IntersectionGraph& graph, const ParameterNames& names,
                       const std::vector<std::vector<std::string>>& places) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    rows.push_back(node_words(graph.nodes[i], names));
    rows.back().insert(rows.back().end(), places[i].begin(), places[i].end());
  }
  std::vector<std::string> heads = {"node", "kind", "on", "turns in"};
  for (const Parameter p : named_parameters(names)) heads.emplace_back(name(p, names));
  heads.insert(heads.end(), {"x", "y", "z"});
  return table(heads, rows);
}

const char* sign_text(int sign) { return sign > 0 ? "+" : "-"; }

std::string sides_text(const std::optional<SideSigns>& beside) {
  return beside ? fmt::format("{} {}", sign_text(beside->left), sign_text(beside->right)) : "";
}

std::vector<std::string> arc_row(const Arc& arc, const ParameterNames& names) {
  std::string remark;
  if (arc.place == ArcPlace::patch_boundary) remark = name(arc.place);
  if (arc.contact == Contact::tangential)
    remark += (remark.empty() ? "" : ", ") + std::string(name(arc.contact));
  for (Parameter p : arc.free)
    remark += (remark.empty() ? "" : ", ") + fmt::format("{} free", name(p, names));
  return {std::to_string(arc.id),
          std::to_string(arc.component),
          std::to_string(arc.from),
          std::to_string(arc.to),
          std::to_string(arc.polyline.size()),
          sides_text(arc.beside),
          rounded_up(arc.error_bound),
          remark};
}

std::string arcs_text(const IntersectionGraph& graph, const ParameterNames& names) {
  std::vector<std::vector<std::string>> rows;
  for (const Arc& arc : graph.arcs) rows.push_back(arc_row(arc, names));
  if (rows.empty()) return "";
  const bool has_sides =
      std::ranges::any_of(graph.arcs, [](const Arc& arc) { return arc.beside.has_value(); });
  if (!has_sides)
    for (std::vector<std::string>& row : rows) row.erase(row.begin() + 5);
  std::vector<std::string> heads = {"arc", "component", "from", "to", "vertices"};
  if (has_sides) heads.emplace_back("sides");
  heads.insert(heads.end(), {"error at most", ""});
  return table(heads, rows) +
         "  error: largest distance of polyline and true arc from each other in space, in the unit of the "
         "control "
         "points\n" +
         (has_sides
              ? "  sides: of the second surface on which the first one lies, left and right of the arc\n"
              : "");
}

std::string normals_text(const Overlap& overlap) {
  if (!overlap.normals) return "";
  return *overlap.normals > 0 ? "same normals" : "opposite normals";
}

std::string overlaps_text(const IntersectionGraph& graph) {
  std::vector<std::vector<std::string>> rows;
  for (const Overlap& overlap : graph.overlaps) {
    for (const std::vector<Arc>& chain : overlap.chains) {
      std::vector<int> nodes;
      double bound = 0;
      for (const Arc& arc : chain) {
        nodes.push_back(arc.from);
        bound = std::max(bound, arc.error_bound);
      }
      nodes.push_back(chain.back().to);
      rows.push_back({std::to_string(overlap.id), ids(nodes), rounded_up(bound), normals_text(overlap)});
    }
  }
  return table({"overlap", "nodes of the rim", "error at most", ""}, rows);
}

/// Which arithmetic decided; its counts and times follow where they are asked for.
std::string work_text(const Work& work, bool verbose) {
  const char* arithmetic =
      work.steps.count("filtered") > 0 ? "in doubles with proved error bounds" : "in exact arithmetic";
  const std::string text = fmt::format("{:.1f} ms, {}\n", work.milliseconds, arithmetic);
  if (!verbose || work.steps.empty()) return text;
  std::vector<std::string> steps;
  for (const auto& [step, count] : work.steps)
    steps.push_back(fmt::format("{} {:.6g}", printable(step), count));
  return text + "  " + joined(steps, ", ") + "\n";
}

std::string incomplete_text(const std::vector<Incomplete>& regions, const ParameterNames& names) {
  if (regions.empty()) return "";
  std::string text = "\nNot decided:\n";
  for (const Incomplete& region : regions) {
    text += fmt::format("  {}\n    {}\n", box_text(region.where, names), printable(region.why));
  }
  return text;
}

std::string coarse_text(const std::optional<CoarseDrawing>& coarse) {
  if (!coarse) return "";
  return fmt::format("\nDrawn to {}: polylines of doubles do not keep the tolerance {} here\n",
                     rounded_up(coarse->bound), rounded_up(coarse->tolerance));
}

std::string isolated_text(const IntersectionGraph& graph) {
  if (graph.isolated_points.empty()) return "";
  std::vector<std::string> points;
  for (const int id : graph.isolated_points) {
    const auto& around = graph.nodes[static_cast<std::size_t>(id)].around;
    points.push_back(std::to_string(id) + (around ? fmt::format(" (side {})", sign_text(*around)) : ""));
  }
  return "\n  isolated points: nodes " + joined(points, " ") + "\n";
}

std::string section(const std::string& text) { return text.empty() ? "" : "\n" + text; }

std::string summary_of(const IntersectResult& result, const PatchNames& names,
                       const std::vector<std::vector<std::string>>& places, bool verbose) {
  const IntersectionGraph& graph = result.graph;
  return headline(result, names) + turning_text(graph, names.parameters) + section(components_text(graph)) +
         section(nodes_text(graph, names.parameters, places)) + section(arcs_text(graph, names.parameters)) +
         section(overlaps_text(graph)) + isolated_text(graph) +
         incomplete_text(result.incomplete, names.parameters) + coarse_text(result.coarse) + "\n" +
         work_text(result.work, verbose);
}

}  // namespace

std::string intersection_summary(const IntersectResult& result, const PatchNames& names,
                                 const RationalPatch& x, const RationalPatch& y, bool verbose) {
  return summary_of(result, names, place_rows(node_boxes(result.graph), x, y, shown_decimals(verbose)),
                    verbose);
}

std::string intersection_summary(const IntersectResult& result, const PatchNames& names,
                                 const RationalPatch& x, bool verbose) {
  return summary_of(result, names, place_rows(node_boxes(result.graph), x, shown_decimals(verbose)), verbose);
}

}  // namespace exsect::cli
