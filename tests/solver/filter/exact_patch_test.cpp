#include "filter/exact_patch.h"

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::exact_patch_test {
namespace {

using namespace filter;

const std::vector<std::array<Rational, 2>> places = {
    {0, 0}, {1, 0}, {Rational(1, 3), Rational(5, 7)}, {Rational(9, 10), Rational(1, 8)}, {1, 1}};

template <class K>
void check_elevated(const RationalPatch& patch) {
  const ElevatedPatch<K> exact = elevated<K>(patch);
  const RationalPatch again = rational_patch<K>(exact);
  for (const auto& [u, v] : places) CHECK(again(u, v) == patch(u, v));
  Rational largest = 0;
  for (const Rational& w : exact.weights) largest = std::max(largest, Rational(abs(w)));
  if (K::weighted) {
    CHECK(largest >= Rational(1, 4));
    CHECK(largest <= 2);
  } else {
    for (const Rational& w : exact.weights) CHECK(w == 1);
  }
}

}  // namespace

TEST_CASE("exact patches: elevation keeps the points, and weights are of size one", "[filter]") {
  random_nets::Generator generator(20276);
  for (const std::array<int, 4>& degrees :
       {std::array{1, 1, 1, 1}, {1, 2, 1, 1}, {2, 2, 1, 1}, {3, 1, 1, 1}, {2, 3, 1, 1}, {3, 3, 1, 1}}) {
    const random_nets::Net net = random_nets::crossing(generator, degrees, true).x;
    const RationalPatch plain(net);
    const RationalPatch weighted = random_nets::weighted(generator, net);
    check_elevated<Bicubic>(plain);
    check_elevated<WeightedBicubic>(plain);
    check_elevated<WeightedBicubic>(weighted);
    if (degrees[0] < 3 && degrees[1] < 3) {
      check_elevated<WeightedBiquadratic>(plain);
      check_elevated<WeightedBiquadratic>(weighted);
    }
  }
}

TEST_CASE("exact patches: weights of any size become numbers near one", "[filter]") {
  random_nets::Generator generator(20277);
  const random_nets::Net net = random_nets::crossing(generator, {2, 2, 2, 2}, false).x;
  const RationalPatch patch = random_nets::weighted(generator, net);
  ControlVectors vectors;
  for (int i = 0; i <= 2; ++i) {
    vectors.emplace_back();
    for (int j = 0; j <= 2; ++j) {
      HomogeneousPoint p = patch.homogeneous(i, j);
      for (Rational& c : p) c *= power_of_two(-700);
      vectors.back().push_back(p);
    }
  }
  check_elevated<WeightedBiquadratic>(RationalPatch::from_homogeneous(vectors));
}

}  // namespace exsect::exact_patch_test
