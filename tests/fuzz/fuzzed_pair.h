// Pairs of patches with small integer nets from a string of bytes, and what has to hold for each of them.
#pragma once

#include <exsect/solver/result.h>

#include <cstdint>
#include <span>
#include <string>

#include "support/random_pairs.h"

namespace exsect::fuzz {

/// The first byte chooses how the nets are made, the others are coordinates: byte b means b mod 5 - 2;
/// missing bytes mean 0.
///   0, 1: both nets free; in {-2..2}, in {-1..1}
///   2, 3: y has a side of x, in the same or the opposite direction
///   4: y is x but for one control point
///   5: y is x over a rectangle with ends in {-1/2, 0, 1/2, 1, 3/2}
///   6: x is bilinear
///   7: y lies in the plane z = 0
///   8: x has a side that is a point
///   9: x is a graph patch, y the plane patch
random_pairs::Pair pair(std::span<const std::uint8_t> bytes);

/// What was found out about a pair.
struct Verdict {
  std::string violation;  // empty: nothing is wrong
  IntersectResult result;
  int compared_lines = 0;  // with the oracle, of 12; with exact fibres, of 6
};

/// Intersects both ways round: the same status and graph, sound and in agreement with the oracle. The
/// processor time must keep to `max_seconds` for each, but for a tenth and half a second; with a work cap
/// that was reached nothing is compared.
Verdict check(const random_pairs::Pair& pair, double max_seconds);

/// Where the patch meets itself: sound, the same status and numbers of components and arcs with the
/// parameters exchanged, and as many crossings of some parameter lines as their exact fibres have points.
Verdict check_self(const BezierPatch& x, double max_seconds);

}  // namespace exsect::fuzz
