#include "chebyshev.h"

#include <array>
#include <cstddef>
#include <stdexcept>

#include "flint.h"

namespace exsect {

namespace {

struct Direction {
  WideBall cosine;
  WideBall sine;
};

WideBall wide_ball(const arb_struct* x) {
  FlintInteger mantissa, exponent;
  arf_get_fmpz_2exp(mantissa.value, exponent.value, arb_midref(x));
  return WideBall::enclosing(mantissa.to_integer(), fmpz_get_si(exponent.value))
      .widened(mag_get_d(arb_radref(x)));
}

/// Of the angle pi p / q.
Direction direction(std::size_t p, std::size_t q) {
  constexpr slong bits = 320;
  FlintRational angle;
  fmpq_set_si(angle.value, static_cast<slong>(p), static_cast<ulong>(q));
  arb_t cosine, sine;
  arb_init(cosine);
  arb_init(sine);
  arb_sin_cos_pi_fmpq(sine, cosine, angle.value, bits);
  const Direction result = {wide_ball(cosine), wide_ball(sine)};
  arb_clear(cosine);
  arb_clear(sine);
  return result;
}

}  // namespace

/// Of the multiples of pi / 2n, every 16th and the first 15 by Arb, the others by the cosine of a sum.
ChebyshevNodes::ChebyshevNodes(std::size_t n) : size_(n), cosines_(4 * n) {
  if (n == 0) throw std::invalid_argument("no Chebyshev nodes");
  constexpr std::size_t step = 16;
  std::array<Direction, step> small;
  for (std::size_t m = 0; m < step; ++m) small[m] = direction(m, 2 * n);
  Direction large;
  for (std::size_t m = 0; m <= 2 * n; ++m) {
    if (m % step == 0) large = direction(m, 2 * n);
    const Direction& rest = small[m % step];
    WideBall::Sum sum(large.cosine, rest.cosine);
    sum.add(-large.sine, rest.sine);
    cosines_[m] = sum.rounded();
    if (m > 0 && m < 2 * n) cosines_[4 * n - m] = cosines_[m];
  }
}

std::vector<WideBall> ChebyshevNodes::coefficients(const std::vector<WideBall>& values) const {
  if (values.size() != size_) throw std::invalid_argument("a value for each Chebyshev node");
  // The sums over k and n - 1 - k, where T_j has the same value up to the sign (-1)^j.
  const std::size_t half = (size_ + 1) / 2;
  std::vector<WideBall> even(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half)), odd = even;
  for (std::size_t k = 0; k < size_ / 2; ++k) {
    even[k] = values[k] + values[size_ - 1 - k];
    odd[k] = values[k] - values[size_ - 1 - k];
  }
  const WideBall over_n = inverse(WideBall(static_cast<double>(size_)));
  std::vector<WideBall> c(size_);
  for (std::size_t j = 0; j < size_; ++j) {
    WideBall::Sum sum;
    for (std::size_t k = 0; k < half; ++k) sum.add((j % 2 == 0 ? even : odd)[k], value(j, k));
    c[j] = scaled(sum.rounded() * over_n, j == 0 ? 0 : 1);
  }
  return c;
}

}  // namespace exsect
