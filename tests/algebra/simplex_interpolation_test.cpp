#include <exsect/algebra/simplex_interpolation.h>

#include <random>

#include "support/catch.h"

namespace exsect::simplex_interpolation_test {
namespace {

Residue value(const PrimeField& field, const SimplexTable& f, Residue x, Residue y, Residue z) {
  Residue sum = field.zero();
  for (int i = 0; i <= f.degree(); ++i)
    for (int j = 0; i + j <= f.degree(); ++j)
      for (int k = 0; i + j + k <= f.degree(); ++k) {
        Residue term = f(i, j, k);
        for (int m = 0; m < i; ++m) term = field.multiply(term, x);
        for (int m = 0; m < j; ++m) term = field.multiply(term, y);
        for (int m = 0; m < k; ++m) term = field.multiply(term, z);
        sum = field.add(sum, term);
      }
  return sum;
}

TEST_CASE("polynomials in three variables are found from their values") {
  const std::uint64_t seed = 20260105;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  for (const std::uint64_t p : {std::uint64_t{11}, prime_below(prime_field_limit)}) {
    const PrimeField field(p);
    for (int degree = 0; degree <= 8; ++degree) {
      SimplexTable wanted(degree), values(degree);
      CHECK(wanted.elements().size() ==
            static_cast<std::size_t>((degree + 1) * (degree + 2) * (degree + 3) / 6));
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j)
          for (int k = 0; i + j + k <= degree; ++k)
            wanted(i, j, k) = field.residue(static_cast<std::int64_t>(random() >> 2));
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j)
          for (int k = 0; i + j + k <= degree; ++k)
            values(i, j, k) = value(field, wanted, field.residue(i), field.residue(j), field.residue(k));
      CHECK(interpolate(field, values).elements() == wanted.elements());
    }
  }
  CHECK_THROWS_AS(interpolate(PrimeField(7), SimplexTable(8)), std::invalid_argument);
}

}  // namespace
}  // namespace exsect::simplex_interpolation_test
