// Charts of the pairs of points of one patch against F and the patch itself, in exact arithmetic.
#include <exsect/checker/pairs_of_points.h>
#include <exsect/geometry/number.h>

#include "certificate/patches.h"
#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::pairs_of_points_test {
namespace {

using namespace checker;
using Generator = random_pairs::Generator;
using Vector = Vector3<Rational>;

Rational some(Generator& generator) { return Rational(random_pairs::integer(generator, -20, 20), 37); }
Vector sum(const Vector& a, const Rational& s, const Vector& b, const Rational& t) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}
bool holds(const Ball<Rational>& ball, const Rational& q) {
  return magnitude(Rational(q - ball.middle)) <= ball.radius;
}

/// F, which changes its sign with both points exchanged, at pairs with this middle and half difference.
Vector at_pair(const Map<Rational>& f, const Vector4<Rational>& pair) {
  const auto& [u, v, a, b] = pair;
  return f.value({u + a, v + b, u - a, v - b});
}

}  // namespace

TEST_CASE("charts of pairs of points of patches of every kind") {
  Generator generator(91);
  INFO("seed 91");
  for (int i = 0; i < 36; ++i) {
    const int m = 1 + i % 3;
    const int n = 1 + i / 3 % 3;
    INFO(i << ": bidegree (" << m << "," << n << ")");
    const auto net = random_nets::scattered(generator, {m, n, 1, 1}).x;
    const RationalPatch x = i % 2 == 0 ? random_nets::weighted(generator, net) : RationalPatch(net);
    const WeightedNet<Rational> c = cli::power_basis(x);
    const Map<Rational> f = pair_map(c, c);
    const std::array<PairChart<Rational>, 2> charts = {pair_chart(c), pair_chart(c.exchanged())};

    const Vector4<Rational> pair = {some(generator), some(generator), some(generator), some(generator)};
    const auto& [u, v, a, b] = pair;
    const auto& [p, q] = charts[0].divided;
    const Vector4<Rational> squares = {u, v, a * a, b * b};
    CHECK(sum(p.value(squares), 2 * a, q.value(squares), 2 * b) == at_pair(f, pair));

    const Rational t(1, 7);
    const Rational slope = some(generator);
    const Vector4<Rational> place = {u, v, slope, t * t};
    CHECK(sum(charts[0].equation.value(place), 2 * t, {}, 0) == at_pair(f, {u, v, t, slope * t}));
    CHECK(sum(charts[1].equation.value(place), 2 * t, {}, 0) == at_pair(f, {v, u, slope * t, t}));
    // The sums of both points and of both weights: where the points are one their quotient is this point.
    const Map<Rational>& points = charts[0].space.points;
    const HomogeneousPoint one = x.homogeneous_at(u + t, v + slope * t);
    const HomogeneousPoint other = x.homogeneous_at(u - t, v - slope * t);
    for (std::size_t d = 0; d < 3; ++d) CHECK(2 * points.value(place)[d] == one[d] + other[d]);
    CHECK(charts[0].space.weight.has_value() == !x.is_polynomial());
    if (!x.is_polynomial()) CHECK(2 * charts[0].space.weight->value(place)[0] == one[3] + other[3]);
  }
}

TEST_CASE("ranges over boxes of pairs hold what is at their pairs") {
  Generator generator(92);
  INFO("seed 92");
  for (int i = 0; i < 20; ++i) {
    INFO(i);
    const auto net = random_nets::scattered(generator, {1 + i % 3, 3, 1, 1}).x;
    const RationalPatch x = i % 2 == 0 ? random_nets::weighted(generator, net) : RationalPatch(net);
    const Divided<Rational> maps = pair_chart(cli::power_basis(x)).divided;
    Box<Rational> box;
    Vector4<Rational> pair;
    for (std::size_t j = 0; j < 4; ++j) {
      box[j] = {some(generator), magnitude(some(generator)) / 4};
      pair[j] = box[j].middle + (i % 3 - 1) * box[j].radius;
    }
    const Rational m = some(generator);
    const DividedOver<Rational> over(maps, box);
    const Balls<Rational> r = over.r(m);
    const Balls<Rational> q = over.q();
    const Vector4<Rational> squares = {pair[0], pair[1], pair[2] * pair[2], pair[3] * pair[3]};
    const Vector at_q = maps[1].value(squares);
    const Vector at_r = sum(maps[0].value(squares), 1, at_q, m);
    const Vector n = {1, -2, 3};
    CHECK(holds(volume(n, maps, box), dot(n, cross(at_r, at_q))));
    for (std::size_t d = 0; d < 3; ++d) CHECK((holds(r[d], at_r[d]) && holds(q[d], at_q[d])));
    CHECK(holds(square(box[2]), squares[2]));
  }
}

}  // namespace exsect::pairs_of_points_test
