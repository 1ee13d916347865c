// Equations of curves out of a common pole: a cone over a wave that touches and crosses a plane.
#include "special/ray_equations.h"

#include <exsect/algebra/nearest_double.h>

#include <cmath>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::ray_equations_test {
namespace {

using random_pairs::Generator;

const Point kOrigin = {0, 0, 0};

/// a (1 - t, t, z(t)) with z of degree 3.
RationalPatch wave(const Polynomial& z, const Rational& speed = 1) {
  std::vector<std::vector<HomogeneousPoint>> net(2, std::vector<HomogeneousPoint>(4, {0, 0, 0, 1}));
  const Rational c0 = z.coefficient(0), c1 = z.coefficient(1) / 3, c2 = z.coefficient(2) / 3;
  const std::array<Rational, 4> heights = {c0, c0 + c1, c0 + 2 * c1 + c2, z(1)};
  for (std::size_t j = 0; j < 4; ++j) {
    const Rational t(static_cast<long>(j), 3);
    net[1][j] = {speed * (1 - t), speed * t, speed * heights[j], 1};
  }
  return RationalPatch::from_homogeneous(net);
}

RationalPatch plane() { return RationalPatch({{kOrigin, kOrigin}, {{1, 0, 0}, {0, 1, 0}}}); }

struct Equations {
  Equations(const RationalPatch& x, const RationalPatch& y) : first(x, kOrigin), second(y, kOrigin) {
    first.reach = Rational(1, 64);
    second.reach = Rational(1, 8);
  }
  Blowup first, second;
  RayEquations all{first, second};
};

Rectangle around(const Rational& t, const Rational& room) {
  return {{t - room, t + room}, {t - room, t + room}};
}

/// With weights and a pole in the origin; a flat one has all its directions in the plane z = 0.
RationalPatch random_sheaf(Generator& generator, bool is_flat) {
  const auto number = [&] { return Rational(random_pairs::integer(generator, 1, 9), 3); };
  std::vector<std::vector<HomogeneousPoint>> net(4, std::vector<HomogeneousPoint>(3, {0, 0, 0, 1}));
  for (std::size_t i = 1; i < 4; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net[i][j] = {number(), number(), is_flat && i == 1 ? Rational(0) : number(), number()};
  return RationalPatch::from_homogeneous(net);
}

/// (14.111) as it is written.
Rational row_value(const Equations& e, std::size_t i, const Rational& a, const std::array<Rational, 3>& at) {
  const auto& [t, s, c] = at;
  const Rational b = a * c, w = e.first.weight(a, t), omega = e.second.weight(b, s);
  if (!e.first.height.is_zero()) {
    const Rational unit = e.first.direction[2](a, t) / a / e.first.height(a, t);  // of the normal
    return (omega * e.first.direction[2](a, t) / a - c * c * w * e.second.direction[2](b, s) / b) / unit;
  }
  return omega * e.first.direction[i](a, t) - c * w * e.second.direction[i](b, s);
}

}  // namespace

TEST_CASE("ray_equations: contact is isolated where nothing else is in the box") {
  const Polynomial t = Polynomial::variable();
  const Polynomial touch = (t - Polynomial(Rational(1, 3))) * (t - Polynomial(Rational(1, 3)));
  for (const Rational& speed : {Rational(1), Rational(1, 2), Rational(3)}) {
    Equations e(wave(touch * (t - Polynomial(Rational(4, 5))), speed), plane());
    const auto isolates = [&](const Rectangle& box) {
      const auto ratio = e.all.ratio_on(box);
      REQUIRE(ratio);
      CHECK(ratio->lower < speed);
      CHECK(speed < ratio->upper);
      return e.all.isolates_contact(box, *ratio, e.all.columns_on(box, *ratio));
    };
    CHECK(isolates(around(Rational(1, 3), Rational(1, 100))));
    CHECK(isolates(around(Rational(1, 3), Rational(1, 20))));
    CHECK(!isolates({{Rational(3, 10), Rational(17, 20)}, {Rational(3, 10), Rational(17, 20)}}));
  }
  // A zero of order three is never isolated by second derivatives, one of order two is: in directions
  // (1 - s, 3 s) with weights, and the wave over another plane, so that all rows and derivatives count.
  const RationalPatch bent = RationalPatch::from_homogeneous(
      {{{0, 0, 0, 1}, {0, 0, 0, 5}}, {{1, 0, Rational(1, 2), 1}, {0, 3, 6, 2}}});
  const auto over = [](const RationalPatch& x) {
    std::vector<std::vector<HomogeneousPoint>> net(2, std::vector<HomogeneousPoint>(4));
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        net[i][j] = x.homogeneous(static_cast<int>(i), static_cast<int>(j));
        net[i][j][2] += net[i][j][0] / 2 + 2 * net[i][j][1];
        net[i][j][3] += net[i][j][0] + 3 * net[i][j][1];
      }
    return RationalPatch::from_homogeneous(net);
  };
  for (const bool is_double : {true, false}) {
    const Polynomial third = is_double ? Polynomial(2) : t - Polynomial(Rational(1, 3));
    Equations e(over(wave(touch * third)), bent);
    e.first.reach = power_of_two(-20);
    const Rational room = power_of_two(-14);
    const Rectangle box = {{Rational(1, 3) - room, Rational(1, 3) + room},
                           {Rational(1, 7) - room, Rational(1, 7) + room}};
    const auto ratio = e.all.ratio_on(box);
    REQUIRE(ratio);
    CHECK(e.all.isolates_contact(box, *ratio, e.all.columns_on(box, *ratio)) == is_double);
  }
}

TEST_CASE("ray_equations: a simple zero is found in its box alone, and begins where it is") {
  const Polynomial t = Polynomial::variable();
  Equations e(wave(t * (t - Polynomial(Rational(4, 5))) * (t + Polynomial(1))), plane());
  const auto solved = [&](const Rectangle& box) {
    const auto ratio = e.all.ratio_on(box);
    REQUIRE(ratio);
    return e.all.has_solution(box, *ratio, e.all.columns_on(box, *ratio));
  };
  CHECK(solved(around(Rational(4, 5), Rational(1, 100))));
  CHECK(solved(around(0, Rational(1, 100))));
  CHECK(!solved(around(Rational(1, 2), Rational(1, 100))));
  CHECK(!solved(around(Rational(81, 100), Rational(1, 200))));
  const Rectangle at_end = around(0, Rational(1, 100)), beside = {{0, 1}, {Rational(1, 100), 1}};
  CHECK(e.all.begins_at(Rational(0), {}, at_end));
  CHECK(e.all.begins_at({}, Rational(0), at_end));
  CHECK(e.all.begins_at(Rational(0), Rational(0), at_end));
  CHECK(!e.all.begins_at(Rational(0), {}, beside));
  CHECK(!e.all.begins_at(Rational(1), {}, around(1, Rational(1, 100))));
  CHECK(!e.all.begins_at(Rational(0), Rational(1), at_end));
}

TEST_CASE("ray_equations: first and second derivatives hold those of differences") {
  // Rows are coordinates, or, for cups over one plane, height and plane.
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const bool is_flat = seed % 2 == 0;
    const RationalPatch x = random_sheaf(generator, is_flat), y = random_sheaf(generator, is_flat);
    Equations e(x, y);
    e.first.reach = e.second.reach = Rational(1, 4);
    const Rational room = power_of_two(-40), step = power_of_two(-24);
    const auto near = [&](const Rational& p) { return RationalInterval{p - room, p + room}; };
    const std::array<Rational, 3> middle = {Rational(2, 5), Rational(3, 7), Rational(5, 8)};
    const Rectangle box = {near(middle[0]), near(middle[1])};
    const RayColumns columns = e.all.columns_on(box, near(middle[2]));
    for (const Rational& a : {Rational(1, 100), Rational(1, 8), Rational(1, 4)}) {
      const auto f = [&](std::size_t i, const std::array<Rational, 3>& at) { return row_value(e, i, a, at); };
      const auto moved = [&](std::size_t j, int to_j, std::size_t k, int to_k) {
        std::array<Rational, 3> at = middle;
        at[j] += to_j * step;
        at[k] += to_k * step;
        return at;
      };
      const auto holds = [](const DoubleBall& ball, const Rational& value) {
        return std::abs(ball.approximation() - to_double(value)) <= ball.radius() + 1e-5;
      };
      for (std::size_t i = 0; i < (is_flat ? 1 : 3); ++i) {
        const std::array<const EnclosedVector*, 3> first = {&columns.t, &columns.s, &columns.c};
        const auto second = e.all.bend_on(i, box, near(middle[2]));
        std::size_t which = 0;
        for (std::size_t j = 0; j < 3; ++j) {
          CHECK(holds((*first[j])[i], (f(i, moved(j, 1, j, 0)) - f(i, moved(j, -1, j, 0))) / (2 * step)));
          for (std::size_t k = j; k < 3; ++k, ++which)
            CHECK(holds(second[which], (f(i, moved(j, 1, k, 1)) - f(i, moved(j, 1, k, -1)) -
                                        f(i, moved(j, -1, k, 1)) + f(i, moved(j, -1, k, -1))) /
                                           (4 * step * step)));
        }
      }
    }
  }
}

}  // namespace exsect::ray_equations_test
