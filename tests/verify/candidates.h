// What tests of verify share: candidates made from the proved result, and what is said of them.
#pragma once

#include <exsect/geometry/bounding_box.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/verify/verify.h>

#include <algorithm>
#include <string>
#include <vector>

namespace exsect::candidates {

using Vertices = std::vector<std::array<double, 3>>;

struct Subject {
  BezierPatch x;
  BezierPatch y;
};

inline Subject example(const std::string& name) {
  const auto patches = read_patches(std::string(EXSECT_EXAMPLES) + "/" + name).patches;
  return {patches[0].patch, patches[1].patch};
}

inline double extent(const Subject& pair) {
  const BoundingBox box = united(bounding_box(pair.x), bounding_box(pair.y));
  return to_double(largest_extent(box));
}

inline IntersectResult fine(const Subject& pair) {
  IntersectOptions options;
  options.tolerance = 1e-5;
  return intersect(pair.x, pair.y, options);
}

/// Curves in space, in (u,v) and in (r,s), from polylines with all seven coordinates.
inline CandidateCurve curve_of(const std::vector<PolylineVertex>& line, const std::string& in) {
  Vertices space;
  Vertices first;
  Vertices second;
  for (const PolylineVertex& v : line) {
    space.push_back(v.point);
    first.push_back({v.parameters[0], v.parameters[1], 0});
    second.push_back({v.parameters[2], v.parameters[3], 0});
  }
  CandidateCurve curve;
  if (in.find('x') != std::string::npos) curve.space = polyline(space);
  if (in.find('u') != std::string::npos) curve.first = polyline(first);
  if (in.find('r') != std::string::npos) curve.second = polyline(second);
  return curve;
}

/// Simple components as one polyline each, arcs of branched ones and of rims as they are.
inline std::vector<std::vector<PolylineVertex>> lines_of(const IntersectionGraph& graph) {
  std::vector<std::vector<PolylineVertex>> lines;
  const auto arc = [&](int id) -> const Arc& { return graph.arcs[static_cast<std::size_t>(id)]; };
  for (const Component& component : graph.components) {
    std::vector<PolylineVertex> line;
    int at = arc(component.arcs[0]).from;
    if (component.arcs.size() > 1) {
      const Arc& second = arc(component.arcs[1]);
      if (at == second.from || at == second.to) at = arc(component.arcs[0]).to;
    }
    for (const int id : component.arcs) {
      std::vector<PolylineVertex> next = arc(id).polyline;
      if (component.shape == ComponentShape::branched) {
        lines.push_back(next);
        continue;
      }
      const bool forward = arc(id).from == at;
      if (!forward) std::reverse(next.begin(), next.end());
      at = forward ? arc(id).to : arc(id).from;
      line.insert(line.end(), next.begin() + (line.empty() ? 0 : 1), next.end());
    }
    if (!line.empty()) lines.push_back(line);
  }
  for (const Overlap& overlap : graph.overlaps)
    for (const auto& chain : overlap.chains)
      for (const Arc& rim : chain) lines.push_back(rim.polyline);
  return lines;
}

inline Candidate candidate_of(const IntersectionGraph& graph, const std::string& in = "x") {
  Candidate candidate;
  for (const auto& line : lines_of(graph)) candidate.curves.push_back(curve_of(line, in));
  for (const int id : graph.isolated_points)
    candidate.points.push_back({graph.nodes[static_cast<std::size_t>(id)].point, {}, {}});
  return candidate;
}

inline bool has(const Verdict& verdict, DifferenceKind kind) {
  return std::any_of(verdict.differences.begin(), verdict.differences.end(),
                     [&](const Difference& d) { return d.kind == kind; });
}

inline std::string text(const Verdict& verdict) {
  std::string result = name(verdict.agreement);
  for (const Difference& d : verdict.differences) result += std::string("; ") + name(d.kind) + ": " + d.text;
  for (const std::string& open : verdict.undecided) result += "; ? " + open;
  return result;
}

inline Verdict verdict_of(const Candidate& candidate, const Subject& pair, double tolerance = 1e-4) {
  VerifyOptions options;
  options.tolerance = tolerance;
  return verify(candidate, pair.x, pair.y, options).verdict;
}

inline Candidate shifted(Candidate candidate, const std::array<double, 3>& by) {
  for (CandidateCurve& curve : candidate.curves)
    for (auto& p : curve.space->points)
      for (std::size_t k = 0; k < 3; ++k) p[k] += by[k];
  return candidate;
}

/// A knot for each vertex again.
inline void renumber(SplineCurve& curve) { curve = polyline(curve.points); }

}  // namespace exsect::candidates
