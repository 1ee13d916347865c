// What the caller of an intersection asks for.
#pragma once

#include <exsect/solver/parameter.h>

#include <functional>
#include <optional>
#include <vector>

namespace exsect {

struct IntersectOptions {
  /// Turning points with respect to these parameters become nodes.
  std::vector<Parameter> turning = {Parameter::u, Parameter::v, Parameter::r, Parameter::s};
  /// Bound of the distance between each polyline and its true arc, relative to the size of the model (the
  /// largest extent of the common bounding box of both patches); > 0, else std::invalid_argument. Where
  /// vertices in doubles cannot keep it, below 1.5e-11 or far from the origin, IntersectResult::coarse says
  /// what they keep.
  double tolerance = 1e-6;
  /// Work cap of the whole call; when it is exceeded the result is incomplete.
  std::optional<double> max_seconds;
  /// Whether a curve is missing is decided by exact arithmetic (method, sections 5 and 14.8), not by a search
  /// in doubles alone. The graph is the same; Work::steps has the entry "filtered" if that sufficed.
  bool exact = false;
  /// Called now and then with a fraction in [0,1] and the name of the step.
  std::function<void(double, const char*)> progress;
};

}  // namespace exsect
