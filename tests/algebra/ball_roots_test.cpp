#include <exsect/algebra/ball_roots.h>
#include <exsect/algebra/real_algebraic.h>

#include <stdexcept>
#include <vector>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::ball_roots_test {
using namespace exsect::test;

namespace {

std::vector<DoubleDoubleBall> balls(const Polynomial& f) {
  std::vector<DoubleDoubleBall> result;
  for (int i = 0; i <= f.degree(); ++i) result.push_back(DoubleDoubleBall::enclosing(f.coefficient(i)));
  return result;
}

/// Each ball holds the root in its place, of those in [0,1] by Descartes' rule over the integers.
void check_roots_in(const std::vector<DoubleDoubleBall>& found, const Polynomial& f) {
  const std::vector<RealAlgebraic> exact = real_roots(f, 0, 1);
  REQUIRE(found.size() == exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const RationalInterval interval = found[i].interval();
    CHECK(exact[i].compare(interval.lower) >= 0);
    CHECK(exact[i].compare(interval.upper) <= 0);
    CHECK(interval.width() < power_of_two(-50));
  }
}

}  // namespace

TEST_CASE("roots in balls are the roots over the integers", "[ball_roots]") {
  std::size_t roots = 0;
  std::size_t decided = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    Polynomial f = random.polynomial(random.integer(0, 12), 1000, seed % 2 == 0 ? 1 : 1000);
    for (int i = random.integer(0, 4); i > 0; --i)
      f = f * linear_factor(Rational(random.integer(1, 999), 1000));
    if (f.is_zero()) continue;
    const auto found = isolate_ball_roots(balls(f));
    if (!found) continue;
    check_roots_in(*found, f);
    roots += found->size();
    ++decided;
  }
  CHECK(decided >= 280);
  CHECK(roots >= 500);
}

TEST_CASE("roots in balls: all polynomials with coefficients in the balls", "[ball_roots]") {
  std::size_t decided = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const Polynomial f =
        random.polynomial(8, 1000) * linear_factor(Rational(1, 3)) * linear_factor(Rational(2, 3));
    std::vector<DoubleDoubleBall> widened = balls(f);
    for (DoubleDoubleBall& c : widened) c = c.widened(0x1p-60);
    const auto found = isolate_ball_roots(widened);
    if (!found) continue;
    ++decided;
    for (int sample = 0; sample < 5; ++sample) {
      std::vector<Rational> c;
      for (int i = 0; i <= f.degree(); ++i)
        c.push_back(f.coefficient(i) + random.integer(-1, 1) * power_of_two(-60));
      check_roots_in(*found, Polynomial(c));
    }
  }
  CHECK(decided >= 50);
}

TEST_CASE("roots in balls: none appears within the radii", "[ball_roots]") {
  std::size_t undecided = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const Polynomial dip = linear_factor(Rational(random.integer(1, 999), 1000));
    const Rational depth = Rational(random.integer(-8, 8)) * power_of_two(-random.integer(4, 16));
    const Rational radius = power_of_two(-random.integer(4, 16));
    const Polynomial f = dip * dip + Polynomial(depth);
    std::vector<DoubleDoubleBall> widened = balls(f);
    widened[0] = widened[0].widened(to_double(radius));
    const auto found = isolate_ball_roots(widened);
    undecided += found ? 0 : 1;
    if (!found) continue;
    for (const Rational& shift : {-radius, radius})
      CHECK(real_roots(f + Polynomial(shift), 0, 1).size() == found->size());
  }
  CHECK(undecided >= 40);
}

TEST_CASE("roots in balls: where they decide nothing", "[ball_roots]") {
  const auto decided = [](const Polynomial& f) { return isolate_ball_roots(balls(f)).has_value(); };
  const Polynomial t = Polynomial::variable();
  CHECK(decided(t + Polynomial(1)));
  CHECK(decided(Polynomial(7)));
  CHECK_FALSE(decided(Polynomial(0)));
  CHECK_FALSE(decided(t));  // at the ends
  CHECK_FALSE(decided(t - Polynomial(1)));
  CHECK_FALSE(decided(with_roots({Rational(1, 3), Rational(1, 3)})));
  CHECK_FALSE(decided(with_roots({Rational(1, 2), Rational(1, 4), Rational(3, 4)})));  // where pieces end
  CHECK(decided(with_roots({2, 2, -1, -1})));

  INFO("close roots, and roots close to an end");
  const Rational close = Rational(1, 3) + power_of_two(-25);
  const Polynomial two = with_roots({Rational(1, 3), close});
  const auto found = isolate_ball_roots(balls(two));
  REQUIRE(found);
  check_roots_in(*found, two);
  CHECK(decided(with_roots({power_of_two(-30), 1 - power_of_two(-30)})));
  CHECK_FALSE(decided(with_roots({Rational(1, 3), Rational(1, 3) + power_of_two(-60)})));

  INFO("radii that hold a double root");
  std::vector<DoubleDoubleBall> wide =
      balls(with_roots({Rational(1, 3), Rational(1, 3) + power_of_two(-20)}));
  wide[0] = wide[0].widened(0x1p-40);
  CHECK_FALSE(isolate_ball_roots(wide));
  std::vector<DoubleDoubleBall> infinite = balls(t - Polynomial(Rational(1, 3)));
  infinite[1] = infinite[1] * DoubleDoubleBall(1e300) * DoubleDoubleBall(1e300);
  CHECK_FALSE(isolate_ball_roots(infinite));
  CHECK_THROWS_AS(isolate_ball_roots(std::vector<DoubleDoubleBall>(18, 1.0)), std::invalid_argument);
  CHECK(isolate_ball_roots(std::vector<DoubleDoubleBall>(17, 1.0))->empty());
}

}  // namespace exsect::ball_roots_test
