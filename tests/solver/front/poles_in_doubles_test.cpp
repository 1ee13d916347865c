// Patches with sides that are one point, and neighbours that share one: in doubles against exact arithmetic,
// and sectors of bicubic domes.
#include <exsect/solver/intersect.h>
#include <exsect/solver/intersect_rational.h>

#include <cmath>

#include "filter/filter.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::poles_in_doubles_test {
namespace {

using random_pairs::Generator;

/// Control points of a dome of four sectors: rings about the pole (0,0,1), the first of which is the pole.
struct Dome {
  int degree;
  std::vector<std::vector<Point>> rings;
};

Dome dome(Generator& generator, int degree) {
  Dome result{degree, {}};
  const int around = 4 * degree;
  for (int k = 0; k <= degree; ++k) {
    auto& ring = result.rings.emplace_back();
    for (int i = 0; i < around; ++i) {
      const auto jitter = [&] { return Rational(random_pairs::integer(generator, -4, 4), 128); };
      const double angle = 2 * M_PI * i / around;
      const Rational radius(k, degree);
      const auto rounded = [](double t) { return Rational(std::lround(64 * t), 64); };
      const Point p = {radius * (rounded(std::cos(angle)) + jitter()),
                       radius * (rounded(std::sin(angle)) + jitter()), 1 - radius * radius / 2 + jitter()};
      ring.push_back(k == 0 ? Point{0, 0, 1} : p);
    }
  }
  return result;
}

std::vector<std::vector<Point>> sector(const Dome& dome, int i) {
  const auto n = static_cast<std::size_t>(dome.degree);
  std::vector<std::vector<Point>> net(n + 1);
  for (std::size_t k = 0; k <= n; ++k)
    for (std::size_t j = 0; j <= n; ++j)
      net[k].push_back(dome.rings[k][(static_cast<std::size_t>(i) * n + j) % (4 * n)]);
  return net;
}

BezierPatch biquadratic(const std::vector<std::vector<Point>>& net) {
  return *RationalPatch(net).biquadratic();
}

}  // namespace

TEST_CASE("poles in doubles: sectors of a bicubic dome meet along their seams and in the pole") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Dome all = dome(generator, 3);
    const RationalPatch first(sector(all, 0));
    for (const int i : {1, 3}) {
      const IntersectResult seam = intersect(first, RationalPatch(sector(all, i)));
      REQUIRE(seam.status == Status::complete);
      REQUIRE(seam.graph.arcs.size() == 1);
      CHECK(seam.graph.arcs[0].place == ArcPlace::patch_boundary);
      CHECK(seam.graph.nodes.size() == 2);
      const Node& pole = seam.graph.nodes[0].free.empty() ? seam.graph.nodes[1] : seam.graph.nodes[0];
      CHECK(pole.free == std::vector<Parameter>{Parameter::v, Parameter::s});
      CHECK(pole.on == std::vector<Side>{{Parameter::u, 0}, {Parameter::r, 0}});
      CHECK(pole.point == std::array<double, 3>{0, 0, 1});
      for (const PolylineVertex& vertex : seam.graph.arcs[0].polyline) {
        const Point p = first(from_double(vertex.parameters[0]), from_double(vertex.parameters[1]));
        for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(to_double(p[c]) - vertex.point[c]) < 1e-12);
      }
    }
    const IntersectResult opposite = intersect(first, RationalPatch(sector(all, 2)));
    REQUIRE(opposite.status == Status::complete);
    CHECK(opposite.graph.arcs.empty());
    REQUIRE(opposite.graph.isolated_points.size() == 1);
    CHECK(opposite.graph.nodes[0].free.size() == 2);
  }
}

TEST_CASE("poles in doubles: elevated biquadratic sectors have the graph of exact arithmetic") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Dome all = dome(generator, 2);
    const BezierPatch first = biquadratic(sector(all, 0));
    for (const int i : {1, 2, 3}) {
      const BezierPatch second = biquadratic(sector(all, i));
      const IntersectResult exact = intersect(first, second);
      const IntersectResult elevated = intersect_in_doubles(first, second, {});
      REQUIRE(exact.status == Status::complete);
      REQUIRE(elevated.status == Status::complete);
      CHECK(difference(exact.graph, elevated.graph, {}) == "");
    }
  }
}

TEST_CASE("poles in doubles: a sector beside a patch that has no pole") {
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Dome all = dome(generator, 2);
    auto net = sector(all, 1);  // the seam with sector 0 is its column 0, and the pole becomes a side
    net[0] = {net[0][0], {Rational(-1, 3), Rational(1, 9), 1}, {Rational(-2, 3), Rational(1, 5), 1}};
    const IntersectResult exact = intersect(biquadratic(sector(all, 0)), biquadratic(net));
    const IntersectResult elevated = intersect_in_doubles(biquadratic(sector(all, 0)), biquadratic(net), {});
    REQUIRE(exact.status == Status::complete);
    if (elevated.status != Status::complete) continue;
    ++complete;
    CHECK(difference(exact.graph, elevated.graph, {}) == "");
    CHECK(elevated.graph.nodes.size() == 2);
  }
  CHECK(complete >= 8);
}

TEST_CASE("poles in doubles: of a sector that folds back the seam is not all") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Dome all = dome(generator, 3);
    auto net = sector(all, 1);
    const auto first = sector(all, 0);
    for (std::size_t k = 1; k < 4; ++k)
      for (std::size_t j = 2; j < 4;
           ++j) {  // away from the seam at first, then back through the first sector
        net[k][j] = first[k][4 - j];
        net[k][j][2] += Rational(j == 2 ? -1 : 1, 4);
      }
    const IntersectResult result = intersect(RationalPatch(first), RationalPatch(net));
    CHECK((result.status == Status::incomplete || result.graph.arcs.size() > 1));
  }
}

}  // namespace exsect::poles_in_doubles_test
