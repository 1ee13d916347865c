#include <exsect/geometry/rational_patch_file.h>

#include <functional>

#include "pair_families.h"
#include "round_families.h"

namespace peers {
namespace {

using exsect::BezierPatch;
using exsect::ControlNet;
using exsect::Point;
using exsect::Rational;
using exsect::RationalPatch;

using Points = std::vector<std::vector<Point>>;
using Weights = std::vector<std::vector<Rational>>;
struct Grids {
  Points x;
  Points y;
};

/// The unit square in the plane z = 0 and an upright, steep or nearly flat square through it, or the same
/// square turned over, as nets of bidegree (n,n); each coordinate is moved by unit() times a width, unit() in
/// [-1,1].
Grids near_grids(Generator& generator, long degree, const std::function<Rational()>& unit) {
  const long placement = integer(generator, 0, 3);
  const Rational half(1, 2);
  const Rational bend(placement < 2 ? 1 : 2, 2);
  const auto size = static_cast<std::size_t>(degree) + 1;
  const Points empty(size, std::vector<Point>(size));
  Grids nets = {empty, empty};
  for (long i = 0; i <= degree; ++i) {
    for (long j = 0; j <= degree; ++j) {
      const Rational a(i, degree);
      const Rational b(j, degree);
      const std::array<Point, 4> grids = {Point{a, half, b - half}, Point{a, (a + b) * half, b - half},
                                          Point{a, b, (a - half) / 4}, Point{b, a, 0}};
      const Point grid = grids[static_cast<std::size_t>(placement)];
      const auto row = static_cast<std::size_t>(i);
      const auto column = static_cast<std::size_t>(j);
      nets.x[row][column] = {a + unit() / 8, b + unit() / 8, bend * unit()};
      nets.y[row][column] = {grid[0] + unit() / 8, grid[1] + unit() / 4, grid[2] + bend * unit()};
    }
  }
  return nets;
}

Rational rounded(const Rational& c) { return exsect::from_double(exsect::to_double(c)); }

Points rounded(Points net) {
  for (auto& row : net)
    for (Point& p : row)
      for (Rational& c : p) c = rounded(c);
  return net;
}

Grids near_grids_in_doubles(Generator& generator, long degree) {
  const Grids nets = near_grids(generator, degree, [&] { return unit_double(generator); });
  return {rounded(nets.x), rounded(nets.y)};
}

/// Between 1/2 and 2.
Weights weights(Generator& generator, long degree) {
  const auto size = static_cast<std::size_t>(degree) + 1;
  Weights result(size, std::vector<Rational>(size));
  for (auto& row : result)
    for (Rational& w : row) w = rounded((5 + 3 * unit_double(generator)) / 4);
  return result;
}

ExactPair with_weights(Generator& generator, long degree) {
  const Grids nets = near_grids_in_doubles(generator, degree);
  const RationalPatch x(nets.x, weights(generator, degree));
  return {x, RationalPatch(nets.y, weights(generator, degree))};
}

ControlNet control_net(const Points& points) {
  ControlNet net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) net[i][j] = points[i][j];
  return net;
}

template <ExactPair (*pair)(Generator&)>
nlohmann::ordered_json member(Generator& generator) {
  return entries(pair(generator));
}

template <Round first, Round second>
nlohmann::ordered_json both(Generator& generator) {
  return round_pair(generator, first, second);
}

template <nlohmann::ordered_json (*pair)(Generator&, int), int degree>
nlohmann::ordered_json beside(Generator& generator) {
  return pair(generator, degree);
}

}  // namespace

ExactPair random_rationals(Generator& generator) {
  const Grids nets = near_grids(generator, 2, [&] {
    const long denominator = integer(generator, 1, 16);
    return Rational(integer(generator, -denominator, denominator), denominator);
  });
  return {RationalPatch(nets.x), RationalPatch(nets.y)};
}

ExactPair random_doubles(Generator& generator) {
  const Grids nets = near_grids_in_doubles(generator, 2);
  return {RationalPatch(nets.x), RationalPatch(nets.y)};
}

ExactPair bicubic(Generator& generator) {
  const Grids nets = near_grids_in_doubles(generator, 3);
  return {RationalPatch(nets.x), RationalPatch(nets.y)};
}

ExactPair weighted(Generator& generator) { return with_weights(generator, 2); }

ExactPair weighted_bicubic(Generator& generator) { return with_weights(generator, 3); }

ExactPair overlap(Generator& generator) {
  const Grids random = near_grids(generator, 2, [&] { return sixteenths(generator, -16, 16); });
  const BezierPatch x(control_net(random.x));
  switch (integer(generator, 0, 2)) {
    case 0: {
      ControlNet net = control_net(random.y);
      net[0] = x.net()[0];
      return {x, BezierPatch(net)};
    }
    case 1:
      return {x, x.restricted_to(0, -1, 0, 1)};
    default: {
      const Rational u(integer(generator, -6, 6), 8);
      const Rational v(integer(generator, -6, 6), 8);
      return {x, x.restricted_to(u, u + 1, v, v + 1)};
    }
  }
}

nlohmann::ordered_json entries(const ExactPair& pair) {
  const exsect::RationalPatchFile file = {"", "", {{"x", pair.x}, {"y", pair.y}}};
  return nlohmann::ordered_json::parse(exsect::format_patches(file)).at("patches");
}

const std::vector<Family>& families() {
  using enum Round;
  static const std::vector<Family> all = {{"random-rational", member<random_rationals>},
                                          {"random-double", member<random_doubles>},
                                          {"loop", member<loop>},
                                          {"tangent", member<tangent>},
                                          {"near", member<near>},
                                          {"nearer", member<nearer>},
                                          {"overlap", member<overlap>},
                                          {"bicubic", member<bicubic>},
                                          {"weighted", member<weighted>},
                                          {"weighted-bicubic", member<weighted_bicubic>},
                                          {"plane-cylinder", both<plane, cylinder>},
                                          {"plane-cone", both<plane, cone>},
                                          {"plane-sphere", both<plane, sphere>},
                                          {"plane-torus", both<plane, torus>},
                                          {"cylinder-cylinder", both<cylinder, cylinder>},
                                          {"cylinder-cone", both<cylinder, cone>},
                                          {"cylinder-sphere", both<cylinder, sphere>},
                                          {"cone-sphere", both<cone, sphere>},
                                          {"sphere-sphere", both<sphere, sphere>},
                                          {"torus-cylinder", both<torus, cylinder>},
                                          {"torus-cone", both<torus, cone>},
                                          {"torus-sphere", both<torus, sphere>},
                                          {"torus-torus", both<torus, torus>},
                                          {"quadric-biquadratic", beside<quadric_and_patch, 2>},
                                          {"quadric-bicubic", beside<quadric_and_patch, 3>},
                                          {"torus-biquadratic", beside<torus_and_patch, 2>}};
  return all;
}

}  // namespace peers
