// exsect on pairs of patches, in process: intersect, with --method exact without floating point in any
// decision, or line_points with --lines. Of the polylines every third vertex is written; residual and
// distance are measured on some of all chords.
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
#include "nearest_point.h"
#include "reference.h"

namespace peers {
namespace {

using exsect::BezierPatch;
using exsect::ComponentShape;
using exsect::IntersectionGraph;

constexpr std::size_t written = 3;      // every so many vertices
constexpr std::size_t measured_of = 8;  // one chord of so many

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
  for (std::size_t i = 0; i < arc.polyline.size(); ++i) {
    if (i % written != 0 && i + 1 < arc.polyline.size()) continue;
    result.push_back({arc.polyline[i].point, arc.polyline[i].parameters});
  }
  return result;
}

/// The arcs of an open or closed component as one polyline: each turned so that it begins where the one
/// before it ends, the first so that the second can follow.
Curve joined(const IntersectionGraph& graph, const std::vector<int>& ids) {
  Curve result;
  int end = -1;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const exsect::Arc& arc = graph.arcs[static_cast<std::size_t>(ids[i])];
    Curve piece = curve(arc);
    bool turned = end == arc.to && end != arc.from;
    if (i == 0 && ids.size() > 1) {
      const exsect::Arc& next = graph.arcs[static_cast<std::size_t>(ids[1])];
      turned = arc.to != next.from && arc.to != next.to;
    }
    if (turned) std::reverse(piece.begin(), piece.end());
    end = turned ? arc.from : arc.to;
    result.insert(result.end(), piece.begin() + (i == 0 ? 0 : 1), piece.end());
  }
  return result;
}

Reference reference(const exsect::IntersectResult& result) {
  const IntersectionGraph& graph = result.graph;
  Reference reference;
  reference.complete = result.status == exsect::Status::complete;
  for (const exsect::Component& component : graph.components) {
    std::vector<Curve> curves;
    if (component.shape == ComponentShape::branched) {
      for (const int id : component.arcs) curves.push_back(curve(graph.arcs[static_cast<std::size_t>(id)]));
    } else {
      curves.push_back(joined(graph, component.arcs));
    }
    reference.components.push_back({name(component.shape), std::move(curves)});
  }
  for (const int id : graph.isolated_points) {
    const exsect::Node& node = graph.nodes[static_cast<std::size_t>(id)];
    reference.isolated.push_back({node.point, node.approx});
  }
  for (const exsect::Overlap& overlap : graph.overlaps)
    for (const auto& chain : overlap.chains)
      for (const exsect::Arc& arc : chain) reference.rims.push_back(curve(arc));
  return reference;
}

/// Bounds claimed, and what is measured: residuals at the vertices, distances at the middles of the chords.
nlohmann::ordered_json measured(const PatchPair& pair, const IntersectionGraph& graph) {
  double bound = 0;
  double largest_residual = 0;
  double largest_distance = 0;
  for (const exsect::Arc& arc : graph.arcs) {
    bound = std::max(bound, arc.error_bound);
    for (std::size_t i = 0; i + 1 < arc.polyline.size(); i += measured_of) {
      const exsect::PolylineVertex& a = arc.polyline[i];
      const exsect::PolylineVertex& b = arc.polyline[i + 1];
      Vertex middle{};
      for (std::size_t k = 0; k < 3; ++k) middle.point[k] = (a.point[k] + b.point[k]) / 2;
      for (std::size_t k = 0; k < 4; ++k) middle.parameters[k] = (a.parameters[k] + b.parameters[k]) / 2;
      largest_residual = std::max(largest_residual, residual(pair, a.parameters));
      if (const auto foot = nearest_point(pair, middle.point, middle.parameters)) {
        largest_distance = std::max(largest_distance, distance(foot->point, middle.point));
      }
    }
  }
  return {{"bound", bound}, {"residual", largest_residual}, {"distance", largest_distance}};
}

/// Triples (v,r,s) of each line.
std::vector<std::vector<Point>> line_points(const ExactPair& pair) {
  const auto middle = [](const exsect::RationalInterval& i) { return exsect::to_double(i.midpoint()); };
  std::vector<std::vector<Point>> result;
  for (int k = 1; k <= line_queries; ++k) {
    const exsect::LinePoints found =
        exsect::line_points(pair.x, pair.y, {exsect::Parameter::u, exsect::Rational(k, 16)});
    if (found.incomplete) throw std::runtime_error("incomplete: " + *found.incomplete);
    std::vector<Point> points;
    for (const exsect::CertifiedPoint& p : found.points) {
      const exsect::ParameterBox& box = p.box();
      points.push_back({middle(box[1]), middle(box[2]), middle(box[3])});
    }
    result.push_back(std::move(points));
  }
  return result;
}

/// Where the library has another mode.
template <class Options>
void decide_exactly(Options& options) {
  if constexpr (requires { options.exact; }) options.exact = true;
}

Task task(const PatchPair& pair, const ExactPair& exact, const Settings& settings) {
  if (settings.lines) {
    return {[&] { line_points(exact); },
            [&] {
              return nlohmann::ordered_json{{"lines", line_points(exact)}};
            }};
  }
  exsect::IntersectOptions options;
  options.tolerance = settings.tolerance;
  if (settings.method == "exact") decide_exactly(options);
  const auto state = std::make_shared<std::optional<exsect::IntersectResult>>();
  return {[&exact, options, state] { *state = intersect(exact.x, exact.y, options); },
          [&pair, state] {
            const exsect::IntersectResult& result = state->value();
            nlohmann::ordered_json answer = measured(pair, result.graph);
            answer["reference"] = to_json(reference(result));
            if (!result.incomplete.empty()) answer["why"] = result.incomplete.front().why;
            return answer;
          }};
}

}  // namespace
}  // namespace peers

int main(int argc, char** argv) {
  std::map<std::string, peers::ExactPair> exact;
  return peers::run(
      argc, argv,
      [&](const peers::Settings& settings) {
        exact = peers::exact_pairs(settings.pairs);
        if (settings.lines) return std::string("exsect line_points");
        return std::string(settings.method == "exact" ? "exsect, exact" : "exsect");
      },
      [&](const peers::PatchPair& pair, const peers::Settings& settings) {
        return peers::task(pair, exact.at(pair.name), settings);
      });
}
