#include "integer_pair.h"

namespace exsect {

namespace {

template <class Function>
void for_each_coefficient(const Function& function) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) function(i, j);
}

}  // namespace

IntegerPair integer_pair(const BezierPatch& x, const BezierPatch& y) {
  const ControlNet a = x.power_basis();
  ControlNet b = y.power_basis();
  b[0][0] = b[0][0] - a[0][0];
  IntegerPair result;
  for (std::size_t k = 0; k < 3; ++k) {
    Integer denominator = 1;
    for_each_coefficient([&](std::size_t i, std::size_t j) {
      if (i + j != 0) denominator = lcm(denominator, Integer(boost::multiprecision::denominator(a[i][j][k])));
      denominator = lcm(denominator, Integer(boost::multiprecision::denominator(b[i][j][k])));
    });
    const auto integer = [&](const Rational& q) {
      return Integer(boost::multiprecision::numerator(q) *
                     (denominator / boost::multiprecision::denominator(q)));
    };
    Integer content = 0;
    for_each_coefficient([&](std::size_t i, std::size_t j) {
      result.x[i][j][k] = i + j == 0 ? Integer(0) : integer(a[i][j][k]);
      result.y[i][j][k] = integer(b[i][j][k]);
      content = gcd(content, gcd(result.x[i][j][k], result.y[i][j][k]));
    });
    if (content == 0) continue;
    for_each_coefficient([&](std::size_t i, std::size_t j) {
      result.x[i][j][k] /= content;
      result.y[i][j][k] /= content;
    });
  }
  return result;
}

}  // namespace exsect
