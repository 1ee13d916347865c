// Tubes around circles, whose places are known, and around random curves, whose zeros Sturm's sequences
// count.
#include "filter/section_tube.h"

#include <exsect/algebra/sturm.h>
#include <exsect/geometry/surface_pull_back.h>

#include <cmath>

#include "square_section.h"
#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::section_tube_test {
namespace {

using S = ImplicitSurface;
using square_section::circle, square_section::square;

}  // namespace

TEST_CASE("section tube: holds the circle over its length, and its neighbours not") {
  const SquareForm f = circle(0, 0, Rational(1, 2));
  const auto on_circle = [](double p) { return std::array{p, std::sqrt(0.25 - p * p)}; };
  for (const double p : {-0.3, -0.1, 0.0, 0.2}) {
    const auto tube = section_tube(f, on_circle(p), 0, 0.04);
    REQUIRE(tube);
    CHECK(tube->sign == 1);
    CHECK(tube->least <= std::fabs(tube->gradient));
    for (const double s : {-0.0399, -0.02, 0.0, 0.01, 0.0399}) {
      const SectionBox there{on_circle(p + s), {1e-12, 1e-12}};
      CHECK(contains(*tube, there));
      CHECK_FALSE(excludes(*tube, there));
      const PlaceNearCurve near = place_near_curve(f, *tube, s, tube->slope * s, 1e-11);
      CHECK(near.error <= 1e-11);
      CHECK(std::fabs(near.place[1] - there.centre[1]) <= near.error + 1e-15);
      const double bend = 0.25 / std::pow(there.centre[1], 3), steep = -(p + s) / there.centre[1];
      CHECK((tube->bends - DoubleBall(-bend)).certain_sign() == 0);
      CHECK((tube->slopes - DoubleBall(steep)).certain_sign() == 0);
    }
    CHECK(excludes(*tube, {on_circle(p + 0.05), {1e-12, 1e-12}}));
    CHECK(excludes(*tube, {{p, tube->centre[1] + 1.5 * tube->width}, {1e-12, 1e-12}}));
    CHECK(std::isinf(place_near_curve(f, *tube, 0.05, 0, 1e-11).error));
    CHECK_FALSE(contains(*tube, {tube->centre, {0.1, 0}}));
    CHECK_FALSE(excludes(*tube, {tube->centre, {0.1, 0}}));
  }
}

TEST_CASE("section tube: none along the wrong axis, off the curve, or beyond the forms") {
  const SquareForm f = circle(0, 0, Rational(1, 2));
  CHECK(section_tube(f, {0.5, 0}, 1, 0.1));
  CHECK_FALSE(section_tube(f, {0.5, 0}, 0, 0.1));
  CHECK_FALSE(section_tube(f, {0.3, 0.3}, 0, 0.01));
  CHECK_FALSE(section_tube(f, {0.5, 0}, 1, 0.6));
  CHECK_FALSE(section_tube(f, {0.5, 0}, 1, std::nan("")));
  const SquareForm large = circle(0, 0, Rational(9, 8));
  CHECK(section_tube(large, {0, 1.124}, 0, 0.02) == std::nullopt);
  CHECK_FALSE(section_tube(large, {0, 1.2}, 0, 0.02));
}

TEST_CASE("section tube: one zero over each place, by Sturm's count") {
  constexpr std::uint64_t seed = 2206;
  INFO("seed " << seed);
  random_nets::Generator generator(seed);
  int tubes = 0;
  for (int round = 0; round < 24; ++round) {
    const RationalPatch patch(random_nets::doubles(generator, 3, 2));
    const S surface = S::cylinder(patch(Rational(1, 3), Rational(1, 2)), {1, 2, 3}, Rational(1, 4));
    const BivariatePolynomial exact = pull_back(surface.equation(), patch);
    const SectionForms forms = section_forms(surface.equation(), patch).value();
    const auto count = [&](const Rational& p, const Rational& low, const Rational& high) {
      const Polynomial over = exact.at_r((1 + p) / 2);
      return SturmSequence(over).count_closed((1 + low) / 2, (1 + high) / 2);
    };
    for (double p = -0.9; p < 1; p += 0.2)
      for (double q = -0.95; q < 1; q += 0.05)
        for (const double reach : {0.02, 0.1}) {
          const auto tube = section_tube(forms.section, {p, q}, 0, reach);
          if (!tube) continue;
          ++tubes;
          for (const double part : {-1.0, -0.4, 0.3, 1.0}) {
            const Rational s = from_double(part) * from_double(reach);
            const Rational line = from_double(q) + from_double(tube->slope) * s,
                           width = from_double(tube->width);
            CHECK(count(from_double(p) + s, line - width, line + width) == 1);
          }
        }
  }
  CHECK(tubes > 50);
}

TEST_CASE("section tube: speeds bound the differences of positions, with weights and without") {
  constexpr std::uint64_t seed = 2207;
  INFO("seed " << seed);
  random_nets::Generator generator(seed);
  for (int round = 0; round < 12; ++round) {
    const random_nets::Net net = random_nets::doubles(generator, 2, 3);
    const RationalPatch patch = round % 2 == 0 ? RationalPatch(net) : random_nets::weighted(generator, net);
    const S surface = S::plane(patch(Rational(1, 2), Rational(1, 2)), {1, 2, 3});
    const SectionForms forms = section_forms(surface.equation(), patch).value();
    const std::size_t axis = std::fabs(forms.section.about(0, 0).derivative(0, 1).approximation()) >
                                     std::fabs(forms.section.about(0, 0).derivative(1, 0).approximation())
                                 ? 0
                                 : 1;
    const auto tube = section_tube(forms.section, {0, 0}, axis, 0.02);
    if (!tube) continue;
    const SectionSpeeds speeds = section_speeds(forms.patch, *tube);
    const auto at = [&](double s) {
      const PlaceNearCurve near = place_near_curve(forms.section, *tube, s, tube->slope * s, 0);
      CHECK(near.error < 1e-9);
      const Point exact = patch((1 + from_double(near.place[0])) / 2, (1 + from_double(near.place[1])) / 2);
      const std::array<double, 3> point = section_point(forms, near.place);
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(abs(exact[k] - from_double(point[k])) <= from_double(speeds.rounding));
      return point;
    };
    const double h = 0.009;
    const auto a = at(-h), b = at(0), c = at(h);
    double second = 0, first = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      second += std::pow((a[k] - 2 * b[k] + c[k]) / (h * h), 2);
      first += std::pow((c[k] - a[k]) / (2 * h), 2);
    }
    CHECK(std::sqrt(second) <= speeds.acceleration + 1e-6);
    CHECK(std::sqrt(first) <= speeds.rate + 1e-9);
    CHECK(std::sqrt(first) >= speeds.least_speed * (1 - 1e-9));
    const std::array<double, 3> d1 = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const std::array<double, 3> d2 = {a[0] - 2 * b[0] + c[0], a[1] - 2 * b[1] + c[1], a[2] - 2 * b[2] + c[2]};
    const double across = std::hypot(d1[1] * d2[2] - d1[2] * d2[1], d1[2] * d2[0] - d1[0] * d2[2],
                                     d1[0] * d2[1] - d1[1] * d2[0]) /
                          std::hypot(d1[0], d1[1], d1[2]) / (h * h);
    CHECK(across <= speeds.normal + 1e-4);
    CHECK(speeds.acceleration < 30 * (std::sqrt(second) + 1));  // not a bound of anything
  }
}

}  // namespace exsect::section_tube_test
