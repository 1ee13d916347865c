// Which of u, v, r, s plays which part when a parameter line of one patch meets the other patch.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/integer_pair.h>
#include <exsect/geometry/parameter_line.h>
#include <exsect/solver/line_query.h>
#include <exsect/solver/parameter.h>

namespace exsect {

/// A line c(t) = a0 + a1 t + a2 t^2 against a patch y(r,s), in the solver's own names: t is the parameter
/// along the line, r the parameter that is eliminated first, s the one that is kept.
struct LineAndPatch {
  ParameterLine line;
  BezierPatch patch;
};

/// The same on integers, in scaled coordinates of space.
struct IntegerLineAndPatch {
  IntegerLine line;
  IntegerNet patch;
};

/// The global parameters that are fixed, t, r and s.
struct LineRoles {
  Parameter fixed;
  Parameter line;
  Parameter first;
  Parameter second;
};

struct LinePlace {
  LineRoles roles;
  Rational value;  // of the fixed parameter
};

/// All throw std::invalid_argument for a value outside [0,1].
LinePlace line_place(const LineQuery& query);
LineAndPatch line_and_patch(const BezierPatch& x, const BezierPatch& y, const LineQuery& query);
IntegerLineAndPatch integer_line_and_patch(const BezierPatch& x, const BezierPatch& y,
                                           const LineQuery& query);

}  // namespace exsect
