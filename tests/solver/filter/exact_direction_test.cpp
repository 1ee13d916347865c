// Directions from exact control points against the curve in 256 bits, of elevated pairs and of their images
// under a projective map, which have the same curve in the parameters.
#include "filter/exact_direction.h"

#include <cmath>

#include "filter/trace.h"
#include "support/catch.h"
#include "support/random_pairs.h"
#include "trace/tube.h"

namespace exsect::exact_direction_test {
namespace {

using Fine = ArbBall<256>;
using random_pairs::Generator;

RationalPatch image(const BezierPatch& patch) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const auto& row : patch.net()) {
    net.emplace_back();
    for (const Point& p : row) {
      net.back().push_back({p[0] + p[1] / 3, p[1] - p[2] / 5, p[2] + 1, 1 + (p[0] + p[1] - p[2]) / 16});
    }
  }
  return RationalPatch::from_homogeneous(net);
}

/// The greatest |d_j - w_j'| over the parameters, from above.
double error_of(const random_pairs::Pair& pair, const filter::Vec4& d, filter::Vec4 start, std::size_t axis,
                double tau) {
  const PairSystem<Fine> system(pair.x, pair.y, {0, 0, 0}, 0);
  BallPoint<Fine> w;
  for (std::size_t j = 0; j < 4; ++j) w[j] = Fine::enclosing(from_double(start[j]) + Rational(1, 2));
  w[axis] = w[axis] + Fine::enclosing(from_double(tau));
  const BallPoint<Fine> point = newton_corrected(system, w, axis, 6).value();
  const BallPoint<Fine> t = Expansion<Fine>(system, point).tangent();
  double result = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    const Fine difference = t[j] - Fine::enclosing(from_double(d[j])) * t[axis];
    result = std::max(result, difference.upper_magnitude());
  }
  return result / std::fabs(t[axis].approximation()) * (1 - 1e-12);
}

/// Along the arcs from all boundary points; returns the number of places.
template <class K>
int check_directions(const random_pairs::Pair& pair, const RationalPatch& first,
                     const RationalPatch& second) {
  const auto x = filter::elevated<K>(first);
  const auto y = filter::elevated<K>(second);
  const auto rounded = filter::make_pair_of<K>(x, y).value();
  filter::TreesOf<K> trees{filter::PatchTreeOf<K>(rounded.x, rounded.net_error),
                           filter::PatchTreeOf<K>(rounded.y, rounded.net_error)};
  long boxes = 0;
  const auto points = filter::boundary_points<K>(rounded, {}, trees, boxes);
  if (!points) return 0;
  const auto exact = filter::exact_directions<K>(x, y, rounded);
  int places = 0;
  for (std::size_t i = 0; i < points->size(); ++i) {
    const auto trace = filter::trace_arc(rounded, *points, i);
    if (!trace) continue;
    for (const filter::PieceOf<K>& piece : trace->pieces) {
      const double tau = piece.range.at(0.375);
      const filter::Direction<K> near = filter::direction_at(piece.tube, tau);
      const filter::Direction<K> d = exact(piece.tube, tau);
      filter::Vec4 start = filter::parameters_of(filter::point_at(piece.tube, tau));
      start[piece.tube.axis] = piece.tube.centre[piece.tube.axis];
      const filter::Vec4 middle = filter::first_four<K>(d.middle);
      CHECK(error_of(pair, middle, start, piece.tube.axis, tau) <= d.radius);
      CHECK(d.radius <= 0x1p-50 * (1 + filter::largest<4>(middle)));
      CHECK(d.radius < near.radius);
      ++places;
    }
  }
  return places;
}

}  // namespace

TEST_CASE("exact direction: the errors hold, and are those of the last rounding") {
  int bicubic = 0;
  int weighted = 0;
  int both = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_pairs::Pair pair =
        seed % 2 == 0 ? random_pairs::doubles(generator) : random_pairs::scattered(generator);
    bicubic += check_directions<filter::Bicubic>(pair, pair.x, pair.y);
    weighted += check_directions<filter::WeightedBiquadratic>(pair, image(pair.x), image(pair.y));
    both += check_directions<filter::WeightedBicubic>(pair, image(pair.x), image(pair.y));
  }
  CHECK(bicubic > 60);
  CHECK(weighted > 60);
  CHECK(both > 60);
}

}  // namespace exsect::exact_direction_test
