#include "shape/shifted_copy.h"

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::shifted_copy_test {

namespace {

Rational q(long n, long d) { return Rational(n, d); }

/// The maps are those of a restriction to [u0,u1] x [v0,v1].
void check_found(const RationalPatch& x, const RationalPatch& y, const std::array<Rational, 4>& ends) {
  const auto copy = shifted_copy(x, y);
  REQUIRE(copy);
  CHECK(copy->maps[0](0) == ends[0]);
  CHECK(copy->maps[0](1) == ends[1]);
  CHECK(copy->maps[1](0) == ends[2]);
  CHECK(copy->maps[1](1) == ends[3]);
}

void check_pieces(const RationalPatch& x) {
  for (const std::array<Rational, 4>& ends :
       {std::array{q(0, 1), q(1, 1), q(0, 1), q(1, 1)}, std::array{q(1, 1), q(0, 1), q(0, 1), q(1, 1)},
        std::array{q(1, 3), q(1, 1), q(3, 4), q(1, 7)}, std::array{q(1, 2), q(5, 9), q(0, 1), q(1, 1000)}}) {
    const RationalPatch y = x.restricted_to(ends[0], ends[1], ends[2], ends[3]);
    check_found(x, y, ends);
    check_found(x, y.elevated(3, 3), ends);
    // From the piece to the whole patch the maps are the inverse ones.
    const auto back = shifted_copy(y, x);
    REQUIRE(back);
    CHECK(back->maps[0](ends[0]) == 0);
    CHECK(back->maps[1](ends[3]) == 1);
  }
}

}  // namespace

TEST_CASE("shifted copy: pieces of patches of every kind, elevated or not") {
  random_nets::Generator generator(31);
  for (const std::array<int, 2> degree : {std::array{1, 1}, std::array{2, 1}, std::array{1, 3},
                                          std::array{2, 2}, std::array{3, 2}, std::array{3, 3}}) {
    for (const bool doubles : {false, true}) {
      INFO("seed 31, bidegree " << degree[0] << " " << degree[1] << ", doubles " << doubles);
      const auto net = random_nets::crossing(generator, {degree[0], degree[1], 1, 1}, doubles).x;
      check_pieces(RationalPatch(net));
      check_pieces(random_nets::weighted(generator, net));
    }
  }
}

TEST_CASE("shifted copy: height fields, cylinders, patches that are even in a parameter") {
  const auto height = [](int i, int j) { return Rational((3 * i * i + 5 * i * j + 2 * j * j * j) % 7, 4); };
  random_nets::Net field, cylinder;
  for (int i = 0; i < 4; ++i) {
    field.emplace_back();
    cylinder.emplace_back();
    for (int j = 0; j < 4; ++j) field.back().push_back({q(i, 3), q(j, 3), height(i, j)});
    for (int j = 0; j < 2; ++j) cylinder.back().push_back({q(i * i, 3), height(i, 1), q(j, 1)});
  }
  check_pieces(RationalPatch(field));
  check_pieces(RationalPatch(cylinder));
  // (u², v, u² v + v²), in Bernstein form: u² has the coefficients 0, 0, 1.
  random_nets::Net even(3);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      even[i].push_back({i == 2 ? 1 : 0, q(j, 2), (i == 2 ? q(j, 2) : q(0, 1)) + (j == 2 ? 1 : 0)});
  }
  check_pieces(RationalPatch(even));
}

TEST_CASE("shifted copy: a quarter of a circle, turned about an axis, with its weights") {
  const std::array<int, 3> w = {1, 1, 2};
  const std::array<std::array<int, 2>, 3> arc = {{{1, 0}, {1, 1}, {0, 1}}};
  random_nets::Net net(3);
  random_nets::Weights weights(3);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      net[i].push_back({arc[i][0] * (2 + arc[j][0]), arc[i][1] * (2 + arc[j][0]), arc[j][1]});
      weights[i].push_back(w[i] * w[j]);
    }
  }
  check_pieces(RationalPatch(net, weights));
}

TEST_CASE("shifted copy: what is nearly a piece is none, nor is another patch") {
  random_nets::Generator generator(32);
  for (int i = 0; i < 10; ++i) {
    INFO("seed 32, pair " << i);
    const auto nets = random_nets::crossing(generator, {3, 3, 3, 3}, true);
    CHECK_FALSE(shifted_copy(nets.first(), nets.second()));
    auto moved = nets.x;
    moved[static_cast<std::size_t>(i % 4)][1][2] += power_of_two(-100);
    CHECK_FALSE(shifted_copy(nets.first(), RationalPatch(moved)));
    CHECK_FALSE(shifted_copy(nets.first(), nets.first().transposed()));
    random_nets::Weights weights(4, std::vector<Rational>(4, 1));
    weights[2][2] += power_of_two(-60);
    CHECK_FALSE(shifted_copy(nets.first(), RationalPatch(nets.x, weights)));
    for (auto& row : weights) std::ranges::fill(row, Rational(7, 3));
    CHECK(shifted_copy(nets.first(), RationalPatch(nets.x, weights)));
  }
}

}  // namespace exsect::shifted_copy_test
