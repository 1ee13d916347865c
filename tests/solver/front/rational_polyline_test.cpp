// Bounds of polylines of pairs of any bidegree, with and without weights, against far finer ones.
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <cmath>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::rational_polyline_test {
namespace {

using random_pairs::Generator;

double distance(const std::array<double, 3>& p, const Arc& arc) {
  double best = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i) {
    const auto& a = arc.polyline[i].point;
    const auto& b = arc.polyline[i + 1].point;
    double along = 0;
    double square = 1e-300;
    for (std::size_t c = 0; c < 3; ++c) {
      along += (p[c] - a[c]) * (b[c] - a[c]);
      square += (b[c] - a[c]) * (b[c] - a[c]);
    }
    const double t = std::clamp(along / square, 0.0, 1.0);
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += std::pow(a[c] + t * (b[c] - a[c]) - p[c], 2);
    best = std::min(best, std::sqrt(sum));
  }
  return best;
}

/// Vertices of the fine polylines are within their bounds of the curve, which is within those of the coarse
/// ones.
void check_bounds(const RationalPatch& x, const RationalPatch& y, int& compared) {
  IntersectOptions options;
  options.tolerance = 1e-5;
  const IntersectResult coarse = intersect(x, y, options);
  options.tolerance = 1e-7;
  const IntersectResult fine = intersect(x, y, options);
  if (coarse.status != Status::complete || fine.status != Status::complete) return;
  ++compared;
  for (const Arc& arc : fine.graph.arcs)
    for (const PolylineVertex& vertex : arc.polyline)
      CHECK(std::any_of(coarse.graph.arcs.begin(), coarse.graph.arcs.end(), [&](const Arc& other) {
        return distance(vertex.point, other) <= other.error_bound + arc.error_bound;
      }));
}

}  // namespace

TEST_CASE("intersect rational: polylines keep within their bounds") {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const std::array<int, 4> degrees = seed % 2 == 0 ? std::array{3, 3, 3, 3} : std::array{2, 2, 1, 2};
    const random_nets::Nets nets = seed % 3 == 0 ? random_nets::loop(generator, degrees)
                                                 : random_nets::crossing(generator, degrees, true);
    check_bounds(nets.first(), nets.second(), compared);
    check_bounds(random_nets::weighted(generator, nets.x), random_nets::weighted(generator, nets.y),
                 compared);
  }
  CHECK(compared >= 22);  // of 24
}

}  // namespace exsect::rational_polyline_test
