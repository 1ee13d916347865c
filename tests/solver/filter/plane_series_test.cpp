#include "filter/plane_series.h"

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::plane_series_test {
namespace {

using filter::PlaneSeries;
using random_pairs::Generator;
using random_pairs::integer;

Rational polynomial_value(const PlaneSeries& f, const Rational& p, const Rational& q) {
  Rational sum = 0, first = 1;
  for (int i = 0; i <= f.order(); ++i, first *= p) {
    Rational second = first;
    for (int j = 0; i + j <= f.order(); ++j, second *= q) sum += f.coefficient(i, j) * second;
  }
  return sum;
}

/// (14.121) at one point.
bool encloses(const PlaneSeries& f, const Rational& p, const Rational& q, const Rational& value) {
  const Rational farthest = std::max(Rational(abs(p)), Rational(abs(q)));
  Rational room = f.rest();
  for (int k = 0; k <= f.order(); ++k) room *= farthest;
  return abs(Rational(polynomial_value(f, p, q) - value)) <= room;
}

PlaneSeries random_series(Generator& generator, int order, const Rational& reach) {
  PlaneSeries f(order, reach);
  for (int i = 0; i <= order; ++i)
    for (int j = 0; i + j <= order; ++j)
      f.add(PlaneSeries::power(order, reach, i, j), Rational(integer(generator, -3, 3)));
  return f;
}

}  // namespace

TEST_CASE("plane series: what is left out of products", "[filter]") {
  const Rational reach(1, 2);
  const PlaneSeries p = PlaneSeries::power(1, reach, 1, 0), q = PlaneSeries::power(1, reach, 0, 1);
  const PlaneSeries square = p * p;
  CHECK(square.is_polynomial_zero());
  CHECK(square.rest() == 1);  // p^2 <= max(p,q)^2
  CHECK((square * q).rest() == Rational(1, 2));
  CHECK(square.size() == Rational(1, 4));
  const PlaneSeries one = PlaneSeries::power(0, reach, 0, 0);
  CHECK((one * one).coefficient(0, 0) == 1);
  CHECK((one * one).rest() == 0);
  CHECK(PlaneSeries(0, reach).is_polynomial_zero());
  CHECK(square.polynomial(3, 1).rest() == 0);
}

TEST_CASE("plane series: sums and products enclose those of values", "[filter]") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const int order = static_cast<int>(integer(generator, 0, 4));
    const Rational reach(1, integer(generator, 1, 4));
    PlaneSeries a = random_series(generator, order, reach), b = random_series(generator, order, reach);
    const Rational wide_a(integer(generator, 0, 2)), wide_b(integer(generator, 0, 2));
    a.widen(wide_a), b.widen(wide_b);
    PlaneSeries sum = a;
    sum.add(b, -2);
    const PlaneSeries product = a * b;
    for (int k = 0; k < 20; ++k) {
      const auto place = [&] { return Rational(reach * Rational(integer(generator, -4, 4), 4)); };
      const Rational p = place(), q = place();
      Rational last = std::max(Rational(abs(p)), Rational(abs(q)));
      for (int n = order; n > 0; --n) last *= std::max(Rational(abs(p)), Rational(abs(q)));
      // A value at the end of what the rest allows.
      const Rational of_a = polynomial_value(a, p, q) + wide_a * last;
      const Rational of_b = polynomial_value(b, p, q) - wide_b * last;
      CHECK(encloses(sum, p, q, of_a - 2 * of_b));
      CHECK(encloses(product, p, q, of_a * of_b));
      CHECK(abs(Rational(of_a * of_b)) <= product.size());
    }
  }
}

TEST_CASE("plane series: quotients by powers enclose those of values", "[filter]") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Rational reach(1, integer(generator, 1, 4));
    const int i = static_cast<int>(integer(generator, 0, 2)), j = static_cast<int>(integer(generator, 0, 2));
    const int order = i + j + static_cast<int>(integer(generator, 0, 2));
    // The product with a polynomial of which terms are left out.
    const PlaneSeries f = random_series(generator, order, reach);
    const PlaneSeries product = PlaneSeries::power(order, reach, i, j) * f;
    const auto quotient = product.divided(i, j);
    REQUIRE(quotient);
    CHECK(quotient->order() == order - i - j);
    CHECK(quotient->rest() == product.rest());
    for (int k = 0; k < 10; ++k) {
      const Rational p = reach * Rational(integer(generator, -8, 8), 8);
      const Rational q = reach * Rational(integer(generator, -8, 8), 8);
      CHECK(encloses(*quotient, p, q, polynomial_value(f, p, q)));
    }
    CHECK_FALSE(product.divided(order + 1, 0));
  }
  const PlaneSeries sum = [] {
    PlaneSeries result = PlaneSeries::power(2, 1, 1, 1);
    result.add(PlaneSeries::power(2, 1, 0, 1), 1);
    return result;
  }();
  CHECK(sum.divided(0, 1));
  CHECK_FALSE(sum.divided(1, 0));
}

}  // namespace exsect::plane_series_test
