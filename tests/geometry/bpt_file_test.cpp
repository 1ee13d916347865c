#include <exsect/geometry/bpt_file.h>

#include <map>
#include <set>

#include "scratch_directory.h"
#include "support/catch.h"

namespace exsect::bpt_file_test {
using Catch::Matchers::Contains;

namespace {

/// One bilinear patch and one of bidegree (3,1), with comments and blank lines.
const std::string small =
    "# two patches\n2\r\n1 1\n0 0 0\n0 1/2 0 # half\n1 0 0  1 1 0.1\n\n"
    "3 1\n0 0 0\n0 1 0\n1 0 1e-3\n1 1 1\n2 0 0\n2 1 0\n3 0 0\n3 1 5";

using Side = std::vector<Point>;

std::vector<Side> sides(const RationalPatch& patch) {
  std::vector<Side> result(4);
  for (int t = 0; t <= 3; ++t) {
    result[0].push_back(patch.point(0, t));
    result[1].push_back(patch.point(3, t));
    result[2].push_back(patch.point(t, 0));
    result[3].push_back(patch.point(t, 3));
  }
  return result;
}

Side unoriented(const Side& side) { return std::min(side, Side(side.rbegin(), side.rend())); }

/// The net as a set of rows or columns that does not depend on the parameters' order and directions.
std::vector<Side> unoriented_net(const RationalPatch& patch, const Point& scale) {
  std::vector<std::vector<Side>> nets;
  for (const RationalPatch& net : {patch, patch.transposed()})
    for (const bool reversed_u : {false, true})
      for (const bool reversed_v : {false, true}) {
        nets.emplace_back();
        for (int i = 0; i <= 3; ++i) {
          nets.back().emplace_back();
          for (int j = 0; j <= 3; ++j) {
            const Point p = net.point(reversed_u ? 3 - i : i, reversed_v ? 3 - j : j);
            nets.back().back().push_back({scale[0] * p[0], scale[1] * p[1], scale[2] * p[2]});
          }
        }
      }
  return *std::min_element(nets.begin(), nets.end());
}

}  // namespace

TEST_CASE("patches of a BPT file are read", "[bpt_file]") {
  const RationalPatchFile file = parse_bpt(small, "f.bpt");
  REQUIRE(file.patches.size() == 2);
  CHECK(file.patches[0].name == "1");
  CHECK(file.patches[0].patch.point(0, 1) == Point{0, Rational(1, 2), 0});
  CHECK(file.patches[0].patch.point(1, 1) == Point{1, 1, Rational(1, 10)});
  const RationalPatch& second = file.patches[1].patch;
  CHECK((file.patches[1].name == "2" && second.degree_u() == 3 && second.degree_v() == 1));
  CHECK(second.point(1, 0) == Point{1, 0, Rational(1, 1000)});
  CHECK(second.point(3, 1) == Point{3, 1, 5});
}

TEST_CASE("bad BPT files are refused with their line", "[bpt_file]") {
  const auto refusal = [](const std::string& text) {
    try {
      parse_bpt(text, "f.bpt");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    FAIL("accepted: " << text);
    return std::string();
  };
  const std::string flat = "1\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 ";
  CHECK_THAT(refusal(""), Contains("f.bpt: line 1: number of patches expected, the file ends"));
  CHECK_THAT(refusal("# nothing\n"), Contains("number of patches expected"));
  CHECK_THAT(refusal("0\n"), Contains("f.bpt: line 1: must hold at least one patch"));
  CHECK_THAT(refusal("1.5\n"), Contains("f.bpt: line 1: number of patches must be a whole number"));
  CHECK_THAT(refusal("-1\n"), Contains("whole number"));
  CHECK_THAT(refusal("99999999999999999999\n"), Contains("is more than"));
  CHECK_THAT(refusal("1\n\n4 3\n"), Contains("f.bpt: line 3: degree 4 is not supported: must be 1, 2 or 3"));
  CHECK_THAT(refusal("1\n3 0\n"), Contains("f.bpt: line 2: degree 0 is not supported"));
  CHECK_THAT(refusal(flat), Contains("f.bpt: line 6: coordinate z expected, the file ends"));
  CHECK_THAT(refusal(flat + "nan"), Contains("f.bpt: line 6: \"nan\" is not a number"));
  CHECK_THAT(refusal(flat + "1e9999"), Contains("exponent beyond"));
  CHECK_THAT(refusal(flat + "0\n7"), Contains("f.bpt: line 7: there is more than 1 patches"));
  std::string point = "1\n3 3\n";
  for (int i = 0; i < 16; ++i) point += "1 2 3\n";
  CHECK_THAT(refusal(point),
             Contains("f.bpt: line 18: the patch that ends here: all control points coincide"));
  for (std::size_t n = 0; n + 1 < small.size(); ++n)
    if (!std::string(refusal(small.substr(0, n))).starts_with("f.bpt: line "))
      FAIL("prefix of " << n << " bytes");
}

TEST_CASE("the teapot has 32 bicubic patches that fit together", "[bpt_file]") {
  const RationalPatchFile file = read_rational_patches(EXSECT_EXAMPLES "/teapot.bpt");
  REQUIRE(file.patches.size() == 32);
  std::set<Point> points;
  std::map<Side, std::set<std::size_t>> shared;
  for (std::size_t k = 0; k < file.patches.size(); ++k) {
    const RationalPatch& patch = file.patches[k].patch;
    CHECK(file.patches[k].name == std::to_string(k + 1));
    CHECK((patch.degree_u() == 3 && patch.degree_v() == 3));
    CHECK((patch.reduced().degree_u() == 3 && patch.reduced().degree_v() == 3));
    for (int i = 0; i < 16; ++i) points.insert(patch.point(i / 4, i % 4));
    for (const Side& side : sides(patch)) shared[unoriented(side)].insert(k + 1);
  }
  CHECK(points.size() == 290);
  // Sides of one patch only: the rims of body and lid, the ends of the handle and of the spout.
  std::multiset<std::size_t> open;
  std::size_t in_two = 0;
  std::vector<std::set<std::size_t>> in_more;
  for (const auto& [side, patches] : shared) {
    if (patches.size() == 1) open.insert(*patches.begin());
    if (patches.size() == 2) ++in_two;
    if (patches.size() > 2) in_more.push_back(patches);
  }
  CHECK(open == std::multiset<std::size_t>{1, 2, 3, 4, 13, 14, 15, 16, 17, 18, 19, 20, 25, 26, 27, 28});
  CHECK(in_two == 52);
  // The knob's top and the middle of the bottom are collapsed sides.
  CHECK(in_more == std::vector<std::set<std::size_t>>{{29, 30, 31, 32}, {21, 22, 23, 24}});
}

TEST_CASE("the teapot is its own mirror image in y, but for handle and spout in x", "[bpt_file]") {
  const RationalPatchFile file = read_rational_patches(EXSECT_EXAMPLES "/teapot.bpt");
  std::set<std::vector<Side>> nets;
  for (const NamedRationalPatch& named : file.patches) nets.insert(unoriented_net(named.patch, {1, 1, 1}));
  CHECK(nets.size() == 32);
  for (std::size_t k = 1; k <= 32; ++k) {
    INFO(k);
    const RationalPatch& patch = file.patches[k - 1].patch;
    CHECK(nets.count(unoriented_net(patch, {1, -1, 1})) == 1);
    CHECK((nets.count(unoriented_net(patch, {-1, 1, 1})) == 1) == (k < 13 || k > 20));
  }
}

TEST_CASE("a file is BPT by its name", "[bpt_file]") {
  const ScratchDirectory directory;
  for (const char* name : {"a.bpt", "b.BPT"}) {
    write_file_atomically(directory.path(name), small);
    CHECK(read_rational_patches(directory.path(name)) == parse_bpt(small, ""));
  }
  write_file_atomically(directory.path("c.json"), small);
  CHECK_THROWS_WITH(read_rational_patches(directory.path("c.json")), Contains("not valid JSON"));
}

}  // namespace exsect::bpt_file_test
