#include "root_gap.h"

#include <algorithm>
#include <vector>

namespace exsect {
namespace {

/// |c| < 2^size and, but for c = 0, |c| >= 2^(size - 1).
long size_of(const fmpz_t c) { return static_cast<long>(fmpz_bits(c)); }

}  // namespace

long root_free_depth(const fmpz_poly_t f, long depth) {
  const slong length = f->length;
  std::vector<long> size;
  for (slong i = 0; i < length; ++i) size.push_back(size_of(f->coeffs + i));
  const auto size_at = [&](slong i) { return size[static_cast<std::size_t>(i)]; };
  const auto is_zero = [&](slong i) { return fmpz_is_zero(f->coeffs + i) != 0; };
  slong greatest = length - 1;
  for (slong i = length - 2; i >= 0; --i)
    if (!is_zero(i) && size_at(i) - depth * i > size_at(greatest) - depth * greatest) greatest = i;
  // Any other term is below 2^-slack of this one, hence their sum below it, wherever it is for x = 2^-depth
  // and a greater power of x, or for x = 2^-k and a smaller one.
  const long slack = 1 + static_cast<long>(FLINT_BIT_COUNT(static_cast<ulong>(length)));
  const long term = size_at(greatest) - slack;
  for (slong i = greatest + 1; i < length; ++i)
    if (!is_zero(i) && size_at(i) - depth * (i - greatest) > term) return depth;
  long k = kNoRoot;
  for (slong i = 0; i < greatest; ++i) {
    if (is_zero(i)) continue;
    if (size_at(i) > term) return depth;
    k = std::min(k, (term - size_at(i)) / (greatest - i));
  }
  return std::max(k, depth);
}

}  // namespace exsect
