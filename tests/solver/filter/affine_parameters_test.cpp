// Moebius maps between the parameters of pieces of one weighted surface, guessed.
#include "filter/affine_parameters.h"

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::affine_parameters_test {
namespace {

using filter::elevated;
using random_nets::Generator;
using random_nets::reparametrised;

template <class K>
auto ratios_between(const RationalPatch& x, const RationalPatch& y) {
  const auto exact_x = elevated<K>(x), exact_y = elevated<K>(y);
  const auto pair = filter::make_pair_of<K>(exact_x, exact_y);
  REQUIRE(pair);
  return filter::parameter_ratios<K>(*pair, exact_x, exact_y);
}

template <class K>
void check_found(const RationalPatch& x, const Rational& k, const Rational& l) {
  INFO("k " << k << ", l " << l);
  const RationalPatch piece = x.restricted_to(Rational(1, 2), 1, Rational(2, 3), Rational(1, 7));
  const RationalPatch y = reparametrised(reparametrised(piece, k).transposed(), l).transposed();
  const auto found = ratios_between<K>(x, y);
  REQUIRE(found);
  CHECK((*found)[0] == 1 / k);
  CHECK((*found)[1] == 1 / l);
  const auto exchanged = ratios_between<K>(x, y.transposed());
  REQUIRE(exchanged);
  CHECK((*exchanged)[0] == 1 / l);
  CHECK((*exchanged)[1] == 1 / k);
  // In these parameters it is the piece again, but for a common factor of all weights.
  const auto back = filter::in_other_parameters<K>(elevated<K>(y), *found);
  for (const Rational& r : {Rational(0), Rational(1, 3), Rational(1)})
    CHECK(filter::rational_patch(back)(r, Rational(3, 5)) == piece(r, Rational(3, 5)));
}

}  // namespace

TEST_CASE("filter affine parameters: the ratios of Moebius maps are found") {
  Generator generator(51);
  for (const auto& [k, l] : {std::pair<Rational, Rational>{2, 1},
                             {1, Rational(3, 7)},
                             {Rational(997, 1000), 5},
                             {Rational(1, 8), Rational(12345, 6789)},
                             {from_double(0.7), from_double(1.9) / from_double(0.3)},
                             {Rational(1) + Rational(1) / pow(Integer(10), 35), Rational(1, 3)}}) {
    for (const bool doubles : {false, true}) {
      INFO("seed 51, doubles " << doubles);
      check_found<filter::WeightedBiquadratic>(
          random_nets::weighted(generator, random_nets::crossing(generator, {2, 2, 1, 1}, doubles).x), k, l);
      check_found<filter::WeightedBicubic>(
          random_nets::weighted(generator, random_nets::crossing(generator, {3, 2, 1, 1}, doubles).x), k, l);
    }
  }
}

TEST_CASE("filter affine parameters: none of other patches, and of affine pieces") {
  Generator generator(52);
  for (int i = 0; i < 20; ++i) {
    INFO("seed 52, pair " << i);
    const auto nets = random_nets::crossing(generator, {2, 2, 2, 2}, true);
    const RationalPatch x = random_nets::weighted(generator, nets.x);
    const RationalPatch y = random_nets::weighted(generator, nets.y);
    CHECK_FALSE(ratios_between<filter::WeightedBiquadratic>(x, y));
    CHECK_FALSE(ratios_between<filter::WeightedBiquadratic>(x, x));
    CHECK_FALSE(ratios_between<filter::WeightedBicubic>(x, x.restricted_to(Rational(1, 3), 1, 1, 0)));
  }
}

}  // namespace exsect::affine_parameters_test
