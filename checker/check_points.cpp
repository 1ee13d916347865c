// The points of a parameter line: each alone in the slice of its tube, and no others.
#include "replay.h"

namespace exsect::checker {

template <class N>
void check_points(const Replay<N>& replay) {
  const Certificate<N>& certificate = replay.certificate;
  const std::size_t k = certificate.fixed->parameter;
  const std::vector<Node<N>>& points = certificate.nodes;
  std::vector<bool> used(replay.tubes.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string where = place("points", i);
    const Node<N>& point = points[i];
    const ProvedTube<N>& tube = element(replay.tubes, point.tube, where, "names no tube");
    require(tube.claim.axis == k, where, "its tube has another axis");
    used[point.tube] = true;
    require(point.radius > 0 && distance(tube, replay.pair, point.at, where) <= point.radius, where,
            "its box may miss the solution");
    const N margin = is_solution(replay.exact, point.at) ? N(0) : point.radius;
    for (const std::size_t j : others(k))
      require(point.at[j] - margin >= 0 && point.at[j] + margin <= 1, where, "its box leaves [0,1]");
    for (std::size_t m = 0; m < i; ++m) {
      bool apart = false;
      for (const std::size_t j : others(k))
        apart = apart || magnitude(N(point.at[j] - points[m].at[j])) > point.radius + points[m].radius;
      require(apart, where, "its box meets that of an earlier point");
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) require(used[i], place("tubes", i), "no point is in it");
  const std::array<std::size_t, 5> claims = {0, used.size(), points.size(), 0, certificate.cover.size()};
  require(certificate.summary.claims == claims, "$.summary", "does not agree with the claims");
}
template void check_points(const Replay<Rational>&);
template void check_points(const Replay<Enclosure>&);

}  // namespace exsect::checker
