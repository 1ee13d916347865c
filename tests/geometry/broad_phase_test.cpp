#include <exsect/geometry/broad_phase.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/catch.h"

namespace exsect::broad_phase_test {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

BoundingBox box(const Rational& x, const Rational& y, const Rational& z, const Rational& width) {
  return {{x, y, z}, {x + width, y + width, z + width}};
}

std::vector<RoundedBox> rounded(const std::vector<BoundingBox>& boxes) {
  std::vector<RoundedBox> result;
  for (const BoundingBox& b : boxes) result.push_back(rounded_outwards(b));
  return result;
}

Pairs found(const std::vector<BoundingBox>& boxes, bool certainly) {
  const std::vector<RoundedBox> outer = rounded(boxes);
  Pairs pairs;
  visit_meeting_boxes(outer, [&](std::uint32_t i, const std::vector<std::uint32_t>& later) {
    CHECK(!later.empty());
    for (const std::uint32_t j : later)
      if (!certainly || certainly_meet(outer[i], outer[j])) pairs.emplace_back(i, j);
  });
  return pairs;
}

Pairs meeting(const std::vector<BoundingBox>& boxes) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
      if (intersects(boxes[i], boxes[j])) pairs.emplace_back(i, j);
  return pairs;
}

TEST_CASE("rounded boxes contain the box and are as small as can be") {
  const double most = std::numeric_limits<double>::max();
  const double infinity = std::numeric_limits<double>::infinity();
  const double least = std::numeric_limits<double>::denorm_min();
  for (const Rational& q :
       {Rational(0), Rational(1, 3), Rational(-1, 3), Rational(1, 4), Rational(-7), power_of_two(-2000),
        Rational(-power_of_two(-2000)), power_of_two(2000), Rational(-power_of_two(2000)), from_double(most),
        Rational(1 + power_of_two(-60))}) {
    INFO(q);
    const RoundedBox r = rounded_outwards({{q, 0, 0}, {q, 0, 0}});
    const double lower = r.lower[0];
    const double upper = r.upper[0];
    CHECK((lower == -infinity || from_double(lower) <= q));
    CHECK((upper == infinity || from_double(upper) >= q));
    CHECK(r.exact == (lower == upper));
    CHECK((r.exact || std::nextafter(lower, infinity) == upper));
  }
  CHECK(rounded_outwards({{power_of_two(-2000), 0, 0}, {1, 0, 0}}).lower[0] == 0);
  CHECK(rounded_outwards({{0, 0, 0}, {power_of_two(-2000), 0, 0}}).upper[0] == least);
}

TEST_CASE("boxes that touch meet, in doubles certainly") {
  CHECK(found({box(0, 0, 0, 1), box(1, 1, 1, 1), box(2, 0, 0, 1)}, true) == Pairs{{0, 1}, {1, 2}});
  const Rational third(1, 3);
  const std::vector<BoundingBox> thirds = {box(0, 0, 0, third), box(third, 0, 0, third),
                                           box(third + power_of_two(-200), 0, 0, third)};
  CHECK(found(thirds, false) == Pairs{{0, 1}, {0, 2}, {1, 2}});  // exact boxes have to decide the first two
  CHECK(found(thirds, true) == Pairs{{1, 2}});
  CHECK(found({}, false).empty());
  CHECK(found({box(0, 0, 0, 0)}, false).empty());
  CHECK(found({box(0, 0, 0, 0), box(0, 0, 0, 0)}, true) == Pairs{{0, 1}});
}

TEST_CASE("all pairs of random boxes that meet are found, and certain ones do") {
  const std::uint64_t seed = 20261121;
  INFO("seed " << seed);
  std::mt19937_64 generator(seed);
  std::uniform_int_distribution<int> place(0, 40);
  for (const int denominator : {1, 3, 16}) {  // many boxes that touch
    std::vector<BoundingBox> boxes;
    for (int i = 0; i < 400; ++i)
      boxes.push_back(box(Rational(place(generator), denominator), Rational(place(generator), denominator),
                          Rational(place(generator), denominator),
                          Rational(place(generator) / 8, denominator)));
    const Pairs expected = meeting(boxes);
    CHECK(expected.size() > 100);
    const Pairs outer = found(boxes, false);
    CHECK(std::includes(outer.begin(), outer.end(), expected.begin(), expected.end()));
    const Pairs certain = found(boxes, true);
    CHECK(std::includes(expected.begin(), expected.end(), certain.begin(), certain.end()));
    if (denominator != 3) CHECK((outer == expected && certain == expected));
  }
}

}  // namespace
}  // namespace exsect::broad_phase_test
