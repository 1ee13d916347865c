#include "filter/loops.h"

#include <cmath>

#include "known_curve.h"

namespace exsect::loops_test {
namespace {

using testing::KnownCurve;
using testing::q;

struct Search {
  bool found;
  std::vector<filter::Trace> traces;
  filter::Vec4 stuck = {1, 1, 1, 1};

  explicit Search(KnownCurve& curve, std::vector<filter::Trace> known = {}) : traces(std::move(known)) {
    found = filter::add_loops<filter::Biquadratic>(curve.pair, {}, {}, curve.trees, curve.points, traces,
                                                   curve.boxes, stuck);
  }
};

/// (u - 1/2)^2 + (v - 1/2)^2 = c
testing::HeightCoefficients circle(const Rational& c) {
  return {{{q(1, 2) - c, -1, 1}, {-1, 0, 0}, {1, 0, 0}}};
}

}  // namespace

TEST_CASE("filter loops: circles of every size, down to a point that is none", "[filter]") {
  for (const long exponent : {4L, 10L, 20L}) {
    CAPTURE(exponent);
    KnownCurve curve(circle(power_of_two(-exponent)));
    const Search search(curve);
    REQUIRE(search.found);
    REQUIRE(search.traces.size() == 1);
    CHECK(search.traces[0].start == -1);
    KnownCurve none(circle(-power_of_two(-exponent)));
    const Search nothing(none);
    CHECK(nothing.found);
    CHECK(nothing.traces.empty());
  }
  KnownCurve touch(circle(0));
  const Search undecided(touch);
  CHECK_FALSE(undecided.found);
  for (const double w : undecided.stuck) CHECK(std::fabs(w) < 0.01);
}

TEST_CASE("filter loops: what is traced already is not found again", "[filter]") {
  KnownCurve open(testing::kHyperbola);
  const Search with_arc(open, {open.arc()});
  CHECK(with_arc.found);
  CHECK(with_arc.traces.size() == 1);
  KnownCurve closed(testing::kCircle);
  const Search first(closed);
  REQUIRE(first.traces.size() == 1);
  const Search again(closed, first.traces);
  CHECK(again.found);
  CHECK(again.traces.size() == 1);
}

}  // namespace exsect::loops_test
