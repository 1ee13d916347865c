// Corners that both patches have in common, and the proof that a pair of sub-patches meets nowhere else.
// Internal to solver/; docs/method-doubles.md, section 14.7.
#pragma once

#include <optional>

#include "filter/part.h"

namespace exsect::filter {

/// How many control points next to a corner are the corner itself, in a row along the first, the second
/// parameter; the one at the other end of a side is not counted.
using Repeated = std::array<std::size_t, 2>;

/// A corner of x, by its index in the net, is one of y. If a side of a patch is one point, a pole, the corner
/// stands for all of it: then it is the lower one of its two ends.
struct CornerContact {
  std::size_t x;
  std::size_t y;
  std::optional<SquareSide> pole_of_x = std::nullopt;
  std::optional<SquareSide> pole_of_y = std::nullopt;
  Repeated repeated_of_x = {};
  Repeated repeated_of_y = {};
  /// A power of two at most 1, if not 0: the parts of both patches that are so near to the corner in both
  /// parameters, or to its pole's side across it, meet there alone, or in it and the arcs of a branched one.
  double lone_reach = 0;
  bool is_pole() const { return pole_of_x || pole_of_y; }
};

/// Whether a corner is at the end of the first, the second parameter's interval.
template <class K>
std::array<bool, 2> corner_ends(std::size_t corner) {
  return {corner >= K::degree * K::side, corner % K::side == K::degree};
}

/// The index of the corner with these parameters; empty if it is none.
template <class K>
std::optional<std::size_t> corner_of(const Rational& first, const Rational& second) {
  const auto is_end = [](const Rational& t) { return t == 0 || t == 1; };
  if (!is_end(first) || !is_end(second)) return std::nullopt;
  return (first == 1 ? K::degree * K::side : 0) + (second == 1 ? K::degree : 0);
}

/// Its parameters, centred. Requires that it is no pole.
template <class K>
Vec4 place_of(const CornerContact& corner) {
  const auto x = corner_ends<K>(corner.x);
  const auto y = corner_ends<K>(corner.y);
  const auto place = [](bool end) { return end ? 0.5 : -0.5; };
  return {place(x[0]), place(x[1]), place(y[0]), place(y[1])};
}

/// Whether both parts reach the corner, or its pole.
template <class K>
bool may_touch(const CornerContact& corner, const Part& x, const Part& y);

/// True only if the parts meet in the corner p, or its pole, alone or not at all.
template <class K>
bool meet_in_corner(const Vec3& p, const CornerContact& corner, const Part& x, const Part& y,
                    double net_error);

}  // namespace exsect::filter
