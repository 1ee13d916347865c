// A rectangle of the plane, drawn in a picture with axes of any range.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "output/drawing/plane_curve.h"
#include "output/drawing/svg_picture.h"

namespace exsect::cli {

/// A closed rectangle in doubles; both sides have positive length.
struct PlaneView {
  std::array<double, 2> across;
  std::array<double, 2> upwards;
};

/// A frame with round ticks; both axes have the same unit. Points are those of the plane.
class SvgPlane {
 public:
  static constexpr double longest = 460;

  /// Draws the frame, its longer side `longest` units. Names and numbers take 60 units to the left and 42
  /// below.
  SvgPlane(SvgPicture& picture, double left, double top, const PlaneView& view, const std::string& across,
           const std::string& upwards);

  static double width(const PlaneView& view);
  static double height(const PlaneView& view);

  /// Draws what lies inside the frame; outside parts are cut off at vertices.
  void polyline(const PlanePolyline& polyline, const Stroke& stroke);
  void box(PlanePoint lower, PlanePoint upper, const std::string& colour);
  void mark(Mark mark, PlanePoint at, const std::string& colour);
  double x(double across) const;
  double y(double upwards) const;

 private:
  bool shows(PlanePoint p) const;

  SvgPicture& picture_;
  double left_;
  double top_;
  PlaneView view_;
  double unit_;
};

/// The zero set of f in the view, as zero_set gives it for the unit square; not seen where f is not finite.
std::vector<PlanePolyline> zero_set_in(const std::function<double(PlanePoint)>& f, const PlaneView& view,
                                       int cells);

}  // namespace exsect::cli
