// The pages of reports as text: what they hold, and that nothing in them ends an element or opens another.
// What they show is tested in a browser, tests/browser.
#include "output/report/report_html.h"

#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/intersect_equations.h>

#include <cctype>

#include "output/report/report_page.h"
#include "output/text/line_json.h"
#include "run_program.h"
#include "sample_result.h"
#include "support/catch.h"

namespace exsect::report_html_test {
namespace {

using cli::Json;

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

std::string between(const std::string& text, const std::string& open, const std::string& close) {
  const std::size_t from = text.find(open);
  REQUIRE(from != std::string::npos);
  const std::size_t begin = from + open.size();
  const std::size_t end = text.find(close, begin);
  REQUIRE(end != std::string::npos);
  return text.substr(begin, end - begin);
}

Json data_of(const std::string& page) {
  return Json::parse(between(page, R"(<script type="application/json" id="data">)", "</script>"));
}

/// Three scripts and a style, none of them ended early, no unfilled place, no address.
void check_page(const std::string& page) {
  CHECK(occurrences(page, "</script") == 3);
  CHECK(occurrences(page, "</style") == 1);
  CHECK(occurrences(page, "<title>") == 1);
  CHECK(occurrences(page, "</title>") == 1);
  CHECK(occurrences(page, "<!--") == 0);
  for (const char* attribute : {" src=\"", "@import", "url(http", "url(\"http"})
    CHECK(page.find(attribute) == std::string::npos);
  for (const char* name :
       {"{{policy}}", "{{title}}", "{{style}}", "{{data}}", "{{three}}", "{{script}}", "{{origin}}",
        "{{grade}}", "{{verdict}}", "{{answer}}", "{{counts}}", "{{picture}}"})
    CHECK(page.find(name) == std::string::npos);
}

const std::string hostile = "</script></title><img src=x onerror=alert(1)><!-- {{ da\"ta }} & \xe2\x80\xa8 '";

TEST_CASE("the page holds its data unchanged, whatever characters they have") {
  const Json data = {{"title", hostile}, {"command", "none"}, {"list", {hostile, 0.1, "\\u003c"}}};
  const std::string page = cli::report_page(hostile, data);
  check_page(page);
  CHECK(page.find("<img") == std::string::npos);
  CHECK(data_of(page) == data);
}

TEST_CASE("bytes that are not UTF-8 do not stop a page") {
  const std::string broken = "a\xff<b\xc3";
  const std::string page = cli::report_page(broken, {{"title", broken}});
  check_page(page);
  CHECK(between(page, "<title>", "</title>") == "a\xef\xbf\xbd&lt;b\xef\xbf\xbd");
  CHECK(data_of(page)["title"] == "a\xef\xbf\xbd<b\xef\xbf\xbd");
}

TEST_CASE("the policy allows the page's own scripts and style by their hashes, and nothing else") {
  const std::string policy = between(cli::report_page("t", Json::object()),
                                     R"(http-equiv="Content-Security-Policy" content=")", "\"");
  CHECK(policy.rfind("default-src 'none'; ", 0) == 0);
  CHECK(policy.find("unsafe") == std::string::npos);
  CHECK(policy.find(':') == policy.find("data:") + 4);
  CHECK(occurrences(policy, "'sha256-") == 3);
  for (std::size_t at = policy.find("sha256-"); at != std::string::npos;
       at = policy.find("sha256-", at + 1)) {
    const std::string hash = policy.substr(at + 7, 44);
    CHECK(hash.back() == '=');
    CHECK(std::all_of(hash.begin(), hash.end() - 1,
                      [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '/'; }));
    CHECK(policy[at + 7 + 44] == '\'');
  }
}

TEST_CASE("the page of an intersection holds the JSON result and exact fibres") {
  const PatchFile file = read_patches(example("chapter9-first.json"));
  const BezierPatch& x = file.patches[0].patch;
  const BezierPatch& y = file.patches[1].patch;
  const IntersectResult result = intersect(x, y, {});
  const cli::PatchNames names = {"x", "y"};
  const std::string page = cli::report_html(result, x, y, names, {file.title, "first.json"});
  check_page(page);
  CHECK(page.size() < 1500000);
  const Json data = data_of(page);
  CHECK(data["title"] == file.title);
  CHECK(data["result"] == cli::intersection_json(result, names));
  REQUIRE(data["fibres"].size() == 41);
  for (const int k : {0, 2, 20, 40}) {
    const LineIntersection line = intersect_line(x, y, {Parameter::u, Rational(k) / 40});
    CHECK(data["fibres"][static_cast<std::size_t>(k)]["result"] == cli::line_json(line, x));
  }
  // method, section 3: of the real roots in [0,1] at u = 1/20 two, at 2/25 one, at 1/2 three
  const Json& fibres = data["fibres"];
  CHECK(fibres[2]["result"]["points"].size() + fibres[2]["phantoms"].size() == 2);
  CHECK(fibres[20]["result"]["points"].size() == 2);
  CHECK(fibres[20]["phantoms"].size() == 1);
}

TEST_CASE("the page of two surfaces given by their equations holds the JSON result and both meshes") {
  const ImplicitSurface tube = ImplicitSurface::cylinder({0, 0, 0}, {1, 2, 3}, 1);
  const ImplicitSurface bowl =
      ImplicitSurface::polynomial(SpacePolynomial({{{2, 0, 0}, 1}, {{0, 2, 0}, 1}, {{0, 0, 1}, -1}}));
  const SurfaceIntersection result = intersect(tube, bowl);
  const cli::SurfaceNames names = {hostile, "bowl", "cylinder", "implicit"};
  const std::string page = cli::surfaces_report_html({result, tube, bowl, names}, {hostile, "a.json"});
  check_page(page);
  const Json data = data_of(page);
  CHECK(data["result"]["exsect"] == "surfaces/1");
  CHECK(data["result"]["nodes"].size() == result.nodes.size());
  CHECK(data["result"]["nodes"][0].contains("charts"));
  CHECK(data["equations"][0]["mesh"]["faces"].size() == 48 * 48);
  CHECK_FALSE(data["equations"][1].contains("mesh"));
  CHECK(data["equations"][1]["terms"].size() == 3);
}

TEST_CASE("every feature of a result has a page, with any names") {
  const BezierPatch x = read_patches(example("chapter9-first.json")).patches[0].patch;
  const IntersectResult result = sample_result();
  const std::string page = cli::self_report_html(result, x, hostile, {hostile, hostile});
  check_page(page);
  CHECK(data_of(page)["result"] == cli::self_json(result, hostile));
}

TEST_CASE("long polynomials are left out of a page") {
  ControlNet net = read_patches(example("chapter9-first.json")).patches[0].patch.net();
  Rational small = Rational(1) / Rational("1234567890123456789012345678901234567890123456789");
  for (auto& row : net)
    for (Point& point : row)
      for (Rational& coordinate : point) coordinate += (small *= Rational(7919) / 7907);
  const BezierPatch x(net);
  const LineIntersection line = intersect_line(x, x.exchanged(), {Parameter::u, Rational(1) / 3});
  const Json data = data_of(cli::line_report_html(line, x, x.exchanged(), {"x", "y"}, {}));
  CHECK(data["fibres"][0]["polynomials"] == false);
  CHECK_FALSE(data["fibres"][0]["result"]["eliminant"].contains("coefficients"));
  CHECK(data["result"] == cli::line_json(line, x));
}

}  // namespace
}  // namespace exsect::report_html_test
