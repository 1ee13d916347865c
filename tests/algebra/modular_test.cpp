#include <exsect/algebra/modular.h>

#include <random>
#include <stdexcept>

#include "support/catch.h"

namespace exsect::modular_test {

namespace {

std::uint64_t power_by_division(std::uint64_t a, std::uint64_t e, std::uint64_t p) {
  WideWord result = 1;
  for (WideWord base = a % p; e != 0; e >>= 1, base = base * base % p)
    if ((e & 1) != 0) result = result * base % p;
  return static_cast<std::uint64_t>(result);
}

std::vector<Residue> residues(const PrimeField& field, const std::vector<std::int64_t>& integers) {
  std::vector<Residue> result;
  for (const auto a : integers) result.push_back(field.residue(a));
  return result;
}

/// The determinant of the Sylvester matrix by Gaussian elimination.
Residue sylvester_determinant(const PrimeField& field, const std::vector<Residue>& f,
                              const std::vector<Residue>& g) {
  const std::size_t m = f.size() - 1;
  const std::size_t n = g.size() - 1;
  const std::size_t size = m + n;
  std::vector<std::vector<Residue>> a(size, std::vector<Residue>(size, 0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= m; ++j) a[i][i + j] = f[m - j];
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j <= n; ++j) a[n + i][i + j] = g[n - j];
  Residue determinant = field.one();
  for (std::size_t c = 0; c < size; ++c) {
    std::size_t pivot = c;
    while (pivot < size && a[pivot][c] == 0) ++pivot;
    if (pivot == size) return 0;
    if (pivot != c) {
      std::swap(a[pivot], a[c]);
      determinant = field.negate(determinant);
    }
    determinant = field.multiply(determinant, a[c][c]);
    const Residue inverse = field.inverse(a[c][c]);
    for (std::size_t i = c + 1; i < size; ++i) {
      const Residue q = field.multiply(a[i][c], inverse);
      for (std::size_t j = c; j < size; ++j) a[i][j] = field.subtract(a[i][j], field.multiply(q, a[c][j]));
    }
  }
  return determinant;
}

}  // namespace

TEST_CASE("prime_below finds the known primes", "[modular]") {
  CHECK(prime_below(4) == 3);
  CHECK(prime_below(5) == 3);
  CHECK(prime_below(6) == 5);
  CHECK(prime_below(100) == 97);
  CHECK(prime_below(97) == 89);
  CHECK(prime_below(std::uint64_t{1} << 32) == 4294967291U);        // 2^32 - 5
  CHECK(prime_below(prime_field_limit) == prime_field_limit - 55);  // 2^59 - 55
  CHECK_THROWS_AS(prime_below(3), std::domain_error);
  CHECK_THROWS_AS(prime_below(0), std::domain_error);
}

TEST_CASE("PrimeField refuses what is not an odd prime below 2^59", "[modular]") {
  const auto make = [](std::uint64_t p) { return PrimeField(p).prime(); };
  for (const std::uint64_t p : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{9},
                                std::uint64_t{561}, prime_field_limit - 1, prime_field_limit + 9})
    CHECK_THROWS_AS(make(p), std::invalid_argument);
  CHECK(make(3) == 3);
}

TEST_CASE("PrimeField agrees with plain division", "[modular]") {
  const std::uint64_t largest = prime_below(prime_field_limit);
  for (const std::uint64_t p : {std::uint64_t{3}, std::uint64_t{7}, std::uint64_t{4294967291U}, largest}) {
    const PrimeField field(p);
    INFO("p " << p);
    std::mt19937_64 random(17);
    std::vector<std::uint64_t> values = {0, 1, 2, p - 1, p - 2, p / 2, p / 2 + 1};
    for (int i = 0; i < 20; ++i) values.push_back(random() % p);
    for (const auto a : values) {
      const Residue x = field.residue(static_cast<std::int64_t>(a % p));
      CHECK(field.representative(x) == a % p);
      CHECK(field.representative(field.negate(x)) == (p - a % p) % p);
      CHECK(field.representative(field.power(x, 12345)) == power_by_division(a, 12345, p));
      CHECK(field.residue(Integer(a % p)) == x);
      if (a % p != 0) CHECK(field.multiply(field.inverse(x), x) == field.one());
      for (const auto b : values) {
        const Residue y = field.residue(Integer(b % p));
        CHECK(field.representative(field.add(x, y)) == (a % p + b % p) % p);
        CHECK(field.representative(field.subtract(x, y)) == (a % p + p - b % p) % p);
        CHECK(field.representative(field.multiply(x, y)) ==
              static_cast<std::uint64_t>(static_cast<WideWord>(a % p) * (b % p) % p));
      }
    }
    CHECK_THROWS_AS(field.inverse(0), std::domain_error);
  }
}

TEST_CASE("PrimeField takes negative and long integers", "[modular]") {
  const PrimeField field(prime_below(prime_field_limit));
  CHECK(field.residue(std::int64_t{-1}) == field.negate(field.one()));
  CHECK(field.residue(INT64_MIN) == field.negate(field.power(field.residue(std::int64_t{2}), 63)));
  const Integer long_integer = -(Integer(1) << 1000) - 3;
  CHECK(field.residue(long_integer) ==
        field.subtract(field.negate(field.power(field.residue(std::int64_t{2}), 1000)),
                       field.residue(std::int64_t{3})));
}

TEST_CASE("the accumulator holds the promised number of largest products", "[modular]") {
  const PrimeField field(prime_below(prime_field_limit));
  const Residue a = field.prime() - 1;
  WideWord sum = 0;
  Residue one_by_one = 0;
  for (int i = 0; i < PrimeField::max_products; ++i) {
    sum += static_cast<WideWord>(a) * a;
    one_by_one = field.add(one_by_one, field.multiply(a, a));
  }
  CHECK(field.reduce(sum) == one_by_one);
}

TEST_CASE("invert_all inverts each element", "[modular]") {
  const PrimeField field(101);
  auto elements = residues(field, {1, 2, -1, 50, 100, 7});
  const auto before = elements;
  invert_all(field, elements);
  for (std::size_t i = 0; i < elements.size(); ++i)
    CHECK(field.multiply(elements[i], before[i]) == field.one());
  auto with_zero = residues(field, {5, 0, 3});
  CHECK_THROWS_AS(invert_all(field, with_zero), std::domain_error);
  std::vector<Residue> none;
  CHECK_NOTHROW(invert_all(field, none));
}

TEST_CASE("modular resultant on awkward shapes equals Sylvester's determinant", "[modular]") {
  const PrimeField field(10007);
  const std::vector<std::vector<std::int64_t>> shapes = {{5},
                                                         {0},
                                                         {0, 0},
                                                         {3, 0},
                                                         {1, 1},
                                                         {-1, 1},
                                                         {0, 1},
                                                         {2, 3, 0},
                                                         {1, 0, 0, 0},
                                                         {1, 0, 0, 1},
                                                         {-1, 0, 1},
                                                         {1, 2, 1},
                                                         {0, 0, 1},
                                                         {6, 5, 1},
                                                         {0, 0, 0},
                                                         {1, 0, 1, 0},
                                                         {4, 4, 1, 0},
                                                         {1, 1, 1, 1, 1},
                                                         {2, 0, 0, 0, 0, 7}};
  for (const auto& a : shapes)
    for (const auto& b : shapes) {
      const auto f = residues(field, a);
      const auto g = residues(field, b);
      INFO("sizes " << a.size() << ' ' << b.size() << ", first coefficients " << a[0] << ' ' << b[0]);
      CHECK(resultant(field, f, g) == sylvester_determinant(field, f, g));
    }
  CHECK_THROWS_AS(resultant(field, {}, residues(field, {1})), std::invalid_argument);
}

TEST_CASE("modular resultant equals Sylvester's determinant on random polynomials", "[modular]") {
  const unsigned seed = 20240611;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  for (const std::uint64_t p : {std::uint64_t{3}, std::uint64_t{5}, prime_below(prime_field_limit)}) {
    const PrimeField field(p);
    for (int repeat = 0; repeat < 200; ++repeat) {
      std::vector<Residue> f(1 + random() % 8);
      std::vector<Residue> g(1 + random() % 8);
      for (auto& c : f) c = random() % p;
      for (auto& c : g) c = random() % p;
      CHECK(resultant(field, f, g) == sylvester_determinant(field, f, g));
    }
  }
}

TEST_CASE("interpolate recovers the polynomial that was evaluated", "[modular]") {
  std::mt19937_64 random(5);
  for (const std::uint64_t p : {std::uint64_t{7}, std::uint64_t{131}, prime_below(prime_field_limit)}) {
    const PrimeField field(p);
    for (const std::size_t n : {0, 1, 2, 3, 7, 129}) {
      if (n > p) {
        CHECK_THROWS_AS(interpolate(field, 0, std::vector<Residue>(n, 0)), std::invalid_argument);
        continue;
      }
      for (const Residue first : {Residue{0}, field.residue(std::int64_t{-64}), random() % p}) {
        std::vector<Residue> f(n);
        for (auto& c : f) c = random() % p;
        std::vector<Residue> values;
        Residue t = first;
        for (std::size_t i = 0; i < n; ++i, t = field.add(t, field.one()))
          values.push_back(evaluate(field, f, t));
        INFO("p " << p << ", n " << n << ", first " << first);
        CHECK(interpolate(field, first, values) == f);
      }
    }
  }
}

TEST_CASE("chinese_remainder recovers integers of both signs up to half the product", "[modular]") {
  std::vector<std::uint64_t> primes;
  std::uint64_t p = prime_field_limit;
  for (const std::size_t count : {1, 2, 5, 40}) {
    while (primes.size() < count) primes.push_back(p = prime_below(p));
    Integer product = 1;
    for (const auto q : primes) product *= q;
    const std::vector<Integer> integers = {0, 1, -1, product / 2, -(product / 2), product / 3, -(product / 5),
                                           42};
    std::vector<std::vector<std::uint64_t>> table;
    for (const auto q : primes) {
      const PrimeField field(q);
      table.emplace_back();
      for (const auto& a : integers) table.back().push_back(field.representative(field.residue(a)));
    }
    CHECK(chinese_remainder({primes, table}) == integers);
  }
}

TEST_CASE("leading_parts encloses what chinese_remainder recovers", "[modular]") {
  std::mt19937_64 random(17);
  for (const std::uint64_t limit : {prime_field_limit, std::uint64_t{1} << 48, std::uint64_t{1} << 10}) {
    ModularIntegers integers;
    std::uint64_t p = limit;
    Integer product = 1;
    for (const std::size_t count : {1, 2, 9, 50}) {
      while (integers.primes.size() < count) {
        integers.primes.push_back(p = prime_below(p));
        product *= p;
      }
      const Integer most = product / 4 - 1;
      std::vector<Integer> values = {0, 1, -1, most, -most, product / 7, -(product / 9)};
      for (int i = 0; i < 20; ++i) values.push_back(most / (1 + random() % 1000) * (i % 2 == 0 ? 1 : -1));
      integers.residues.clear();
      for (const std::uint64_t q : integers.primes) {
        const PrimeField field(q);
        integers.residues.emplace_back();
        for (const Integer& a : values)
          integers.residues.back().push_back(field.representative(field.residue(a)));
      }
      for (const std::size_t limbs : {2, 3, 20}) {
        INFO("limit " << limit << ", " << count << " primes, " << limbs << " limbs");
        const LeadingParts parts = leading_parts(integers, 64 * limbs - 5);
        REQUIRE(parts.leading.size() == values.size());
        CHECK(parts.error <= Integer(limit) * count);
        for (std::size_t i = 0; i < values.size(); ++i) {
          const Integer scaled = values[i] << static_cast<unsigned>(64 * limbs);
          CHECK(abs(scaled - parts.leading[i] * product) <= parts.error * product);
        }
      }
    }
  }
  CHECK_THROWS_AS(leading_parts({{3, 5}, {{1}}}, 64), std::invalid_argument);
}

TEST_CASE("chinese_remainder refuses wrong shapes", "[modular]") {
  CHECK_THROWS_AS(chinese_remainder({{}, {}}), std::invalid_argument);
  CHECK_THROWS_AS(chinese_remainder({{3, 5}, {{1}}}), std::invalid_argument);
  CHECK_THROWS_AS(chinese_remainder({{3, 5}, {{1}, {1, 2}}}), std::invalid_argument);
  CHECK_THROWS_AS(chinese_remainder({{5, 5}, {{1}, {1}}}), std::invalid_argument);
  CHECK(chinese_remainder({{3, 5}, {{}, {}}}).empty());
  CHECK(chinese_remainder({{3, 5}, {{2}, {3}}}) == std::vector<Integer>{-7});
}

namespace {

ModularValues values_of(const std::vector<Integer>& coefficients) {
  return [&coefficients](const PrimeField& field, Residue first, std::size_t count) {
    std::vector<Residue> f;
    for (const auto& c : coefficients) f.push_back(field.residue(c));
    std::vector<ResidueFraction> result;
    for (std::size_t i = 0; i < count; ++i, first = field.add(first, field.one()))
      result.push_back(
          {field.multiply(evaluate(field, f, first), field.add(first, first)), field.add(first, first)});
    return result;
  };
}

}  // namespace

TEST_CASE("interpolate_integer_polynomial recovers coefficients just below the bound", "[modular]") {
  for (const unsigned bits : {1U, 10U, 58U, 59U, 117U, 118U, 1000U}) {
    INFO("bits " << bits);
    const Integer largest = (Integer(1) << bits) - 1;
    const std::vector<Integer> f = {largest, -largest, 0, 1, -largest, largest};
    CHECK(interpolate_integer_polynomial(5, bits, values_of(f)) == f);
    auto with_zeros = f;
    with_zeros.resize(8, Integer(0));
    CHECK(interpolate_integer_polynomial(7, bits, values_of(f)) == with_zeros);
    CHECK_THROWS_AS(interpolate_integer_polynomial(4, bits, values_of(f)), std::logic_error);
  }
}

TEST_CASE("interpolate_integer_polynomial leaves out primes where a value is undefined", "[modular]") {
  const std::vector<Integer> f = {3, -4, (Integer(1) << 199) + 1};
  const auto values = values_of(f);
  int calls = 0;
  const auto sometimes = [&](const PrimeField& field, Residue first, std::size_t count) {
    auto result = values(field, first, count);
    if (calls++ % 2 == 0) result.back() = {1, 0};
    return result;
  };
  CHECK(interpolate_integer_polynomial(2, 200, sometimes) == f);
}

}  // namespace exsect::modular_test
