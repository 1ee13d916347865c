// Relations, lines, touches and tubes.
#pragma once

#include "replay.h"

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

/// normal . F + sum_d (multipliers_d . e) F_d = e^T S(e) e at w = at + e, where S(e) is in a matrix of balls
/// for |e_i| <= radius, and positive definite, so that F(w) = 0 for e = 0 alone.
inline void check_touch(const std::array<Net<Rational>, 2>& exact, const Touch& touch,
                        const std::string& where) {
  for (const Rational& q : touch.at) require(q >= 0 && q <= 1, where, "not in [0,1]^4");
  require(touch.radius > 0, where, "without a neighbourhood");
  const Map<Rational> local = pair_map(exact[0], exact[1]).at(touch.at);
  std::array<Box<Rational>, 4> s;
  // value e^power e_i, of degree at least 2: e_i and one more factor are those of e^T S e.
  const auto add = [&](const Rational& value, Power power, std::size_t i) {
    std::size_t j = 0;
    while (power[j] == 0) ++j;
    --power[j];
    const int degree = power[0] + power[1] + power[2] + power[3];
    const Rational size = value / 2 *
                          Rational(pow(numerator(touch.radius), static_cast<unsigned>(degree)),
                                   pow(denominator(touch.radius), static_cast<unsigned>(degree)));
    for (auto [a, b] : {std::pair{i, j}, {j, i}}) {
      if (degree == 0)
        s[a][b].middle += size;
      else
        s[a][b].radius += abs(size);
    }
  };
  for (const auto& term : local.terms()) {
    const int degree = term.power[0] + term.power[1] + term.power[2] + term.power[3];
    require(degree > 0 || term.c == Vector3<Rational>{}, where, "not a solution");
    const Rational along = dot(touch.normal, term.c);
    require(degree != 1 || along == 0, where, "the normal is not normal to both patches");
    if (degree == 0) continue;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t d = 0; d < 3; ++d) add(touch.multipliers[d][i] * term.c[d], term.power, i);
    if (degree == 1) continue;
    Power rest = term.power;
    std::size_t i = 0;
    while (rest[i] == 0) ++i;
    --rest[i];
    add(along, rest, i);
  }
  for (std::size_t k = 0; k < 4; ++k) {  // Cholesky's pivots
    require(s[k][k].middle > s[k][k].radius, where, "not alone in its neighbourhood");
    for (std::size_t i = k + 1; i < 4; ++i)
      for (std::size_t j = k + 1; j < 4; ++j) s[i][j] = s[i][j] - s[i][k] * s[k][j] / s[k][k];
  }
}

/// The line is in the tube for all values of the axis, so it is the tube's curve.
template <class N>
void check_on_line(const Tube<N>& tube, const Line& line, const std::string& where) {
  require(tube.chart == Chart::pair && line.axis == tube.axis, where, "its line has another axis");
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
  require(tube.chart == Chart::pair || certificate.self, where, "a chart of two patches");
  const Map<N> local = replay.map(tube).at(tube.centre).times(tube.inverse);
  for (const N& slack : contraction(tube, local)) require(slack > 0, where, "no contraction");
  const Vector4<N> extent = tube.extent();
  replay.tubes.push_back({tube, curve_bounds(local, tube.axis, extent), {}});
  auto& [claim, bounds, constant] = replay.tubes.back();
  if (tube.chart != Chart::pair)
    return require(monotone_pairs(tube, bounds, N(tube.centre[3] + tube.reach)), where,
                   "a parameter may turn");
  if (tube.line >= 0) {
    const Line& line =
        element(certificate.lines, static_cast<std::size_t>(tube.line), where, "names no line");
    check_on_line(tube, line, where);
    for (std::size_t i = 0; i < 4; ++i)
      constant[i] = line.at[i][1] == 0 && line.at[i][2] == 0 && line.at[i][0] >= 0 && line.at[i][0] <= 1;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const bool inside = tube.centre[i] >= extent[i] && tube.centre[i] + extent[i] <= 1;
    require(constant[i] || bounds.first[i].sign() != 0 || (bounds.second[i].sign() != 0 && inside), where,
            "a parameter may turn more than once, or outside the domain");
  }
}

}  // namespace exsect::checker
