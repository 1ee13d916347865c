// Bounds of the speed and curvature of arcs against points of the arcs.
#include "filter/space_bounds.h"

#include <cmath>

#include "filter/boundary.h"
#include "filter/contact.h"
#include "filter/polynomial.h"
#include "filter/trace.h"
#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::space_bounds_test {
namespace {

using namespace filter;

/// The chord over 2 d about tau is within d^2 |X''| of the arc: so |X''| from three points.
double curvature_at(const Pair& pair, const filter::Tube& tube, double tau, double d) {
  Vec3 second{};
  for (const auto& [offset, factor] : {std::pair(-d, 1.0), {0.0, -2.0}, {d, 1.0}}) {
    const filter::Ball at = filter::point_at(tube, tau + offset);
    const Vec3 x = value_at<Biquadratic>(pair.x.power, at.middle[0], at.middle[1]);
    for (std::size_t k = 0; k < 3; ++k) second[k] += factor * x[k];
  }
  return std::sqrt(second[0] * second[0] + second[1] * second[1] + second[2] * second[2]) / (d * d);
}

}  // namespace

TEST_CASE("space bounds: above what three points of an arc say, and not far above", "[filter]") {
  random_pairs::Generator generator(20281);
  int tubes = 0;
  double sharpest = 1e300;
  for (int round = 0; round < 10; ++round) {
    const auto p = random_pairs::small_rationals(generator);
    const Pair pair = make_pair(p.x, p.y).value();
    Trees trees{PatchTree(pair.x), PatchTree(pair.y)};
    long boxes = 0;
    const auto points = boundary_points(pair, {}, trees, boxes);
    if (!points || points->empty()) continue;
    const auto trace = trace_arc(pair, *points, 0);
    if (!trace) continue;
    for (const auto& piece : trace->pieces) {
      ++tubes;
      const SpaceBounds bounds = space_bounds(pair, piece.tube);
      const double length = piece.tube.upper - piece.tube.lower;
      const double d = length / 16;
      for (const double t : {0.25, 0.5, 0.75}) {
        const double tau = piece.tube.lower + t * length;
        const double found = curvature_at(pair, piece.tube, tau, d);
        CHECK(found <= bounds.curvature + 1e-9 / (d * d));
        if (found > 1e-3) sharpest = std::min(sharpest, bounds.curvature / found);
        const filter::Ball a = filter::point_at(piece.tube, tau), b = filter::point_at(piece.tube, tau + d);
        const Vec3 x = value_at<Biquadratic>(pair.x.power, a.middle[0], a.middle[1]);
        const Vec3 y = value_at<Biquadratic>(pair.x.power, b.middle[0], b.middle[1]);
        double far = 0, apart = 0;
        for (std::size_t k = 0; k < 3; ++k) far += (x[k] - y[k]) * (x[k] - y[k]);
        for (std::size_t j = 0; j < 4; ++j) apart = std::max(apart, std::fabs(a.middle[j] - b.middle[j]));
        CHECK(std::sqrt(far) <= bounds.speed * apart + 1e-12);
      }
    }
  }
  CHECK(tubes > 10);
  CHECK(sharpest < 3);
}

}  // namespace exsect::space_bounds_test
