#include "output/text/node_place.h"

#include <exsect/geometry/patch_file.h>

#include <random>

#include "cli/run_program.h"
#include "support/catch.h"

namespace exsect::cli::node_place_test {
namespace {

const BezierPatch& patch_of(const PatchFile& file, std::size_t i) { return file.patches[i].patch; }

TEST_CASE("the box of space around a point holds what the exact parameters give") {
  const PatchFile file = read_patches(example("chapter9-first.json"));
  const BezierPatch& x = patch_of(file, 0);
  const unsigned seed = 11;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> draw(0, 1000);
  for (int i = 0; i < 50; ++i) {
    const Rational u(draw(random), 1000);
    const Rational v(draw(random), 1000);
    const Rational wide(draw(random), 1000);
    // The patch with itself: (u,v,u,v) solves it, and the second box may be as wide as it likes.
    const ParameterBox box = {{{u, u + wide}, {v - wide, v}, {u, u}, {v - wide, v + wide}}};
    const Point p = x(u, v);
    const SpaceBox place = space_box(box, x, x);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(place[k].lower <= p[k]);
      CHECK(place[k].upper >= p[k]);
    }
    const SpaceBox point = space_box({{{u, u}, {v, v}, {0, 1}, {0, 1}}}, x, x);
    for (std::size_t k = 0; k < 3; ++k) CHECK((point[k].lower == p[k] && point[k].upper == p[k]));
  }
}

TEST_CASE(
    "coordinates have as many digits below the first digit of the largest one as parameters have decimals") {
  const BezierPatch plane =
      BezierPatch::elevated({{Point{0, 0, 0}, Point{0, 254, 0}}, {Point{254, 0, 0}, Point{254, 254, 0}}});
  const Rational third(1, 3);
  const Rational near = third + Rational(1, Integer(1) << 40);
  const auto rows = place_rows({{{{third, near}, {1, 1}, {third, near}, {1, 1}}}}, plane, plane, 6);
  REQUIRE(rows.size() == 1);
  CHECK(rows[0] == std::vector<std::string>{"0.333333", "1", "0.333333", "1", "84.6667", "254", "0"});
  CHECK(place_rows({}, plane, plane, 6).empty());
}

}  // namespace
}  // namespace exsect::cli::node_place_test
