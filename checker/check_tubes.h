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

/// The line is in the tube for all values of the axis, so it is the tube's curve.
template <class N>
void check_on_line(const Tube<N>& tube, const Line& line, const std::string& where) {
  require(line.axis == tube.axis, where, "its line has another axis");
  const N& t = tube.centre[tube.axis];
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3<N> a = {N(line.at[i][0]), N(line.at[i][1]), N(line.at[i][2])};
    const N middle = a[0] + t * (a[1] + t * a[2]) - tube.centre[i];
    const N slope = a[1] + 2 * t * a[2] - tube.slope[i];
    require(
        i == tube.axis ||
            magnitude(middle) + tube.reach * (magnitude(slope) + tube.reach * magnitude(a[2])) <= tube.width,
        where, "its line is not in it");
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
  const Map<N> local = replay.map(tube).at(tube.centre).times(tube.inverse);
  for (const N& slack : contraction(tube, local)) require(slack > 0, where, "no contraction");
  const Vector4<N> extent = tube.extent();
  replay.tubes.push_back({tube, curve_bounds(local, tube.axis, extent), {}, {}});
  auto& [claim, bounds, constant, grows] = replay.tubes.back();
  if (tube.chart == Chart::first || tube.chart == Chart::second)
    return require(monotone_pairs(tube, bounds, N(tube.centre[3] + tube.reach)), where,
                   "a parameter may turn");
  if (tube.line >= 0) {
    const Line& line =
        element(certificate.lines, static_cast<std::size_t>(tube.line), where, "names no line");
    tube.chart == Chart::star ? check_ray(certificate.stars[tube.star], tube, line, where)
                              : check_on_line(tube, line, where);
    for (std::size_t i = 0; i < 4; ++i)
      constant[i] = line.at[i][1] == 0 && line.at[i][2] == 0 && line.at[i][0] >= 0 && line.at[i][0] <= 1;
  }
  if (tube.chart == Chart::star) return check_half_branch(replay, where);
  for (std::size_t i = 0; i < 4; ++i) {
    const bool inside = tube.centre[i] >= extent[i] && tube.centre[i] + extent[i] <= 1;
    require(constant[i] || bounds.first[i].sign() != 0 || (bounds.second[i].sign() != 0 && inside), where,
            "a parameter may turn more than once, or outside the domain");
  }
}

}  // namespace exsect::checker
