// Sides of one patch that lie on the other one along a straight line of its parameters. Internal to solver/;
// docs/method-doubles.md, section 14.7.
#pragma once

#include <array>
#include <optional>

#include "filter/exact_patch.h"
#include "filter/part.h"

namespace exsect::filter {

/// The point t of a side, t increasing with the parameter along it, is the other patch's point
/// (1-f) ends[0] + f ends[1], f = ratio t / (1 - t + ratio t), for all t; exactly. `common` are the t in
/// [0,1] for which that is in the square: more than one. Without weights ratio = 1.
struct SidePath {
  bool of_x;  // the side is one of x, the line one of y; else the other way round
  SquareSide side;
  std::array<std::array<Rational, 2>, 2> ends;
  Rational ratio;
  RationalInterval common;

  /// (u,v,r,s) of the point t.
  std::array<Rational, 4> at(const Rational& t) const;
};

/// The path of the side that parameter `fixed` (0..3) has at 1 or, unless `upper`, at 0, if it has one that
/// passes near the solution `near` (centred) on it. Looks for it in doubles first, and proves it by
/// substitution.
template <class K>
std::optional<SidePath> side_path_near(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                                       std::size_t fixed, bool upper, const Vec4& near);

/// The Moebius map of [0,1] that keeps 0 and 1 (14.84), by five operations on numbers that are not negative;
/// ratio > 0. Its inverse is that of 1 / ratio.
template <class Number>
Number along_path(const Number& ratio, const Number& t) {
  return ratio * t / (1 - t + ratio * t);
}

/// The same of a parameter line of one patch, inside or a side, on which the first (0) or second (1)
/// parameter is `value`, and t its other one.
struct LinePath {
  bool of_x;
  std::size_t parameter;
  Rational value;
  std::array<std::array<Rational, 2>, 2> ends;
  Rational ratio;
  RationalInterval common;

  std::array<Rational, 4> at(const Rational& t) const;
};

/// The path of the line on which parameter `fixed` (0..3) is `value`, in [0,1], as above.
template <class K>
std::optional<LinePath> line_path_near(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                                       std::size_t fixed, const Rational& value, const Vec4& near);

}  // namespace exsect::filter
