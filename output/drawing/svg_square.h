// The unit square of two parameters, drawn in a picture.
#pragma once

#include <string>
#include <vector>

#include "output/drawing/plane_curve.h"
#include "output/drawing/svg_picture.h"

namespace exsect::cli {

/// Polylines are simplified to this distance before they are drawn; the side of the square is 1.
inline constexpr double drawing_tolerance = 1e-4;

/// A frame with ticks at every fifth and the names of both axes: the first parameter runs to the right.
class SvgSquare {
 public:
  static constexpr double size = 360;

  /// Draws the frame. Names and numbers take 46 units to the left and 42 below it.
  SvgSquare(SvgPicture& picture, double left, double top, const std::string& across,
            const std::string& upwards);

  void polyline(const PlanePolyline& polyline, const Stroke& stroke);
  /// The region inside closed rings (even-odd), in a light tint of the colour.
  void region(const std::vector<PlanePolyline>& rings, const std::string& colour);
  /// A grey box, at least a few units wide so that it is seen.
  void box(PlanePoint lower, PlanePoint upper);
  void mark(Mark mark, PlanePoint at, const std::string& colour);
  double x(double across) const { return left_ + size * across; }
  double y(double upwards) const { return top_ + size * (1 - upwards); }

 private:
  std::string path(const PlanePolyline& polyline) const;

  SvgPicture& picture_;
  double left_;
  double top_;
};

/// Two squares side by side: where the first one begins, the gap, and the width of the picture.
inline constexpr double pair_left = 58;
inline constexpr double pair_between = 80;
inline constexpr double pair_width = pair_left + 2 * SvgSquare::size + pair_between + 24;

}  // namespace exsect::cli
