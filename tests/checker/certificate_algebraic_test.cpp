// Certificates with stars whose points are irrational.
#include <exsect/geometry/number.h>

#include "certificate_changes.h"
#include "support/families.h"
#include "support/graph_patches.h"

namespace exsect::certificate_algebraic_test {
namespace {

using namespace certificates;
using families::Plane;
using testing::graph;
using testing::Terms;

/// Added to the height of both patches: the plane patch becomes curved.
const Terms w = {{{1, 1}, Rational(1, 8)}, {{2, 0}, Rational(1, 16)}, {{0, 2}, Rational(1, 24)}};

/// u + u v / 2 = 1/2 and v = u / 2 + 1/4 meet where u² + 9/2 u = 2.
const Terms hyperbola = {{{1, 0}, 1}, {{1, 1}, Rational(1, 2)}, {{0, 0}, -Rational(1, 2)}};
const Terms line = {{{0, 1}, 1}, {{1, 0}, -Rational(1, 2)}, {{0, 0}, -Rational(1, 4)}};
const Terms minus_one = {{{0, 0}, -1}};

std::string crossing_text() {
  static const std::string text = certificate(graph(hyperbola * line + w), graph(w));
  return text;
}
std::string touch_text() {
  static const std::string text = certificate(graph(hyperbola * hyperbola + line * line + w), graph(w));
  return text;
}

checker::Summary summary(const BezierPatch& x, const BezierPatch& y) {
  return check_certificate(certificate(x, y)).summary;
}

}  // namespace

TEST_CASE(
    "points where patches touch or branches cross have certificates where all parameters are irrational") {
  const checker::Report touch = check_certificate(touch_text());
  CHECK(touch.summary.isolated == 1);
  CHECK(touch.summary.components == 0);
  const checker::Report crossing = check_certificate(crossing_text());
  CHECK(crossing.summary.branched == 1);
  CHECK(crossing.summary.claims[1] == 1);
  CHECK(summary(graph(hyperbola * hyperbola + minus_one * line * line), graph({})).branched == 1);
  const Json json = Json::parse(crossing_text());
  CHECK(json["stars"][0]["modulus"] == Json({"-2", "9/2", "1"}));
}

TEST_CASE("two crossings in conjugate points have a certificate", "[.slow]") {
  // 8 u v = 1 and u + v = 1 meet in (1 ± 1/√2)/2; the arcs of the component come in no connected order.
  const Terms conic = {{{1, 1}, 8}, {{0, 0}, -1}};
  const Terms diagonal = {{{1, 0}, 1}, {{0, 1}, 1}, {{0, 0}, -1}};
  const std::string text = certificate(graph(conic * diagonal), graph({}));
  const checker::Summary found = check_certificate(text).summary;
  CHECK(found.branched == 1);
  CHECK(found.claims[1] == 2);
  // Either star in the place of the other one.
  reason(text, "$.", [](Json& j) { std::swap(j["stars"][0]["between"], j["stars"][1]["between"]); });
  reason(text, "$.", [](Json& j) { j["stars"][1] = j["stars"][0]; });
}

TEST_CASE("irrational stars keep under exchange, reversal and affine maps") {
  random_pairs::Generator generator(9);
  const BezierPatch x = graph(hyperbola * line + w);
  const BezierPatch y = graph(w);
  const random_pairs::AffineMap map = random_pairs::affine_map(generator);
  for (const auto& [a, b] :
       {std::pair{y, x}, {x.exchanged(), y}, {x, y.reversed_second()}, {map(x), map(y)}}) {
    const checker::Summary found = summary(a, b);
    CHECK(found.branched == 1);
    CHECK(found.claims[1] == 1);
  }
}

TEST_CASE("patches with irrational parameters on one of them have certificates") {
  CHECK(summary(families::cap(0, Plane::quadratic).x, families::cap(0, Plane::quadratic).y).isolated == 1);
  const ExactCase crossing = families::crossing(Plane::quadratic);
  CHECK(summary(crossing.x, crossing.y).branched == 1);
}

TEST_CASE("cusps have certificates with irrational axes") {
  const ExactCase cusp = families::curve_cusp(Plane::quadratic);
  CHECK(summary(cusp.x, cusp.y).open == 1);
}

TEST_CASE("false claims about numbers of a field are rejected where they stand") {
  const std::string text = crossing_text();
  const auto star = [](auto change) { return [change](Json& j) { change(j["stars"][0]); }; };
  reason(text, "$.", star([](Json& s) { s["modulus"][0] = "-21/10"; }));
  reason(text, "$.stars[0]: its modulus has no leading", star([](Json& s) { s["modulus"][2] = "2"; }));
  reason(text, "$.stars[0]: its modulus has no leading", star([](Json& s) { s["modulus"] = Json::array(); }));
  reason(text, "$.stars[0]: its modulus changes no sign", star([](Json& s) {
           s["between"] = {"1/4", "1/3"};
         }));
  reason(text, "$.stars[0]: its modulus changes no sign",
         star([](Json& s) { std::swap(s["between"][0], s["between"][1]); }));
  reason(text, "$.", star([](Json& s) { s["between"] = {"0", "1/2"}; }));  // right, but too wide
  for (const char* key : {"at", "rows"})
    for (const std::size_t i : {0U, 1U})
      reason(text, "$.", star([&](Json& s) {
               Json& list = key[0] == 'r' ? s["rows"][2] : s["at"];
               if (list[i].is_array())
                 list[i][1] = "1/7";
               else
                 list[i] = "1/7";
             }));
  reason(text, "$.", star([](Json& s) { s["at"][0] = Json({"0", "1", "1/3"}); }));
  reason(text, "$.stars[0]: its coordinates", star([](Json& s) { s["axes"][0][0] = Json({"0", "1"}); }));
  reason(text, "$.stars[0]: its last row", star([](Json& s) { std::swap(s["rows"][0], s["rows"][2]); }));
  reason(text, "$.arcs[0].points[", [](Json& j) {
    Json& arc = j["arcs"][0];
    const bool begins = arc["from"] >= j["nodes"].size();
    REQUIRE((begins || arc["to"] >= j["nodes"].size()));
    Json& u = (begins ? arc["points"].front() : arc["points"].back())[0];
    u = to_string(Rational(checker::number_of(u.get<std::string>()) + power_of_two(-39)));
  });
}

TEST_CASE("a star of another number than that of the intersection is rejected") {
  reason(touch_text(), "$.stars[0]: its last row is not normal", [](Json& j) {
    Json& star = j["stars"][0];
    star["modulus"][0] = "-9/4";
    star["between"] = {"9/20", "23/50"};
  });
  // The conjugate number is a solution of the equations as well, but beyond the squares.
  reason(touch_text(), "$.stars[0]: not in [0,1]^4", [](Json& j) {
    j["stars"][0]["between"] = {"-5", "-4"};
  });
}

TEST_CASE("no random single change of a certificate with an irrational star is accepted") {
  Generator generator(33);
  INFO("seed 33");
  reject_changes(crossing_text(), generator, 40);
}

TEST_CASE("a forged irrational star is rejected, or says the same as the true one") {
  Generator generator(34);
  INFO("seed 34");
  CHECK(rejected_forgeries(crossing_text(), {"stars"}, generator, 40) > 20);
}

}  // namespace exsect::certificate_algebraic_test
