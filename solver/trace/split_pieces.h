// Pieces of a traced curve, split until turning points on them can be told apart. Internal to solver/.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "trace/pair_system.h"

namespace exsect {

/// Why pieces could not be split any further: at this offset of the piece.
template <class Piece>
struct SplitFailure {
  Piece piece;
  double at;
  const char* why;
};

/// Splits the pieces, in their order, until `is_simple` holds for each; empty if that succeeds. `part(piece,
/// from, to)` is the part between two offsets on a tube of its own, empty if that cannot be proved. Gives up
/// beyond `most` pieces. After a failure the pieces are not valid.
template <class Piece, class IsSimple, class Part>
std::optional<SplitFailure<Piece>> split_pieces(std::vector<Piece>& pieces, std::size_t most,
                                                const IsSimple& is_simple, const Part& part) {
  constexpr int kDeepestSplit = 40;
  std::vector<Piece> done;
  std::vector<std::pair<Piece, int>> waiting;
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
    waiting.emplace_back(std::move(*piece), 0);
  }
  while (!waiting.empty()) {
    auto [piece, depth] = std::move(waiting.back());
    waiting.pop_back();
    if (is_simple(piece)) {
      done.push_back(std::move(piece));
      continue;
    }
    if (done.size() > most) {
      return SplitFailure<Piece>{piece, piece.range.from(), "a parameter is nearly constant along a curve"};
    }
    const double middle = piece.range.at(0.4853);
    const auto first = part(piece, piece.range.from(), middle);
    const auto second = part(piece, middle, piece.range.to());
    if (depth >= kDeepestSplit || !first || !second) {
      return SplitFailure<Piece>{piece, middle, "two turning points are too close to be separated"};
    }
    waiting.emplace_back(*second, depth + 1);
    waiting.emplace_back(*first, depth + 1);
  }
  pieces = std::move(done);
  return std::nullopt;
}

/// Encloses the tube's curve between two offsets, in either order.
template <class Ball, template <class> class AnyTube>
BallPoint<Ball> box_between(const AnyTube<Ball>& tube, double from, double to) {
  const double middle = 0.5 * (from + to);
  // The second term covers the rounding of `middle` and of the difference (each below 2^-52 times the larger
  // end).
  const double half =
      0.5 * std::fabs(to - from) + 0x1p-50 * larger_bound(std::fabs(from), std::fabs(to)) + kUnderflowLoss;
  BallPoint<Ball> box = point_at(tube, middle);
  for (std::size_t j = 0; j < 4; ++j) {
    box[j] = box[j].widened(half * (std::fabs(tube.slope[j]) + tube.slope_error[j]) * kSlack);
  }
  return box;
}

}  // namespace exsect
