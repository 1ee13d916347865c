// exsect on pairs of patches and of surfaces by their equations, in process: intersect, or the parameter
// lines with --lines; in doubles where they suffice, or with --method exact without floating point in any
// decision.
#include <exsect/geometry/surface_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/intersect_equations.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>
#include <exsect/solver/line_patch.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "harness.h"

namespace peers {
namespace {

using exsect::IntersectionGraph;
using exsect::IntersectOptions;
using exsect::NamedSurface;

struct ExactPair {
  NamedSurface x;
  NamedSurface y;
};

std::map<std::string, ExactPair> exact_pairs(const std::string& path) {
  std::ifstream file(path);
  std::map<std::string, ExactPair> result;
  for (std::string line; std::getline(file, line);) {
    const exsect::SurfaceFile pair = exsect::parse_surfaces(line, path);
    result.emplace(pair.title, ExactPair{pair.surfaces.at(0), pair.surfaces.at(1)});
  }
  return result;
}

Curve curve(const exsect::Arc& arc) {
  Curve result;
  for (const exsect::PolylineVertex& v : arc.polyline) result.push_back({v.point, v.parameters});
  return result;
}

/// The arcs and the rims of overlaps as curves, with the largest bound.
nlohmann::ordered_json answer(const exsect::IntersectResult& result) {
  const IntersectionGraph& graph = result.graph;
  Answer answer;
  double bound = 0;
  const auto add = [&](const exsect::Arc& arc) {
    answer.curves.push_back(curve(arc));
    bound = std::max(bound, arc.error_bound);
  };
  for (const exsect::Arc& arc : graph.arcs) add(arc);
  for (const exsect::Overlap& overlap : graph.overlaps)
    for (const auto& chain : overlap.chains)
      for (const exsect::Arc& arc : chain) add(arc);
  for (const int id : graph.isolated_points) {
    const exsect::Node& node = graph.nodes[static_cast<std::size_t>(id)];
    answer.points.push_back({node.point, node.approx});
  }
  nlohmann::ordered_json json = to_json(answer);
  json["polylines"] = true;  // not samples of a curve
  json["bound"] = bound;
  json["in_doubles"] = result.work.steps.contains("filtered");
  json["complete"] = result.status == exsect::Status::complete;
  return json;
}

/// Two surfaces by their equations have no parameters: curves and bound only.
nlohmann::ordered_json answer(const exsect::SurfaceIntersection& result) {
  Answer answer;
  double bound = 0;
  for (const exsect::SpaceArc& arc : result.arcs) {
    Curve& curve = answer.curves.emplace_back();
    for (const Point& p : arc.polyline) curve.push_back({p, {}});
    bound = std::max(bound, arc.error_bound);
  }
  nlohmann::ordered_json json = to_json(answer);
  json["bound"] = bound;
  json["in_doubles"] = false;
  json["complete"] = result.status == exsect::Status::complete;
  return json;
}

std::optional<exsect::BezierPatch> biquadratic(const NamedSurface& surface) {
  if (surface.patch() == nullptr) return std::nullopt;
  return surface.patch()->biquadratic();
}

std::vector<exsect::LinePoints> line_points(const exsect::BezierPatch& x, const exsect::BezierPatch& y,
                                            bool exactly) {
  std::vector<exsect::LinePoints> result;
  for (int k = 1; k <= line_queries; ++k) {
    const exsect::LineQuery query = {exsect::Parameter::u, exsect::Rational(k, 16)};
    result.push_back(exactly ? exsect::line_points(x, y, query) : exsect::line_points_filtered(x, y, query));
    if (result.back().incomplete) throw std::runtime_error("incomplete: " + *result.back().incomplete);
  }
  return result;
}

/// Triples (v,r,s) of each line.
nlohmann::ordered_json answer(const std::vector<exsect::LinePoints>& lines) {
  const auto middle = [](const exsect::RationalInterval& i) { return exsect::to_double(i.midpoint()); };
  std::vector<std::vector<Point>> result;
  for (const exsect::LinePoints& line : lines) {
    std::vector<Point>& points = result.emplace_back();
    for (const exsect::CertifiedPoint& p : line.points) {
      const exsect::ParameterBox& box = p.box();
      points.push_back({middle(box[1]), middle(box[2]), middle(box[3])});
    }
  }
  return {{"lines", result}};
}

/// `solve` timed, its result answered.
template <class Solve>
Task solved(Solve solve) {
  const auto state = std::make_shared<std::optional<decltype(solve())>>();
  return {[solve, state] { *state = solve(); }, [state] { return answer(state->value()); }};
}

Task task(const ExactPair& pair, const Settings& settings) {
  const bool exactly = settings.method == "exact";
  const auto bezier_x = biquadratic(pair.x), bezier_y = biquadratic(pair.y);
  if (settings.lines) {
    const exsect::BezierPatch p = bezier_x.value(), q = bezier_y.value();
    return {[=] { line_points(p, q, exactly); }, [=] { return answer(line_points(p, q, exactly)); }};
  }
  IntersectOptions options;
  options.tolerance = settings.tolerance;
  options.exact = exactly;
  if (bezier_x && bezier_y) return solved([=] { return intersect(*bezier_x, *bezier_y, options); });
  const exsect::RationalPatch *x = pair.x.patch(), *y = pair.y.patch();
  const exsect::ImplicitSurface *f = pair.x.equation(), *g = pair.y.equation();
  if (x != nullptr && y != nullptr) return solved([=] { return intersect(*x, *y, options); });
  if (x != nullptr) return solved([=] { return intersect(*g, *x, options); });
  if (y != nullptr) return solved([=] { return intersect(*f, *y, options); });
  return solved([=] { return intersect(*f, *g, options); });
}

}  // namespace
}  // namespace peers

int main(int argc, char** argv) {
  std::map<std::string, peers::ExactPair> exact;
  return peers::run(
      argc, argv,
      [&](const peers::Settings& settings) {
        exact = peers::exact_pairs(settings.pairs);
        const std::string routine = !settings.lines              ? "exsect"
                                    : settings.method == "exact" ? "exsect line_points"
                                                                 : "exsect line_points_filtered";
        return routine + (settings.method == "exact" && !settings.lines ? " --exact" : "");
      },
      [&](const peers::SurfacePair& pair, const peers::Settings& settings) {
        return peers::task(exact.at(pair.name), settings);
      });
}
