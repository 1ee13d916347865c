#include "number.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace exsect {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_hex_digit(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// digits must be digits of the base; leading zeros allowed (Boost's own reader would take them for octal).
Integer integer_from(const std::string& digits, int base) {
  Integer result;
  mpz_set_str(result.backend().data(), digits.c_str(), base);
  return result;
}

/// Reads one number from left to right; every failure names the text and the reason.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  struct Number {
    Rational value;
    bool decimal;  // neither a fraction of integers nor hexadecimal
  };

  Number scan() {
    if (text_.size() > max_number_length)
      fail("longer than " + std::to_string(max_number_length) + " characters");
    const bool negative = sign();
    const bool hexadecimal = text_.substr(at_, 2) == "0x" || text_.substr(at_, 2) == "0X";
    Number number = hexadecimal ? Number{scan_hexadecimal(), false} : scan_fraction_or_decimal();
    if (at_ != text_.size()) fail("unexpected character at position " + std::to_string(at_ + 1));
    if (too_long(numerator(number.value)) || too_long(denominator(number.value)))
      fail("numerator or denominator of more than " + std::to_string(max_number_digits) + " digits");
    if (negative) number.value = -number.value;
    return number;
  }

  [[noreturn]] void fail(const std::string& reason) const {
    constexpr std::size_t shown = 40;
    std::string start(text_.substr(0, shown));
    for (char& c : start)
      if (c < ' ' || c > '~') c = '?';
    throw std::invalid_argument("\"" + start + (text_.size() > shown ? "...\"" : "\"") +
                                " is not a number: " + reason);
  }

 private:
  bool accept(char lower, char upper) {
    if (at_ == text_.size() || (text_[at_] != lower && text_[at_] != upper)) return false;
    ++at_;
    return true;
  }

  bool sign() {
    if (accept('-', '-')) return true;
    accept('+', '+');
    return false;
  }

  std::string digits(bool (*belongs)(char)) {
    const std::size_t start = at_;
    while (at_ != text_.size() && belongs(text_[at_])) ++at_;
    if (at_ == start) fail("digit expected at position " + std::to_string(at_ + 1));
    return std::string(text_.substr(start, at_ - start));
  }

  /// [sign] digits, at most max_number_exponent in magnitude.
  int exponent() {
    const bool negative = sign();
    const Integer magnitude = integer_from(digits(is_digit), 10);
    if (magnitude > max_number_exponent)
      fail("exponent beyond " + std::to_string(max_number_exponent) + " in magnitude");
    return negative ? -magnitude.convert_to<int>() : magnitude.convert_to<int>();
  }

  Number scan_fraction_or_decimal() {
    std::string mantissa = digits(is_digit);
    if (accept('/', '/')) {
      const Integer denominator = integer_from(digits(is_digit), 10);
      if (denominator.is_zero()) fail("zero denominator");
      return {Rational(integer_from(mantissa, 10), denominator), false};
    }
    long scale = 0;
    if (accept('.', '.')) {
      const std::string fraction = digits(is_digit);
      mantissa += fraction;
      scale = -static_cast<long>(fraction.size());
    }
    if (accept('e', 'E')) scale += exponent();
    const Integer power = pow(Integer(10), static_cast<unsigned>(std::labs(scale)));
    const Integer m = integer_from(mantissa, 10);
    return {scale < 0 ? Rational(m, power) : Rational(m * power), true};
  }

  Rational scan_hexadecimal() {
    at_ += 2;
    std::string mantissa = digits(is_hex_digit);
    long scale = 0;
    if (accept('.', '.')) {
      const std::string fraction = digits(is_hex_digit);
      mantissa += fraction;
      scale = -4 * static_cast<long>(fraction.size());
    }
    if (!accept('p', 'P')) fail("a hexadecimal number needs a binary exponent, as in 0x1.8p-3");
    scale += exponent();
    return Rational(integer_from(mantissa, 16)) * power_of_two(scale);
  }

  static bool too_long(const Integer& n) {
    static const Integer limit = pow(Integer(10), static_cast<unsigned>(max_number_digits));
    return n >= limit;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

Rational parse_number(std::string_view text) { return Scanner(text).scan().value; }

Rational parse_binary64(std::string_view text) {
  Scanner scanner(text);
  const Scanner::Number number = scanner.scan();
  if (!number.decimal) return number.value;
  const double nearest = to_double(number.value);
  if (std::isinf(nearest)) scanner.fail("beyond the range of binary64");
  return from_double(nearest);
}

std::string to_string(const Rational& q) { return q.str(); }

}  // namespace exsect
