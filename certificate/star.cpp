#include "certificate/star.h"

#include <exsect/checker/factors.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "certificate/algebraic.h"
#include "certificate/claims.h"
#include "certificate/cover.h"
#include "certificate/singular.h"

namespace exsect::cli {
namespace {

using checker::others;
using checker::Star;

Parameters parameters_at(const Star& star) {
  Parameters result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = checker::number<double>(star.at[i]);
  return result;
}

/// A subdivision of a chart that does not end soon.
struct NotAlone {};

/// A direction in which the map has one sign where its variables differ by `half` at most from the middle, as
/// an entry of a subdivision; empty if none is found.
std::string one_sign(const Map& map, const Parameters& middle, const Parameters& half, std::size_t axis) {
  const Map local = map.at(middle);
  std::vector<Vector> normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, local.value(Parameters{})};
  if (const auto c = inverse(local, axis)) normals.insert(normals.end(), c->begin(), c->end());
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) normals.push_back(checker::cross(local.slope(i), local.slope(j)));
  for (const auto& normal : normals) {
    const auto n = rounded_direction(normal);
    const checker::Ball<double> range =
        checker::along({double(n[0]), double(n[1]), double(n[2])}, local, half);
    if (std::abs(range.middle) > range.radius * (1 + 1e-9) + 1e-11)
      return fmt::format("{},{},{}", n[0], n[1], n[2]);
  }
  return "";
}

/// The charts' maps of a star, whose rows are each multiplied by a power of 2, so that the largest term is
/// near 1; the orders become the largest possible ones.
std::array<Map, 8> scaled_maps(Star& star, const checker::Map<Rational>& equation) {
  const checker::Terms terms = checker::centred(equation, star);
  std::array<int, 3> orders = {100, 100, 100};
  for (const auto& [power, c] : terms) {
    const int degree = checker::weighted_degree(star, power);
    for (std::size_t d = 0; d < 3; ++d)
      if (checker::dot(star.rows[d], c) != 0) orders[d] = std::min(orders[d], degree);
  }
  star.orders = orders;
  for (int& order : star.orders) {
    if (order == 0) throw NotAlone();
    if (order == 100) order = 1;  // no term at all
  }
  std::array<Map, 8> maps;
  for (int pass = 0; pass < 2; ++pass) {
    std::array<double, 3> most{};
    for (std::size_t direction = 0; direction < 8; ++direction) {
      maps[direction] = checker::in_direction<double>(terms, star, direction, star.rows, star.orders);
      for (const auto& term : maps[direction].terms())
        for (std::size_t d = 0; d < 3; ++d) most[d] = std::max(most[d], std::abs(term.c[d]));
    }
    for (std::size_t d = 0; pass == 0 && d < 3; ++d)
      for (checker::Algebraic& q : star.rows[d])
        q = q * checker::Algebraic(power_of_two(most[d] > 0 ? -std::ilogb(most[d]) : 0));
  }
  return maps;
}

/// One chart: its tubes and its subdivision. Throws NotAlone if it does not end.
class ChartSearch {
 public:
  ChartSearch(FoundStar& found, const ClaimNumbers& first, std::size_t direction)
      : found_(found),
        star_(found.claim),
        map_(found.maps.at({-1, direction}).map),
        first_(first),
        direction_(direction) {
    chart_ = {Chart::star, first.star, direction};
  }

  void run() {
    Parameters middle{};
    Parameters half = {1, 1, 1, 1};
    middle[direction_ / 2] = half[direction_ / 2] = 0.5;
    add(middle, half, 0);
  }

  std::string entries_;

 private:
  void add(const Parameters& middle, const Parameters& half, int depth) {
    if (++count_ > max_entries || depth > 60) throw NotAlone();
    std::string place = leaf(middle, half);
    if (place.empty() && depth > 8 && half_branch(middle, half)) place = leaf(middle, half);
    std::size_t parameter = 0;
    for (std::size_t j = 1; j < 4; ++j)
      if (weight(half, j) > weight(half, parameter)) parameter = j;
    entries_ += (entries_.empty() ? "" : " ") + (place.empty() ? std::string(1, "uvrs"[parameter]) : place);
    if (!place.empty()) return;
    Parameters less = half;
    less[parameter] /= 2;
    for (const int side : {-1, 1}) {
      Parameters moved = middle;
      moved[parameter] += side * less[parameter];
      add(moved, less, depth + 1);
    }
  }

  /// t is halved late: little depends on it.
  double weight(const Parameters& half, std::size_t j) const {
    return j == direction_ / 2 ? 0.1 * half[j] : half[j];
  }

  std::string leaf(const Parameters& middle, const Parameters& half) const {
    checker::Box<double> box;
    for (std::size_t j = 0; j < 4; ++j) box[j] = {middle[j], half[j]};
    for (std::size_t i = 0; i < found_.tubes.size(); ++i) {
      Tube tube = found_.tubes[i];
      tube.width *= 1 - 1e-9;
      if (tube == chart_ && tube.surrounds(box)) return "t" + std::to_string(first_.tube + i);
    }
    return one_sign(map_, middle, half, direction_ / 2);
  }

  /// A tube whose half branch begins in the cell, if Newton's method finds one, with one of the maps.
  bool half_branch(const Parameters& middle, const Parameters& half) {
    for (const auto& [key, maps] : found_.maps)
      if (key.second == direction_ && half_branch(key.first, maps.map, middle, half)) return true;
    return false;
  }
  bool half_branch(int factor, const Map& map, Parameters z, const Parameters& half) {
    const std::size_t k = direction_ / 2;
    const Parameters middle = z;
    z[k] = 0;
    try {
      z = on_curve(map, z, k);
    } catch (const NoCertificate&) {
      return false;
    }
    for (const std::size_t j : others(k))
      if (!(std::abs(z[j] - middle[j]) <= 4 * half[j] && std::abs(z[j]) < 0.97)) return false;
    for (const Tube& tube : found_.tubes) {
      double away = 0;
      for (const std::size_t j : others(k)) away = std::max(away, std::abs(z[j] - tube.centre[j]));
      if (tube == chart_ && away < tube.width) return false;
    }
    return find_tube(factor, map, z);
  }

  bool find_tube(int factor, const Map& map, const Parameters& z) {
    const std::size_t k = direction_ / 2;
    const Map here = map.at(z);
    auto c = inverse(here, k);
    if (!c) return false;
    for (auto& row : *c)
      for (double& a : row) a = std::ldexp(std::nearbyint(std::ldexp(a, 20)), -20);
    const auto slope = checker::curve_bounds(here.times(*c), k, {}).first;
    for (int e = 2; e < 30; ++e) {
      Tube tube = {chart_, z, k, {}, 1 + 0x1p-20, std::ldexp(1.0, -e), *c, factor};
      for (std::size_t j = 0; j < 4; ++j) {
        tube.centre[j] = std::ldexp(std::nearbyint(std::ldexp(z[j], e + 20)), -e - 20);
        tube.slope[j] = j == k ? 1 : std::ldexp(std::nearbyint(std::ldexp(slope[j].middle, 12)), -12);
      }
      if (!holds(tube, map)) continue;
      found_.tubes.push_back(tube);
      return true;
    }
    return false;
  }

  bool holds(const Tube& tube, const Map& map) const {
    const Map local = map.at(tube.centre).times(tube.inverse);
    for (const double slack : checker::contraction(tube, local))
      if (!(slack > 0.05 * tube.width)) return false;
    for (const std::size_t j : others(tube.axis))
      if (!(std::abs(tube.centre[j]) + tube.width < 1 - 1e-9)) return false;
    for (const Tube& other : found_.tubes) {
      double away = 0;
      for (const std::size_t j : others(tube.axis))
        away = std::max(away, std::abs(tube.centre[j] - other.centre[j]));
      if (other == chart_ && !(away > 1.001 * (tube.width + other.width))) return false;
    }
    checker::Box<double> box;
    const Parameters extent = tube.extent();
    for (std::size_t j = 0; j < 4; ++j) box[j] = {tube.centre[j], extent[j] * (1 + 0x1p-20)};
    box[tube.axis] = {0.5 * tube.reach, 0.5 * tube.reach};
    std::array<bool, 4> constant = found_.constant;
    if (tube.factor >= 0) {
      if (!checker::independent<double>(found_.maps.at({tube.factor, direction_}).columns, box)) return false;
      const NearFactor& factor = found_.factors[static_cast<std::size_t>(tube.factor)];
      constant =
          checker::constant_in(factor.exact.map, factor.map, checker::from_star(star_, direction_, box));
    }
    const auto signs =
        checker::half_branch_signs(star_, tube, checker::curve_bounds(local, tube.axis, extent));
    for (std::size_t i = 0; i < 4; ++i)
      if (!constant[i] && signs[i] == 0) return false;
    return true;
  }

  static constexpr std::size_t max_entries = 3000;
  FoundStar& found_;
  const Star& star_;
  const Map& map_;
  ClaimNumbers first_;
  std::size_t direction_;
  checker::MapName chart_;
  std::size_t count_ = 0;
};

/// The star, if what is around its point is in tubes; otherwise throws NotAlone.
FoundStar alone(const Star& star, const SingularSearch& search, const ClaimNumbers& first,
                const std::vector<NearFactor>& factors) {
  FoundStar result = {star, {}, {}, factors, search.constant, {}};
  const std::array<Map, 8> maps = scaled_maps(result.claim, search.equation);
  for (std::size_t direction = 0; direction < 8; ++direction) {
    result.maps[{-1, direction}].map = maps[direction];
    for (std::size_t n = 0; n < factors.size(); ++n) {
      const auto at = factors[n].map.value(parameters_at(star));
      if (std::abs(at[0]) + std::abs(at[1]) + std::abs(at[2]) > 1e-9) continue;
      try {
        result.maps[{static_cast<int>(n), direction}] =
            checker::factor_in_direction<double>(factors[n].exact, result.claim, direction);
      } catch (const checker::Failed&) {
      }
    }
  }
  for (std::size_t direction = 0; direction < 8; ++direction) {
    ChartSearch chart(result, first, direction);
    chart.run();
    result.subdivisions[direction] = chart.entries_;
  }
  return result;
}

/// The greatest way of a parameter in the star.
double extent(const Star& star) {
  double most = 0;
  for (const auto& row : star.axes) {
    double sum = 0;
    for (const checker::Algebraic& q : row) sum += std::abs(checker::number<double>(q));
    most = std::max(most, sum);
  }
  return most;
}

}  // namespace

FoundStar star_at(const SingularSearch& search, const Node& node, const ClaimNumbers& first, double size,
                  const std::vector<NearFactor>& factors) {
  const std::vector<Star> candidates = singular_points(search, node);
  for (const Star& star : candidates) {
    const bool plain = candidates.size() == 1 || star.weights == std::array<std::size_t, 4>{1, 1, 1, 1};
    int tried = 0;
    for (int e = 2; e < 46 && tried < (plain ? 22 : 6); plain ? e += 2 : ++e) {
      const Star scaled = at_scale(star, e);
      if (extent(scaled) > size) continue;
      ++tried;
      try {
        return alone(scaled, search, first, factors);
      } catch (const NotAlone&) {
      }
    }
  }
  throw NoCertificate("a special point with degenerate quadratic terms");
}

namespace {

template <class Numbers>
Json list(const Numbers& numbers) {
  Json result = Json::array();
  for (const checker::Algebraic& q : numbers) result.push_back(algebraic_claim(q));
  return result;
}
template <class Rows>
Json matrix(const Rows& m) {
  Json rows = Json::array();
  for (const auto& row : m) rows.push_back(list(row));
  return rows;
}

}  // namespace

Json star_claims(const std::vector<FoundStar>& stars) {
  Json result = Json::array();
  for (const FoundStar& found : stars) {
    const Star& star = found.claim;
    result.push_back(sealed(in_list("stars", result.size()), {{"modulus", rationals(star.root->modulus)},
                                                              {"between", rationals(star.root->between)},
                                                              {"at", list(star.at)},
                                                              {"axes", matrix(star.axes)},
                                                              {"coordinates", matrix(star.coordinates)},
                                                              {"weights", star.weights},
                                                              {"rows", matrix(star.rows)},
                                                              {"orders", star.orders},
                                                              {"charts", found.subdivisions}}));
  }
  return result;
}

Parameters on_half_branch(const FoundStar& star, const Tube& tube, double t) {
  Parameters z = tube.centre;
  for (std::size_t j = 0; j < 4; ++j) z[j] += t * tube.slope[j];
  return on_curve(star.maps.at({tube.factor, tube.direction}).map, z, tube.axis);
}

Parameters parameters_of(const FoundStar& star, const Tube& tube, const Parameters& z) {
  checker::Box<double> box;
  for (std::size_t j = 0; j < 4; ++j) box[j] = {z[j], 0};
  const auto w = checker::from_star(star.claim, tube.direction, box);
  return {w[0].middle, w[1].middle, w[2].middle, w[3].middle};
}

double distance_from_point(const checker::Star& star, const Parameters& w) {
  double t = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    double e = 0;
    for (std::size_t i = 0; i < 4; ++i)
      e += checker::number<double>(star.coordinates[j][i]) * (w[i] - checker::number<double>(star.at[i]));
    t = std::max(t, std::pow(std::abs(e), 1.0 / static_cast<double>(star.weights[j])));
  }
  return t;
}

}  // namespace exsect::cli
