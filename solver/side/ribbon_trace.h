// One run along an arc of a parameter line that lies on the other patch. Internal to solver/; docs/method.md,
// section 6.2.
#pragma once

#include <exsect/solver/result.h>

#include <string>
#include <variant>
#include <vector>

#include "answer/certified_point.h"
#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "answer/stop_request.h"
#include "line/line_place.h"
#include "line/line_system.h"
#include "side/ribbon.h"

namespace exsect {

/// A part of an arc from a point to the first landmark that it meets.
struct RibbonRun {
  std::size_t end;                       // index of this landmark
  std::vector<PolylineVertex> polyline;  // in the parameters (t, h, r, s) of the ribbon and the other patch
  double error_bound;
  std::vector<ParameterBox> hulls;  // of the pair's parameters; the part is in their union
};

/// The arc is traced as the intersection of the other patch with a ribbon p(t) + (h - 1/2) n(t) along the
/// line, n transversal to that patch: there it is regular, with h = 1/2 throughout, even if the two patches
/// touch along it (6.1). What the constructor is given stays alive.
class RibbonTracer {
 public:
  RibbonTracer(const LinePlace& place, const LineAndPatch& problem, const BezierPatch& owner,
               const ModelScale& scale, double tolerance, const StopRequest& stop)
      : place_(place), problem_(problem), owner_(owner), scale_(scale), tolerance_(tolerance), stop_(stop) {}

  /// Normals to try for the part of the line from one parameter to another: that of the line's own patch,
  /// interpolated, if it is not zero; then the other patch's at the point.
  std::vector<RibbonNormal> normals(const CertifiedPoint& point, const Rational& from,
                                    const Rational& to) const;

  /// From `start`, t falling (direction -1) or rising (1), to the first landmark: the points `ends`, then
  /// `targets`, all of them refined to `width`. Otherwise the reason why it was not traced.
  template <class Ball>
  std::variant<RibbonRun, std::string> run(const CertifiedPoint& start, int direction,
                                           const std::vector<CertifiedPoint>& ends,
                                           const std::vector<CertifiedPoint>& targets,
                                           const RibbonNormal& normal, const Rational& width) const;

 private:
  const LinePlace& place_;
  const LineAndPatch& problem_;
  const BezierPatch& owner_;
  const ModelScale& scale_;
  double tolerance_;
  const StopRequest& stop_;
};

}  // namespace exsect
