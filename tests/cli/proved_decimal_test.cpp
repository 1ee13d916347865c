#include "output/text/proved_decimal.h"

#include <exsect/geometry/number.h>

#include <random>

#include "support/catch.h"

namespace exsect::cli::proved_decimal_test {
namespace {

Rational number(const char* text) { return parse_number(text); }

std::string shown(const char* lower, const char* upper, long finest = -6, long scale = 0) {
  return proved_decimal({number(lower), number(upper)}, finest, scale);
}

/// What the last digit of a decimal stands for: 1/100 of "0.12", 10^298 of "-1.23e+300".
Rational last_digit(const std::string& text) {
  const std::size_t e = text.find('e');
  const std::string digits = text.substr(0, e);
  const std::size_t point = digits.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : digits.size() - point - 1;
  Rational unit = e == std::string::npos ? Rational(1) : number(("1" + text.substr(e)).c_str());
  for (std::size_t i = 0; i < decimals; ++i) unit /= 10;
  return unit;
}

/// The contract, checked by the text alone: both ends are within half a unit of the last digit shown; an
/// interval in brackets contains the one that it stands for.
void check_contract(const RationalInterval& interval, long finest, long scale) {
  const std::string text = proved_decimal(interval, finest, scale);
  INFO("[" << to_string(interval.lower) << ", " << to_string(interval.upper) << "] down to 10^" << finest
           << ", scale 10^" << scale << ": " << text);
  if (text.front() == '[') {
    const std::size_t comma = text.find(", ");
    CHECK(number(text.substr(1, comma - 1).c_str()) <= interval.lower);
    CHECK(number(text.substr(comma + 2, text.size() - comma - 3).c_str()) >= interval.upper);
    return;
  }
  const Rational value = number(text.c_str());
  if (interval.lower == interval.upper && value == interval.lower) return;
  const Rational half = last_digit(text) / 2;
  CHECK(abs(Rational(interval.lower - value)) <= half);
  CHECK(abs(Rational(interval.upper - value)) <= half);
}

TEST_CASE("digits: a wide interval shows the few that all of its numbers share") {
  CHECK(shown("0.12345678", "0.12345679") == "0.123457");
  CHECK(shown("0.1234", "0.1236") == "[0.1234, 0.1236]");  // 0.123 and 0.124; 0.12 would be true, and little
  CHECK(shown("0.12341", "0.12349") == "0.123");
  CHECK(shown("0.1", "0.9") == "[0.1, 0.9]");
  CHECK(shown("0.12345678", "0.57") == "[0.12, 0.57]");
}

TEST_CASE("digits: an interval across a power of ten") {
  CHECK(shown("0.09999999", "0.10000001") == "0.100000");
  CHECK(shown("0.99999999", "1") == "1.000000");
  CHECK(shown("9.9999999", "10.0000001", -5, 1) == "10.00000");
  CHECK(shown("0.0999", "0.1001") == "0.100");
}

TEST_CASE("digits: half way between two decimals either is true, around it neither") {
  CHECK(shown("0.1234565", "0.1234565") == "0.123457");
  CHECK(shown("0.1234564", "0.1234566") == "0.12346");
}

TEST_CASE("digits: negative numbers, and zero inside") {
  CHECK(shown("-0.12345679", "-0.12345678") == "-0.123457");
  CHECK(shown("-1/10000000000", "1/10000000000") == "0.000000");
  CHECK(shown("-0.1", "0.2") == "[-0.1, 0.2]");
  CHECK(shown("-1/10000000000", "-1/20000000000") == "0.000000");
}

TEST_CASE("digits: one point is shown as it is, if it is short") {
  CHECK(shown("0", "0") == "0");
  CHECK(shown("1", "1") == "1");
  CHECK(shown("3/4", "3/4") == "0.75");
  CHECK(shown("17/24", "17/24") == "17/24");
  CHECK(shown("-1/3", "-1/3") == "-1/3");
  CHECK(shown("100", "100", -4, 2) == "100");
  CHECK(shown("100000000", "100000000", 2, 8) == "100000000");
  CHECK(shown("12345678901/98765432101", "12345678901/98765432101") == "0.125000");
  CHECK(shown("0x1.999999999999ap-4", "0x1.999999999999ap-4") == "0.100000");
}

TEST_CASE("digits: huge and tiny numbers have a power of ten") {
  CHECK(shown("1.23456789e300", "1.23456789001e300", 294, 300) == "1.234568e+300");
  CHECK(shown("1e300", "1e300", 294, 300) == "1e+300");
  CHECK(shown("-1.5e-300", "-1.5e-300", -306, -300) == "-1.5e-300");
  CHECK(shown("-1e-310", "1e-310", -306, -300) == "0e-306");
  CHECK(shown("1e300", "2e300", 294, 300) == "[1e+300, 2e+300]");
  CHECK(shown("123456789.43", "123456789.43", 2, 8) == "1.234568e+08");
  CHECK(shown("25.4e9", "25.4e9", 4, 10) == "2.54e+10");
}

TEST_CASE("digits: what is no interval and a last digit above the scale are refused") {
  CHECK_THROWS_AS(proved_decimal({1, 0}, -6), std::invalid_argument);
  CHECK_THROWS_AS(proved_decimal({0, 1}, 0, 0), std::invalid_argument);
  CHECK_THROWS_AS(decimal_exponent(0), std::invalid_argument);
}

TEST_CASE("the power of ten below a number") {
  CHECK(decimal_exponent(1) == 0);
  CHECK(decimal_exponent(number("999999/1000000")) == -1);
  CHECK(decimal_exponent(number("-1000")) == 3);
  CHECK(decimal_exponent(number("1/3")) == -1);
  CHECK(decimal_exponent(number("1e-300")) == -300);
  CHECK(decimal_exponent(number("9.99e2999")) == 2999);
}

TEST_CASE("digits: random intervals of any place and width keep the contract") {
  const unsigned seed = 20261123;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  const auto draw = [&](long least, long greatest) {
    return std::uniform_int_distribution<long>(least, greatest)(random);
  };
  for (int i = 0; i < 3000; ++i) {
    const long scale = i % 3 == 0 ? 0 : draw(-300, 300);
    const long finest = scale - draw(1, 16);
    const Rational unit = number(("1e" + std::to_string(scale)).c_str());
    const Rational middle = unit * Rational(draw(-1000000000, 1000000000), draw(1, 9) * 1000000000);
    const Rational radius =
        unit * number(("1e" + std::to_string(-draw(0, 18))).c_str()) * Rational(draw(0, 7), 3);
    check_contract({middle - radius, middle + radius}, finest, scale);
  }
}

TEST_CASE("digits: one more digit than is shown is not true of the whole interval") {
  const unsigned seed = 7;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 1000; ++i) {
    const double middle = std::uniform_real_distribution<double>(0.1, 1)(random);
    const double radius = std::pow(10, std::uniform_real_distribution<double>(-9, -4)(random));
    const RationalInterval interval = {from_double(middle - radius), from_double(middle + radius)};
    const std::string text = proved_decimal(interval, -6);
    if (text.front() == '[' || text.size() == 8) continue;  // "0.123456" has as many as are asked for
    const Rational unit = last_digit(text) / 10;
    const auto rounded = [&](const Rational& q) {
      const Rational units = q / unit + Rational(1, 2);
      return Integer(numerator(units) / denominator(units));
    };
    INFO(middle << " +- " << radius << ": " << text);
    CHECK(rounded(interval.lower) != rounded(interval.upper));
  }
}

}  // namespace
}  // namespace exsect::cli::proved_decimal_test
