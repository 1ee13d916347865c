#include <exsect/geometry/number.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.h"

namespace exsect::number_test {

namespace {

std::string repeated(char c, std::size_t n) { return std::string(n, c); }

std::string refusal(const std::string& text) {
  try {
    parse_number(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("numbers are read exactly as written", "[number]") {
  const std::vector<std::pair<const char*, Rational>> good = {
      {"0", 0},
      {"-0", 0},
      {"+0/5", 0},
      {"0.0e-5", 0},
      {"0x0p0", 0},
      {"3/7", Rational(3, 7)},
      {"-3/7", Rational(-3, 7)},
      {"+3/7", Rational(3, 7)},
      {"4/6", Rational(2, 3)},
      {"010", 10},  // decimal, not octal
      {"08/09", Rational(8, 9)},
      {"0.1", Rational(1, 10)},
      {"-12.50", Rational(-25, 2)},
      {"1e3", 1000},
      {"1E+3", 1000},
      {"2.5e-3", Rational(1, 400)},
      {"0.00025e7", 2500},
      {"0x1.8p-3", Rational(3, 16)},
      {"-0X1.8P+3", -12},
      {"0xffp0", 255},
      {"0x0.000000001p36", 1},
      {"0xAbp1", 342},
      {"340282366920938463463374607431768211456", power_of_two(128)},
      {"1/340282366920938463463374607431768211456", power_of_two(-128)},
  };
  for (const auto& [text, value] : good) {
    INFO(text);
    CHECK(parse_number(text) == value);
  }
}

TEST_CASE("anything but a number is refused", "[number]") {
  const std::vector<std::string> bad = {
      "",
      " ",
      " 1",
      "1 ",
      "1 /2",
      "-",
      "+",
      "--1",
      "+-1",
      "1/",
      "/2",
      "3/-6",
      "3/+6",
      "1/0",
      "0/0",
      "1/00",
      "1/2/3",
      "1.5/2",
      "1/2.5",
      "1/2e3",
      ".5",
      "5.",
      ".",
      "-.5",
      "1..2",
      "1e",
      "1e+",
      "1e1.5",
      "e5",
      "1e5e5",
      "1,5",
      "1_000",
      "1'000",
      "nan",
      "NaN",
      "inf",
      "-inf",
      "Infinity",
      "0x",
      "0x1",
      "0x.8p1",
      "0x1.p1",
      "0xp1",
      "0x1.8p",
      "0xgp1",
      "1x8p3",
      "0x1.8p-3.",
      "0x1/0x2",
      "x1p1",
      "0b101",
      "1f",
      "1L",
      "\xe2\x88\x92"
      "1",
      "\xd9\xa1",
      "1\n",
      "\t1",
      "(1)",
      "1+1",
      "1-1",
      "\"1\"",
      "true",
      "0x1.8e3",
  };
  for (const std::string& text : bad) {
    INFO(text);
    CHECK_THROWS_AS(parse_number(text), std::invalid_argument);
    CHECK_THROWS_AS(parse_binary64(text), std::invalid_argument);
  }
  CHECK_THROWS_AS(parse_number(std::string("1\0", 2)), std::invalid_argument);
  CHECK_THROWS_AS(parse_number(std::string("\0"
                                           "1",
                                           2)),
                  std::invalid_argument);
  CHECK_THAT(refusal("1/0"),
             Catch::Matchers::Contains("\"1/0\"") && Catch::Matchers::Contains("zero denominator"));
  CHECK_THAT(refusal("1.5/2"), Catch::Matchers::Contains("position 4"));
  CHECK_THAT(refusal("3/-6"), Catch::Matchers::Contains("digit expected at position 3"));
}

TEST_CASE("documented sizes are the border between legal and refused", "[number]") {
  const auto digits = static_cast<std::size_t>(max_number_digits);
  CHECK(parse_number(repeated('9', digits)) == pow(Integer(10), 3000u) - 1);
  CHECK_THROWS_AS(parse_number("1" + repeated('0', digits)), std::invalid_argument);
  CHECK(parse_number(repeated('0', digits + 1) + "1") == 1);
  CHECK(parse_number("1e2999") == pow(Integer(10), 2999u));
  CHECK_THAT(refusal("1e3000"), Catch::Matchers::Contains("3000 digits"));
  CHECK_THAT(refusal("1e3001"), Catch::Matchers::Contains("exponent beyond"));
  CHECK_THAT(refusal("1e-3001"), Catch::Matchers::Contains("exponent beyond"));
  CHECK(parse_number("0e3000") == 0);
  CHECK(parse_number("0x1p3000") == power_of_two(3000));
  CHECK_THROWS_AS(parse_number("0x1p-3001"), std::invalid_argument);
  CHECK_THROWS_AS(parse_number("1e" + repeated('9', 1000)), std::invalid_argument);
  CHECK_THROWS_AS(parse_number(repeated('1', 3001) + "/7"), std::invalid_argument);
  CHECK_THROWS_AS(parse_number("7/" + repeated('1', 3001)), std::invalid_argument);
  CHECK(parse_number("0." + repeated('0', 2998) + "1") * pow(Integer(10), 2999u) == 1);
  CHECK(parse_number(repeated('0', max_number_length)) == 0);
  const std::string longest = refusal(repeated('0', max_number_length + 1));
  CHECK_THAT(longest, Catch::Matchers::Contains("longer than"));
  CHECK(longest.size() < 200);
}

TEST_CASE("canonical text is in lowest terms", "[number]") {
  CHECK(to_string(parse_number("4/6")) == "2/3");
  CHECK(to_string(parse_number("-4/6")) == "-2/3");
  CHECK(to_string(parse_number("-6/3")) == "-2");
  CHECK(to_string(parse_number("-0.0")) == "0");
  CHECK(to_string(parse_number("0x1.8p-3")) == "3/16");
}

TEST_CASE("text to number to text is the identity on canonical texts", "[number]") {
  std::mt19937_64 random(20240901);
  for (int round = 0; round < 300; ++round) {
    Integer p = 0;
    Integer q = 0;
    for (int words = round % 20; words >= 0; --words) {
      p = (p << 64) + random();
      q = (q << 64) + random();
    }
    const Rational value = Rational(round % 2 == 0 ? p : Integer(-p), q + 1);
    INFO("round " << round);
    CHECK(parse_number(to_string(value)) == value);
  }
}

TEST_CASE("a decimal in binary64 is the nearest double", "[number]") {
  CHECK(parse_binary64("0.1") == Rational(Integer("3602879701896397"), Integer("36028797018963968")));
  CHECK(parse_binary64("9007199254740993") == Integer("9007199254740992"));  // tie to even
  CHECK(parse_binary64("9007199254740993.0000000000000000000000000000000000000000000000000000000001") ==
        Integer("9007199254740994"));
  CHECK(parse_binary64("1e-400") == 0);
  CHECK(parse_binary64("5e-324") == power_of_two(-1074));
  CHECK(parse_binary64("2.4703282292062327e-324") == 0);
  CHECK(parse_binary64("2.4703282292062328e-324") == power_of_two(-1074));
  CHECK(parse_binary64("1.7976931348623158e308") == from_double(1.7976931348623157e308));
  CHECK_THROWS_AS(parse_binary64("1.7976931348623159e308"), std::invalid_argument);
  CHECK_THROWS_AS(parse_binary64("-1e309"), std::invalid_argument);
  CHECK(parse_binary64("1/3") == Rational(1, 3));
  CHECK(parse_binary64("0x1.00000000000000000001p0") == 1 + power_of_two(-80));

  const auto seed = 77u;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 2000; ++round) {
    const double x = std::bit_cast<double>(random());
    if (!std::isfinite(x)) continue;
    char shortest[64] = {};
    std::to_chars(shortest, shortest + sizeof shortest, x);
    INFO(shortest);
    CHECK(parse_binary64(shortest) == from_double(x));
    // An arbitrary decimal of 5 to 25 digits, against the standard library's correctly rounded reader.
    std::string text = std::to_string(random()).substr(0, 5 + random() % 15) + "." + std::to_string(random());
    text += "e" + std::to_string(static_cast<int>(random() % 600) - 330);
    double nearest = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), nearest).ec == std::errc()) {
      INFO(text);
      CHECK(parse_binary64(text) == from_double(nearest));
    }
  }
}

TEST_CASE("damaged numbers are refused or read, never anything else", "[number]") {
  const std::vector<std::string> seeds = {"3/7", "-12.5e-3", "0x1.8p-3", "123456789/987654321", "+0.000e+00"};
  const std::string alphabet = "0123456789+-/.eExXpPaAfF \n\0,nN";
  std::mt19937_64 random(4);
  int readable = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = seeds[random() % seeds.size()];
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      const char c =
          random() % 4 == 0 ? static_cast<char>(random() % 256) : alphabet[random() % alphabet.size()];
      const auto at = random() % (text.size() + 1);
      if (random() % 3 == 0)
        text.insert(at, 1, c);
      else if (at < text.size() && random() % 2 == 0)
        text.erase(at, 1);
      else if (at < text.size())
        text[at] = c;
    }
    try {
      const Rational value = parse_number(text);
      ++readable;
      if (parse_number(to_string(value)) != value) FAIL("no round trip: " << text);
      if (text.find_first_not_of("0123456789+-/.eExXpPaAbBcCdDfF") != std::string::npos)
        FAIL("read: " << text);
    } catch (const std::invalid_argument&) {
    }
  }
  CHECK(readable > 1000);
}

}  // namespace exsect::number_test
