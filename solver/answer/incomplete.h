// Regions of parameters that are left undecided, and why.
#pragma once

#include <exsect/solver/parameter.h>

#include <string>

namespace exsect {

/// The question that is left open in a region, as far as the proof that failed tells.
enum class Reason {
  not_decided,  // none of the others is known to be it
  tangency,     // whether the patches touch, or a curve and a side do
  crossing,     // whether branches of a curve meet in a point
  corner,       // whether, and where, a curve passes through a corner, or along a side, of both patches
  time,         // the time of the call was over
  failed_proof  // a proof that ought to succeed has failed, or two contradict each other
};

/// A region of the parameter domain [0,1]^4 that is undecided, and why.
struct Incomplete {
  ParameterBox where;
  std::string why;
  Reason reason = Reason::not_decided;
};

/// "not decided", "tangency", "crossing", "corner", "time", "failed proof".
const char* name(Reason reason);

}  // namespace exsect
