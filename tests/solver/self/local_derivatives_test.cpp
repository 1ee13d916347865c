// Derivatives of patches of every kind against their Taylor series and each other.
#include "self/local_derivatives.h"

#include <exsect/algebra/nearest_rounding.h>

#include <cmath>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::local_derivatives_test {
namespace {

RationalPatch patch_of(std::uint64_t seed, bool weighted) {
  random_nets::Generator generator(seed);
  const random_nets::Nets nets = random_nets::scattered(generator, {3, seed % 2 == 0 ? 2 : 3, 2, 2});
  return weighted ? random_nets::weighted(generator, nets.x) : nets.first();
}

double factorial(std::size_t n) { return n < 2 ? 1 : static_cast<double>(n) * factorial(n - 1); }

}  // namespace

TEST_CASE("local derivatives: the Taylor series gives values nearby") {
  in_nearest_rounding([] {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      INFO("seed " << seed);
      const RationalPatch x = patch_of(seed, seed > 4);
      const Point origin = {Rational(1, 3), 0, -1};
      const AffineDerivatives d = LocalDerivatives(x, origin).at(0.375, 0.625);
      const Rational h(1, 500), k(-1, 800);
      const Point near = x(Rational(3, 8) + h, Rational(5, 8) + k) - origin;
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < kLocalOrders; ++i)
          for (std::size_t j = 0; i + j < kLocalOrders; ++j) {
            CHECK(d[i][j][c].radius() < 1e-9);
            sum += d[i][j][c].approximation() * std::pow(to_double(h), i) * std::pow(to_double(k), j) /
                   (factorial(i) * factorial(j));
          }
        CHECK(std::fabs(sum - to_double(near[c])) < 1e-13);
      }
    }
  });
}

TEST_CASE("local derivatives: those over the square hold those at its points") {
  in_nearest_rounding([] {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      INFO("seed " << seed);
      const LocalDerivatives x(
          patch_of(seed, seed > 4).restricted_to(Rational(1, 3), Rational(1, 2), 0, Rational(1, 4)),
          Point{0, 0, 0});
      const AffineDerivatives all = x.everywhere();
      for (const double u : {0.0, 0.3, 1.0})
        for (const double v : {0.0, 0.8, 1.0}) {
          const AffineDerivatives d = x.at(u, v);
          for (std::size_t i = 0; i < kLocalOrders; ++i)
            for (std::size_t j = 0; i + j < kLocalOrders; ++j)
              for (std::size_t c = 0; c < 3; ++c)
                CHECK(std::fabs(d[i][j][c].approximation() - all[i][j][c].approximation()) <=
                      all[i][j][c].radius() + d[i][j][c].radius());
        }
    }
  });
}

}  // namespace exsect::local_derivatives_test
