// Ratios of Moebius maps between parameters, guessed to many digits from a place in doubles.
#include "filter/moebius_ratios.h"

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::moebius_ratios_test {
namespace {

using namespace filter;
using K = WeightedBiquadratic;
using random_nets::reparametrised;

RationalPatch surface() {
  random_nets::Generator generator(61);
  return random_nets::weighted(generator, random_nets::crossing(generator, {2, 2, 1, 1}, true).x);
}

/// Of x in other parameters, from the middle of these: t = 1/2 is k/(1 + k) in those of x (random_nets.h).
std::optional<std::array<Rational, 2>> ratios(const Rational& k, const Rational& l, double off = 0) {
  const RationalPatch x = surface();
  const RationalPatch y = reparametrised(reparametrised(x, k).transposed(), l).transposed();
  const auto there = [](const Rational& q) { return to_double(q / (1 + q)) - 0.5; };
  Place on_x = {there(k), there(l)};
  if (!(x(from_double(on_x[0]) + Rational(1, 2), 0) == y(Rational(1, 2), 0)))
    on_x = {there(1 / k), there(1 / l)};
  on_x[0] += off;
  return moebius_ratios<K>(elevated<K>(x), elevated<K>(y), on_x, {0, 0}, 0);
}

}  // namespace

TEST_CASE("moebius ratios: short and long ones, exactly", "[filter]") {
  const Rational tiny = power_of_two(-120);
  for (const auto& [k, l] :
       std::vector<std::pair<Rational, Rational>>{{1, 1},
                                                  {2, Rational(1, 3)},
                                                  {from_double(0.7), from_double(1.1) / from_double(0.9)},
                                                  {1 + tiny, 1 - tiny},
                                                  {Rational(1) + Rational(1) / pow(Integer(10), 35), 5}}) {
    CAPTURE(k, l);
    for (const double off : {0.0, 1e-4, -1e-6}) {
      const auto found = ratios(k, l, off);
      REQUIRE(found);
      CHECK((*found)[0] == 1 / k);
      CHECK((*found)[1] == 1 / l);
    }
  }
}

TEST_CASE("moebius ratios: none with too many digits, none from a wrong place", "[filter]") {
  CHECK_FALSE(ratios((power_of_two(400) + 1) / (power_of_two(401) - 1), 1));
  const RationalPatch x = surface();
  // Another surface than y's: Newton's method ends off the point, or nowhere.
  const RationalPatch moved =
      RationalPatch(random_nets::Net{{{5, 0, 1}, {5, 1, 1}}, {{6, 0, 1}, {6, 1, 3}}}, {{1, 2}, {1, 1}});
  CHECK_FALSE(moebius_ratios<K>(elevated<K>(x), elevated<K>(moved), {0, 0}, {0, 0}, 0));
}

}  // namespace exsect::moebius_ratios_test
