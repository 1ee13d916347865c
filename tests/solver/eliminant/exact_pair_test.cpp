// Facts about a pair that are kept: the same as those computed anew, and computed once.
#include "eliminant/exact_pair.h"

#include "answer/parameter_box.h"
#include "line/exact_line_points.h"
#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::exact_pair_test {
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

TEST_CASE("kept turning values are those computed anew", "[exact_pair]") {
  const std::uint64_t seed = 4;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int i = 0; i < 3; ++i) {
    const auto pair = random_pairs::small_rationals(generator);
    ExactPair exact(pair.x, pair.y);
    check_same(exact.choice().turning, choose_sweep(pair.x, pair.y).turning);
    for (const Parameter p : all_parameters) {
      check_same(exact.turning(p), turning_values(pair.x, pair.y, p));
    }
  }
}

TEST_CASE("a turning eliminant is computed once, and not after the stop", "[exact_pair]") {
  random_pairs::Generator generator(5);
  const auto pair = random_pairs::small_rationals(generator);
  int asked = 0;  // choose_sweep asks before each eliminant that it computes
  bool stop = false;
  ExactPair exact(pair.x, pair.y, [&] {
    ++asked;
    return stop;
  });
  stop = true;
  CHECK(!exact.turning(Parameter::v));
  stop = false;
  const SweepChoice* first = &exact.choice();
  const int computed = asked;
  CHECK(computed > 1);
  CHECK(&exact.choice() == first);
  CHECK(asked == computed);
  stop = true;
  const Parameter sweep = first->turning->sweep;
  const auto& kept = exact.turning(sweep);
  REQUIRE(kept);
  CHECK(&exact.turning(sweep) == &kept);
  stop = false;
  const auto& other = exact.turning(Parameter::s);
  stop = true;
  CHECK(&exact.turning(Parameter::s) == &other);
}

TEST_CASE("a fibre is kept, with the points that are found anew", "[exact_pair]") {
  random_pairs::Generator generator(6);
  const auto pair = random_pairs::small_rationals(generator);
  ExactPair exact(pair.x, pair.y);
  for (const Parameter p : all_parameters) {
    const LineQuery query = {p, Rational(2, 7)};
    const LinePoints& kept = exact.fibre(query);
    CHECK(&exact.fibre(query) == &kept);
    const LinePoints anew = exact_line_points(pair.x, pair.y, query);
    REQUIRE(kept.points.size() == anew.points.size());
    for (std::size_t i = 0; i < anew.points.size(); ++i) {
      CHECK(meet(kept.points[i].box(), anew.points[i].box()));
      CHECK(exact.surely_takes(kept.points[i], p, query.value));
      CHECK_FALSE(exact.surely_takes(kept.points[i], p, Rational(3, 7)));
    }
  }
}

}  // namespace exsect::exact_pair_test
