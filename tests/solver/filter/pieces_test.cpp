#include "filter/pieces.h"

#include <cmath>

#include "filter/boundary.h"
#include "filter/direction_nets.h"
#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::pieces_test {
namespace {

using filter::Vec3;
using random_pairs::Generator;

Rational exact(double t) { return from_double(t) + Rational(1, 2); }

/// The sub-patch exactly, in the coordinates of filter::Pair.
ControlNet exact_net(const BezierPatch& patch, const ModelFrame& frame, const filter::SubPatch& piece) {
  const BezierPatch part = patch.restricted_to(exact(piece.first), exact(piece.first + piece.width),
                                               exact(piece.second), exact(piece.second + piece.width));
  ControlNet net = part.net();
  for (auto& row : net) {
    for (Point& p : row) {
      for (std::size_t c = 0; c < 3; ++c)
        p[c] = (p[c] - from_double(frame.origin[c])) * power_of_two(-frame.exponent);
    }
  }
  return net;
}

/// A random path down the tree.
std::size_t descend(filter::PatchTree& tree, Generator& generator, int levels) {
  std::size_t node = 0;
  for (int i = 0; i < levels; ++i) node = tree.split(node) + generator() % 4;
  return node;
}

Vec3 rounded(const Point& p) { return {to_double(p[0]), to_double(p[1]), to_double(p[2])}; }

}  // namespace

TEST_CASE("filter pieces: subdivided nets are within the stated error") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const auto pair = random_pairs::doubles(generator);
    const auto scaled = filter::make_pair(pair.x, pair.y).value();
    filter::PatchTree tree(scaled.x);
    const filter::SubPatch piece = tree[descend(tree, generator, static_cast<int>(seed % 12) + 3)];
    const ControlNet net = exact_net(pair.x, scaled.frame, piece);
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(std::fabs(to_double(net[i / 3][i % 3][c] - from_double(piece.net[i][c]))) <= scaled.net_error);
      }
    }
  }
}

TEST_CASE("filter pieces: what has a point in common is not separated") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const auto pair = random_pairs::scattered(generator);
    // y is moved so that x(a) = y(b) exactly for the lower corners a, b of two pieces.
    const auto first = filter::make_pair(pair.x, pair.y).value();
    filter::PatchTree tree(first.x);
    const int levels = static_cast<int>(seed % 8) + 1;
    const filter::SubPatch a = tree[descend(tree, generator, levels)];
    const filter::SubPatch b = tree[descend(tree, generator, levels)];
    const Point shift = pair.x(exact(a.first), exact(a.second)) - pair.y(exact(b.first), exact(b.second));
    ControlNet net = pair.y.net();
    for (auto& row : net) {
      for (Point& p : row) p = p + shift;
    }
    const auto moved = filter::make_pair(pair.x, BezierPatch(net)).value();
    filter::PatchTree x(moved.x);
    filter::PatchTree y(moved.y);
    const auto find = [](filter::PatchTree& in, const filter::SubPatch& piece) {
      std::size_t node = 0;
      while (in[node].level < piece.level) {
        const std::size_t child = in.split(node);
        for (std::size_t k = 0; k < 4; ++k) {
          const filter::SubPatch& c = in[child + k];
          if (c.first <= piece.first && piece.first < c.first + c.width && c.second <= piece.second &&
              piece.second < c.second + c.width) {
            node = child + k;
            break;
          }
        }
      }
      return node;
    };
    CHECK_FALSE(filter::separated(x[find(x, a)], y[find(y, b)], moved.net_error));
  }
}

TEST_CASE("filter pieces: directions proved never orthogonal are not") {
  int proved = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const auto pair = random_pairs::doubles(generator);
    const auto scaled = filter::make_pair(pair.x, pair.y).value();
    filter::PatchTree x(scaled.x);
    filter::PatchTree y(scaled.y);
    const int levels = static_cast<int>(seed % 5);
    const filter::SubPatch a = x[descend(x, generator, levels)];
    const filter::SubPatch b = y[descend(y, generator, levels)];
    const std::array<double, 2> c = {0.6, seed % 2 == 0 ? 0.8 : -0.8};
    if (!filter::never_orthogonal<filter::Biquadratic>(filter::direction_net(a, c, scaled.net_error),
                                                       filter::normal_net(b, scaled.net_error))) {
      continue;
    }
    ++proved;
    int sign = 0;
    for (int i = 0; i < 40; ++i) {
      const auto place = [&](double from, double width) {
        return exact(from + width * static_cast<double>(generator() % 5) / 4);
      };
      const Rational u = place(a.first, a.width);
      const Rational v = place(a.second, a.width);
      const Rational r = place(b.first, b.width);
      const Rational s = place(b.second, b.width);
      const Point d = from_double(c[0]) * pair.x.derivative_second(u, v) -
                      from_double(c[1]) * pair.x.derivative_first(u, v);
      const Point n = cross(pair.y.derivative_first(r, s), pair.y.derivative_second(r, s));
      const int here = exsect::sign(dot(d, n));
      CHECK(here != 0);
      CHECK(sign * here >= 0);
      sign = here;
    }
  }
  CHECK(proved > 10);
}

TEST_CASE("filter pieces: points divided by their weights are within the stated error") {
  using K = filter::WeightedBiquadratic;
  Generator generator(11);
  const double net_error = 0x1p-46;
  for (int round = 0; round < 200; ++round) {
    std::array<filter::Row<K>, 3> net;
    for (filter::Row<K>& p : net) {
      for (double& c : p)
        c = std::ldexp(static_cast<double>(generator() >> 11), -53) * (generator() % 2 == 0 ? 1 : -1);
      p[3] = std::ldexp(0.5 + 0.5 * std::fabs(p[3]), -static_cast<int>(generator() % 11));
    }
    if (round == 0) net[0] = {1, -1, 0, 1.0 / 3};
    const auto curve = filter::make_curve<K>(net, 0, 1, 0, net_error);
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational w = from_double(net[i][3]);
      for (std::size_t c = 0; c < 3; ++c) {
        // Any numbers within the error of the net, over any such weight.
        for (const int sign : {-1, 1}) {
          for (const int of_weight : {-1, 0, 1}) {
            const Rational e = from_double(net_error);
            const Rational x = (from_double(net[i][c]) + sign * e) / (w + of_weight * e);
            CHECK(abs(x - from_double(curve.affine[i][c])) <= from_double(curve.affine_error));
          }
        }
        const Rational x = from_double(net[i][c]) / w;
        CHECK(abs(x - from_double(curve.affine[i][c])) <= abs(x) * 3 * power_of_two(-53));
      }
    }
  }
}

TEST_CASE("filter pieces: control vectors of the normal are within the stated error") {
  Generator generator(5);
  const auto pair = random_pairs::doubles(generator);
  const auto scaled = filter::make_pair(pair.x, pair.y).value();
  filter::PatchTree tree(scaled.y);
  const filter::SubPatch piece = tree[descend(tree, generator, 4)];
  const filter::NormalNet n = filter::normal_net(piece, scaled.net_error);
  const ControlNet net = exact_net(pair.y, scaled.frame, piece);
  const BezierPatch part(net);
  // At the corners the control vectors are values: y_r x y_s, each derivative divided by 2.
  for (const std::size_t i : {0, 1}) {
    for (const std::size_t j : {0, 1}) {
      const Rational r(static_cast<long>(i));
      const Rational s(static_cast<long>(j));
      const Point expected =
          Rational(1, 4) * cross(part.derivative_first(r, s), part.derivative_second(r, s));
      const Vec3 e = rounded(expected);
      const Vec3 computed = n.vector(12 * i + 3 * j);
      for (std::size_t c = 0; c < 3; ++c) CHECK(std::fabs(computed[c] - e[c]) <= n.error);
    }
  }
}

}  // namespace exsect::pieces_test
