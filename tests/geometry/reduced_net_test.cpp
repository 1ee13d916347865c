#include <exsect/geometry/reduced_net.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::reduced_net_test {
namespace {

using Net = std::vector<HomogeneousPoint>;

Net random_net(Random& random, int m, int n, bool weighted) {
  Net net;
  for (int i = 0; i < (m + 1) * (n + 1); ++i) {
    const Point p = random_point(random);
    net.push_back({p[0], p[1], p[2], weighted ? Rational(1 + abs(random_rational(random))) : Rational(1)});
  }
  return net;
}

/// Times (1-u) a + u b, in u: the degree m + 1.
Net times_in_u(const Net& net, int m, int n, const Rational& a, const Rational& b) {
  Net result;
  for (int i = 0; i <= m + 1; ++i)
    for (int j = 0; j <= n; ++j) {
      HomogeneousPoint p = {0, 0, 0, 0};
      for (std::size_t k = 0; k < 4; ++k) {
        if (i <= m)
          p[k] += a * Rational(m + 1 - i, m + 1) * net[static_cast<std::size_t>(i * (n + 1) + j)][k];
        if (i > 0) p[k] += b * Rational(i, m + 1) * net[static_cast<std::size_t>((i - 1) * (n + 1) + j)][k];
      }
      result.push_back(p);
    }
  return result;
}

Net exchanged(const Net& net, int m, int n) {
  Net result;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= m; ++i) result.push_back(net[static_cast<std::size_t>(i * (n + 1) + j)]);
  return result;
}

}  // namespace

TEST_CASE("random nets are surely reduced, their products with factors of one parameter are not") {
  const std::uint64_t seed = 20261128;
  INFO("seed " << seed);
  Random random(seed);
  for (int m = 1; m <= 3; ++m)
    for (int n = 1; n <= 3; ++n)
      for (const bool weighted : {false, true}) {
        const Net net = random_net(random, m, n, weighted);
        CHECK(is_surely_reduced(net, m, n));
        CHECK(is_surely_reduced(exchanged(net, m, n), n, m));
        if (m == 3) continue;
        // Elevated; with factors that vanish at no parameter, elsewhere, and in a far place.
        for (const auto& [a, b] :
             {std::pair<Rational, Rational>{1, 1}, {1, 2}, {2, 1}, {1, power_of_two(90)}}) {
          const Net product = times_in_u(net, m, n, a, b);
          CHECK_FALSE(is_surely_reduced(product, m + 1, n));
          CHECK_FALSE(is_surely_reduced(exchanged(product, m + 1, n), n, m + 1));
        }
      }
}

TEST_CASE("a common factor of both parameters, equal weights, and a constant parameter") {
  Random random(5);
  // (1 + u + v) (a, b, c, d) with a, ..., d of bidegree (1,1): control vectors by polar forms.
  const Net net = random_net(random, 1, 1, true);
  Net product;
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; j <= 2; ++j) {
      HomogeneousPoint p = {0, 0, 0, 0};
      for (int a = 0; a <= 1; ++a)
        for (int b = 0; b <= 1; ++b) {
          const int c = i - a, d = j - b;
          if (c < 0 || c > 1 || d < 0 || d > 1) continue;
          const Rational share = Rational(1, (i == 1 ? 2 : 1) * (j == 1 ? 2 : 1)) * (1 + c + d);
          for (std::size_t k = 0; k < 4; ++k) p[k] += share * net[static_cast<std::size_t>(2 * a + b)][k];
        }
      product.push_back(p);
    }
  CHECK_FALSE(is_surely_reduced(product, 2, 2));
  Net equal = random_net(random, 3, 2, false);
  CHECK(is_surely_reduced(equal, 3, 2));
  for (HomogeneousPoint& p : equal)
    for (Rational& c : p) c *= 2;
  CHECK_FALSE(is_surely_reduced(equal, 3, 2));
  Net line = random_net(random, 1, 1, false);
  line[2] = line[0];
  line[3] = line[1];
  CHECK_FALSE(is_surely_reduced(line, 1, 1));
}

}  // namespace exsect::reduced_net_test
