// Relations, lines and tubes.
#pragma once

#include "check_stars.h"

namespace exsect::checker {

/// The coefficients of direction . c in the parameter, or nothing if the other parameter occurs as well.
inline std::optional<Vector3<Rational>> in_one_parameter(const Net<Rational>& c, const Relation& relation,
                                                         std::size_t parameter) {
  Vector3<Rational> f;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational product = dot(relation.direction, parameter % 2 == 0 ? c[i][j] : c[j][i]);
      if (j == 0)
        f[i] = product;
      else if (product != 0)
        return std::nullopt;
    }
  }
  return f;
}

/// direction . x and direction . y are monotone functions of one parameter each.
inline void check_relation(const std::array<Net<Rational>, 2>& exact, const Relation& relation,
                           const std::string& where) {
  require(relation.first < 2 && relation.second >= 2, where, "not between a parameter of either patch");
  for (const std::size_t p : {relation.first, relation.second}) {
    const auto f = in_one_parameter(exact[p / 2], relation, p);
    require(f.has_value(), where, "a third parameter occurs");
    require(sign((*f)[1]) * sign(Rational((*f)[1] + 2 * (*f)[2])) > 0, where, "not monotone");
  }
}

/// F(w(t)) = 0 for all t: it has degree <= 8, and vanishes at 9 values.
inline void check_line(const std::array<Net<Rational>, 2>& exact, const Line& line,
                       const std::string& where) {
  require(line.at[line.axis] == Vector3<Rational>{0, 1, 0}, where, "its axis is not its parameter");
  for (int t = 0; t < 9; ++t) {
    Vector4<Rational> w;
    for (std::size_t i = 0; i < 4; ++i) w[i] = line.at[i][0] + t * (line.at[i][1] + t * line.at[i][2]);
    require(is_zero_at(exact, w), where, "not a solution everywhere");
  }
}

/// The patches touch all along the line: the derivative of F has no rank 3, which is of degree <= 18 in t.
inline bool touches(const std::array<Net<Rational>, 2>& exact, const Line& line) {
  for (int t = 0; t < 19; ++t) {
    Vector4<Rational> w;
    for (std::size_t i = 0; i < 4; ++i) w[i] = value(line.at[i], Rational(t));
    for (const Ball<Rational>& minor : tangent(pair_map(exact[0], exact[1]).at(w), {}))
      if (minor.middle != 0) return false;
  }
  return true;
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
          along.push_back({inwards(i) * seam.axes[i][n], inwards(j) * seam.axes[j][n]});
      const auto& [a, b] = std::tie(along[0], along[1]);
      const bool proportional = a[0] * b[1] == a[1] * b[0];
      if (proportional && (a[0] * a[1] < 0 || b[0] * b[1] < 0)) return true;
    }
  }
  return false;
}

/// The tube lies in its seam, all solutions of which in [0,1]^4 are on the line.
template <class N>
void check_in_seam(const Replay<N>& replay, const Tube<N>& tube, const OnAxis<Rational>& on,
                   const std::string& where) {
  const Star& seam =
      element(replay.certificate.seams, static_cast<std::size_t>(tube.seam), where, "names no seam");
  require(seam.of == tube, where, "its seam is one of another map");
  require(tube.inverse == Matrix3<N>{}, where, "an inverse where none is needed");
  const bool plane = std::count(seam.weights.begin(), seam.weights.end(), std::size_t{0}) == 2;
  require(!plane || is_edge(seam, on), where, "its seam's plane goes on in the domain");
  for (std::size_t j = 0; j < 4; ++j) {
    N middle = 0;
    N slope = 0;
    N size = 0;
    Vector3<Rational> e = {};
    for (std::size_t i = 0; i < 4; ++i) {
      const Rational& c = seam.coordinates[j][i];
      middle += N(c) * (tube.centre[i] - N(seam.at[i]));
      slope += N(c) * tube.slope[i];
      if (i != tube.axis) size += N(Rational(abs(c))) * tube.width;
      for (std::size_t n = 0; n < 3; ++n) e[n] += c * (on[i][n] - (n == 0 ? seam.at[i] : Rational(0)));
    }
    require(magnitude(middle) + tube.reach * magnitude(slope) + size <= 1, where, "not in its seam");
    const bool on_it = e[0] == 0 && e[1] == 0 && e[2] == 0;
    require(seam.weights[j] == 0 || on_it, where, "its line is not that of its seam");
  }
}

/// The tube's curve is a line, which is in it for all values of the axis.
template <class N>
void check_on_line(Replay<N>& replay, const std::string& where) {
  auto& [tube, bounds, constant, grows, exact] = replay.tubes.back();
  const Certificate<N>& certificate = replay.certificate;
  const Line& line = element(certificate.lines, static_cast<std::size_t>(tube.line), where, "names no line");
  require(tube.chart == Chart::star || line.axis == tube.axis, where, "its line has another axis");
  const OnAxis<Rational> on =
      tube.chart == Chart::star ? ray(certificate.stars[tube.star], tube, line, where) : line.at;
  if (tube.seam >= 0) check_in_seam(replay, tube, on, where);
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
        where, "its line is not in it");
    if (tube.seam >= 0) bounds.first[i] = {a[1], N(0)};  // straight
    constant[i] = line.at[i][1] == 0 && line.at[i][2] == 0 && line.at[i][0] >= 0 && line.at[i][0] <= 1;
  }
}

template <class N>
void check_tube(Replay<N>& replay, const Tube<N>& tube) {
  const Certificate<N>& certificate = replay.certificate;
  const std::string where = place("tubes", replay.tubes.size());
  require(tube.slope[tube.axis] == 1 && tube.reach > 0 && tube.width > 0, where, "not a tube");
  if (tube.chart == Chart::star)
    element(certificate.stars, tube.star, where, "names no star");
  else
    require(tube.chart == Chart::pair || certificate.self, where, "a chart of two patches");
  const Vector4<N> extent = tube.extent();
  replay.tubes.push_back({tube, {}, {}, {}, {}});
  auto& [claim, bounds, constant, grows, exact] = replay.tubes.back();
  if (tube.seam < 0) {
    const Map<N> local = replay.map(tube).at(tube.centre).times(tube.inverse);
    for (const N& slack : contraction(tube, local)) require(slack > 0, where, "no contraction");
    bounds = curve_bounds(local, tube.axis, extent);
  }
  if (tube.chart == Chart::first || tube.chart == Chart::second)
    return require(monotone_pairs(tube, bounds, N(tube.centre[3] + tube.reach)), where,
                   "a parameter may turn");
  if (tube.line >= 0) check_on_line(replay, where);
  if (tube.chart == Chart::star) return check_half_branch(replay, where);
  for (std::size_t i = 0; i < 4; ++i) {
    const bool inside = tube.centre[i] >= extent[i] && tube.centre[i] + extent[i] <= 1;
    require(constant[i] || bounds.first[i].sign() != 0 || (bounds.second[i].sign() != 0 && inside), where,
            "a parameter may turn more than once, or outside the domain");
  }
}

}  // namespace exsect::checker
