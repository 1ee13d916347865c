#include "cli/input_file.h"

#include <exsect/geometry/candidate_file.h>
#include <exsect/geometry/text_file.h>

namespace exsect::cli {
namespace {

constexpr const char* standard_input = "-";

/// The largest of all files that a command reads as a whole, and one byte more.
constexpr std::size_t most_bytes = (std::size_t{256} << 20) + 1;

std::string read_standard_input() {
  try {
    return read_text_file("/dev/stdin", most_bytes);
  } catch (const InputError& error) {
    throw InputError(input_name(standard_input), error.where(), error.reason());
  }
}

/// The standard input cannot be read again, and a refusal may have to look for a place in it.
const std::string& standard_input_text() {
  static const std::string text = read_standard_input();
  return text;
}

}  // namespace

std::string input_name(const std::string& path) { return path == standard_input ? "standard input" : path; }

std::string input_text(const std::string& path, std::size_t max_bytes) {
  if (path != standard_input) return read_text_file(path, max_bytes);
  const std::string& text = standard_input_text();
  if (text.size() > max_bytes)
    throw InputError(input_name(path), "", "longer than " + std::to_string(max_bytes) + " bytes");
  return text;
}

SurfaceFile input_surfaces(const std::string& path) {
  if (path != standard_input) return read_surfaces(path);
  return parse_surfaces(input_text(path, max_patch_file_bytes), input_name(path));
}

CurveFile input_curve(const std::string& path) {
  return parse_curve(input_text(path, max_curve_file_bytes), input_name(path));
}

Candidate input_candidate(const std::string& path) {
  if (path != standard_input) return read_candidate(path);
  return parse_candidate(input_text(path, max_candidate_file_bytes), input_name(path), CandidateFormat::json);
}

}  // namespace exsect::cli
