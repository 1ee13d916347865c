#include "output/text/proved_decimal.h"

#include <exsect/geometry/number.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace exsect::cli {
namespace {

Rational power_of_ten(long k) {
  const Integer power = pow(Integer(10), static_cast<unsigned>(std::labs(k)));
  return k >= 0 ? Rational(power) : Rational(Integer(1), power);
}

/// The largest integer that is not above q.
Integer floor_of(const Rational& q) {
  const Integer quotient = numerator(q) / denominator(q);  // towards zero
  return q < quotient ? Integer(quotient - 1) : quotient;
}

/// How numbers of one scale are written.
bool is_plain(long scale) { return scale >= -4 && scale < 9; }

/// n * 10^k with all its digits, those of a plain number from its decimal point on.
std::string plain(const Integer& n, long k) {
  std::string digits = Integer(abs(n)).str();
  if (k > 0) {
    if (n != 0) digits.append(static_cast<std::size_t>(k), '0');
  } else if (k < 0) {
    const auto decimals = static_cast<std::size_t>(-k);
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, ".");
  }
  return (n < 0 ? "-" : "") + digits;
}

std::string scientific(const Integer& n, long k) {
  std::string digits = Integer(abs(n)).str();
  const long exponent = k + static_cast<long>(digits.size()) - 1;
  if (digits.size() > 1) digits.insert(1, ".");
  const std::string size = std::to_string(std::labs(exponent));
  return (n < 0 ? "-" : "") + digits + (exponent < 0 ? "e-" : "e+") + (size.size() < 2 ? "0" : "") + size;
}

/// No zeros are added that would look proved.
std::string proved_text(const Integer& n, long k, long scale) {
  return is_plain(scale) && k <= 0 ? plain(n, k) : scientific(n, k);
}

std::string without_zeros(Integer n, long k, long scale) {
  if (n == 0) return "0";
  while ((!is_plain(scale) || k < 0) && n % 10 == 0) {
    n /= 10;
    ++k;
  }
  return is_plain(scale) ? plain(n, k) : scientific(n, k);
}

/// The value as it is, if that is short; else "".
std::string exact(const Rational& value, long finest, long scale) {
  const Rational multiple = value * power_of_ten(-finest);
  if (denominator(multiple) == 1) return without_zeros(numerator(multiple), finest, scale);
  constexpr std::size_t longest_fraction = 12;
  const std::string fraction = to_string(value);
  return is_plain(scale) && fraction.size() <= longest_fraction ? fraction : "";
}

}  // namespace

long decimal_exponent(const Rational& q) {
  if (q == 0) throw std::invalid_argument("decimal_exponent: of zero");
  const auto digits = [](const Integer& n) { return static_cast<long>(Integer(abs(n)).str().size()); };
  const long above = digits(numerator(q)) - digits(denominator(q));  // 10^(above-1) < |q| < 10^(above+1)
  return abs(q) >= power_of_ten(above) ? above : above - 1;
}

std::string outward_decimal(const RationalInterval& interval, long finest, long scale) {
  const Rational units = power_of_ten(-finest);
  return "[" + without_zeros(floor_of(interval.lower * units), finest, scale) + ", " +
         without_zeros(-floor_of(-interval.upper * units), finest, scale) + "]";
}

std::string proved_decimal(const RationalInterval& interval, long finest, long scale) {
  if (interval.lower > interval.upper || finest >= scale)
    throw std::invalid_argument("proved_decimal: an interval and a last digit below its scale are needed");
  if (interval.lower == interval.upper) {
    const std::string text = exact(interval.lower, finest, scale);
    if (!text.empty()) return text;
  }
  constexpr long fewest_digits = 3;
  const Rational half(1, 2);
  for (long k = finest; k <= std::max(finest, scale - fewest_digits); ++k) {
    const Rational units = power_of_ten(-k);
    const Integer nearest = floor_of(interval.midpoint() * units + half);
    if (interval.lower * units >= nearest - half && interval.upper * units <= nearest + half)
      return proved_text(nearest, k, scale);
  }
  return outward_decimal(interval, std::max(finest, decimal_exponent(interval.width()) - 1), scale);
}

}  // namespace exsect::cli
