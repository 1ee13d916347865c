#include "trace/shorter_piece.h"

#include <cmath>

#include "support/known_curves.h"
#include "trace/tube_points.h"

namespace exsect::shorter_piece_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

/// The distance of a point of the plane from the circle.
double off_circle(const BallPoint<DoubleBall>& p) {
  return std::fabs(std::hypot(p[0].approximation() - 0.5, p[1].approximation() - 0.5) - 1.0 / 3);
}

}  // namespace

TEST_CASE("shorter piece: between two offsets, the same arc in the same direction", "[trace]") {
  const auto system = system_of<DoubleBall>(kCircle);
  for (const Piece<DoubleBall>& piece : circle_trace().pieces) {
    const double from = piece.range.at(0.25), to = piece.range.at(0.75);
    const auto part = shorter_piece(system, piece, from, to);
    REQUIRE(part);
    CHECK(part->range.length() <= piece.range.length() * 1.5);  // the axis may be another one
    // Its ends are those of the part, in this order, and its points are on the circle.
    for (const auto& [old_offset, new_offset] :
         {std::pair<double, double>{from, part->range.from()}, {to, part->range.to()}}) {
      const auto a = point_at(piece.tube, old_offset), b = point_at(part->tube, new_offset);
      for (std::size_t j = 0; j < 4; ++j)
        CHECK(a[j].approximation() == Approx(b[j].approximation()).margin(1e-12));
    }
    for (const double at : {0.0, 0.3, 0.5, 1.0})
      CHECK(off_circle(point_at(part->tube, part->range.at(at))) < 1e-13);
    CHECK(part->tube.reach < piece.tube.reach);
  }
}

TEST_CASE("shorter piece: a tube of its size for an arc that is shorter than the rounding", "[trace]") {
  // u + v = 2^-50, 1: the step that finds its end is as long as the square.
  const Rational e = power_of_two(-50);
  const auto system = system_of<DoubleBall>({{{-e, 1, 0}, {1, 0, 0}, {0, 0, 0}}});
  const Landmarks<DoubleBall> landmarks = {on_diagonal(0, e), on_diagonal(e, 0)};
  const int sign = Expansion<DoubleBall>(system, landmarks[0]).tangent()[0].certain_sign();
  auto trace = require_trace(trace_arc(system, landmarks, 0, sign, {}));
  resolve_short_arc(system, trace);
  REQUIRE(trace.pieces.size() == 1);
  CHECK(trace.start == 0);
  CHECK(trace.end == 1);
  const Piece<DoubleBall>& piece = trace.pieces[0];
  CHECK(piece.tube.reach < 0x1p-40);
  const auto first = point_at(piece.tube, piece.range.from()), last = point_at(piece.tube, piece.range.to());
  CHECK(first[0].approximation() < last[0].approximation());
  CHECK(first[1].approximation() > last[1].approximation());
}

}  // namespace exsect::shorter_piece_test
