// What an intersection run returns: complete, or incomplete with place and reason. There is no third answer.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include <map>
#include <string>
#include <vector>

namespace exsect {

enum class Status { complete, incomplete };

/// A region of the parameter domain [0,1]^4 that is undecided, and why.
struct Incomplete {
  ParameterBox where;
  std::string why;
};

/// Milliseconds spent and counts of steps ("tubes", "fibres", ...), for reports and benchmarks.
struct Work {
  double milliseconds = 0;
  std::map<std::string, double> steps;
};

/// complete: the graph is the whole intersection, proved. incomplete: the graph holds what is proved and
/// `incomplete` says what is not known, and why.
struct IntersectResult {
  Status status;
  IntersectionGraph graph;
  std::vector<Incomplete> incomplete;
  Work work;
};

}  // namespace exsect
