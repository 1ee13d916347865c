// Makers of undecided regions whose reason may be that time is over. Internal to solver/.
#pragma once

#include <exsect/solver/incomplete.h>

#include <utility>

#include "answer/stop_request.h"

namespace exsect {

/// Left open because time is over.
inline Incomplete out_of_time(const ParameterBox& where, std::string why = "the work cap was reached") {
  return {where, std::move(why), Reason::time};
}

/// For this reason, unless time is over.
inline Incomplete left_open(const ParameterBox& where, std::string why, const StopRequest& stop,
                            Reason reason = Reason::not_decided) {
  return is_stopped(stop) ? out_of_time(where) : Incomplete{where, std::move(why), reason};
}

}  // namespace exsect
