// Certificates that were made to be accepted although they are false: numbers beyond the doubles, beyond the
// integers of the checker, and bounds that arithmetic with overflow would not keep.
#include <exsect/geometry/number.h>
#include <exsect/geometry/text_file.h>

#include <cfenv>

#include "certificate_changes.h"
#include "support/families.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace exsect::forged_certificate_test {
namespace {

using namespace certificates;
using checker::Ball;
using checker::Enclosure;

std::string found(const std::string& name) {
  return read_text_file(EXSECT_CASES "/found/" + name + ".certificate.json", 1 << 20);
}
/// The kind of violation; it has to be one.
Rejected::Kind kind_of(const std::string& text) {
  try {
    check_certificate(text);
  } catch (const Rejected& rejected) {
    INFO(rejected.place() << ": " << rejected.what());
    CHECK(!rejected.place().empty());
    return rejected.kind();
  }
  FAIL("accepted");
  return {};
}
std::string sheets() {
  static const ExactCase c = families::tangent_curve(Rational(1, 3), families::Plane::square);
  static const std::string text = certificate(c.x, c.y);
  return text;
}
Rejected::Kind kind_after(const std::string& text, const std::function<void(Json&)>& change) {
  Json json = Json::parse(text);
  change(json);
  seal_again(json);
  return kind_of(json.dump());
}

}  // namespace

TEST_CASE("what is beyond the doubles separates nothing") {
  CHECK(kind_of(found("forged-nan-in-doubles")) == Rejected::Kind::cover);
  CHECK(kind_of(found("forged-nan-beyond-doubles")) == Rejected::Kind::cover);
}

TEST_CASE("a number that does not fit its integer is not another one") {
  CHECK(kind_of(found("forged-exponent")) == Rejected::Kind::form);
  for (const std::uint64_t n :
       {std::uint64_t{13}, std::uint64_t{1} << 31, (std::uint64_t{1} << 31) + 1, (std::uint64_t{1} << 32),
        (std::uint64_t{1} << 32) + 1, std::uint64_t{1} << 63, ~std::uint64_t{0}}) {
    INFO(n);
    CHECK(kind_after(sheets(), [n](Json& j) { j["factors"][0]["map"][0][0][1] = n; }) ==
          Rejected::Kind::form);
    CHECK(kind_after(sheets(), [n](Json& j) { j["factors"][0]["powers"][0] = n; }) == Rejected::Kind::claim);
    CHECK(kind_after(sheets(), [n](Json& j) { j["arcs"][0]["pieces"][0][1] = n; }) != Rejected::Kind::form);
    CHECK(kind_after(sheets(), [n](Json& j) { j["arcs"][0]["from"] = n; }) == Rejected::Kind::graph);
    CHECK(kind_after(sheets(), [n](Json& j) { j["nodes"][0]["tube"] = n; }) == Rejected::Kind::claim);
    CHECK(kind_after(sheets(), [n](Json& j) { j["cover"][0] = "t" + std::to_string(n) + " #"; }) !=
          Rejected::Kind::seal);
  }
}

TEST_CASE("what is larger than docs/certificate.md allows is rejected where it stands") {
  const auto form = [](auto change) { CHECK(kind_after(sheets(), change) == Rejected::Kind::form); };
  form([](Json& j) { j["factors"][0]["map"][0].push_back({"1", 4, 4, 4, 1}); });
  form([](Json& j) { j["tubes"][0]["reach"] = "1/1" + std::string(6100, '0'); });
  form([](Json& j) { j["tubes"][0]["reach"] = std::string(100000, '7'); });
  form([](Json& j) { j["first"]["name"] = Json::array(); });
  std::string text = sheets();
  text.replace(text.find("\"name\":\"x\""), 10, "\"name\":\"\\q\"");
  CHECK_THROWS_AS(check_certificate(text), Unreadable);
  // Depth and length of a subdivision.
  const std::string forever = [] {
    std::string entries = "u";
    for (int i = 0; i < 60; ++i) entries += " u";
    return entries + " #";
  }();
  CHECK(kind_after(sheets(), [&](Json& j) { j["cover"] = {forever}; }) == Rejected::Kind::summary);
  CHECK(kind_after(sheets(), [&](Json& j) {
          j["cover"] = {forever};
          j["summary"]["claims"][5] = 61;
        }) == Rejected::Kind::cover);
  std::string many;
  for (std::size_t i = 0; i <= checker::max_entries; ++i) many += "u ";
  form([&](Json& j) { j["cover"] = {many + "#"}; });
  // Deep nesting, and an integer that is written in another way.
  text = sheets();
  const std::size_t at = text.find("\"tubes\"");
  const std::string nested = std::string(200000, '[') + std::string(200000, ']') + ",";
  CHECK(kind_of(text.insert(text.find('[', at) + 1, nested)) == Rejected::Kind::form);
}

TEST_CASE("maps of a high degree, as t has in charts of stars, are moved exactly") {
  checker::Map<Rational> map;
  map.coefficient({2, 1, 0, 40}) = {1, -1, 2};  // binomial coefficients up to 2^37
  map.coefficient({0, 0, 1, 36}) = {5, 0, -1};
  const checker::Vector4<Rational> w = {Rational(1, 2), -3, Rational(2, 3), 5};
  const checker::Vector4<Rational> h = {7, Rational(1, 5), -1, Rational(1, 7)};
  const checker::Vector4<Rational> both = {w[0] + h[0], w[1] + h[1], w[2] + h[2], w[3] + h[3]};
  CHECK(map.at(w).value(h) == map.value(both));
  checker::Map<Rational> high;
  high.coefficient({0, 0, 0, 72}) = {1, 0, 0};  // binomial coefficients up to 2^68
  const checker::Vector4<Rational> one = {0, 0, 0, 1};
  CHECK(high.at(one).value(one) == high.value({0, 0, 0, 2}));
}

TEST_CASE("nothing is divided by what may be 0") {
  const Ball<Rational> a = {1, Rational(1, 8)};
  CHECK((a / Ball<Rational>(2, 1)).radius > 0);
  for (const Ball<Rational>& b : {Ball<Rational>(1, 1), Ball<Rational>(1, 2), Ball<Rational>(0, 0)})
    CHECK_THROWS_AS(a / b, checker::Failed);
  const Ball<Enclosure> unsure = {Enclosure(1), Enclosure(Rational(1)) - Enclosure(0x1p-60)};
  CHECK_THROWS_AS(Ball<Enclosure>(Enclosure(1)) / unsure, checker::Failed);
}

namespace {

/// With an error bound of 2^-60: the one that is needed.
double needed_bound(Json& json) {
  json["arcs"][0]["error_bound"] = "1/2^60";
  seal_again(json);
  try {
    check_certificate(json.dump());
  } catch (const Rejected& rejected) {
    if (rejected.kind() == Rejected::Kind::error_bound && rejected.place() == "$.arcs[0]")
      return rejected.needed().value_or(0);
  }
  return 0;
}

}  // namespace

TEST_CASE("an arc whose error bound is too small is rejected with the bound that it needs") {
  Json json = Json::parse(sheets());
  const double needed = needed_bound(json);
  REQUIRE(needed > 0);
  const auto with = [&](double bound) {
    json["arcs"][0]["error_bound"] = to_string(from_double(bound));
    seal_again(json);
    return verdict(json.dump());
  };
  CHECK(with(needed) == "");
  CHECK(with(needed * (1 - 0x1p-20)) == "$.arcs[0]: the error bound is too small");
}

namespace {

/// The certificate's arcs and edges of overlaps, with these error bounds instead.
Json with_error_bounds(Json json, const std::string& bound) {
  for (Json& arc : json["arcs"]) arc["error_bound"] = bound;
  for (Json& overlap : json["overlaps"])
    for (Json& edge : overlap["edges"]) edge["error_bound"] = bound;
  seal_again(json);
  return json;
}

}  // namespace

TEST_CASE("all error bounds that are too small are found at once, where nothing else is wrong") {
  const ExactCase overlap = families::shifted_copy();
  for (const std::string& text : {sheets(), certificate(overlap.x, overlap.y)}) {
    CHECK(checker::too_small_error_bounds(text).empty());
    Json json = with_error_bounds(Json::parse(text), "1/2^60");
    const std::vector<checker::Shortfall> found = checker::too_small_error_bounds(json.dump());
    std::size_t all = json["arcs"].size();
    for (const Json& one : json["overlaps"]) all += one["edges"].size();
    CHECK(found.size() == all);
    for (const auto& [in, i, needed] : found)
      (in ? json["overlaps"][*in]["edges"][i] : json["arcs"][i])["error_bound"] =
          to_string(from_double(1.125 * needed));
    seal_again(json);
    CHECK(verdict(json.dump()) == "");
  }
  Json json = with_error_bounds(Json::parse(sheets()), "1/2^60");
  json["summary"]["open"] = 7;
  seal_again(json);
  CHECK_THROWS_AS(checker::too_small_error_bounds(json.dump()), Rejected);
  json = with_error_bounds(Json::parse(sheets()), "1/2^60");
  json["cover"].erase(json["cover"].size() - 1);
  seal_again(json);
  CHECK_THROWS_AS(checker::too_small_error_bounds(json.dump()), Rejected);
}

TEST_CASE("each kind of violation has a name") {
  using Kind = Rejected::Kind;
  CHECK(std::string(name(Kind::form)) == "form");
  CHECK(std::string(name(Kind::error_bound)) == "error-bound");
  CHECK(std::string(name(Kind::summary)) == "summary");
  CHECK(kind_after(sheets(), [](Json& j) { j["components"][0]["shape"] = "closed"; }) == Kind::graph);
  CHECK(kind_after(sheets(), [](Json& j) { j["tubes"][0]["width"] = "0"; }) == Kind::claim);
  Json json = Json::parse(sheets());
  json["tubes"][0]["seal"] = "0";
  CHECK(kind_of(json.dump()) == Kind::seal);
}

TEST_CASE("the caller's rounding mode and flushing to zero change no verdict, and come back") {
  const std::vector<std::string> accepted = {sheets()};
  Json too_near = Json::parse(sheets());
  const double needed = needed_bound(too_near);
  const std::vector<std::string> rejected = {found("forged-nan-in-doubles"), found("forged-exponent")};
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    for (const bool flush : {false, true}) {
      REQUIRE(std::fesetround(mode) == 0);
#if defined(__SSE2__)
      if (flush) _mm_setcsr(_mm_getcsr() | 0x8040);  // flush to zero, denormals are zero
      const unsigned before = _mm_getcsr() & 0xFFC0U;
#endif
      bool right = true;
      for (const std::string& text : accepted) {
        const std::string said = verdict(text);
        right = right && said.empty();
      }
      for (const std::string& text : rejected) right = right && !verdict(text).empty();
      const bool same_bits = needed_bound(too_near) == needed;  // a number that rounding changes
      const bool kept = std::fegetround() == mode;
#if defined(__SSE2__)
      const bool same = (_mm_getcsr() & 0xFFC0U) == before;
      _mm_setcsr(_mm_getcsr() & ~0x8040U);
#else
      const bool same = true;
#endif
      std::fesetround(FE_TONEAREST);
      INFO(mode << " " << flush);
      CHECK(right);
      CHECK(same_bits);
      CHECK(kept);
      CHECK(same);
    }
  }
}

}  // namespace exsect::forged_certificate_test
