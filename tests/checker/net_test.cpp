// Control nets: halves, lines and powers against polar forms and against sums of Bernstein polynomials.
#include <exsect/checker/net.h>
#include <exsect/geometry/rational_patch.h>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::net_test {
namespace {

using checker::Net;
using Generator = random_pairs::Generator;

Net<Rational> net_of(const RationalPatch& patch) {
  Net<Rational> net(static_cast<std::size_t>(patch.degree_u()), static_cast<std::size_t>(patch.degree_v()));
  net.each([&](std::size_t i, std::size_t j) {
    net[i][j] = patch.point(static_cast<int>(i), static_cast<int>(j));
  });
  return net;
}
bool equal(const Net<Rational>& a, const Net<Rational>& b) {
  bool result = a.degree(0) == b.degree(0) && a.degree(1) == b.degree(1);
  a.each([&](std::size_t i, std::size_t j) { result = result && a[i][j] == b[i][j]; });
  return result;
}
Rational power(const Rational& a, std::size_t n) {
  return n == 0 ? Rational(1) : Rational(a * power(a, n - 1));
}
Point value(const Net<Rational>& powers, const Rational& u, const Rational& v) {
  Point sum = {};
  powers.each([&](std::size_t i, std::size_t j) { sum = sum + power(u, i) * power(v, j) * powers[i][j]; });
  return sum;
}

}  // namespace

TEST_CASE("halves, lines and powers of nets of every bidegree") {
  Generator generator(31);
  INFO("seed 31");
  const Rational half(1, 2);
  for (int m = 1; m <= 3; ++m) {
    for (int n = 1; n <= 3; ++n) {
      INFO("bidegree " << m << "," << n);
      const RationalPatch patch = random_nets::scattered(generator, {m, n, 1, 1}).first();
      Net<Rational> upper = net_of(patch);
      CHECK(equal(upper.split(0), net_of(patch.restricted_to(0, half, 0, 1))));
      CHECK(equal(upper, net_of(patch.restricted_to(half, 1, 0, 1))));
      upper = net_of(patch);
      CHECK(equal(upper.split(1), net_of(patch.restricted_to(0, 1, 0, half))));
      CHECK(equal(upper, net_of(patch.restricted_to(0, 1, half, 1))));
      Net<Rational> powers = net_of(patch);
      powers.to_powers();
      for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1), Rational(-2)})
        CHECK(value(powers, t, Rational(2, 7)) == patch(t, Rational(2, 7)));
      Net<Rational> line = net_of(patch);
      line.restrict_to(1, Rational(2, 7));
      CHECK((line.degree(0) == static_cast<std::size_t>(m) && line.degree(1) == 0));
      line.to_powers();
      CHECK(value(line, Rational(1, 3), 0) == patch(Rational(1, 3), Rational(2, 7)));
    }
  }
}

}  // namespace exsect::net_test
