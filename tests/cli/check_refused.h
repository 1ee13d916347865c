// What every refusal of the program looks like.
#pragma once

#include <string>
#include <vector>

#include "run_program.h"
#include "support/catch.h"

namespace exsect {

/// Bad input or usage: exit status 2, nothing on the standard output, one line on the standard error.
inline void check_refused(const std::vector<std::string>& arguments, const std::string& reason) {
  const ProgramRun run = run_program(arguments);
  INFO("arguments " << Catch::rangeToString(arguments) << "\nstderr " << run.err);
  CHECK(run.status == 2);
  CHECK(run.out.empty());
  CHECK(run.err.starts_with("exsect: "));
  CHECK(run.err.find(reason) != std::string::npos);
  CHECK(run.err.find('\n') == run.err.size() - 1);
}

}  // namespace exsect
