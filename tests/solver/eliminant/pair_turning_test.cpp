// The kept turning values: the same as those computed anew, and computed once.
#include "eliminant/pair_turning.h"

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::pair_turning_test {
namespace {

void check_same(const std::optional<TurningValues>& a, const std::optional<TurningValues>& b) {
  REQUIRE(a.has_value() == b.has_value());
  if (!a) return;
  CHECK(a->sweep == b->sweep);
  CHECK(a->touching == b->touching);
  REQUIRE(a->values.size() == b->values.size());
  for (std::size_t i = 0; i < a->values.size(); ++i) {
    CHECK(a->values[i].value == b->values[i].value);
    CHECK(a->values[i].multiplicity == b->values[i].multiplicity);
  }
}

}  // namespace

TEST_CASE("kept turning values are those computed anew", "[pair_turning]") {
  const std::uint64_t seed = 4;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int i = 0; i < 3; ++i) {
    const auto pair = random_pairs::small_rationals(generator);
    PairTurning turning(pair.x, pair.y);
    check_same(turning.choice().turning, choose_sweep(pair.x, pair.y).turning);
    for (const Parameter p : all_parameters) {
      check_same(*turning.values(p), turning_values(pair.x, pair.y, p));
    }
  }
}

TEST_CASE("a turning eliminant is computed once", "[pair_turning]") {
  random_pairs::Generator generator(5);
  const auto pair = random_pairs::small_rationals(generator);
  int asked = 0;  // choose_sweep asks before each eliminant that it computes
  const StopRequest count = [&asked] {
    ++asked;
    return false;
  };
  PairTurning turning(pair.x, pair.y);
  CHECK(turning.values(Parameter::v, false) == nullptr);
  const SweepChoice* first = &turning.choice(count);
  const int computed = asked;
  CHECK(computed > 0);
  CHECK(&turning.choice(count) == first);
  CHECK(asked == computed);
  const Parameter sweep = first->turning->sweep;
  const auto* kept = turning.values(sweep, false);
  REQUIRE(kept != nullptr);
  CHECK(turning.values(sweep) == kept);
  const auto* other = turning.values(Parameter::s);
  CHECK(turning.values(Parameter::s, false) == other);
}

}  // namespace exsect::pair_turning_test
