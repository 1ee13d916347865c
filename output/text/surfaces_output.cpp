#include "output/text/surfaces_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "output/text/proved_decimal.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

constexpr std::array all_curve_kinds = {SpaceCurveKind::line,      SpaceCurveKind::circle,
                                        SpaceCurveKind::ellipse,   SpaceCurveKind::parabola,
                                        SpaceCurveKind::hyperbola, SpaceCurveKind::general};

Json exact_point_json(const Point& p) {
  return Json::array({json_number(p[0]), json_number(p[1]), json_number(p[2])});
}

bool is_on_bound(const SpaceNode& node) { return !node.bounds[0].empty() || !node.bounds[1].empty(); }

Json node_on_surfaces_json(const SpaceNode& node) {
  Json box = Json::array();
  for (const RationalInterval& side : node.box) box.push_back(json_interval(side));
  Json json = {{"id", node.id}, {"kind", name(node.kind)}, {"degree", node.degree}};
  if (is_on_bound(node)) json["bounds"] = {{"first", node.bounds[0]}, {"second", node.bounds[1]}};
  json["box"] = std::move(box);
  json["approx"] = node.approx;
  if (node.around) json["around"] = *node.around;
  return json;
}

Json space_arc_json(const SpaceArc& arc) {
  Json json = {{"id", arc.id},
               {"curve", arc.curve},
               {"from", arc.from},
               {"to", arc.to},
               {"multiplicity", arc.multiplicity},
               {"polyline", arc.polyline},
               {"error_bound", decimal_not_below(arc.error_bound)}};
  if (arc.beside) {
    json["left"] = arc.beside->left;
    json["right"] = arc.beside->right;
  }
  return json;
}

Json space_curve_json(const SpaceCurve& curve) {
  Json json = {{"id", curve.id},
               {"kind", name(curve.kind)},
               {"closed", curve.is_closed},
               {"multiplicity", curve.multiplicity},
               {"arcs", curve.arcs}};
  if (curve.point) json["point"] = exact_point_json(*curve.point);
  if (curve.direction) json["direction"] = exact_point_json(*curve.direction);
  if (curve.radius_squared) json["radius_squared"] = json_number(*curve.radius_squared);
  return json;
}

template <class T, class Form>
Json listed(const std::vector<T>& values, Form form) {
  Json json = Json::array();
  for (const T& value : values) json.push_back(form(value));
  return json;
}

const char* noun(SpaceCurveKind kind) {
  return kind == SpaceCurveKind::general ? "general curve" : name(kind);
}

std::string plural(int number, const std::string& singular, const std::string& several) {
  return fmt::format("{} {}", number, number == 1 ? singular : several);
}

std::string exact_text(const std::optional<Point>& p) {
  if (!p) return "-";
  return fmt::format("({}, {}, {})", (*p)[0].str(), (*p)[1].str(), (*p)[2].str());
}

const char* contact_word(int multiplicity) {
  return multiplicity == 1 ? "transversal" : multiplicity == 0 ? "one surface" : "tangential";
}

std::string space_curve_table(const SurfaceIntersection& result) {
  std::vector<std::vector<std::string>> rows;
  for (const SpaceCurve& curve : result.curves)
    rows.push_back({std::to_string(curve.id), name(curve.kind), curve.is_closed ? "closed" : "open",
                    contact_word(curve.multiplicity), exact_text(curve.point), exact_text(curve.direction),
                    curve.radius_squared ? curve.radius_squared->str() : "-"});
  const std::string text =
      table({"curve", "kind", "shape", "contact", "point", "direction", "radius squared"}, rows);
  return text.empty() ? "" : "\n" + text;
}

std::string node_table(const SurfaceIntersection& result, bool verbose) {
  const bool has_bounds = std::ranges::any_of(result.nodes, is_on_bound);
  std::vector<std::vector<std::string>> rows;
  for (const SpaceNode& node : result.nodes) {
    if (node.kind == SpaceNodeKind::joint && !verbose) continue;
    rows.push_back({std::to_string(node.id), name(node.kind), std::to_string(node.degree)});
    if (has_bounds) rows.back().push_back(is_on_bound(node) ? bounds_text(node) : "-");
    for (const RationalInterval& side : node.box)
      rows.back().push_back(proved_decimal(side, verbose ? -15 : -6));
  }
  std::vector<std::string> heads = {"node", "kind", "arcs"};
  if (has_bounds) heads.push_back("on");
  heads.insert(heads.end(), {"x", "y", "z"});
  const std::string text = table(heads, rows);
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

std::string bounds_text(const SpaceNode& node) {
  std::string text;
  for (const std::size_t of : {0, 1})
    for (const std::string& bound : node.bounds[of])
      text += (text.empty() ? "" : " ") + std::string(of == 0 ? "first:" : "second:") + bound;
  return text;
}

std::string what_is_common(const SurfaceIntersection& result) {
  std::vector<std::string> parts;
  if (result.is_same) parts.push_back("one surface");
  for (const SpaceCurveKind kind : all_curve_kinds)
    if (const int number = result.count(kind); number > 0)
      parts.push_back(
          plural(number, noun(kind),
                 kind == SpaceCurveKind::hyperbola ? "hyperbolas" : std::string(noun(kind)) + "s"));
  if (const int number = result.count(SpaceNodeKind::touch); number > 0)
    parts.push_back(plural(number, "point", "points"));
  if (const int number = result.count(SpaceNodeKind::crossing); number > 0)
    parts.push_back(plural(number, "crossing", "crossings"));
  return parts.empty() ? "nothing in common" : joined(parts, ", ");
}

Json surfaces_json(const SurfaceIntersection& result, const SurfaceNames& names) {
  Json json = {{"exsect", "surfaces/1"},
               {"status", result.status == Status::complete ? "complete" : "incomplete"},
               {"first", names.first},
               {"second", names.second},
               {"equations", {names.first_kind, names.second_kind}},
               {"same", result.is_same},
               {"nodes", listed(result.nodes, node_on_surfaces_json)},
               {"arcs", listed(result.arcs, space_arc_json)},
               {"curves", listed(result.curves, space_curve_json)},
               {"summary", what_is_common(result)},
               {"incomplete", listed(result.incomplete,
                                     [](const OpenQuestion& open) {
                                       return Json{{"why", open.why}, {"reason", name(open.reason)}};
                                     })},
               {"work", {{"milliseconds", result.work.milliseconds}, {"steps", result.work.steps}}}};
  if (result.normals) json["normals"] = *result.normals;
  return json;
}

std::string surfaces_summary(const SurfaceIntersection& result, const SurfaceNames& names, bool verbose) {
  std::string text = fmt::format("{} with {}: ", printable(names.first), printable(names.second));
  if (result.status == Status::complete)
    text += "complete, proved: " + what_is_common(result) + "\n";
  else
    text += "incomplete\n";
  text += space_curve_table(result) + node_table(result, verbose);
  for (const OpenQuestion& open : result.incomplete) text += "\nNot decided: " + open.why + "\n";
  return text;
}

}  // namespace exsect::cli
