#include <exsect/algebra/chebyshev.h>

#include <random>
#include <stdexcept>

#include "support/catch.h"

namespace exsect::chebyshev_test {

namespace {

bool holds(const WideBall& ball, const Rational& value) {
  const RationalInterval interval = ball.interval();
  return interval.lower <= value && value <= interval.upper;
}

std::vector<WideBall> balls(const std::vector<Rational>& c) {
  std::vector<WideBall> result;
  for (const Rational& q : c) result.push_back(WideBall::enclosing(RationalInterval{q, q}));
  return result;
}

}  // namespace

TEST_CASE("Chebyshev nodes: values and coefficients", "[chebyshev]") {
  CHECK_THROWS_AS(ChebyshevNodes(0), std::invalid_argument);
  CHECK_THROWS_AS(ChebyshevNodes(2).coefficients({1.0}), std::invalid_argument);
  CHECK(holds(ChebyshevNodes(1).coefficients({7.0}).at(0), 7));
  for (const std::size_t n : {2u, 5u, 16u, 17u, 129u}) {
    const ChebyshevNodes nodes(n);
    for (std::size_t k = 0; k < n; ++k) {
      // T_n vanishes at its node; T_2 = 2 T_1^2 - 1, T_3 = 4 T_1^3 - 3 T_1.
      WideBall before = 1, now = nodes.node(k);
      for (std::size_t j = 1; j < n; ++j) {
        CHECK((now - nodes.value(j, k)).certain_sign() == 0);
        const WideBall next = scaled(nodes.node(k) * now, 1) - before;
        before = now;
        now = next;
      }
      CHECK(now.certain_sign() == 0);
      CHECK(nodes.node(k).radius() < 0x1p-250);
      if (k > 0) CHECK((nodes.node(k - 1) - nodes.node(k)).certain_sign() == 1);
    }
  }
}

TEST_CASE("Chebyshev nodes: interpolation gives back the coefficients", "[chebyshev]") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (const std::size_t n : {1u, 2u, 17u, 64u, 129u}) {
    const ChebyshevNodes nodes(n);
    std::vector<Rational> c;
    for (std::size_t j = 0; j < n; ++j)
      c.emplace_back(static_cast<long>(random() % 2001) - 1000, 1 + random() % 50);
    const std::vector<WideBall> exact = balls(c);
    std::vector<WideBall> values;
    for (std::size_t k = 0; k < n; ++k) {
      WideBall::Sum sum;
      for (std::size_t j = 0; j < n; ++j) sum.add(exact[j], nodes.value(j, k));
      values.push_back(sum.rounded());
    }
    const std::vector<WideBall> found = nodes.coefficients(values);
    for (std::size_t j = 0; j < n; ++j) {
      CHECK(holds(found[j], c[j]));
      CHECK(found[j].radius() < 0x1p-220);
    }
  }
}

}  // namespace exsect::chebyshev_test
