#include "filter/line.h"

#include <cmath>

#include "known_curve.h"

namespace exsect::line_test {
namespace {

using testing::KnownCurve;

std::optional<std::vector<filter::Ball>> on_line(KnownCurve& curve, std::size_t fixed, double value,
                                                 double error = 0) {
  long boxes = 0;
  auto found = filter::points_on_line<filter::Biquadratic>(curve.pair, {fixed, value, error}, {},
                                                           fixed < 2 ? curve.trees.y : curve.trees.x, boxes);
  CHECK(boxes > 0);
  return found;
}

}  // namespace

TEST_CASE("filter line: one point of the hyperbola on every line that meets it", "[filter]") {
  KnownCurve curve(testing::kHyperbola);
  for (const double c : {-0.2, 0.0, 0.1, 0.375}) {
    const auto found = on_line(curve, 0, c);
    REQUIRE(found);
    REQUIRE(found->size() == 1);
    const filter::Ball& ball = found->front();
    const double u = 0.5 + c, v = 1 / (4 * u);
    CHECK(ball.middle[0] == c);
    const filter::Vec4 expected = KnownCurve::centred(u, v);
    for (std::size_t j = 0; j < 4; ++j) CHECK(std::fabs(ball.middle[j] - expected[j]) <= ball.radius + 1e-15);
    CHECK(ball.radius < 1e-6);
  }
  // u < 1/4: the hyperbola is above the square. Of y's lines likewise.
  const auto above = on_line(curve, 0, -0.4);
  REQUIRE(above);
  CHECK(above->empty());
  const auto of_y = on_line(curve, 3, 0.0);  // s = 1/2 is v = 1/2
  REQUIRE(of_y);
  CHECK(of_y->size() == 1);
}

TEST_CASE("filter line: two points of a circle, none beside it, nothing decided where it is tangent",
          "[filter]") {
  KnownCurve curve(testing::kCircle);
  for (const double c : {-0.33, -0.1, 0.3, 0.3333}) {
    const auto found = on_line(curve, 1, c);
    REQUIRE(found);
    CHECK(found->size() == 2);
  }
  const auto beside = on_line(curve, 1, 0.3334);
  REQUIRE(beside);
  CHECK(beside->empty());
  const double third = 1.0 / 3;
  CHECK_FALSE(on_line(curve, 1, third, 0x1p-54));
  const auto stuck =
      filter::undecided_on_line<filter::Biquadratic>(curve.pair, {1, third, 0x1p-54}, {}, curve.trees.y);
  REQUIRE(stuck);
  const filter::Vec4 tangent = KnownCurve::centred(0.5, 0.5 + third);
  for (std::size_t j = 0; j < 4; ++j) CHECK(std::fabs((*stuck)[j] - tangent[j]) < 1e-3);
  CHECK_FALSE(filter::undecided_on_line<filter::Biquadratic>(curve.pair, {1, 0.1, 0}, {}, curve.trees.y));
}

}  // namespace exsect::line_test
