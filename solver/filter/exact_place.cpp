#include "filter/exact_place.h"

#include <exsect/algebra/common_field.h>
#include <exsect/algebra/rational_matrix.h>

#include <algorithm>

#include "filter/common_normal.h"
#include "filter/exact_taylor.h"
#include "filter/second_order.h"

namespace exsect::filter {

namespace {

using LongPlace = std::array<Rational, 4>;

/// Parameters are known to so many bits: more where fewer are not enough for the digits of the field.
constexpr std::array<int, 3> kPlaceBits = {320, 1280, 3200};
constexpr int kGuardDigits = 64;
constexpr int kMostPlaceSteps = 16;

/// To about `bits` significant bits.
Rational with_bits(const Rational& q, long bits) {
  if (q == 0) return q;
  const long exponent =
      static_cast<long>(msb(Integer(abs(numerator(q))))) - static_cast<long>(msb(denominator(q)));
  const Rational scaled = q * power_of_two(bits - exponent);
  return Rational(Integer(numerator(scaled) / denominator(scaled))) * power_of_two(exponent - bits);
}
Point with_bits(const Point& p, long bits) {
  return {with_bits(p[0], bits), with_bits(p[1], bits), with_bits(p[2], bits)};
}

template <class K>
ExactSecondOrder long_second_order(const ExactPatch<K>& patch, const Rational& u, const Rational& v,
                                   long bits) {
  const auto c = exact_taylor<K>(patch, LongBall::enclosing(u), LongBall::enclosing(v));
  ExactTaylor<K> rounded;
  for (std::size_t i = 0; i < K::side; ++i)
    for (std::size_t j = 0; i + j <= 2 && j < K::side; ++j)
      for (std::size_t k = 0; k < K::rows; ++k)
        rounded[K::side * i + j][k] = with_bits(c[K::side * i + j][k].interval().midpoint(), bits);
  const ExactSecondOrder x = in_space<K>(rounded);
  return {with_bits(x.value, bits), with_bits(x.u, bits),  with_bits(x.v, bits),
          with_bits(x.uu, bits),    with_bits(x.uv, bits), with_bits(x.vv, bits)};
}

/// The step of Newton's method, as in filter::common_normal; empty if it is not determined.
std::optional<std::vector<Rational>> newton_step(const ExactSecondOrder& x, const ExactSecondOrder& y,
                                                 long bits) {
  const auto equations = common_normal_equations<Rational>(x, y);
  RationalMatrix matrix(4, 4);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) matrix(i, j) = with_bits(equations.jacobian[i][j], bits);
  return solve(matrix, {equations.value.begin(), equations.value.end()});
}

/// Replaces w by the place to about `bits` bits; false if Newton's method does not lead there, or the patches
/// are apart by more than the error.
template <class K>
bool refine_place(const ExactPatch<K>& x, const ExactPatch<K>& y, LongPlace& w, int bits) {
  const long digits = bits + kGuardDigits;
  Rational size = 1;
  for (int step = 0; step < kMostPlaceSteps; ++step) {
    const ExactSecondOrder at_x = long_second_order<K>(x, w[0], w[1], digits);
    const ExactSecondOrder at_y = long_second_order<K>(y, w[2], w[3], digits);
    if (size < power_of_two(-bits / 2)) {
      using exsect::operator-, exsect::dot;
      const Point gap = at_x.value - at_y.value;
      return dot(gap, gap) <= dot(at_y.u, at_y.u) * power_of_two(-3 * bits / 2);
    }
    const auto change = newton_step(at_x, at_y, digits);
    if (!change) return false;
    size = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      w[j] = with_bits(w[j] - (*change)[j], digits);
      size = std::max<Rational>(size, abs((*change)[j]));
    }
    if (size > Rational(1, 4)) return false;
  }
  return false;
}

}  // namespace

template <class K>
std::optional<std::array<FieldNumber, 4>> exact_place(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                      const Vec4& w) {
  LongPlace place;
  for (std::size_t j = 0; j < 4; ++j) place[j] = from_double(w[j]) + Rational(1, 2);
  for (const int bits : kPlaceBits) {
    if (!refine_place<K>(x, y, place, bits)) return std::nullopt;
    const auto numbers = recognised_in_field({place.begin(), place.end()}, bits, kMostFieldDegree);
    if (numbers) return std::array{(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
  }
  return std::nullopt;
}

#define EXSECT_INSTANTIATE(K)                                                             \
  template std::optional<std::array<FieldNumber, 4>> exact_place<K>(const ExactPatch<K>&, \
                                                                    const ExactPatch<K>&, const Vec4&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
