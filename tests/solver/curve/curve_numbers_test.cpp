// What midpoints in doubles lose of expansions of polynomials, against exact ones.
#include "curve/curve_numbers.h"

#include <exsect/algebra/bivariate_polynomial.h>

#include <random>

#include "curve/taylor_shift.h"
#include "support/catch.h"

namespace exsect::curve_numbers_test {
namespace {

using Numbers = CurveNumbers<DoubleBall>;

BivariatePolynomial random_polynomial(std::mt19937& generator, int m, int n) {
  std::uniform_int_distribution<int> digit(-99, 99);
  std::vector<Polynomial> rows;
  for (int i = 0; i <= m; ++i) {
    std::vector<Rational> row;
    for (int j = 0; j <= n; ++j) row.emplace_back(digit(generator), 7);
    row.back() += row.back() == 0 ? 1 : 0;
    rows.emplace_back(row);
  }
  return BivariatePolynomial(rows);
}

/// f(u + x, v + slope x + edge) in x.
Polynomial exactly_along(const BivariatePolynomial& f, double u, double v, double slope, double edge) {
  const Polynomial x = Polynomial::variable();
  const Polynomial in_u = x + Polynomial(from_double(u));
  const Polynomial in_v = x * Polynomial(from_double(slope)) + Polynomial(from_double(v) + from_double(edge));
  Polynomial exact;
  for (int k = f.degree_r(); k >= 0; --k) {
    Polynomial coefficient;
    for (int j = f.degree_s(); j >= 0; --j)
      coefficient = coefficient * in_v + Polynomial(f.coefficient(k, j));
    exact = exact * in_u + coefficient;
  }
  return exact;
}

/// sum |found_k - exact_k| reach^k
Rational difference(const std::vector<double>& found, const Polynomial& exact, double reach) {
  Rational sum = 0, power = 1;
  for (std::size_t k = 0; k < found.size(); ++k, power *= from_double(reach))
    sum += abs(from_double(found[k]) - exact.coefficient(static_cast<int>(k))) * power;
  return sum;
}

}  // namespace

TEST_CASE("curve numbers: doubles along lines lose no more than they say", "[curve]") {
  const unsigned seed = 13;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0, 1);
  int lost = 0;
  for (int i = 0; i < 300; ++i) {
    const BivariatePolynomial f = random_polynomial(generator, i % 7, i % 5);
    const std::size_t row = static_cast<std::size_t>(f.degree_s()) + 1;
    const double u = std::ldexp(place(generator) - 0.5, i % 4), v = std::ldexp(place(generator), i % 3);
    const double w = std::ldexp(place(generator), -i % 30);
    const double slope = std::ldexp(place(generator) - 0.5, i % 60 - 40);  // flat and steep
    const double reach = std::ldexp(place(generator), -i % 20);
    const Numbers numbers(enclosed_coefficients<DoubleBall>(f, greatest_coefficient(f)), row);
    std::vector<double> c = numbers.coefficients;
    shift_to(c, row, u, v);
    const double error = numbers.error(std::fabs(u) + reach, std::fabs(v) + std::fabs(slope) * reach + w);
    for (const double edge : {-w, w}) {
      const Polynomial exact = exactly_along(f, u, v, slope, edge) * Polynomial(1 / greatest_coefficient(f));
      const Rational off = difference(along_line(c, row, slope, edge), exact, reach);
      CHECK(off <= from_double(error) * (1 + power_of_two(-45)));
      lost += off > from_double(error) / 1000 ? 1 : 0;
    }
  }
  CHECK(lost > 100);  // the bound is of the size of what is lost
}

TEST_CASE("curve numbers: magnitudes that are not known", "[curve]") {
  const double infinite = std::numeric_limits<double>::infinity(), nan = std::nan("");
  CHECK(Numbers::least(-2, 1) > 0.999);
  CHECK(Numbers::least(-2, 1) < 1);
  for (const double x : {0.5, -1.0, 1.0, infinite, -infinite, nan}) CHECK(Numbers::least(x, 1) == 0);
  for (const double error : {infinite, nan}) CHECK(Numbers::least(3, error) == 0);
  CHECK(std::isnan(Numbers::number(DoubleBall(0.5, 0x1p-60))));
  // Beyond doubles nothing is proved.
  const Numbers square(std::vector<DoubleBall>{0.0, 0.0, 1.0}, 3);
  CHECK_FALSE(square.error(1, 1e200) < 1e300);
}

}  // namespace exsect::curve_numbers_test
