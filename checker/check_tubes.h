// Relations, lines and tubes.
#pragma once

#include "check_stars.h"

namespace exsect::checker {

/// direction . F is the sum of monotone functions of one parameter each.
inline void check_relation(const Map<Rational>& exact, const Relation& relation) {
  require(relation.first < 2 && relation.second >= 2, "not between a parameter of either patch");
  for (const auto& term : exact.terms())
    for (std::size_t j = 0; j < 4; ++j)
      require(term.power[j] == 0 || j == relation.first || j == relation.second ||
                  dot(relation.direction, term.c) == 0,
              "a third parameter occurs");
  for (const std::size_t p : {relation.first, relation.second}) {
    const auto slope = [&, p = p](int t) {  // at 0 and 1 of the same sign: it is linear
      Vector4<Rational> w = {};
      w[p] = t;
      const Balls<Rational> f = exact.at(w).first(p, {});
      return sign_of(dot(relation.direction, {f[0].middle, f[1].middle, f[2].middle}));
    };
    require(slope(0) * slope(1) > 0, "not monotone");
  }
}

/// F(w(t)) = 0 for all t: it has degree <= 8, and vanishes at 9 values.
inline void check_line(const Map<Rational>& exact, const Line& line) {
  require(line.at[line.axis] == Vector3<Rational>{0, 1, 0}, "its axis is not its parameter");
  for (int t = 0; t < 9; ++t)
    require(is_solution(exact, value(line.at, Rational(t))), "not a solution everywhere");
}

/// In [0,1]^4 two parameters have the values of the line at the same time, or neither: with a, b in {0,1}
/// these values, w_i - a and w_j - b are proportional on the seam's plane, with the sign that keeps one of
/// them outside unless both are 0.
inline bool is_edge(const Star& seam, const OnAxis<Rational>& on) {
  const auto inwards = [&](std::size_t p) {
    return on[p][1] == 0 && (on[p][0] == 0 || on[p][0] == 1) ? (on[p][0] == 0 ? 1 : -1) : 0;
  };
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::vector<std::array<Rational, 2>> along;  // of the two directions of the plane
      for (std::size_t n = 0; n < 4; ++n)
        if (seam.weights[n] == 0)
          along.push_back({inwards(i) * seam.axes[i][n].rational(), inwards(j) * seam.axes[j][n].rational()});
      const auto& [a, b] = std::tie(along[0], along[1]);
      const bool proportional = a[0] * b[1] == a[1] * b[0];
      if (proportional && (a[0] * a[1] < 0 || b[0] * b[1] < 0)) return true;
    }
  }
  return false;
}

/// The tube lies in its seam, all solutions of which in [0,1]^4 are on the line.
template <class N>
void check_in_seam(const Replay<N>& replay, const Tube<N>& tube, const OnAxis<Rational>& on) {
  const Star& seam = element(replay.certificate.seams, static_cast<std::size_t>(tube.seam), "names no seam");
  require(seam.of == tube, "its seam is one of another map");
  require(tube.inverse == Matrix3<N>{}, "an inverse where none is needed");
  require(!seam.is_plane() || is_edge(seam, on), "its seam's plane goes on in the domain");
  for (int t = 0; t < 3; ++t)
    require(is_on(seam, value(on, Rational(t))), "its line is not that of its seam");
  Box<N> across = box_around(tube.centre, tube.width);
  across[tube.axis].radius = 0;
  const Box<N> e = Frame<N>(seam).of(across);
  for (std::size_t j = 0; j < 4; ++j) {
    N slope = 0;
    for (std::size_t i = 0; i < 4; ++i) slope += number<N>(seam.coordinates[j][i]) * tube.slope[i];
    require(e[j].magnitude() + tube.reach * magnitude(slope) <= 1, "not in its seam");
  }
}

/// The tube's curve is a line, which is in it for all values of the axis.
template <class N>
void check_on_line(Replay<N>& replay) {
  auto& [tube, bounds, constant, grows, exact] = replay.tubes.back();
  const Certificate<N>& certificate = replay.certificate;
  const Line& line = element(certificate.lines, static_cast<std::size_t>(tube.line), "names no line");
  require(tube.chart == Chart::star || line.axis == tube.axis, "its line has another axis");
  const OnAxis<Rational> on =
      tube.chart == Chart::star ? ray(certificate.stars[tube.star], tube, line) : line.at;
  if (tube.seam >= 0) check_in_seam(replay, tube, on);
  exact.emplace();
  const N& t = tube.centre[tube.axis];
  for (std::size_t i = 0; i < 4; ++i) {
    Vector3<N>& a = (*exact)[i];
    a = {N(on[i][0]), N(on[i][1]), N(on[i][2])};
    const N middle = value(a, t) - tube.centre[i];
    const N slope = a[1] + 2 * t * a[2] - tube.slope[i];
    require(
        i == tube.axis ||
            magnitude(middle) + tube.reach * (magnitude(slope) + tube.reach * magnitude(a[2])) <= tube.width,
        "its line is not in it");
    if (tube.seam >= 0) bounds.first[i] = a[1];  // straight
    constant[i] = line.at[i][1] == 0 && line.at[i][2] == 0 && line.at[i][0] >= 0 && line.at[i][0] <= 1;
  }
}

template <class N>
void check_tube(Replay<N>& replay, const Tube<N>& tube) {
  const Certificate<N>& certificate = replay.certificate;
  require(tube.slope[tube.axis] == 1 && tube.reach > 0 && tube.width > 0, "not a tube");
  if (tube.chart == Chart::star)
    element(certificate.stars, tube.star, "names no star");
  else
    require(tube.chart == Chart::pair || certificate.self, "a chart of two patches");
  const Vector4<N> extent = tube.extent();
  replay.tubes.push_back({tube});
  auto& [claim, bounds, constant, grows, exact] = replay.tubes.back();
  if (tube.seam < 0) {
    const Map<N> local = replay.map(tube).at(tube.centre).times(tube.inverse);
    for (const N& slack : contraction(tube, local)) require(slack > 0, "no contraction");
    bounds = curve_bounds(local, tube.axis, extent);
  }
  if (tube.chart == Chart::first || tube.chart == Chart::second)
    return require(monotone_pairs(tube, bounds, N(tube.centre[3] + tube.reach)), "a parameter may turn");
  if (tube.line >= 0) check_on_line(replay);
  if (tube.chart == Chart::star) return check_half_branch(replay);
  for (std::size_t i = 0; i < 4; ++i) {
    const bool inside = tube.centre[i] >= extent[i] && tube.centre[i] + extent[i] <= 1;
    require(constant[i] || bounds.first[i].sign() != 0 || (bounds.second[i].sign() != 0 && inside),
            "a parameter may turn more than once, or outside the domain");
  }
}

}  // namespace exsect::checker
