// Tubes.
#pragma once

#include "check_stars.h"

namespace exsect::checker {

/// The box around the tube in the variables of its map; of a star, for t >= 0.
template <class N>
Box<N> box_of(const Tube<N>& tube) {
  Box<N> box;
  const Vector4<N> extent = tube.extent();
  for (std::size_t i = 0; i < 4; ++i) box[i] = {tube.centre[i], extent[i]};
  if (tube.chart == Chart::star) box[tube.axis] = {tube.reach / 2, tube.reach / 2};
  return box;
}

/// The map of the tube's factor; there are no other solutions in the tube.
template <class N>
Map<N> check_factored(const Replay<N>& replay, const Tube<N>& tube) {
  const auto& [factors, stars] = std::tie(replay.certificate.factors, replay.certificate.stars);
  const Factor& factor = element(factors, static_cast<std::size_t>(tube.factor), "names no factor");
  require(!factor.is_surface() || is_edge(factor.map), "its surface goes on in the domain");
  const FactorMaps<N> maps = tube.chart == Chart::star
                                 ? factor_in_direction<N>(factor, stars[tube.star], tube.direction)
                                 : factor_maps<N>(factor);
  const Box<N> box = box_of(tube);
  const auto walls = tube.chart == Chart::star ? std::nullopt : walls_of(factor);
  require(independent(maps.columns, box) || (walls && on_one_side(factor, *walls, maps.columns, box)),
          "there may be other solutions");
  return maps.map;
}

/// The parameters that are constant on the tube's curve.
template <class N>
std::array<bool, 4> constant_parameters(const Replay<N>& replay, const Tube<N>& tube) {
  if (tube.factor < 0 && !replay.certificate.equation) return {};
  Box<N> box = box_of(tube);
  if (tube.chart == Chart::star) box = from_star(replay.certificate.stars[tube.star], tube.direction, box);
  const Map<Rational>& map = replay.exact_map(tube);
  return constant_in(map, rounded<N>(map), box);
}

template <class N>
void check_tube(Replay<N>& replay, const Tube<N>& tube) {
  const Certificate<N>& certificate = replay.certificate;
  require(tube.slope[tube.axis] == 1 && tube.reach > 0 && tube.width > 0, "not a tube");
  const bool in_star = tube.chart == Chart::star;
  if (in_star)
    element(certificate.stars, tube.star, "names no star");
  else
    require(tube.chart == Chart::pair || certificate.self, "a chart of two patches");
  replay.tubes.push_back({tube, tube.factor >= 0 ? check_factored(replay, tube)
                                : in_star        ? replay.stars[tube.star].equation[tube.direction]
                                                 : replay.equation[static_cast<std::size_t>(tube.chart)]});
  auto& [claim, map, bounds, constant, grows] = replay.tubes.back();
  const Vector4<N> extent = tube.extent();
  const Map<N> local = map.at(tube.centre).times(tube.inverse);
  for (const N& slack : contraction(tube, local)) require(slack > 0, "no contraction");
  bounds = curve_bounds(local, tube.axis, extent);
  require(bounds.defect < 1, "no contraction");  // without it the bounds say nothing
  if (tube.chart == Chart::first || tube.chart == Chart::second)
    return require(monotone_pairs(tube, bounds, N(tube.centre[3] + tube.reach)), "a parameter may turn");
  constant = constant_parameters(replay, tube);
  if (in_star) return check_half_branch(replay);
  for (std::size_t i = 0; i < 4; ++i) {
    const bool inside = tube.centre[i] >= extent[i] && tube.centre[i] + extent[i] <= 1;
    require(constant[i] || bounds.first[i].sign() != 0 || inside, "a parameter may turn outside the domain");
  }
}

}  // namespace exsect::checker
