// Proved points of the curve where traces may start and end. Internal to solver/; docs/method-doubles.md,
// sections 14.9 and 14.26.
#pragma once

#include <optional>

#include "filter/tube.h"

namespace exsect::filter {

/// Near a place, where `axis` moves fastest: exactly one solution in the ball has the value of ball.middle in
/// `axis`.
template <class K>
std::optional<BallOf<K>> point_of_curve(const PairOf<K>& pair, const Vec4& place, std::size_t axis);

/// How far x at the middle of a ball is from x at any point of it at most, with what graphs do not know of
/// weighted patches: errors of the values.
template <class K>
double vertex_error(const PairOf<K>& pair, const Vec4& middle, double radius);

/// It is so small that tubes which start there, or come close, have some room.
template <class K>
bool has_room(const BallOf<K>& ball);

}  // namespace exsect::filter
