#include "certificate/overlap.h"

#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>

#include "certificate/claims.h"

namespace exsect::cli {
namespace {

/// An edge of the polygon, of one arc or of several.
struct Edge {
  Place from;
  std::vector<PolylineVertex> polyline;
  double error_bound;
};

/// b is on the segment from a to c, where all three are on one.
bool collinear(const Place& a, const Place& b, const Place& c) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((b[i] - a[i]) * (c[j] - a[j]) != (b[j] - a[j]) * (c[i] - a[i])) return false;
  return true;
}

/// The arcs of the chain, those on one straight line together.
std::vector<Edge> edges_of(const IntersectionGraph& graph, const std::vector<Arc>& chain) {
  std::vector<Edge> edges;
  for (const Arc& arc : chain) {
    const Place from = short_place(graph.nodes[static_cast<std::size_t>(arc.from)]);
    const Place to = short_place(graph.nodes[static_cast<std::size_t>(arc.to)]);
    if (edges.empty() || !collinear(edges.back().from, from, to)) {
      edges.push_back({from, arc.polyline, arc.error_bound});
      continue;
    }
    auto& polyline = edges.back().polyline;
    polyline.insert(polyline.end(), arc.polyline.begin() + 1, arc.polyline.end());
    edges.back().error_bound = std::max(edges.back().error_bound, arc.error_bound);
  }
  return edges;
}

/// Its points on the straight line from its corner to the next one.
Json edge_claim(const Edge& edge, const Place& to) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (abs(Rational(to[i] - edge.from[i])) > abs(Rational(to[axis] - edge.from[axis]))) axis = i;
  Json points = Json::array();
  for (std::size_t k = 0; k < edge.polyline.size(); ++k) {
    const PolylineVertex& vertex = edge.polyline[k];
    const Rational t =
        (from_double(vertex.parameters[axis]) - edge.from[axis]) / (to[axis] - edge.from[axis]);
    Parameters w;
    for (std::size_t i = 0; i < 4; ++i) w[i] = to_double(Rational(edge.from[i] + t * (to[i] - edge.from[i])));
    Json point = k == 0 ? rationals(edge.from) : k + 1 == edge.polyline.size() ? rationals(to) : exact(w);
    for (const double c : vertex.point) point.push_back(exact_number(c));
    points.push_back(point);
  }
  return {{"points", points}, {"error_bound", exact_number(edge.error_bound)}};
}

/// The change of all parameters along the plane of the three places if u grows by 1 and v stays, or v by 1.
std::array<Place, 2> directions(const Place& a, const Place& b, const Place& c) {
  const Rational det = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  if (det == 0) throw NoCertificate("an overlap that is no region of u and v");
  std::array<Place, 2> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result[0][i] = ((b[i] - a[i]) * (c[1] - a[1]) - (c[i] - a[i]) * (b[1] - a[1])) / det;
    result[1][i] = ((c[i] - a[i]) * (b[0] - a[0]) - (b[i] - a[i]) * (c[0] - a[0])) / det;
  }
  return result;
}

}  // namespace

FoundOverlap overlap_at(Factors& factors, const IntersectionGraph& graph, const Overlap& overlap) {
  if (overlap.chains.size() != 1) throw NoCertificate("an overlap with holes");
  const std::vector<Edge> edges = edges_of(graph, overlap.chains[0]);
  if (edges.size() < 3) throw NoCertificate("an overlap with curved edges");
  const auto [first, second] = directions(edges[0].from, edges[1].from, edges[2].from);
  FoundOverlap result = {factors.of_plane(edges[0].from, first, second), Json::array()};
  for (std::size_t i = 0; i < edges.size(); ++i)
    result.edges.push_back(edge_claim(edges[i], edges[(i + 1) % edges.size()].from));
  return result;
}

}  // namespace exsect::cli
