// exsect on pairs of patches, in process: intersect, or the parameter lines with --lines; in doubles where
// they suffice, or with --method exact without floating point in any decision.
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
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

using exsect::BezierPatch;
using exsect::IntersectionGraph;

struct ExactPair {
  BezierPatch x;
  BezierPatch y;
};

std::map<std::string, ExactPair> exact_pairs(const std::string& path) {
  std::ifstream file(path);
  std::map<std::string, ExactPair> result;
  for (std::string line; std::getline(file, line);) {
    const exsect::PatchFile pair = exsect::parse_patches(line, path);
    result.emplace(pair.title, ExactPair{pair.patches.at(0).patch, pair.patches.at(1).patch});
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

std::vector<exsect::LinePoints> line_points(const ExactPair& pair, bool exactly) {
  std::vector<exsect::LinePoints> result;
  for (int k = 1; k <= line_queries; ++k) {
    const exsect::LineQuery query = {exsect::Parameter::u, exsect::Rational(k, 16)};
    result.push_back(exactly ? exsect::line_points(pair.x, pair.y, query)
                             : exsect::line_points_filtered(pair.x, pair.y, query));
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

Task task(const ExactPair& exact, const Settings& settings) {
  const bool exactly = settings.method == "exact";
  if (settings.lines) {
    return {[&exact, exactly] { line_points(exact, exactly); },
            [&exact, exactly] { return answer(line_points(exact, exactly)); }};
  }
  exsect::IntersectOptions options;
  options.tolerance = settings.tolerance;
  options.exact = exactly;
  const auto state = std::make_shared<std::optional<exsect::IntersectResult>>();
  return {[&exact, options, state] { *state = intersect(exact.x, exact.y, options); },
          [state] { return answer(state->value()); }};
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
      [&](const peers::PatchPair& pair, const peers::Settings& settings) {
        return peers::task(exact.at(pair.name), settings);
      });
}
