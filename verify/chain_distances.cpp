#include "chain_distances.h"

#include <algorithm>
#include <limits>

namespace exsect {

void FarParts::find(const SpacePoint& a, const SpacePoint& b, double from, double to, double slack) {
  if (others_.distance_from_below(a, b, least_ + slack) > least_ + slack) {
    parts_.push_back({from, to});
    return;
  }
  const double length = distance(a, b);
  if (!(length >= smallest_ && length > slack) || others_.distance_from_above(a, b) < least_ - slack) return;
  const SpacePoint m = between(a, b, 0.5);
  find(a, m, from, (from + to) / 2, slack);
  find(m, b, (from + to) / 2, to, slack);
}

DistanceEnclosure largest_distance(const Chain& chain, const PieceTree& others, double fine,
                                   const StopRequest& stop) {
  DistanceEnclosure result;
  if (others.empty())
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  std::size_t from = 0;  // where the search begins: near the last piece that was found
  const auto raise_lower = [&](const SpacePoint& p, double bound) {
    result.lower = std::max(result.lower, others.distance_from_below(p, result.lower + bound, &from) - bound);
  };
  for (std::size_t i = 0; i < chain.pieces(); ++i) {
    require_time(stop);
    for (const SpacePoint& p : {chain.points[i], chain.points[i + 1]}) raise_lower(p, chain.bound[i]);
  }
  struct Part {
    SpacePoint a;
    SpacePoint b;
    int depth;
  };
  for (std::size_t i = 0; i < chain.pieces(); ++i) {
    require_time(stop);
    std::vector<Part> parts = {{chain.points[i], chain.points[i + 1], 0}};
    while (!parts.empty()) {
      const Part part = parts.back();
      parts.pop_back();
      const double sharp = std::max({1.05 * result.lower, fine, result.upper});
      const double above =
          others.distance_from_above(part.a, part.b, sharp - chain.bound[i], &from) + chain.bound[i];
      if (above <= sharp || part.depth == 12 || !(above <= std::numeric_limits<double>::max())) {
        result.upper = std::max(result.upper, above);
        continue;
      }
      const SpacePoint m = between(part.a, part.b, 0.5);
      raise_lower(m, chain.bound[i]);
      parts.push_back({part.a, m, part.depth + 1});
      parts.push_back({m, part.b, part.depth + 1});
    }
  }
  return result;
}

}  // namespace exsect
