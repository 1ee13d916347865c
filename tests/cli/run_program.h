// Runs the built program as a process of its own.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "geometry/scratch_directory.h"

namespace exsect {

struct ProgramRun {
  int status;  // exit status; -1 if a signal ended it
  std::string out;
  std::string err;
};

inline std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string quoted(const std::string& argument) {
  std::string text = "'";
  for (char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// exsect with the given arguments; the standard output goes to `out` if it is given.
inline ProgramRun run_program(const std::vector<std::string>& arguments, const std::string& out = "") {
  const ScratchDirectory scratch;
  std::string command = quoted(EXSECT_PROGRAM);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  const std::string out_file = out.empty() ? scratch.path("out") : out;
  command += " >" + quoted(out_file) + " 2>" + quoted(scratch.path("err")) + " </dev/null";
  const int ended = std::system(command.c_str());
  return {WIFEXITED(ended) ? WEXITSTATUS(ended) : -1, out.empty() ? content(out_file) : "",
          content(scratch.path("err"))};
}

inline std::string example(const std::string& name) { return std::string(EXSECT_EXAMPLES) + "/" + name; }

}  // namespace exsect
