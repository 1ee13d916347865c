// Boundary points in doubles against those of exact arithmetic.
#include "filter/boundary.h"

#include <exsect/solver/line_patch.h>

#include "filter/contact.h"
#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::boundary_test {
namespace {

using namespace filter;

bool holds(const Ball& ball, const CertifiedPoint& point) {
  const ParameterBox box = point.refined_to(power_of_two(-80)).box();
  for (std::size_t j = 0; j < 4; ++j) {
    const Rational d = box[j].midpoint() - Rational(1, 2) - from_double(ball.middle[j]);
    if (abs(d) > from_double(ball.radius) + power_of_two(-70)) return false;
  }
  return true;
}

/// Each exact point is in one ball on its side, and there are no other balls. Returns how many.
std::size_t checked(const random_pairs::Pair& p) {
  const Pair pair = make_pair(p.x, p.y).value();
  Trees trees{PatchTree(pair.x), PatchTree(pair.y)};
  long boxes = 0;
  const auto found = boundary_points(pair, {}, trees, boxes);
  REQUIRE(found);
  std::size_t count = 0;
  for (const Parameter parameter : all_parameters)
    for (const int value : {0, 1}) {
      for (const CertifiedPoint& point : line_points(p.x, p.y, {parameter, value}).points) {
        ++count;
        int balls = 0;
        for (const BoundaryPoint& at : *found)
          if (at.parameter == index(parameter) && at.side == value - 0.5 && holds(at.ball, point)) ++balls;
        CHECK(balls == 1);
      }
    }
  CHECK(found->size() == count);
  return count;
}

}  // namespace

TEST_CASE("boundary points in doubles are the exact ones", "[filter]") {
  random_pairs::Generator generator(20279);
  std::size_t count = 0;
  for (int round = 0; round < 15; ++round) {
    count += checked(random_pairs::small_rationals(generator));
    count += checked(random_pairs::doubles(generator));
    count += checked(random_pairs::scattered(generator));
  }
  CHECK(count > 60);
}

}  // namespace exsect::boundary_test
