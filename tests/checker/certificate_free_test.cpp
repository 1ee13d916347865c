// Certificates of pairs with points at which a parameter is free, sides at two speeds, turns on sides.
#include "certificate_changes.h"
#include "support/families.h"

namespace exsect::certificate_free_test {

using namespace certificates;

TEST_CASE("a point with a free parameter has the certificate of its solutions, an arc") {
  const ExactCase c = families::collapsed_side();
  const std::string text = certificate(c.x, c.y);
  const checker::Report report = check_certificate(text);
  CHECK(report.summary.open == 1);
  CHECK(report.summary.isolated == 0);
  CHECK(report.summary.boundary == 2);
  reason(text, "$.arcs[0]: the error bound", [](Json& j) {  // the point of space stays where it is
    for (Json& point : j["arcs"][0]["points"]) point[4] = "1";
  });
  Generator generator(33);
  INFO("seed 33");
  reject_changes(text, generator, 20);
}

TEST_CASE("a common side at two speeds has a certificate") {
  const ExactCase c = families::side_at_two_speeds();
  CHECK(check_certificate(certificate(c.x, c.y)).summary.open == 1);
}

TEST_CASE("an arc that turns where it meets a side has a certificate") {
  for (const auto plane : {families::Plane::square, families::Plane::larger}) {
    const ExactCase c = families::quarter_circle(plane);
    CHECK(check_certificate(certificate(c.x, c.y)).summary.open == 1);
  }
  // With another slope of y across the side nothing turns there for certain.
  const ExactCase c = families::quarter_circle(families::Plane::square);
  reason(certificate(c.x, c.y), "$.", [](Json& j) {
    for (Json& row : j["second"]["points"]) row[2][0] = "1/7";
  });
}

}  // namespace exsect::certificate_free_test
