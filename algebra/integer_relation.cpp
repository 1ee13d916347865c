#include "integer_relation.h"

#include <algorithm>

#include "flint.h"

// after flint.h, which includes what this needs
#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>

namespace exsect {

namespace {

struct Lattice {
  fmpz_mat_t rows;
  Lattice(std::size_t n, std::size_t m) { fmpz_mat_init(rows, static_cast<slong>(n), static_cast<slong>(m)); }
  ~Lattice() { fmpz_mat_clear(rows); }
  Lattice(const Lattice&) = delete;
  Lattice& operator=(const Lattice&) = delete;

  fmpz* entry(std::size_t i, std::size_t j) {
    return fmpz_mat_entry(rows, static_cast<slong>(i), static_cast<slong>(j));
  }
  void reduce() {
    fmpz_lll_t parameters;
    fmpz_lll_context_init_default(parameters);
    fmpz_lll(rows, nullptr, parameters);
  }
};

}  // namespace

std::optional<std::vector<Integer>> integer_relation(const std::vector<Rational>& values, int bits) {
  const std::size_t n = values.size();
  Lattice lattice(n, n + 1);  // the vectors (c, 2^bits Σ c_i v_i)
  for (std::size_t i = 0; i < n; ++i) {
    const Rational scaled = values[i] * power_of_two(bits);
    fmpz_one(lattice.entry(i, i));
    const FlintInteger rounded(Integer(numerator(scaled) / denominator(scaled)));
    fmpz_set(lattice.entry(i, n), rounded.value);
  }
  lattice.reduce();
  std::vector<Integer> relation;
  for (std::size_t i = 0; i < n; ++i) {
    FlintInteger c;
    fmpz_set(c.value, lattice.entry(0, i));
    relation.push_back(c.to_integer());
  }
  // Without a relation the shortest vectors have about bits / n bits in every component.
  const Integer most = Integer(1) << static_cast<unsigned>(bits) / static_cast<unsigned>(2 * n);
  const auto is_short = [&](const Integer& c) { return abs(c) < most; };
  if (!std::all_of(relation.begin(), relation.end(), is_short)) return std::nullopt;
  if (std::all_of(relation.begin(), relation.end(), [](const Integer& c) { return c == 0; }))
    return std::nullopt;
  return relation;
}

}  // namespace exsect
