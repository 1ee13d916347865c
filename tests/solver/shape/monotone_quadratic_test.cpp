#include "shape/monotone_quadratic.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "support/catch.h"

namespace exsect::monotone_quadratic_test {

namespace {

const std::vector<Rational>& speeds() {
  static const std::vector<Rational> t = {0, Rational(1, 4), Rational(1, 1000000), Rational(499999, 1000000)};
  return t;
}

/// The preimage's ends map to both sides of the interval's, closely.
void check_preimage(const MonotoneQuadratic& f, const RationalInterval& q, const RationalInterval& r) {
  CHECK(r.lower >= 0);
  CHECK(r.upper <= 1);
  CHECK(f(r.lower) <= q.lower);
  CHECK(f(r.upper) >= q.upper);
  CHECK(q.lower - f(r.lower) < power_of_two(-100));
  CHECK(f(r.upper) - q.upper < power_of_two(-100));
}

}  // namespace

TEST_CASE("other speeds are no increasing map", "[monotone_quadratic]") {
  for (const Rational& t : {Rational(-1, 9), Rational(1, 2), Rational(3)})
    CHECK_THROWS_AS(MonotoneQuadratic(t), std::invalid_argument);
}

TEST_CASE("preimages that are rational are exact", "[monotone_quadratic]") {
  for (const Rational& t : speeds()) {
    const MonotoneQuadratic f(t);
    CHECK(f.starts_at_turn() == (t == 0));
    for (const Rational& r : {Rational(0), Rational(1), Rational(1, 3), Rational(5, 7), power_of_two(-500)}) {
      const RationalInterval found = f.inverse({{f(r), f(r)}}).front();
      CHECK(found.lower == r);
      CHECK(found.upper == r);
    }
  }
}

TEST_CASE("preimages of close intervals stay apart", "[monotone_quadratic]") {
  for (const Rational& t : speeds()) {
    const MonotoneQuadratic f(t);
    for (const Rational& at : {power_of_two(-900), Rational(1, 3), Rational(1 - power_of_two(-700))}) {
      const Rational gap = std::min<Rational>(at, 1 - at) * power_of_two(-300);
      const std::vector<RationalInterval> q = {{at - gap, at}, {at + gap / 2, at + gap}};
      const std::vector<RationalInterval> r = f.inverse(q);
      for (std::size_t i = 0; i < 2; ++i) check_preimage(f, q[i], r[i]);
      CHECK(r[0].lower > 0);
      CHECK(r[0].upper < r[1].lower);
      CHECK(r[1].upper < 1);
    }
  }
}

TEST_CASE("random preimages", "[monotone_quadratic]") {
  const unsigned seed = 41;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  const auto unit = [&] { return Rational(static_cast<long>(random() >> 32)) * power_of_two(-32); };
  for (int i = 0; i < 200; ++i) {
    const MonotoneQuadratic f(unit() / 2);
    std::vector<RationalInterval> q;
    for (int k = 0; k < 5; ++k) {
      const Rational a = unit();
      const Rational b = k == 0 ? a : unit();
      q.push_back({std::min(a, b), std::max(a, b)});
    }
    const std::vector<RationalInterval> r = f.inverse(q);
    for (std::size_t k = 0; k < q.size(); ++k) {
      check_preimage(f, q[k], r[k]);
      CHECK(std::fabs(f.inverse(to_double(q[k].lower)) - to_double(r[k].lower)) < 1e-15);
    }
  }
}

}  // namespace exsect::monotone_quadratic_test
