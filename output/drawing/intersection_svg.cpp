#include "output/drawing/intersection_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "output/drawing/svg_legend.h"
#include "output/drawing/svg_square.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

constexpr double squares_top = 78;
constexpr std::size_t most_listed = 8;  // components in the legend

struct KindMark {
  NodeKind kind;
  Mark mark;
  const char* text;
};

/// In drawing order: what is rarer is drawn later, on top.
constexpr std::array<KindMark, 7> kind_marks = {{{NodeKind::turning, Mark::ring, "turning point"},
                                                 {NodeKind::boundary, Mark::square, "boundary point"},
                                                 {NodeKind::corner, Mark::diamond, "corner"},
                                                 {NodeKind::end_of_overlap, Mark::dot, "end of overlap"},
                                                 {NodeKind::touch, Mark::plus, "touch"},
                                                 {NodeKind::crossing, Mark::cross, "crossing"},
                                                 {NodeKind::cusp, Mark::triangle, "cusp"}}};

bool has(const Node& node, NodeKind kind) {
  return std::find(node.kinds.begin(), node.kinds.end(), kind) != node.kinds.end();
}

/// The plane point of (u,v,r,s) in square 0 (u,v) or 1 (r,s).
PlanePoint in_square(const std::array<double, 4>& parameters, std::size_t square) {
  return {parameters[2 * square], parameters[2 * square + 1]};
}

PlanePolyline in_square(const Arc& arc, std::size_t square) {
  PlanePolyline polyline;
  for (const PolylineVertex& vertex : arc.polyline) polyline.push_back(in_square(vertex.parameters, square));
  return polyline;
}

bool is_free(const std::vector<Parameter>& free, std::size_t parameter) {
  return std::any_of(free.begin(), free.end(), [&](Parameter p) { return index(p) == parameter; });
}

bool is_free_in(const std::vector<Parameter>& free, std::size_t square) {
  return is_free(free, 2 * square) || is_free(free, 2 * square + 1);
}

PlanePolyline rectangle(PlanePoint a, PlanePoint b) { return {a, {b[0], a[1]}, b, {a[0], b[1]}, a}; }

std::string component_colour(int component) {
  return palette(static_cast<std::size_t>(std::max(component, 0)));
}

Stroke arc_stroke(const Arc& arc) {
  return {component_colour(arc.component), arc.place == ArcPlace::patch_boundary ? 4.0 : 2.0,
          arc.contact == Contact::tangential ? "7 5" : ""};
}

/// One ring through the arcs of a chain, each turned round where it has to be.
PlanePolyline ring(const std::vector<Arc>& chain, std::size_t square) {
  PlanePolyline points;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Arc& next = chain[(i + 1) % chain.size()];
    PlanePolyline piece = in_square(chain[i], square);
    const bool forward = chain.size() == 1 || chain[i].to == next.from || chain[i].to == next.to;
    if (!forward) std::reverse(piece.begin(), piece.end());
    points.insert(points.end(), piece.begin(), piece.end());
  }
  return points;
}

/// Colour of the component each node belongs to; black for a node of none.
std::vector<std::string> node_colours(const IntersectionGraph& graph) {
  std::vector<std::string> colours(graph.nodes.size(), "#000000");
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    for (const Arc& arc : graph.arcs) {
      if (arc.from == graph.nodes[i].id || arc.to == graph.nodes[i].id)
        colours[i] = component_colour(arc.component);
    }
  }
  return colours;
}

/// Whether the node turns with respect to a parameter of this square.
bool turns_in(const Node& node, std::size_t square) {
  return std::any_of(node.wrt.begin(), node.wrt.end(), [&](Parameter p) { return index(p) / 2 == square; });
}

/// The parameters of a node with free ones: a segment, or the whole square.
void draw_free(const Node& node, SvgSquare& drawn, std::size_t square, const std::string& colour) {
  PlanePoint from = in_square(node.approx, square);
  PlanePoint to = from;
  for (std::size_t k = 0; k < 2; ++k) {
    const RationalInterval& interval = node.box[2 * square + k];
    if (is_free(node.free, 2 * square + k)) {
      from[k] = to_double(interval.lower);
      to[k] = to_double(interval.upper);
    }
  }
  if (from[0] != to[0] && from[1] != to[1]) drawn.region({rectangle(from, to)}, colour);
  drawn.polyline({from, to}, {colour, 5});
}

/// The parameters of an arc with a free one: a strip of the square.
void draw_strip(const Arc& arc, SvgSquare& drawn, std::size_t square) {
  PlanePoint from = {1, 1};
  PlanePoint to = {0, 0};
  for (const PlanePoint& p : in_square(arc, square)) {
    for (std::size_t k = 0; k < 2; ++k) {
      from[k] = is_free(arc.free, 2 * square + k) ? 0 : std::min(from[k], p[k]);
      to[k] = is_free(arc.free, 2 * square + k) ? 1 : std::max(to[k], p[k]);
    }
  }
  drawn.region({rectangle(from, to)}, component_colour(arc.component));
}

void draw_nodes(const IntersectionGraph& graph, SvgSquare& drawn, std::size_t square) {
  const std::vector<std::string> colours = node_colours(graph);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    if (is_free_in(graph.nodes[i].free, square)) draw_free(graph.nodes[i], drawn, square, colours[i]);
  }
  for (const KindMark& entry : kind_marks) {
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      const Node& node = graph.nodes[i];
      if (!has(node, entry.kind)) continue;
      const bool elsewhere = entry.kind == NodeKind::turning && !turns_in(node, square);
      drawn.mark(elsewhere ? Mark::point : entry.mark, in_square(node.approx, square), colours[i]);
    }
  }
  for (int id : graph.isolated_points) {
    for (const Node& node : graph.nodes) {
      if (node.id == id) drawn.mark(Mark::plus, in_square(node.approx, square), "#000000");
    }
  }
}

void draw_square(const IntersectResult& result, SvgSquare& drawn, std::size_t square) {
  for (const Incomplete& region : result.incomplete) {
    const RationalInterval& across = region.where[2 * square];
    const RationalInterval& upwards = region.where[2 * square + 1];
    drawn.box({to_double(across.lower), to_double(upwards.lower)},
              {to_double(across.upper), to_double(upwards.upper)});
  }
  for (const Overlap& overlap : result.graph.overlaps) {
    std::vector<PlanePolyline> rings;
    for (const std::vector<Arc>& chain : overlap.chains) {
      rings.push_back(ring(chain, square));
      drawn.polyline(rings.back(), {"#000000", 1.2});
    }
    drawn.region(rings, "#56b4e9");
  }
  for (const Arc& arc : result.graph.arcs) {
    if (is_free_in(arc.free, square)) draw_strip(arc, drawn, square);
  }
  for (const Arc& arc : result.graph.arcs) drawn.polyline(in_square(arc, square), arc_stroke(arc));
  draw_nodes(result.graph, drawn, square);
}

SvgLegend legend(const IntersectResult& result, bool two_squares) {
  const IntersectionGraph& graph = result.graph;
  SvgLegend legend;
  for (std::size_t i = 0; i < std::min(graph.components.size(), most_listed); ++i) {
    const Component& component = graph.components[i];
    legend.add(Stroke{component_colour(component.id)},
               fmt::format("component {}, {}", component.id, name(component.shape)));
  }
  if (graph.components.size() > most_listed) {
    legend.add(Stroke{"none"}, fmt::format("and {} more", graph.components.size() - most_listed));
  }
  const auto arcs_with = [&](auto property) {
    return std::any_of(graph.arcs.begin(), graph.arcs.end(), property);
  };
  if (arcs_with([](const Arc& arc) { return arc.contact == Contact::tangential; })) {
    legend.add(Stroke{"#404040", 2, "7 5"}, "tangential contact");
  }
  if (arcs_with([](const Arc& arc) { return arc.place == ArcPlace::patch_boundary; })) {
    legend.add(Stroke{"#404040", 4}, "along a side of a patch");
  }
  for (const KindMark& entry : kind_marks) {
    const bool occurs = std::any_of(graph.nodes.begin(), graph.nodes.end(),
                                    [&](const Node& node) { return has(node, entry.kind); });
    if (!occurs) continue;
    legend.add(entry.mark, "#404040", entry.text);
    if (entry.kind == NodeKind::turning && two_squares)
      legend.add(Mark::point, "#404040", "turns in the other square");
  }
  if (std::any_of(graph.nodes.begin(), graph.nodes.end(), [](const Node& n) { return !n.free.empty(); })) {
    legend.add(Stroke{"#404040", 5}, "one point of space");
  }
  if (!graph.isolated_points.empty()) legend.add(Mark::plus, "#000000", "isolated point");
  if (!graph.overlaps.empty()) legend.add(Stroke{"#ddf0fb", 10}, "overlap");
  if (!result.incomplete.empty()) legend.add(Stroke{"#b0b0b0", 10}, "not decided");
  return legend;
}

/// "x(u, v)".
std::string square_heading(const PatchNames& names, std::size_t square) {
  return fmt::format("{}({}, {})", printable(square == 0 ? names.first : names.second),
                     names.parameters[2 * square], names.parameters[2 * square + 1]);
}

}  // namespace

std::string intersection_svg(const IntersectResult& result, const PatchNames& names,
                             const std::string& title) {
  return intersection_svg(result, names, title, {});
}

std::string intersection_svg(const IntersectResult& result, const PatchNames& names, const std::string& title,
                             const SquareAdditions& additions) {
  const bool two_squares = names.equation.empty();
  SvgLegend entries = legend(result, two_squares);
  for (const auto& [stroke, text] : additions.legend) entries.add(stroke, text);
  const double legend_width = pair_width - pair_left - 24;
  const double legend_top = squares_top + SvgSquare::size + 56;
  SvgPicture picture(pair_width, legend_top + entries.height(legend_width) + 14);
  picture.element("<g fill=\"#000000\">");
  const double title_size = text_width(title, 16) <= pair_width - 40 ? 16 : 13;
  picture.text(pair_width / 2, 28, fitted(title, title_size, pair_width - 40), title_size,
               TextAnchor::middle);
  const std::array<std::string, 2> heads = {
      square_heading(names, 0),
      two_squares ? square_heading(names, 1) : fmt::format("{} by its equation", printable(names.second))};
  const std::array<double, 2> lefts = {pair_left, pair_left + SvgSquare::size + pair_between};
  for (std::size_t square : {0, 1}) {
    picture.text(lefts[square] + SvgSquare::size / 2, squares_top - 14,
                 fitted(heads[square], 14, SvgSquare::size), 14, TextAnchor::middle);
  }
  picture.element("</g>");
  SvgSquare first(picture, lefts[0], squares_top, names.parameters[0], names.parameters[1]);
  const auto add_second = [&] {
    return two_squares ? std::optional<SvgSquare>(std::in_place, picture, lefts[1], squares_top,
                                                  names.parameters[2], names.parameters[3])
                       : std::nullopt;
  };
  std::optional<SvgSquare> second = add_second();
  const auto draw_lines = [&](const std::vector<SquareAdditions::Line>& lines) {
    for (const auto& line : lines) (line.square == 0 ? first : *second).polyline(line.points, line.stroke);
  };
  draw_lines(additions.below);
  draw_square(result, first, 0);
  if (second) draw_square(result, *second, 1);
  draw_lines(additions.above);
  for (const auto& mark : additions.marks)
    (mark.square == 0 ? first : *second).mark(Mark::cross, mark.at, "#d00000");
  entries.draw(picture, pair_left, legend_top, legend_width);
  return picture.document();
}

}  // namespace exsect::cli
