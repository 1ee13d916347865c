#include "trace/shorter_piece.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "trace/tube.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

/// An arc that ends within this part of the reach of its only tube is short.
constexpr double kShort = 0x1p-10;
constexpr int kMiddleSteps = 8;

}  // namespace

template <class Ball>
std::optional<Piece<Ball>> shorter_piece(const PairSystem<Ball>& system, const Piece<Ball>& piece,
                                         const BallPoint<Ball>& start, const BallPoint<Ball>& end,
                                         const BallPoint<Ball>& centre) {
  double radius = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    radius = larger_bound(radius, centre[j].radius(), start[j].radius(), end[j].radius());
  }
  const std::size_t axis = piece.tube.axis;
  const double length = std::fabs((end[axis] - start[axis]).approximation());
  const auto result = certify_tube(system, centre, axis, 0.505 * length + 2 * radius, 4 * radius);
  const auto range =
      result ? range_on(*result, start, centre, end, piece.range.direction()) : std::optional<PieceRange>();
  return range ? std::optional(Piece<Ball>{*result, *range}) : std::nullopt;
}

template <class Ball>
std::optional<Piece<Ball>> shorter_piece(const PairSystem<Ball>& system, const Piece<Ball>& piece,
                                         double from, double to) {
  return shorter_piece(system, piece, point_at(piece.tube, from), point_at(piece.tube, to),
                       point_at(piece.tube, 0.5 * (from + to)));
}

template <class Ball>
void resolve_short_arc(const PairSystem<Ball>& system, Trace<Ball>& trace) {
  const Piece<Ball> piece = trace.pieces.front();
  if (trace.start < 0 || trace.pieces.size() > 1 || piece.range.length() > kShort * piece.tube.reach) {
    return;
  }
  BallPoint<Ball> middle;
  for (std::size_t j = 0; j < 4; ++j) {
    middle[j] = (Ball(0.5) * (trace.ends[0][j] + trace.ends[1][j])).midpoint();
  }
  const auto centre = newton_corrected(system, middle, piece.tube.axis, kMiddleSteps);
  const auto resolved = centre ? shorter_piece(system, piece, trace.ends[0], trace.ends[1], *centre)
                               : std::optional<Piece<Ball>>();
  if (resolved) {
    trace.pieces.front() = *resolved;
  }
}

#define EXSECT_INSTANTIATE_SHORTER_PIECE(Ball)                                                           \
  template std::optional<Piece<Ball>> shorter_piece(const PairSystem<Ball>&, const Piece<Ball>&,         \
                                                    const BallPoint<Ball>&, const BallPoint<Ball>&,      \
                                                    const BallPoint<Ball>&);                             \
  template std::optional<Piece<Ball>> shorter_piece(const PairSystem<Ball>&, const Piece<Ball>&, double, \
                                                    double);                                             \
  template void resolve_short_arc(const PairSystem<Ball>&, Trace<Ball>&);

EXSECT_INSTANTIATE_SHORTER_PIECE(DoubleBall)
EXSECT_INSTANTIATE_SHORTER_PIECE(DoubleDoubleBall)
EXSECT_INSTANTIATE_SHORTER_PIECE(ArbBall<256>)
EXSECT_INSTANTIATE_SHORTER_PIECE(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_SHORTER_PIECE

}  // namespace exsect
