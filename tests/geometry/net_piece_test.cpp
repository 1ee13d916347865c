#include <exsect/geometry/net_piece.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::net_piece_test {
namespace {

std::vector<HomogeneousPoint> random_net(Random& random, int m, int n) {
  std::vector<HomogeneousPoint> net(static_cast<std::size_t>((m + 1) * (n + 1)));
  for (HomogeneousPoint& p : net)
    for (Rational& c : p) c = random_rational(random);
  return net;
}

/// The polynomial of a coordinate, as a sum of products of powers of u, 1-u, v and 1-v.
BivariatePolynomial polynomial_of(const std::vector<HomogeneousPoint>& net, int m, int n, std::size_t k) {
  const auto power = [](const BivariatePolynomial& f, int e) {
    BivariatePolynomial result = BivariatePolynomial::constant(1);
    for (int i = 0; i < e; ++i) result = result * f;
    return result;
  };
  const BivariatePolynomial u = BivariatePolynomial::r(), v = BivariatePolynomial::s(),
                            one = BivariatePolynomial::constant(1);
  const auto basis = [&](int degree, int i, const BivariatePolynomial& t) {
    const int times = degree == 3 && i % 3 != 0 ? 3 : degree == 2 && i == 1 ? 2 : 1;
    return BivariatePolynomial::constant(times) * power(t, i) * power(one - t, degree - i);
  };
  BivariatePolynomial sum;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
      sum = sum + BivariatePolynomial::constant(net[static_cast<std::size_t>(i * (n + 1) + j)][k]) *
                      basis(m, i, u) * basis(n, j, v);
  return sum;
}

}  // namespace

TEST_CASE("the net of a piece is that of the polynomials in other parameters") {
  const std::uint64_t seed = 20261127;
  INFO("seed " << seed);
  Random random(seed);
  const Rational far = power_of_two(-70) + Rational(1, 2);
  const std::vector<std::array<Rational, 2>> ranges = {{0, 1},
                                                       {1, 0},
                                                       {0, Rational(26, 64)},
                                                       {far, 1},
                                                       {far, far},
                                                       {Rational(1, 3), Rational(6, 7)},
                                                       {Rational(2), Rational(-1)}};
  for (int m = 1; m <= 3; ++m)
    for (int n = 1; n <= 3; ++n)
      for (std::size_t a = 0; a < ranges.size(); ++a) {
        const auto net = random_net(random, m, n);
        const auto &u = ranges[a], &v = ranges[(3 * a + static_cast<std::size_t>(m)) % ranges.size()];
        const auto piece = net_of_piece(net, m, n, u, v);
        REQUIRE(piece.size() == net.size());
        for (std::size_t k = 0; k < 4; ++k) {
          const BivariatePolynomial whole = polynomial_of(net, m, n, k), part = polynomial_of(piece, m, n, k);
          for (int i = 0; i <= m; ++i)
            for (int j = 0; j <= n; ++j) {
              const Rational s(i, 5), t(j, 7);
              CHECK(part(s, t) == whole(u[0] + s * (u[1] - u[0]), v[0] + t * (v[1] - v[0])));
            }
        }
      }
}

TEST_CASE("numbers of a piece are in lowest terms") {
  // 1/3 and -1/12 in a net of u: the middle one is 1/8, the zero stays one.
  const std::vector<HomogeneousPoint> net = {{Rational(1, 3), 0, 8, 1},
                                             {Rational(1, 3), 0, 8, 1},
                                             {Rational(-1, 12), 0, -8, 1},
                                             {Rational(-1, 12), 0, -8, 1}};
  const auto piece = net_of_piece(net, 1, 1, {0, Rational(1, 2)}, {0, 1});
  CHECK(numerator(piece[2][0]) == 1);
  CHECK(denominator(piece[2][0]) == 8);
  CHECK(denominator(piece[2][1]) == 1);
  CHECK(denominator(piece[2][2]) == 1);
  CHECK(piece[2][2] == 0);
  CHECK(piece[0] == net[0]);
}

}  // namespace exsect::net_piece_test
