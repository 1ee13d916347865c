// Pieces in coordinates of space in which they are as wide as long.
#include "answer/whitened_pieces.h"

#include <exsect/algebra/nearest_rounding.h>

#include <cmath>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::whitened_pieces_test {

TEST_CASE("whitened pieces: points there and back, of long and flat pieces too") {
  in_nearest_rounding([] {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      INFO("seed " << seed);
      random_nets::Generator generator(seed);
      const random_nets::Nets nets = random_nets::scattered(generator, {3, 3, 2, 3});
      const Rational flat = power_of_two(-static_cast<long>(3 * seed));
      const auto flattened = [&](random_nets::Net net) {
        for (auto& row : net)
          for (Point& p : row) p = {p[0] + p[1], p[1] + flat * p[0], 7 + p[0] + flat * flat * p[2]};
        return RationalPatch(net);
      };
      const RationalPatch x = flattened(nets.x), y = flattened(nets.y);
      const auto map = Whitening::of(x, y);
      REQUIRE(map);
      const RationalPatch there = (*map)(x);
      IntersectionGraph graph;
      Arc arc{};
      arc.error_bound = 1e-12;
      const Rational u(2, 7), v(3, 5);
      const Point p = there(u, v), expected = x(u, v);
      PolylineVertex vertex{};
      for (std::size_t c = 0; c < 3; ++c) {
        vertex.point[c] = to_double(p[c]);
        CHECK(std::fabs(vertex.point[c]) < 8);
      }
      arc.polyline.push_back(vertex);
      graph.arcs.push_back(arc);
      map->restore(graph);
      double square = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double off = graph.arcs[0].polyline[0].point[c] - to_double(expected[c]);
        square += off * off;
      }
      CHECK(std::sqrt(square) <= graph.arcs[0].error_bound);
      CHECK(graph.arcs[0].error_bound < 1e-10);
    }
  });
}

TEST_CASE("whitened pieces: none with a weight that is not positive, or of one point") {
  const RationalPatch half_circle({{{-1, 0, 0}, {-1, 0, 1}}, {{0, 1, 0}, {0, 1, 1}}, {{1, 0, 0}, {1, 0, 1}}},
                                  {{1, 1}, {0, 0}, {1, 1}});
  CHECK_FALSE(Whitening::of(half_circle, half_circle));
}

}  // namespace exsect::whitened_pieces_test
