#include "star/other_turning.h"

#include <algorithm>

#include "support/known_curves.h"
#include "support/random_pairs.h"

namespace exsect::other_turning_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

}  // namespace

TEST_CASE("other turning values: of a graph and its plane those of the other parameter") {
  const BezierPatch x = graph_patch(kCircle), y = plane_patch();
  ExactPair pair(x, y);
  for (const Parameter sweep : all_parameters) {
    const OtherTurning others = other_turning(pair, sweep);
    CHECK(others.complete);
    REQUIRE_FALSE(others.values.empty());
    for (const TurningValues* values : others.values) {
      CHECK(index(values->sweep) % 2 != index(sweep) % 2);
      for (const Rational& turn : {q(1, 6), q(5, 6)})
        CHECK(std::count_if(values->values.begin(), values->values.end(),
                            [&](const TurningValue& v) { return v.value == RealAlgebraic(turn); }) == 1);
    }
  }
}

TEST_CASE("other turning values: of a generic pair those of all three other parameters") {
  random_pairs::Generator generator(3);
  const auto pair_of = random_pairs::scattered(generator);
  ExactPair pair(pair_of.x, pair_of.y);
  const OtherTurning others = other_turning(pair, Parameter::r);
  CHECK(others.complete);
  REQUIRE(others.values.size() == 3);
  CHECK(others.values[0] == &*pair.turning(Parameter::u));
  CHECK(others.values[1] == &*pair.turning(Parameter::v));
  CHECK(others.values[2] == &*pair.turning(Parameter::s));
}

TEST_CASE("other turning values: after a stop they are not complete") {
  random_pairs::Generator generator(3);
  const auto pair_of = random_pairs::scattered(generator);
  ExactPair pair(pair_of.x, pair_of.y, [] { return true; });
  const OtherTurning others = other_turning(pair, Parameter::u);
  CHECK_FALSE(others.complete);
  CHECK(others.values.empty());
}

}  // namespace exsect::other_turning_test
