#include "filter/common_side.h"

#include "filter/contact_finder.h"
#include "support/catch.h"
#include "support/families.h"

namespace exsect::common_side_test {
namespace {

Contact along_the_side(const ExactCase& c) {
  const filter::Pair pair = filter::make_pair(c.x, c.y).value();
  const auto contacts = filter::find_contacts<filter::Biquadratic>(c.x, c.y, pair);
  REQUIRE(contacts);
  REQUIRE(contacts->sides.size() == 1);
  return filter::contact_along<filter::Biquadratic>(c.x, c.y, pair, contacts->sides[0]);
}

}  // namespace

TEST_CASE("common side: patches cross along it, or touch if one continues the other", "[filter]") {
  CHECK(along_the_side(families::shared_side({0, 1, 0})) == Contact::transversal);
  for (const int k : {0, 1, -3}) CHECK(along_the_side(families::smooth_neighbour(k)) == Contact::tangential);
}

TEST_CASE("common side: the parameter on y of weighted sides", "[filter]") {
  for (const Rational& ratio : {Rational(1), Rational(3), Rational(2, 7)})
    for (int i = 0; i <= 8; ++i) {
      const Rational t(i, 8), on_y = filter::inverse({{0, ratio}, {1, ratio}}, t);
      CHECK(ratio * on_y / (1 - on_y + ratio * on_y) == t);
      CHECK(on_y >= 0);
      CHECK(on_y <= 1);
    }
  const filter::MoebiusMap<Rational> part = {{Rational(-1, 3), 2}, {3, Rational(5, 2)}};
  for (int i = 0; i <= 8; ++i) {
    const Rational on_y(i, 8);
    const Rational t = ((1 - on_y) * part.value[0] + on_y * part.value[1]) /
                       ((1 - on_y) * part.weight[0] + on_y * part.weight[1]);
    CHECK(filter::inverse(part, t) == on_y);
  }
}

TEST_CASE("common side: steps between control points, rounded and exact", "[filter]") {
  const ExactCase c = families::shared_side({0, 1, 0});
  const filter::Pair pair = filter::make_pair(c.x, c.y).value();
  const Point exact = filter::step_between(c.x, 8, 0);
  const filter::Vec3 rounded = filter::step_between<filter::Biquadratic>(pair.x, 8, 0);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(std::ldexp(rounded[i], static_cast<int>(pair.frame.exponent)) ==
          Approx(to_double(exact[i])).margin(1e-14));
}

}  // namespace exsect::common_side_test
