// Runs one program of the comparison over a file of pairs: each pair in a process of its own with a limit of
// processor time, and one line of JSON for each.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "surface_pair.h"

namespace peers {

/// What is timed, and afterwards the answer of the last run: the members that are added to the line of this
/// pair.
struct Task {
  std::function<void()> timed;
  std::function<nlohmann::ordered_json()> answer;
};

struct Settings {
  std::string pairs;        // file
  double tolerance = 1e-6;  // relative to the size of the pair
  bool lines = false;       // the queries u = k/16, k = 1..15, instead of the whole pair
  std::string method;       // where a program has several
  int seconds = 30;         // limit of processor time for a pair, with all runs
};

/// main of such a program: PAIRS [--tolerance T] [--lines] [--method NAME] [--seconds N].
/// Writes
/// {"name", "program", "tolerance", "status", "milliseconds", ...} to the standard output, where milliseconds
/// is the median processor time of up to 31 runs in 20 ms (of all queries together with --lines) and status
/// one of
///
///     done       the answer follows
///     timeout    the processor time ran out, with all runs
///     crash      the process ended by another signal
///     error      an exception, its text under "reason"
int run(int argc, char** argv, const std::function<std::string(const Settings&)>& program,
        const std::function<Task(const SurfacePair&, const Settings&)>& task);

/// The values k/16 of a line query.
inline constexpr int line_queries = 15;
inline double line_parameter(int k) { return k / 16.0; }

}  // namespace peers
