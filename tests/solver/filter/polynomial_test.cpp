#include "filter/polynomial.h"

#include <exsect/algebra/rational.h>

#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::polynomial_test {
namespace {

using namespace filter;
using Generator = std::mt19937_64;

/// Small integers and eighths: doubles compute values of these exactly.
template <class K>
CoefficientsOf<K> small_coefficients(Generator& generator) {
  std::uniform_int_distribution<int> any(-9, 9);
  CoefficientsOf<K> c;
  for (auto& row : c)
    for (double& entry : row) entry = any(generator);
  return c;
}
double eighths(Generator& generator) { return std::uniform_int_distribution<int>(-8, 8)(generator) / 8.0; }

double power(double t, std::size_t n) { return n == 0 ? 1 : t * power(t, n - 1); }

/// The derivative of orders (p,q) at (a,b), term by term.
template <class K>
double derivative(const CoefficientsOf<K>& c, std::size_t row, std::size_t p, std::size_t q, double a,
                  double b) {
  double sum = 0;
  for (std::size_t i = p; i < K::side; ++i)
    for (std::size_t j = q; j < K::side; ++j) {
      double factor = 1;
      for (std::size_t n = 0; n < p; ++n) factor *= static_cast<double>(i - n);
      for (std::size_t n = 0; n < q; ++n) factor *= static_cast<double>(j - n);
      sum += factor * c[K::side * i + j][row] * power(a, i - p) * power(b, j - q);
    }
  return sum;
}

template <class K>
void check_kind() {
  Generator generator(20275);
  for (int round = 0; round < 50; ++round) {
    const auto c = small_coefficients<K>(generator);
    const double a = eighths(generator), b = eighths(generator);
    const Row<K> value = value_at<K>(c, a, b);
    Row<K> first, second;
    derivatives<K>(c, a, b, first, second);
    const auto pa = powers<K>(a), pb = powers<K>(b);
    const Row<K> linear = form_of_order<K, 1>(c, pa, pb);
    const Row<K> last = form_of_order<K, 2 * K::degree>(c, pa, pb);
    const Row<K> cubic = form_of_order<K, 3>(c, pa, pb);
    for (std::size_t row = 0; row < K::rows; ++row) {
      CHECK(value[row] == derivative<K>(c, row, 0, 0, a, b));
      CHECK(first[row] == derivative<K>(c, row, 1, 0, a, b));
      CHECK(second[row] == derivative<K>(c, row, 0, 1, a, b));
      CHECK(linear[row] == c[kFirst<K>][row] * a + c[kSecond][row] * b);
      CHECK(last[row] == c[K::count - 1][row] * power(a, K::degree) * power(b, K::degree));
      double sum = 0;
      for (std::size_t i = 0; i < K::side; ++i)
        for (std::size_t j = 0; j < K::side; ++j)
          if (i + j == 3) sum += c[K::side * i + j][row] * power(a, i) * power(b, j);
      CHECK(cubic[row] == sum);
    }
    const double ha = std::fabs(eighths(generator)), hb = std::fabs(eighths(generator));
    const auto v = variation<K>(c, ha, hb);
    const Row<K> change = value_variation<K>(c, ha, hb);
    const double bend = second_derivatives<K>(c, ha, hb);
    for (int sample = 0; sample < 8; ++sample) {
      const double x = ha * eighths(generator), y = hb * eighths(generator);
      for (std::size_t row = 0; row < K::rows; ++row) {
        const auto d = [&](std::size_t p, std::size_t q, double s, double t) {
          return derivative<K>(c, row, p, q, s, t);
        };
        CHECK(std::fabs(d(0, 0, x, y) - d(0, 0, 0, 0)) <= change[row] * (1 + 1e-14));
        CHECK(std::fabs(d(1, 0, x, y) - d(1, 0, 0, 0)) <= v.first[row] * (1 + 1e-14));
        CHECK(std::fabs(d(0, 1, x, y) - d(0, 1, 0, 0)) <= v.second[row] * (1 + 1e-14));
        CHECK(std::fabs(d(2, 0, x, y)) + std::fabs(d(1, 1, x, y)) <= bend * (1 + 1e-14));
        CHECK(std::fabs(d(1, 1, x, y)) + std::fabs(d(0, 2, x, y)) <= bend * (1 + 1e-14));
      }
    }
  }
}

}  // namespace

TEST_CASE("filter polynomials: values, derivatives and bounds of every kind", "[filter]") {
  check_kind<Biquadratic>();
  check_kind<Bicubic>();
  check_kind<WeightedBiquadratic>();
  check_kind<WeightedBicubic>();
}

}  // namespace exsect::polynomial_test
