#include "chebyshev.h"

#include <cstddef>
#include <stdexcept>

#include "flint.h"

namespace exsect {

ChebyshevNodes::ChebyshevNodes(std::size_t n) : size_(n), cosines_(4 * n) {
  if (n == 0) throw std::invalid_argument("no Chebyshev nodes");
  constexpr slong bits = 320;
  arb_t cosine;
  arb_init(cosine);
  for (std::size_t m = 0; m <= 2 * n; ++m) {
    FlintRational angle;
    fmpq_set_si(angle.value, static_cast<slong>(m), static_cast<ulong>(2 * n));
    arb_cos_pi_fmpq(cosine, angle.value, bits);
    FlintInteger mantissa, exponent;
    arf_get_fmpz_2exp(mantissa.value, exponent.value, arb_midref(cosine));
    cosines_[m] = WideBall::enclosing(mantissa.to_integer(), fmpz_get_si(exponent.value))
                      .widened(mag_get_d(arb_radref(cosine)));
    if (m > 0 && m < 2 * n) cosines_[4 * n - m] = cosines_[m];
  }
  arb_clear(cosine);
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
