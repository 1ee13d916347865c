// The families of the comparison: the same pairs for the same seed, in doubles where that is promised.
#include "pair_families.h"

#include "support/catch.h"

using namespace peers;

namespace {

bool in_doubles(const exsect::BezierPatch& patch) {
  for (const auto& row : patch.net())
    for (const exsect::Point& p : row)
      for (const exsect::Rational& c : p)
        if (exsect::from_double(exsect::to_double(c)) != c) return false;
  return true;
}

}  // namespace

TEST_CASE("families are reproducible and, but one, in doubles") {
  for (const Family& family : families()) {
    INFO(family.name);
    Generator a(1);
    Generator b(1);
    bool all = true;
    for (int i = 0; i < 20; ++i) {
      const ExactPair first = family.member(a);
      const ExactPair second = family.member(b);
      CHECK((first.x == second.x && first.y == second.y));
      all = all && in_doubles(first.x) && in_doubles(first.y);
    }
    CHECK(all == (family.name != "random-rational"));
  }
}
