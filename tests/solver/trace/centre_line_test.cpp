#include "trace/centre_line.h"

#include <vector>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::centre_line_test {
namespace {

/// Small integers, on which doubles compute exactly.
using Series = std::vector<double>;

Series product(const Series& f, const Series& g) {
  Series result(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < g.size(); ++j) result[i + j] += f[i] * g[j];
  return result;
}

Series power(const Series& f, std::size_t n) { return n == 0 ? Series{1} : product(f, power(f, n - 1)); }

double coefficient(const Series& f, std::size_t k) { return k < f.size() ? f[k] : 0; }

/// The coefficient of sigma^k of the (i,j)-th derivative over i! j! of sum c a^i b^j at a = f, b = g.
double expected(const NetRow<double>& c, const Series& f, const Series& g, std::size_t i, std::size_t j,
                std::size_t k) {
  const auto choose = [](std::size_t n, std::size_t m) {
    return m > n ? 0.0 : m == 0 || m == n ? 1.0 : static_cast<double>(n);
  };
  double sum = 0;
  for (std::size_t p = i; p < 3; ++p)
    for (std::size_t q = j; q < 3; ++q)
      sum += c[3 * p + q] * choose(p, i) * choose(q, j) *
             coefficient(product(power(f, p - i), power(g, q - j)), k);
  return sum;
}

}  // namespace

TEST_CASE("centre line: values and derivatives of a patch along a polynomial line", "[trace]") {
  constexpr std::size_t degree = 3;
  random_pairs::Generator generator(20266);
  for (int round = 0; round < 50; ++round) {
    NetRow<double> c;
    for (double& entry : c) entry = static_cast<double>(random_pairs::integer(generator, -9, 9));
    Series f(degree + 1), g(degree + 1);
    Monomials<double, degree> m;
    for (std::size_t k = 1; k <= degree; ++k) {
      m.a[k] = f[k] = static_cast<double>(random_pairs::integer(generator, -9, 9));
      m.b[k] = g[k] = static_cast<double>(random_pairs::integer(generator, -9, 9));
    }
    for (std::size_t k = 1; k <= 4 * degree; ++k) m.extend(k);
    for (std::size_t k = 1; k <= 4 * degree; ++k) {
      CHECK(value_coefficient(c, m, k) == expected(c, f, g, 0, 0, k));
      CHECK(gradient_coefficients(c, m, k)[0] == expected(c, f, g, 1, 0, k));
      CHECK(gradient_coefficients(c, m, k)[1] == expected(c, f, g, 0, 1, k));
      const NetRow<double> higher = higher_coefficients(c, m, k);
      for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{2, 0}, {1, 1}, {0, 2}, {2, 1}, {1, 2}})
        CHECK(higher[3 * i + j] == expected(c, f, g, i, j, k));
      CHECK(higher[8] == 0);
    }
  }
}

}  // namespace exsect::centre_line_test
