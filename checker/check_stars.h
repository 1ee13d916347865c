// Stars: points where half branches of the curve meet, seen in eight charts.
#pragma once

#include "star_maps.h"

namespace exsect::checker {

/// The box of parameters in the variables of the tube's map.
template <class N>
Box<N> in_chart(const Replay<N>& replay, const Tube<N>& tube, const Box<N>& w, const std::string& where) {
  if (tube.chart == Chart::pair) return w;
  if (tube.chart == Chart::star)
    return in_star(replay.certificate.stars[tube.star], tube.direction, w, where);
  const auto [u, v, a, b] = halves(tube.chart, w);
  require(a.sign() != 0, where, "a pair of points that may be one");
  return {u, v, b / a, a * a};
}
/// A node's box likewise; on the diagonal with m from the tube, and w = 0; the centre of a star's tube.
template <class N>
Box<N> node_box(const Tube<N>& tube, const Node<N>& node, const std::string& where) {
  if (node.star >= 0) {
    require(tube.chart == Chart::star && static_cast<int>(tube.star) == node.star, where,
            "not in a chart of its star");
    return ball(tube.centre, N(0));
  }
  if (tube.chart == Chart::pair) return ball(node.at, node.radius);
  require(node.on.empty() && node.wrt.empty() && node.at[0] == node.at[2] && node.at[1] == node.at[3] &&
              tube.chart != Chart::star,
          where, "not a cuspidal point with a tube along w");
  const auto [u, v, a, b] = halves(tube.chart, ball(node.at, N(0)));
  const N m = tube.centre[2] - tube.slope[2] * tube.centre[3];
  return ball<N>({u.middle, v.middle, m, N(0)}, node.radius);
}

/// Of a star or a seam: the coordinates are the inverse of the axes, and the rows are independent.
inline void check_frame(const Star& star, const std::string& where) {
  for (std::size_t i = 0; i < 4; ++i) {
    require(star.weights[i] <= 6, where, "a weight is not in 0, ..., 6");
    for (std::size_t j = 0; j < 4; ++j) {
      Rational product = 0;
      for (std::size_t n = 0; n < 4; ++n) product += star.coordinates[i][n] * star.axes[n][j];
      require(product == (i == j ? 1 : 0), where, "its coordinates are not the inverse of its axes");
    }
  }
  const auto& [a, b, c] = star.rows;
  require(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0]) !=
              0,
          where, "its rows are dependent");
  for (const std::size_t order : star.orders) require(order >= 1, where, "an order below 1");
}

/// `equation` in the charts with t.
template <class N>
void add_equations(StarMaps<N>& maps, const Star& star, const Map<Rational>& equation,
                   const std::string& where) {
  const Terms terms = centred(equation, star);
  for (std::size_t direction = 0; direction < 8; ++direction)
    if (star.weights[direction / 2] > 0)
      maps.equation[direction] = in_direction<N>(terms, star, direction, star.rows, star.orders, where);
}

/// The star's point is a singular solution; its maps.
template <class N>
StarMaps<N> check_star(const Replay<N>& replay, const Star& star, const std::string& where) {
  for (const Rational& q : star.at) require(q >= 0 && q <= 1, where, "not in [0,1]^4");
  for (const std::size_t weight : star.weights) require(weight >= 1, where, "a weight is not in 1, ..., 6");
  check_frame(star, where);
  const Map<Rational> equation = pair_map(replay.exact[0], replay.exact[1]);
  const Map<Rational> local = equation.at(star.at);
  for (const auto& term : local.terms())
    if (term.power[0] + term.power[1] + term.power[2] + term.power[3] == 1)
      require(dot(star.rows[2], term.c) == 0, where, "its last row is not normal to both patches");
  StarMaps<N> result;
  add_equations(result, star, equation, where);
  Map<Rational> space;
  Net<Rational> moved = replay.exact[0];
  for (std::size_t d = 0; d < 3; ++d) moved[0][0][d] -= replay.origin[d];
  add_patch(space, moved, Rational(1), 0);
  const Terms points = centred(space, star);
  for (std::size_t direction = 0; direction < 8; ++direction)
    result.space[direction] =
        in_direction<N>(points, star, direction, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 0, 0}, where);
  return result;
}

/// The points e_j = 0, for all j with a weight > 0, of a seam are solutions; its maps.
template <class N>
StarMaps<N> check_seam(const Replay<N>& replay, const Star& seam, const std::string& where) {
  const auto dimension = std::count(seam.weights.begin(), seam.weights.end(), std::size_t{0});
  const bool plane = dimension == 2 && seam.of.chart == Chart::pair && !replay.certificate.self;
  require(dimension == 1 || plane, where, "neither of a line nor of a plane");
  check_frame(seam, where);
  Map<Rational> equation = pair_map(replay.exact[0], replay.exact[1]);
  if (seam.of.chart == Chart::star) {
    const Star& star = element(replay.certificate.stars, seam.of.star, where, "names no star");
    equation = in_direction<Rational>(centred(equation, star), star, seam.of.direction, star.rows,
                                      star.orders, where);
  }
  StarMaps<N> result;
  add_equations(result, seam, equation, where);
  return result;
}

/// The tube holds one half branch of its star, which begins between the charts' sides, and along which each
/// parameter is monotone: with w_i - at_i = sum_j axes_ij t^weights_j d_j, its derivative divided by a power
/// of t.
template <class N>
void check_half_branch(Replay<N>& replay, const std::string& where) {
  auto& [tube, bounds, constant, grows, exact] = replay.tubes.back();
  const Star& star = replay.certificate.stars[tube.star];
  const std::size_t k = tube.direction / 2;
  require(tube.axis == k && tube.centre[k] == 0, where, "does not begin at its star's point");
  for (const std::size_t j : others(k))
    require(magnitude(tube.centre[j]) + tube.width < 1, where, "begins beyond its chart");
  for (std::size_t i = 0; i + 1 < replay.tubes.size(); ++i) {
    const Tube<N>& other = replay.tubes[i].claim;
    if (static_cast<const MapName&>(other) != tube) continue;
    const auto apart = [&](std::size_t j) {
      return j != k && magnitude(N(tube.centre[j] - other.centre[j])) > tube.width + other.width;
    };
    require(apart(0) || apart(1) || apart(2) || apart(3), where, "may begin where an earlier tube does");
  }
  grows = half_branch_signs(star, tube, bounds);
  for (std::size_t i = 0; i < 4; ++i) {
    if (constant[i]) grows[i] = 0;
    require(constant[i] || grows[i] != 0, where, "a parameter may turn");
  }
}

/// The half branch is outside [0,1]^4 but for the star's point.
template <class N>
bool leaves_domain(const Replay<N>& replay, const ProvedTube<N>& tube) {
  if (tube.claim.chart != Chart::star) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational& q = replay.certificate.stars[tube.claim.star].at[i];
    if ((q == 0 && tube.grows[i] < 0) || (q == 1 && tube.grows[i] > 0)) return true;
  }
  return false;
}

/// The subdivision of a chart of a star or a seam, 0 <= t <= 1 and |d_j| <= 1: every leaf holds no solution,
/// or lies in a tube of the star.
template <class N>
class ChartCover {
 public:
  ChartCover(const Replay<N>& replay, const Star& star, const StarMaps<N>& maps, const MapName& chart,
             const std::string& where)
      : replay_(replay),
        chart_(chart),
        map_(maps.equation[chart.direction]),
        where_(where + ".charts[" + std::to_string(chart.direction) + "]"),
        cells_(star.charts[chart.direction]) {
    if (star.weights[chart.direction / 2] > 0)
      check();
    else
      require(cells_.empty(), where_, "no chart");
  }

 private:
  void check() {
    Vector4<double> middle = {};
    middle[chart_.direction / 2] = 0.5;
    Vector4<double> half = {1, 1, 1, 1};
    half[chart_.direction / 2] = 0.5;
    check(middle, half);
    require(next_ == cells_.size(), where_, "beyond the end of the subdivision");
  }

  void check(const Vector4<double>& middle, const Vector4<double>& half) {
    const Cell& cell = element(cells_, next_++, where_, "the subdivision is not complete");
    Box<N> box;
    for (std::size_t j = 0; j < 4; ++j) box[j] = {N(middle[j]), N(half[j])};
    if (cell.kind == Cell::Kind::split) {
      Vector4<double> less = half;
      less[cell.index] /= 2;
      require(less[cell.index] > 0x1p-50, where_, "halved more than 50 times");
      for (const int side : {-1, 1}) {
        Vector4<double> moved = middle;
        moved[cell.index] += side * less[cell.index];
        check(moved, less);
      }
    } else if (cell.kind == Cell::Kind::tube) {
      const Tube<N>& tube = element(replay_.tubes, cell.index, where_, "names no tube").claim;
      require(chart_.chart == Chart::star && tube == chart_, where_, "a tube of another chart");
      require(tube.contains(box), where_, "a cell is not in its tube");
    } else {
      require(cell.kind == Cell::Kind::excluded, where_, "not an entry of a star's chart");
      const Vector3<N> n = {cell.direction[0], cell.direction[1], cell.direction[2]};
      const Map<N> local = map_.at(middles(box));
      require(local.along(n, {N(half[0]), N(half[1]), N(half[2]), N(half[3])}).sign() != 0, where_,
              "a cell may hold a solution");
    }
  }

  const Replay<N>& replay_;
  const MapName chart_;
  const Map<N>& map_;
  const std::string where_;
  const std::vector<Cell>& cells_;
  std::size_t next_ = 0;
};

}  // namespace exsect::checker
