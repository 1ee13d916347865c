#include "walks.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "infinite.h"

namespace exsect {
namespace {

/// A vertex of a result is rounded to doubles after its bound was proved.
double with_rounding(const Arc& arc) {
  double size = 0;
  for (const PolylineVertex& v : arc.polyline)
    for (const double c : v.point) size = std::max(size, std::fabs(c));
  return arc.error_bound + size * 0x1p-51;
}

Chain chain_of(const Arc& arc) {
  Chain chain;
  for (const PolylineVertex& v : arc.polyline) {
    chain.at.push_back(static_cast<double>(chain.points.size()));
    chain.points.push_back(v.point);
  }
  chain.bound.assign(arc.polyline.size() - 1, with_rounding(arc));
  return chain;
}

std::vector<TrueArc> all_arcs(const IntersectionGraph& graph) {
  std::vector<TrueArc> arcs;
  for (const Arc& arc : graph.arcs) arcs.push_back({&arc, -1});
  for (const Overlap& overlap : graph.overlaps)
    for (const auto& loop : overlap.chains)
      for (const Arc& arc : loop) arcs.push_back({&arc, overlap.id});
  return arcs;
}

std::vector<Chain> all_chains(const std::vector<TrueArc>& arcs) {
  std::vector<Chain> chains;
  for (const TrueArc& arc : arcs) chains.push_back(chain_of(*arc.arc));
  return chains;
}

/// Follows the truth from one vertex of a chain on.
class Follower {
 public:
  Follower(const TrueCurve& truth, const Chain& chain, const WalkSearch& search)
      : truth_(truth), chain_(chain), search_(search) {}

  /// The longest walk from vertex `first`, at the given place of the truth in the given direction.
  Walk follow(std::size_t first, std::size_t arc, double position, int direction, double distance) const {
    Walk walk{first, first, {{arc, direction, position, position}}, distance, {}};
    const std::size_t most_legs = 4 * truth_.arcs().size() + 8;
    while (walk.last < chain_.pieces()) {
      const std::size_t legs = walk.legs.size();
      const Leg leg = walk.legs.back();
      const double before = walk.distance;
      if (walk.legs.size() > most_legs || !step(walk, walk.last)) {
        walk.legs.resize(legs, leg);
        walk.legs.back() = leg;
        walk.distance = before;
        break;
      }
      ++walk.last;
    }
    return walk;
  }

  /// Adds what is within the tolerance of the end vertices.
  void extend(Walk& walk) const {
    walk.reach = walk.legs;
    reverse(walk.reach);
    wait(walk.reach, walk.first);
    reverse(walk.reach);
    wait(walk.reach, walk.last);
  }

 private:
  const Chain& chain(std::size_t arc) const { return truth_.chains()[arc]; }

  static void reverse(std::vector<Leg>& legs) {
    std::reverse(legs.begin(), legs.end());
    for (Leg& leg : legs) {
      std::swap(leg.from, leg.to);
      leg.direction = -leg.direction;
    }
  }

  bool at_end(const Leg& leg) const {
    return leg.direction > 0 ? leg.to >= static_cast<double>(chain(leg.arc).pieces()) : leg.to <= 0;
  }

  /// The piece ahead of a place that is not the arc's end.
  std::size_t piece_ahead(const Leg& leg) const {
    return leg.direction > 0 ? static_cast<std::size_t>(std::floor(leg.to))
                             : static_cast<std::size_t>(std::ceil(leg.to)) - 1;
  }

  SpacePoint point_at(std::size_t arc, double position) const {
    const Chain& c = chain(arc);
    const auto i = std::min(static_cast<std::size_t>(position), c.pieces() - 1);
    return between(c.points[i], c.points[i + 1], position - static_cast<double>(i));
  }

  /// Whether matched points may be that far apart; records it.
  bool accepts(Walk& walk, double computed, double bound) const {
    const double proved = computed + bound + search_.rounding;
    if (!(proved <= search_.tolerance)) return false;
    walk.distance = std::max(walk.distance, proved);
    return true;
  }

  /// Matches piece j of the chain. Between matched places both sides are straight, so that the distance is
  /// largest at such a place (15.2).
  bool step(Walk& walk, std::size_t j) const {
    const SpacePoint& a = chain_.points[j];
    const SpacePoint& b = chain_.points[j + 1];
    double done = 0;  // of the piece
    const std::size_t most_legs = walk.legs.size() + truth_.arcs().size() + 4;
    for (;;) {
      Leg& leg = walk.legs.back();
      const double bound = chain_.bound[j] + chain(leg.arc).bound.front();
      if (at_end(leg)) {
        const auto next = continuation(leg, j);
        if (!next || walk.legs.size() > most_legs)
          return accepts(walk, distance(b, point_at(leg.arc, leg.to)), bound);
        const double start = next->second > 0 ? 0 : static_cast<double>(chain(next->first).pieces());
        walk.legs.push_back({next->first, next->second, start, start});
        continue;
      }
      const std::size_t i = piece_ahead(leg);
      const SpacePoint here = point_at(leg.arc, leg.to);
      const SpacePoint& end = chain(leg.arc).points[leg.direction > 0 ? i + 1 : i];
      const double vertex = static_cast<double>(leg.direction > 0 ? i + 1 : i);
      const double t = foot(b, here, end);
      // where the truth turns back, its nearest place to b is not ahead: then go on to the end of its piece
      if (t < 1 && distance(here, end) > 0 && accepts(walk, distance(b, between(here, end, t)), bound)) {
        leg.to += t * (vertex - leg.to);
        return true;
      }
      done = std::max(done, foot(end, a, b));
      if (!accepts(walk, distance(end, between(a, b, done)), bound)) return false;
      leg.to = vertex;
    }
  }

  /// Where a walk goes on behind a node: the only way, or the one that is nearest to what comes next.
  std::optional<std::pair<std::size_t, int>> continuation(const Leg& leg, std::size_t j) const {
    const auto ways = truth_.after(leg.arc, leg.direction);
    if (ways.empty()) return std::nullopt;
    if (ways.size() == 1) return ways.front();
    const SpacePoint node = point_at(leg.arc, leg.to);
    std::size_t ahead = j + 1;
    while (ahead < chain_.pieces() && distance(chain_.points[ahead], node) < 8 * search_.tolerance) ++ahead;
    const SpacePoint& target = chain_.points[ahead];
    std::pair<double, double> best = {infinite, infinite};
    std::optional<std::pair<std::size_t, int>> result;
    for (const auto& way : ways) {
      double nearest = infinite;
      double position = 0;
      const Chain& c = chain(way.first);
      for (std::size_t i = 0; i < c.pieces(); ++i) {
        const double t = foot(target, c.points[i], c.points[i + 1]);
        const double d = distance(target, between(c.points[i], c.points[i + 1], t));
        if (d < nearest) nearest = d, position = static_cast<double>(i) + t;
      }
      const std::pair<double, double> rank = {std::max(nearest, search_.tolerance),
                                              search_.rank ? search_.rank(way.first, position, ahead) : 0};
      if (rank < best) best = rank, result = way;
    }
    return result;
  }

  /// Goes on along the truth while it stays within the tolerance of one vertex of the chain.
  void wait(std::vector<Leg>& legs, std::size_t vertex) const {
    const SpacePoint& p = chain_.points[vertex];
    const double own = std::max(vertex > 0 ? chain_.bound[vertex - 1] : 0,
                                vertex < chain_.pieces() ? chain_.bound[vertex] : 0);
    const auto near = [&](std::size_t arc, const SpacePoint& q) {
      return distance(p, q) + own + chain(arc).bound.front() + search_.rounding <= search_.tolerance;
    };
    const std::size_t most_legs = legs.size() + truth_.arcs().size() + 4;
    while (legs.size() <= most_legs) {
      Leg& leg = legs.back();
      if (at_end(leg)) {
        const auto ways = truth_.after(leg.arc, leg.direction);
        if (ways.size() != 1) return;  // behind a branching another walk has to begin
        const double start = ways[0].second > 0 ? 0 : static_cast<double>(chain(ways[0].first).pieces());
        if (!near(ways[0].first, point_at(ways[0].first, start))) return;
        legs.push_back({ways[0].first, ways[0].second, start, start});
        continue;
      }
      const std::size_t i = piece_ahead(leg);
      const std::size_t vertex_ahead = leg.direction > 0 ? i + 1 : i;
      if (near(leg.arc, chain(leg.arc).points[vertex_ahead])) {
        leg.to = static_cast<double>(vertex_ahead);
        continue;
      }
      double in = leg.to;
      double out = static_cast<double>(vertex_ahead);
      for (int k = 0; k < 30; ++k) {
        const double middle = (in + out) / 2;
        (near(leg.arc, point_at(leg.arc, middle)) ? in : out) = middle;
      }
      if (near(leg.arc, point_at(leg.arc, in))) leg.to = in;
      return;
    }
  }

  const TrueCurve& truth_;
  const Chain& chain_;
  const WalkSearch& search_;
};

/// Where a walk can start: of consecutive pieces of an arc the nearest place.
std::vector<ChainPlace> starts(const TrueCurve& truth, const Chain& chain, std::size_t vertex,
                               const WalkSearch& search) {
  std::vector<ChainPlace> result;
  double last = -infinite;
  const double own = chain.bound[std::min(vertex, chain.pieces() - 1)];
  truth.tree().within(chain.points[vertex], search.tolerance, [&](const ChainPlace& found) {
    if (!(found.distance + found.bound + own + search.rounding <= search.tolerance)) return;
    const bool goes_on = !result.empty() && result.back().chain == found.chain && found.position - last <= 1;
    last = found.position;
    if (!goes_on)
      result.push_back(found);
    else if (found.distance < result.back().distance)
      result.back() = found;
  });
  return result;
}

}  // namespace

TrueCurve::TrueCurve(const IntersectionGraph& graph)
    : arcs_(all_arcs(graph)), chains_(all_chains(arcs_)), tree_(chains_) {
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    leaving_[arcs_[i].arc->from].push_back({i, 1});
    leaving_[arcs_[i].arc->to].push_back({i, -1});
  }
}

std::vector<std::pair<std::size_t, int>> TrueCurve::after(std::size_t arc, int direction) const {
  const Arc& before = *arcs_[arc].arc;
  std::vector<std::pair<std::size_t, int>> result;
  for (const auto& way : leaving_.at(direction > 0 ? before.to : before.from))
    if (way != std::pair{arc, -direction}) result.push_back(way);
  return result;
}

std::vector<Walk> find_walks(const TrueCurve& truth, const Chain& chain, const WalkSearch& search) {
  const Follower follower(truth, chain, search);
  constexpr std::size_t most_starts = 16;
  std::vector<Walk> walks;
  std::size_t vertex = 0;
  while (vertex < chain.pieces()) {
    require_time(search.stop);
    std::optional<Walk> best;
    std::tuple<std::size_t, double, double> best_rank;
    std::vector<ChainPlace> places = starts(truth, chain, vertex, search);
    if (places.size() > most_starts) places.resize(most_starts);
    for (const ChainPlace& place : places) {
      for (const int direction : {1, -1}) {
        const double proved = place.distance + place.bound + chain.bound[vertex] + search.rounding;
        Walk walk = follower.follow(vertex, place.chain, place.position, direction, proved);
        if (walk.last == vertex) continue;
        const double preference = (search.rank ? search.rank(place.chain, place.position, vertex) : 0.0) +
                                  (search.rank_of_walk ? search.rank_of_walk(walk) : 0.0);
        const std::tuple rank = {chain.pieces() - walk.last, preference, place.distance};
        if (!best || rank < best_rank) best = std::move(walk), best_rank = rank;
      }
    }
    if (!best) {
      ++vertex;
      continue;
    }
    vertex = best->last;
    follower.extend(*best);
    walks.push_back(std::move(*best));
    if (vertex < chain.pieces() && walks.back().last == walks.back().first) ++vertex;
  }
  return walks;
}

}  // namespace exsect
