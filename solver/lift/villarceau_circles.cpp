#include "lift/villarceau_circles.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "lift/surface_chart.h"

namespace exsect {
namespace {

/// The sum of the magnitudes.
Rational not_below_length(const Point& p) { return abs(p[0]) + abs(p[1]) + abs(p[2]); }

/// The two circles of a torus in a plane through its centre with this normal.
class CirclePair {
 public:
  CirclePair(const SurfaceData& torus, const Point& normal)
      : centre_(torus.point),
        normal_(normal),
        across_(cross(torus.axis, normal)),
        power_(torus.squared - torus.minor_squared),
        squared_(torus.squared),
        shift_(rational_root(torus.minor_squared / dot(across_, across_), 2)) {}

  /// Of an arc of both tori: on which circle it is if it is on one, 1 or -1; 0 if it is on none for certain;
  /// empty if its vertices do not tell.
  std::optional<int> side(const SpaceArc& arc) const {
    const Rational error = from_double(arc.error_bound);
    std::optional<int> side;
    for (const std::array<double, 3>& vertex : arc.polyline) {
      const Point q = Point{from_double(vertex[0]), from_double(vertex[1]), from_double(vertex[2])} - centre_;
      if (abs(dot(normal_, q)) > error * not_below_length(normal_)) return 0;
      if (side) continue;
      const Rational power = dot(q, q) - power_, along = dot(across_, q);
      if (abs(power) > error * (2 * not_below_length(q) + error) &&
          abs(along) > error * not_below_length(across_))
        side = sign(power) * sign(along);  // (17.62)
    }
    return side;
  }

  SpaceCurve circle(int side) const {
    SpaceCurve circle{0, SpaceCurveKind::circle, {}, false, 1};
    if (shift_) circle.point = centre_ + side * *shift_ * across_;
    circle.direction = normal_;
    circle.radius_squared = squared_;
    return circle;
  }

 private:
  Point centre_, normal_, across_;
  Rational power_;  // of the centre, up to sign
  Rational squared_;
  std::optional<Rational> shift_;  // of the circles' centres along `across_`
};

/// The arcs are one closed curve that does not meet itself.
bool is_cycle(const SurfaceIntersection& result, const std::vector<int>& arcs) {
  std::map<int, std::vector<int>> at;
  for (const int id : arcs) {
    const SpaceArc& arc = result.arcs[static_cast<std::size_t>(id)];
    at[arc.from].push_back(id);
    at[arc.to].push_back(id);
  }
  if (!std::ranges::all_of(at, [](const auto& node) { return node.second.size() == 2; })) return false;
  std::size_t count = 0;
  int id = arcs.front(), node = result.arcs[static_cast<std::size_t>(id)].from;
  do {
    const SpaceArc& arc = result.arcs[static_cast<std::size_t>(id)];
    node = arc.from == node ? arc.to : arc.from;
    const std::vector<int>& both = at[node];
    id = both[0] == id ? both[1] : both[0];
    ++count;
  } while (id != arcs.front() && count <= arcs.size());
  return count == arcs.size();
}

/// The sides of all arcs. One that is too short to tell goes on, in a regular point, in another one;
/// two that differ are on no circle.
std::vector<std::optional<int>> sides_of(const SurfaceIntersection& result, const CirclePair& pair) {
  std::vector<std::optional<int>> sides;
  for (const SpaceArc& arc : result.arcs) sides.push_back(pair.side(arc));
  std::vector<std::vector<std::size_t>> at(result.nodes.size());
  for (std::size_t i = 0; i < result.arcs.size(); ++i)
    for (const int end : {result.arcs[i].from, result.arcs[i].to})
      at[static_cast<std::size_t>(end)].push_back(i);
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (const SpaceNode& node : result.nodes) {
      if (node.kind != SpaceNodeKind::joint) continue;
      const std::vector<std::size_t>& both = at[static_cast<std::size_t>(node.id)];
      std::optional<int>&one = sides[both[0]], &other = sides[both[1]];
      if (one == other) continue;
      const std::optional<int> both_sides = !one ? other : !other ? one : 0;
      one = other = both_sides;
      is_new = true;
    }
  }
  return sides;
}

/// The arcs of both circles; empty if that is not proved.
std::optional<std::array<std::vector<int>, 2>> arcs_of(const SurfaceIntersection& result,
                                                       const CirclePair& pair) {
  const std::vector<std::optional<int>> sides = sides_of(result, pair);
  std::array<std::vector<int>, 2> arcs;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (!sides[i]) return std::nullopt;
    if (*sides[i] != 0) arcs[*sides[i] > 0 ? 0 : 1].push_back(static_cast<int>(i));
  }
  for (const std::vector<int>& circle : arcs)
    if (circle.empty() || !is_cycle(result, circle)) return std::nullopt;
  return arcs;
}

/// What is left of a curve of the answer, in connected parts.
std::vector<SpaceCurve> connected_rest(const SurfaceIntersection& result, const SpaceCurve& curve) {
  std::map<int, int> part;  // of the nodes
  for (const int id : curve.arcs) {
    const SpaceArc& arc = result.arcs[static_cast<std::size_t>(id)];
    const int from = part.try_emplace(arc.from, arc.from).first->second,
              to = part.try_emplace(arc.to, arc.to).first->second;
    for (auto& [node, number] : part)
      if (number == from) number = to;
  }
  SpaceCurve of_no_arc = curve;
  of_no_arc.arcs.clear();
  std::map<int, SpaceCurve> parts;
  for (const int id : curve.arcs) {
    const int number = part.at(result.arcs[static_cast<std::size_t>(id)].from);
    parts.try_emplace(number, of_no_arc).first->second.arcs.push_back(id);
  }
  std::vector<SpaceCurve> all;
  for (auto& [number, rest] : parts) all.push_back(std::move(rest));
  return all;
}

/// Takes the arcs out of the curves `general`, as a curve of their own, unless they are named already.
void name(SurfaceIntersection& result, const std::vector<int>& arcs, SpaceCurve circle) {
  std::vector<SpaceCurve> curves;
  for (const SpaceCurve& curve : result.curves) {
    SpaceCurve rest = curve;
    std::erase_if(rest.arcs, [&](int id) { return std::ranges::find(arcs, id) != arcs.end(); });
    if (rest.arcs.size() == curve.arcs.size()) {
      curves.push_back(curve);
      continue;
    }
    if (curve.kind != SpaceCurveKind::general) return;
    circle.multiplicity = curve.multiplicity;
    for (SpaceCurve& part : connected_rest(result, rest)) curves.push_back(std::move(part));
  }
  circle.arcs = arcs;
  curves.push_back(std::move(circle));
  result.curves = std::move(curves);
}

}  // namespace

std::vector<Point> shared_bitangent_planes(const SurfaceData& first, const SurfaceData& second) {
  if (!(first.point == second.point && first.squared == second.squared &&
        first.minor_squared == second.minor_squared) ||
      is_zero(cross(first.axis, second.axis)))
    return {};
  const Rational aa = dot(first.axis, first.axis), bb = dot(second.axis, second.axis);
  const std::optional<Rational> product = rational_root(aa * bb, 2);
  if (!product) return {};
  std::vector<Point> planes;
  for (const int sense : {1, -1}) {
    const Point normal = shortened(bb * first.axis + sense * *product * second.axis);
    const Rational height = dot(normal, first.axis);
    if (height * height * first.squared == (first.squared - first.minor_squared) * aa * dot(normal, normal))
      planes.push_back(normal);  // (17.61)
  }
  return planes;
}

void name_villarceau_circles(SurfaceIntersection& result, const SurfaceData& first,
                             const SurfaceData& second) {
  for (const Point& normal : shared_bitangent_planes(first, second)) {
    const CirclePair pair(first, normal);
    const auto arcs = arcs_of(result, pair);
    if (!arcs) continue;
    for (const int side : {1, -1}) name(result, (*arcs)[side > 0 ? 0 : 1], pair.circle(side));
  }
}

}  // namespace exsect
