#include "trace/split_pieces.h"

#include <cmath>
#include <string>

#include "support/catch.h"
#include "support/graph_patches.h"
#include "trace/piece_range.h"
#include "trace/tube.h"
#include "trace/tube_points.h"

namespace exsect::split_pieces_test {
namespace {

struct Part {
  PieceRange range;
};

Part part(double from, double to) { return {*PieceRange::between(from, to)}; }

std::optional<Part> part_of(const Part&, double from, double to) {
  const auto range = PieceRange::between(from, to);
  return range ? std::optional(Part{*range}) : std::nullopt;
}

}  // namespace

TEST_CASE("split pieces: in order, without gaps, until all are simple", "[trace]") {
  // Forwards from 0 to 1, then backwards from 1/2 to -1/2.
  std::vector<Part> pieces = {part(0, 1), part(0.5, -0.5)};
  const auto simple = [](const Part& p) { return std::fabs(double(p.range.to()) - p.range.from()) < 0.2; };
  REQUIRE_FALSE(split_pieces(pieces, 1000, simple, part_of));
  CHECK(pieces.size() > 10);
  double at = 0;
  bool is_second = false;
  for (const Part& p : pieces) {
    CHECK(simple(p));
    if (!is_second && at == 1) {
      is_second = true;
      at = 0.5;
    }
    CHECK(double(p.range.from()) == at);
    CHECK(p.range.direction() == (is_second ? -1 : 1));
    at = p.range.to();
  }
  CHECK(is_second);
  CHECK(at == -0.5);
}

TEST_CASE("split pieces: says where, and why, it gave up", "[trace]") {
  const auto never = [](const Part&) { return false; };
  std::vector<Part> pieces = {part(0, 1)};
  const auto deep = split_pieces(pieces, 1000, never, part_of);
  REQUIRE(deep);
  CHECK(deep->at < 1e-10);
  CHECK(std::string(deep->why) == "two turning points are too close to be separated");

  pieces = {part(0, 1)};
  const auto short_alone = [](const Part& p) {
    return std::fabs(double(p.range.to()) - p.range.from()) < 1e-3;
  };
  const auto many = split_pieces(pieces, 20, short_alone, part_of);
  REQUIRE(many);
  CHECK(std::string(many->why) == "a parameter is nearly constant along a curve");

  pieces = {part(0, 1)};
  const auto none = [](const Part&, double, double) { return std::optional<Part>(); };
  CHECK(split_pieces(pieces, 1000, never, none));
}

TEST_CASE("split pieces: the box between two offsets holds the arc there", "[trace]") {
  // u v = 1/4 over u, around (1/2, 1/2).
  testing::HeightCoefficients h{};
  h[0][0] = Rational(-1, 4);
  h[1][1] = 1;
  const PairSystem<DoubleBall> system(testing::graph_patch(h), testing::plane_patch(), {0, 0, 0}, 0);
  const auto tube = certify_tube(system, BallPoint<DoubleBall>{0.5, 0.5, 0.5, 0.5}, 0, 0.05, 0);
  REQUIRE(tube);
  for (const auto& [from, to] : {std::pair(-0.05, 0.05), {0.02, -0.03}, {0.01, 0.01}}) {
    const BallPoint<DoubleBall> box = box_between(*tube, from, to);
    for (const double t : {0.0, 0.25, 1.0}) {
      const Rational u = from_double(0.5 + from + t * (to - from));
      const RationalInterval in_u = box[0].interval(), in_v = box[1].interval();
      const Rational slack = power_of_two(-45);
      CHECK(in_u.lower - slack <= u);
      CHECK(u <= in_u.upper + slack);
      CHECK(in_v.lower - slack <= 1 / (4 * u));
      CHECK(1 / (4 * u) <= in_v.upper + slack);
    }
  }
}

}  // namespace exsect::split_pieces_test
