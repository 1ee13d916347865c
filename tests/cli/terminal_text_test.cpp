#include "output/text/terminal_text.h"

#include <exsect/geometry/number.h>

#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::cli::terminal_text_test {
namespace {

TEST_CASE("a rounded error bound is at least the bound and at most one unit of its last digit above") {
  CHECK(rounded_up(0) == "0.00e+00");
  CHECK(rounded_up(1) == "1.00e+00");
  CHECK(rounded_up(1.001) == "1.01e+00");
  CHECK(rounded_up(0.9999) == "1.00e+00");
  CHECK(rounded_up(9.991) == "1.00e+01");
  CHECK(rounded_up(0.1) == "1.01e-01");  // the double 0.1 is above 1/10
  std::mt19937_64 random(20260713);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 2000; ++i) {
    const double bound = std::pow(10.0, exponent(random));
    INFO("bound " << bound << " shown " << rounded_up(bound));
    const Rational shown = parse_number(rounded_up(bound));
    CHECK(shown >= from_double(bound));
    CHECK(shown <= from_double(bound) * Rational("101/100"));
  }
}

TEST_CASE("no control character of a file reaches the terminal") {
  CHECK(printable("a\x1b[31mb\nc\td\x7f") == "a [31mb c d ");
  CHECK(printable("Jüttler \u2264 \u4e2d") == "Jüttler \u2264 \u4e2d");
  CHECK(printable("\u009b31m\u00a0") == " 31m\u00a0");
  CHECK(printable("cut \xc2") == "cut  ");
  const std::string broken =
      "\xff\x9b"
      "31m \xe2\x82 \xed\xa0\x80 \xc0\xaf";
  CHECK(printable(broken) == "  31m" + std::string(10, ' '));
  CHECK(printable("\U0001F600 \u0627\u0644") == "\U0001F600 \u0627\u0644");
}

TEST_CASE("no name turns the direction of the text around it") {
  for (const char* mark : {"\u061c", "\u200e", "\u200f", "\u202a", "\u202b", "\u202c", "\u202d", "\u202e",
                           "\u2066", "\u2067", "\u2068", "\u2069", "\u2028", "\u2029"}) {
    CHECK(printable("a" + std::string(mark) + "b") == "a b");
  }
}

TEST_CASE("tables align their columns") {
  CHECK(table({"a", "long head"}, {}) == "");
  CHECK(table({"a", "head", ""}, {{"wide", "1", ""}, {"b", "2", "x"}}) ==
        "  a     head\n"
        "  wide  1\n"
        "  b     2     x\n");
}

TEST_CASE("boxes are shown rounded outwards") {
  const ParameterBox box = {
      {{0, 1}, {Rational("1/3"), Rational("2/3")}, {1, 1}, {Rational("1/2"), Rational("1/2")}}};
  CHECK(box_text(box) == "u in [0, 1], v in [0.333333, 0.666667], r in [1, 1], s in [0.5, 0.5]");
}

TEST_CASE("counts and lists") {
  CHECK(counted(0, "point") == "0 points");
  CHECK(counted(1, "point") == "1 point");
  CHECK(joined({}, ", ") == "-");
  CHECK(joined({"a", "b"}, ", ") == "a, b");
  CHECK(heading("f.json", "") == "f.json\n");
  CHECK(heading("f.json", "A\nB") == "f.json: A B\n");
}

}  // namespace
}  // namespace exsect::cli::terminal_text_test
