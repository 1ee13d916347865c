// How far points are from a surface given by its equation, against distances in closed form.
#include "verify/compared_side.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "support/catch.h"

namespace exsect::compared_side_test {
namespace {

const double infinity = std::numeric_limits<double>::infinity();

ComparedSide side(const ImplicitSurface& surface) { return ComparedSide(surface, Rational(1, 64)); }

}  // namespace

TEST_CASE("compared side: an equation has no patch, and a patch is one") {
  CHECK(side(ImplicitSurface::sphere({0, 0, 0}, 1)).patch() == nullptr);
  const RationalPatch patch({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}});
  const ComparedSide square(patch, Rational(1, 64));
  REQUIRE(square.patch() != nullptr);
  CHECK(square.certainly_farther({0.5, 0.5, 1}, 0.9));
  CHECK_FALSE(square.certainly_farther({0.5, 0.5, 1}, 1));
}

TEST_CASE("compared side: nothing is farther than what is on the surface, not a number, or infinite") {
  const ComparedSide ball = side(ImplicitSurface::sphere({0, 0, 0}, 5));
  CHECK_FALSE(ball.certainly_farther({3, 4, 0}, 0));
  CHECK(ball.certainly_farther({3, 4, 0x1p-50}, 0));
  CHECK_FALSE(ball.certainly_farther({3, 4, 0x1p-50}, 0x1p-50));
  CHECK(ball.certainly_farther({0, 0, 0}, 2.8));
  CHECK_FALSE(ball.certainly_farther({0, 0, 0}, 5));
  for (const double bad : {std::nan(""), infinity, -1.0}) CHECK_FALSE(ball.certainly_farther({9, 9, 9}, bad));
  for (const double bad : {std::nan(""), infinity}) CHECK_FALSE(ball.certainly_farther({bad, 9, 9}, 1));
}

TEST_CASE("compared side: of planes and spheres at every size, never farther than they are") {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-2, 2);
  int proved = 0;
  for (int k = 0; k < 400; ++k) {
    const double size = std::ldexp(1, std::array{0, 27, -300, 300}[static_cast<std::size_t>(k % 4)]);
    const auto any = [&] { return std::array{number(generator), number(generator), number(generator)}; };
    const auto exact = [](const std::array<double, 3>& p) {
      return Point{from_double(p[0]), from_double(p[1]), from_double(p[2])};
    };
    const std::array<double, 3> c = any(), p = any(), n = any();
    const std::array<double, 3> d = {p[0] - c[0], p[1] - c[1], p[2] - c[2]};
    const double from_centre = std::hypot(d[0], d[1], d[2]);
    const double from_plane =
        std::fabs(d[0] * n[0] + d[1] * n[1] + d[2] * n[2]) / std::hypot(n[0], n[1], n[2]);
    const Rational scale = from_double(size);
    const auto check = [&](const ImplicitSurface& surface, double distance) {
      const ComparedSide one = side(surface);
      for (const double part : {0.2, 0.5, 0.9, 1.0 + 1e-9, 3.0}) {
        const bool farther =
            one.certainly_farther({p[0] * size, p[1] * size, p[2] * size}, part * distance * size);
        INFO(k << " of seed 7, " << part << " of the distance " << distance);
        CHECK_FALSE((farther && part > 1));
        proved += farther ? 1 : 0;
      }
    };
    check(ImplicitSurface::sphere(scale * exact(c), Length(scale)), std::fabs(from_centre - 1));
    check(ImplicitSurface::plane(scale * exact(c), exact(n)), from_plane);
  }
  CHECK(proved > 1000);
}

}  // namespace exsect::compared_side_test
