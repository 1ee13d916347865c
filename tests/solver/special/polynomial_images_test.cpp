// Weighted pairs that are images of polynomial ones: which they are, and what is put back.
#include "special/polynomial_images.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "support/catch.h"
#include "support/random_nets.h"
#include "support/random_pairs.h"

namespace exsect::polynomial_images_test {
namespace {

using random_nets::Generator;
using random_nets::image;
using random_nets::reparametrised;

struct Pair {
  RationalPatch x;
  RationalPatch y;
};

/// A random polynomial pair after a projective map, with other parameters u and s.
Pair image_pair(Generator& generator, const std::array<int, 4>& degrees, bool doubles) {
  const random_nets::Nets nets = random_nets::crossing(generator, degrees, doubles);
  const auto map = random_nets::projective_map(generator);
  return {reparametrised(image(nets.first(), map), Rational(5, 7)),
          reparametrised(image(nets.second(), map).transposed(), Rational(3, 2)).transposed()};
}

Rational of_image(const Rational& t, const Rational& k) { return t / (k * (1 - t) + t); }

/// The point of the patch is that of its image.
void check_point(const RationalPatch& patch, const BezierPatch& seen, const PolynomialImages& images,
                 std::size_t first) {
  const Rational u(2, 7), v(3, 5);
  const Point q = seen(u, v);
  const Rational divisor = 1 - dot(images.slope, q);
  CHECK(divisor > 0);
  CHECK(images.centre + Rational(1 / divisor) * q ==
        patch(of_image(u, images.ratios[first]), of_image(v, images.ratios[first + 1])));
}

}  // namespace

TEST_CASE("polynomial images: of polynomial pairs, whatever the map and the parameters") {
  const std::array<std::array<int, 4>, 5> degrees = {
      {{2, 2, 2, 2}, {2, 2, 1, 1}, {1, 2, 2, 1}, {2, 1, 2, 2}, {1, 1, 2, 2}}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair = image_pair(generator, degrees[seed % 5], seed % 2 == 0);
    for (const auto& [x, y] :
         {pair, Pair{pair.y, pair.x.transposed()}, Pair{pair.x.elevated(3, 3), pair.y}}) {
      const auto images = polynomial_images(x, y);
      REQUIRE(images);
      check_point(x, images->x, *images, 0);
      check_point(y, images->y, *images, 2);
    }
  }
}

TEST_CASE("polynomial images: none of patches with other weights, nor on both sides of a plane") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_nets::Nets nets = random_nets::crossing(generator, {2, 2, 2, 2}, seed % 2 == 0);
    const RationalPatch x = random_nets::weighted(generator, nets.x);
    CHECK_FALSE(polynomial_images(x, nets.second()));
    CHECK_FALSE(polynomial_images(nets.first(), x));
    CHECK_FALSE(polynomial_images(x, random_nets::weighted(generator, nets.y)));
  }
  // Both are polynomial seen through 1 - 2z only, which is positive on the one and negative on the other.
  Generator generator(1);
  const random_nets::Nets nets = random_nets::crossing(generator, {2, 2, 2, 2}, false);
  const auto lifted = [](const RationalPatch& patch, const Rational& weight, const Rational& z) {
    return image(patch, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, z}, {0, 0, weight, 1}}});
  };
  const RationalPatch near = lifted(nets.first(), Rational(1, 50), 0);
  REQUIRE(polynomial_images(near, lifted(nets.second(), Rational(1, 50), 0)));
  CHECK_FALSE(polynomial_images(near, lifted(nets.second(), Rational(1, 60), 0)));
}

TEST_CASE("polynomial images: what is put back keeps its bounds") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair = image_pair(generator, {2, 2, 2, 2}, seed % 2 == 0);
    const auto images = polynomial_images(pair.x, pair.y);
    REQUIRE(images);
    // A chord of the image of x, and the curve v = 1/2, which is as far from it as the middle is.
    IntersectResult result;
    Arc arc = {};
    const Rational half(1, 2);
    for (const int end : {0, 1}) {
      PolylineVertex& vertex = arc.polyline.emplace_back();
      vertex.parameters = {static_cast<double>(end), 0.5, 0, 0};
      const Point q = images->x(end, half);
      for (std::size_t c = 0; c < 3; ++c) vertex.point[c] = to_double(q[c]);
    }
    const auto distance = [&](const Point& p) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c)
        sum += std::pow((arc.polyline[0].point[c] + arc.polyline[1].point[c]) / 2 - to_double(p[c]), 2);
      return std::sqrt(sum);
    };
    arc.error_bound = distance(images->x(half, half));
    result.graph.arcs = {arc};
    put_back(*images, result);
    const Arc& back = result.graph.arcs[0];
    // The nearest of many points of the segment to that point of the patch, u' = v' = 1/2.
    const Point p = pair.x(of_image(half, images->ratios[0]), of_image(half, images->ratios[1]));
    double nearest = HUGE_VAL;
    for (int i = 0; i <= 10000; ++i) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c)
        sum += std::pow(back.polyline[0].point[c] * (1 - i * 1e-4) + back.polyline[1].point[c] * i * 1e-4 -
                            to_double(p[c]),
                        2);
      nearest = std::min(nearest, std::sqrt(sum));
    }
    CHECK(back.error_bound >= nearest * (1 - 1e-6));
    CHECK(back.error_bound <= 40 * nearest + 1e-12);
    for (const int end : {0, 1}) {
      const Point at = pair.x(end, of_image(half, images->ratios[1]));
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(std::fabs(back.polyline[static_cast<std::size_t>(end)].point[c] - to_double(at[c])) <
              1e-14 * 8);
      CHECK(std::fabs(back.polyline[static_cast<std::size_t>(end)].parameters[1] -
                      to_double(of_image(half, images->ratios[1]))) < 1e-15);
    }
  }
}

TEST_CASE("polynomial images: a bound where the map is not defined is infinite") {
  const PolynomialImages images = {
      BezierPatch(ControlNet{}), BezierPatch(ControlNet{}), {1, 1, 1, 1}, {0, 0, 0}, {1, 0, 0}};
  IntersectResult result;
  result.graph.arcs.emplace_back();
  result.graph.arcs[0].polyline = {{{}, {0, 0, 0}}, {{}, {0.75, 0, 0}}};
  result.graph.arcs[0].error_bound = 0.125;
  IntersectResult far = result;
  far.graph.arcs[0].error_bound = 0.25;
  put_back(images, result);
  CHECK(result.graph.arcs[0].polyline[1].point[0] == 3);
  CHECK(result.graph.arcs[0].error_bound >= 0.125 * 4 / 0.125);  // to 7/8, at 7
  CHECK(result.graph.arcs[0].error_bound <= 4.01);
  put_back(images, far);
  CHECK(far.graph.arcs[0].error_bound == HUGE_VAL);
}

}  // namespace exsect::polynomial_images_test
