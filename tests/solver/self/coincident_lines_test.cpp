// Parameter lines that are one curve: of swept loops, and none of other patches.
#include "self/coincident_lines.h"

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::coincident_lines_test {
namespace {

/// A cubic p(t) with p(t1) = p(t2) for t1 + t2 = sum, t1 t2 = product, in both coordinates, moved along a
/// curve.
RationalPatch swept(random_nets::Generator& generator, const Rational& sum, const Rational& product) {
  const Rational e = sum * sum - product;
  std::array<std::array<Rational, 4>, 2> power;
  do {
    for (auto& a : power) {
      for (std::size_t i : {0U, 2U, 3U}) a[i] = Rational(random_pairs::integer(generator, -9, 9), 4);
      a[1] = -a[2] * sum - a[3] * e;
    }
  } while (power[0][2] * power[1][3] == power[0][3] * power[1][2]);
  std::vector<std::vector<Point>> net(4, std::vector<Point>(3));
  for (int j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 4; ++i) {
      Point& p = net[i][static_cast<std::size_t>(j)];
      p[2] = 3 * j;
      const Rational k(static_cast<long>(i));
      for (std::size_t c = 0; c < 2; ++c)
        p[c] = power[c][0] + k * power[c][1] / 3 + k * (k - 1) * power[c][2] / 6 +
               k * (k - 1) * (k - 2) * power[c][3] / 6 + Rational(j * j, 3 + static_cast<long>(c));
    }
  return RationalPatch(net);
}

}  // namespace

TEST_CASE("coincident lines: of random swept loops") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    random_nets::Generator generator(seed);
    const Rational sum(random_pairs::integer(generator, 3, 9), 7), product = sum * sum / 4 - Rational(1, 9);
    const RationalPatch x = swept(generator, sum, product);
    const auto lines = coincident_lines(x, 0);
    REQUIRE(lines);
    CHECK(lines->sum == sum);
    CHECK(lines->product == product);
    const Rational t1 = sum / 2 - Rational(1, 3), t2 = sum / 2 + Rational(1, 3);
    CHECK(x(t1, Rational(2, 5)) == x(t2, Rational(2, 5)));
    CHECK_FALSE(coincident_lines(x, 1));
    const auto exchanged = coincident_lines(x.transposed(), 1);
    REQUIRE(exchanged);
    CHECK(exchanged->product == product);
    const Rational middle = sum / 2, room(1, 100);
    const auto cell = [&](const Rational& t, const Rational& from, const Rational& to) {
      return ParameterRectangle{{t - room, t + room}, {from, to}};
    };
    CHECK(lines->pass(cell(t1, 0, Rational(1, 2)), cell(t2, Rational(1, 3), 1)));
    CHECK_FALSE(lines->pass(cell(t1, 0, Rational(1, 2)), cell(t2, Rational(1, 2), 1)));
    CHECK_FALSE(lines->pass(cell(t1, 0, 1), cell(middle, 0, 1)));
    CHECK_FALSE(lines->pass(cell(t1, 0, 1), cell(t1, 0, 1)));
  }
}

TEST_CASE("coincident lines: of projective images and in other parameters, with weights") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    random_nets::Generator generator(seed);
    const Rational sum(random_pairs::integer(generator, 3, 9), 7), product = sum * sum / 4 - Rational(1, 9);
    const RationalPatch x =
        random_nets::image(swept(generator, sum, product), random_nets::projective_map(generator));
    REQUIRE_FALSE(x.is_polynomial());
    const auto lines = coincident_lines(x, 0);
    REQUIRE(lines);
    CHECK(lines->sum == sum);
    CHECK(lines->product == product);
    // u = t / (t + 3 (1 - t)), so that t = 3 u / (1 + 2 u).
    const auto others = coincident_lines(random_nets::reparametrised(x, 3), 0);
    REQUIRE(others);
    const auto t = [](const Rational& u) { return Rational(3 * u / (1 + 2 * u)); };
    const Rational t1 = t(sum / 2 - Rational(1, 3)), t2 = t(sum / 2 + Rational(1, 3));
    CHECK(others->sum == t1 + t2);
    CHECK(others->product == t1 * t2);
  }
}

TEST_CASE("coincident lines: none of scattered patches, nor of those with weights") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    random_nets::Generator generator(seed);
    const random_nets::Nets nets = random_nets::scattered(generator, {3, 3, 2, 3});
    for (const std::size_t fixed : {0U, 1U}) {
      CHECK_FALSE(coincident_lines(nets.first(), fixed));
      CHECK_FALSE(coincident_lines(random_nets::weighted(generator, nets.y), fixed));
    }
  }
}

}  // namespace exsect::coincident_lines_test
