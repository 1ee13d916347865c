// Stars: points where half branches of the curve meet, seen in eight charts.
#pragma once

#include <numeric>

#include "replay.h"

namespace exsect::checker {

/// The box of parameters in the variables of the tube's map.
template <class N>
Box<N> in_chart(const Replay<N>& replay, const Tube<N>& tube, const Box<N>& w) {
  if (tube.chart == Chart::pair) return w;
  if (tube.chart == Chart::star)
    return in_star(replay.certificate.stars[tube.star], replay.stars[tube.star].frame, tube.direction, w);
  const auto [u, v, a, b] = halves(tube.chart, w);
  require(a.sign() != 0, "a pair of points that may be one");
  return {u, v, b / a, a * a};
}
/// A node's box likewise; on the diagonal with m from the tube, and w = 0; the centre of a star's tube.
template <class N>
Box<N> node_box(const Tube<N>& tube, const Node<N>& node) {
  if (node.star >= 0) {
    require(tube.chart == Chart::star && static_cast<int>(tube.star) == node.star,
            "not in a chart of its star");
    return box_around(tube.centre, N(0));
  }
  if (tube.chart == Chart::pair) return box_around(node.at, node.radius);
  require(node.on.empty() && node.wrt.empty() && node.place[0] == node.place[2] &&
              node.place[1] == node.place[3] && tube.chart != Chart::star,
          "not a cuspidal point with a tube along w");
  const auto [u, v, a, b] = halves(tube.chart, box_around(node.at, N(0)));
  const N m = tube.centre[2] - tube.slope[2] * tube.centre[3];
  return box_around<N>({u.middle, v.middle, m, N(0)}, node.radius);
}

/// The coordinates are the inverse of the axes, and the rows are independent.
inline void check_frame(const Star& star) {
  for (std::size_t i = 0; i < 4; ++i) {
    require(star.weights[i] >= 1 && star.weights[i] <= 6, "a weight is not in 1, ..., 6");
    for (std::size_t j = 0; j < 4; ++j) {
      Algebraic product;
      for (std::size_t n = 0; n < 4; ++n) product += star.coordinates[i][n] * star.axes[n][j];
      require(product == (i == j ? 1 : 0), "its coordinates are not the inverse of its axes");
    }
  }
  require(sign_of(dot(star.rows[0], cross(star.rows[1], star.rows[2]))) != 0, "its rows are dependent");
  for (const int order : star.orders) require(order >= 1, "an order below 1");
}

/// The last row n of the star satisfies n . DF = 0 at its point, which is on the curve of no tube of F.
inline bool is_singular(const Map<Rational>& equation, const Star& star) {
  const Map<Algebraic> local = rounded<Algebraic>(equation).at(star.at);
  const auto& terms = local.terms();
  return std::all_of(terms.begin(), terms.end(), [&](const auto& term) {
    return std::accumulate(term.power.begin(), term.power.end(), 0) != 1 || dot(star.rows[2], term.c) == 0;
  });
}

/// How many half branches of the star there are among the tubes claimed.
template <class N>
std::size_t half_branches(const Certificate<N>& certificate, std::size_t star) {
  return static_cast<std::size_t>(std::ranges::count_if(certificate.tubes, [&](const Tube<N>& tube) {
    return tube.chart == Chart::star && tube.star == star;
  }));
}

/// The star's point is a singular solution, or one with two half branches; its maps.
template <class N>
StarMaps<N> check_star(const Replay<N>& replay, std::size_t i) {
  const Star& star = replay.certificate.stars[i];
  const auto at_least = [](const Algebraic& a, const Algebraic& b) { return a == b || sign_of(a - b) > 0; };
  for (const Algebraic& q : star.at) require(at_least(q, 0) && at_least(1, q), "not in [0,1]^4");
  require(half_branches(replay.certificate, i) == 2 || is_singular(replay.exact, star),
          "its last row is not normal to both patches");
  check_frame(star);
  StarMaps<N> result = {Frame<N>(star), {}, {}};
  const Terms terms = centred(replay.exact, star);
  const Matrix3<Algebraic> unit = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const Terms points = centred(replay.exact_space.points, star);
  const Terms weight = replay.exact_space.weight ? centred(*replay.exact_space.weight, star) : Terms{};
  for (std::size_t direction = 0; direction < 8; ++direction) {
    result.equation[direction] = in_direction<N>(terms, star, direction, star.rows, star.orders);
    result.space[direction].points = in_direction<N>(points, star, direction, unit, {0, 0, 0});
    if (!weight.empty())
      result.space[direction].weight = in_direction<N>(weight, star, direction, unit, {0, 0, 0});
  }
  return result;
}

/// The tube holds one half branch of its star, which begins between the charts' sides, and along which each
/// parameter is monotone.
template <class N>
void check_half_branch(Replay<N>& replay) {
  auto& [tube, map, bounds, constant, grows] = replay.tubes.back();
  const Star& star = replay.certificate.stars[tube.star];
  const std::size_t k = tube.direction / 2;
  require(tube.axis == k && tube.centre[k] == 0, "does not begin at its star's point");
  for (const std::size_t j : others(k))
    require(magnitude(tube.centre[j]) + tube.width < 1, "begins beyond its chart");
  for (std::size_t i = 0; i + 1 < replay.tubes.size(); ++i) {
    const Tube<N>& other = replay.tubes[i].claim;
    if (static_cast<const MapName&>(other) != tube) continue;
    bool apart = false;
    for (const std::size_t j : others(k))
      apart = apart || magnitude(N(tube.centre[j] - other.centre[j])) > tube.width + other.width;
    require(apart, "may begin where an earlier tube does");
  }
  grows = half_branch_signs(star, tube, bounds);
  for (std::size_t i = 0; i < 4; ++i) {
    if (constant[i]) grows[i] = 0;
    require(constant[i] || grows[i] != 0, "a parameter may turn");
  }
}

/// The half branch is outside [0,1]^4 but for the star's point.
template <class N>
bool leaves_domain(const Replay<N>& replay, const ProvedTube<N>& tube) {
  if (tube.claim.chart != Chart::star) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Algebraic& q = replay.certificate.stars[tube.claim.star].at[i];
    if ((q == 0 && tube.grows[i] < 0) || (q == 1 && tube.grows[i] > 0)) return true;
  }
  return false;
}

/// No arc has the star's point inside, which is singular, or has two half branches: one of them is outside
/// [0,1]^4, or a parameter, in which arcs are monotone, grows along both or falls along both. Requires
/// check_star.
template <class N>
void check_no_arc_inside(const Replay<N>& replay, std::size_t star) {
  if (half_branches(replay.certificate, star) != 2) return;  // it is singular
  if (is_singular(replay.exact, replay.certificate.stars[star])) return;
  std::array<int, 4> sum{};
  bool ends = false;
  for (const ProvedTube<N>& tube : replay.tubes) {
    if (tube.claim.chart != Chart::star || tube.claim.star != star) continue;
    ends = ends || leaves_domain(replay, tube);
    for (std::size_t i = 0; i < 4; ++i) sum[i] += tube.grows[i];
  }
  for (const int both : sum) ends = ends || both == 2 || both == -2;
  require(ends, "an arc may run through its point");
}

/// The subdivision of a chart of a star, 0 <= t <= 1 and |d_j| <= 1: every leaf holds no solution,
/// or lies in the box of a tube of the star.
template <class N>
class ChartCover {
 public:
  ChartCover(const Replay<N>& replay, const MapName& chart)
      : replay_(replay),
        chart_(chart),
        map_(replay.stars[chart.star].equation[chart.direction]),
        cells_(replay.certificate.stars[chart.star].charts[chart.direction]) {}

  void check() {
    Box<double> whole = box_around<double>({}, 1);
    whole[chart_.direction / 2] = {0.5, 0.5};
    check(whole);
    require(next_ == cells_.size(), "beyond the end of the subdivision");
  }

 private:
  void check(const Box<double>& part) {
    const Cell& cell = element(cells_, next_++, "the subdivision is not complete");
    const Box<N> box = exactly<N>(part);
    if (cell.kind == Cell::Kind::split) {
      for (const bool upper : {false, true}) check(half_of(part, cell.index, upper));
    } else if (cell.kind == Cell::Kind::tube) {
      const Tube<N>& tube = element(replay_.tubes, cell.index, "names no tube").claim;
      require(tube == chart_, "a tube of another chart");
      require(tube.surrounds(box), "a cell is not in its tube's box");
    } else {
      require(cell.kind == Cell::Kind::excluded, "not an entry of a star's chart");
      const Vector3<N> n = {cell.direction[0], cell.direction[1], cell.direction[2]};
      require(along(n, map_.at(middles(box)), radii(box)).sign() != 0, "a cell may hold a solution");
    }
  }

  const Replay<N>& replay_;
  const MapName chart_;
  const Map<N>& map_;
  const std::vector<Cell>& cells_;
  std::size_t next_ = 0;
};

template <class N>
void check_charts(const Replay<N>& replay, std::size_t star) {
  for (std::size_t direction = 0; direction < 8; ++direction)
    replayed(
        place("$.stars", star) + ".charts", direction,
        [&] {
          ChartCover<N>(replay, {Chart::star, star, direction}).check();
        },
        Violation::cover);
}

}  // namespace exsect::checker
