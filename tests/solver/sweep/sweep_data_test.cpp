#include "sweep/sweep_data.h"

#include "support/families.h"
#include "support/known_curves.h"
#include "swept_pair.h"

namespace exsect::sweep_data_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

StarNeighbourhood star_over(const CertifiedPoint& centre, const ParameterBox& box) {
  return {centre, Parameter::u, box, {}, {}};
}

}  // namespace

TEST_CASE("sweep data: a point is in a star if it is in its closed box", "[sweep]") {
  // The hyperbola u v = 1/4 ends in (1/4, 1) and (1, 1/4).
  SweptPair pair(graph_patch(kHyperbola), plane_patch());
  REQUIRE(pair.data.landmarks.size() == 2);
  const CertifiedPoint& first = pair.data.landmarks[0].point;
  const CertifiedPoint& second = pair.data.landmarks[1].point;
  CHECK_FALSE(in_star(pair.data, first));
  const bool starts_low = first.box()[0].lower < q(1, 2);
  const Rational u = starts_low ? q(1, 4) : q(1), v = starts_low ? q(1) : q(1, 4);
  const auto range = [](const Rational& c, const Rational& reach) {
    return RationalInterval{c - reach, c + reach};
  };
  // Around the first one; then with it on the box's corner; then beside it by 2^-300.
  pair.data.stars = {
      star_over(first, {range(u, q(1, 8)), range(v, q(1, 8)), range(u, q(1, 8)), range(v, q(1, 8))})};
  CHECK(in_star(pair.data, first));
  CHECK_FALSE(in_star(pair.data, second));
  const RationalInterval above = {u, u + q(1, 8)}, beside = {u + power_of_two(-300), u + q(1, 8)};
  pair.data.stars = {star_over(first, {above, range(v, q(1, 8)), above, range(v, q(1, 8))})};
  CHECK(in_star(pair.data, first));
  pair.data.stars = {star_over(first, {beside, range(v, q(1, 8)), beside, range(v, q(1, 8))})};
  CHECK_FALSE(in_star(pair.data, first));
}

TEST_CASE("sweep data: samples lie between all critical values, and fibres have the curve's points",
          "[sweep]") {
  SweptPair pair(graph_patch(kCircle), plane_patch());
  const SweepData& data = pair.data;
  REQUIRE(data.samples.size() == data.fibres.size());
  const std::size_t along = index(data.turning->sweep);
  std::size_t twice = 0;
  for (std::size_t i = 0; i < data.samples.size(); ++i) {
    const Rational offset = data.samples[i] - q(1, 2), room = q(1, 9) - offset * offset;
    CHECK(room != 0);
    CHECK(data.fibres[i].size() == (room > 0 ? 2 : 0));
    if (room > 0) ++twice;
    for (const CertifiedPoint& point : data.fibres[i]) CHECK(point.box()[along].lower == data.samples[i]);
  }
  CHECK(twice > 0);
}

}  // namespace exsect::sweep_data_test
