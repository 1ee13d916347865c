// Input files by their names on the command line, where "-" is the standard input.
#pragma once

#include <exsect/geometry/candidate.h>
#include <exsect/geometry/curve_file.h>
#include <exsect/geometry/rational_patch_file.h>
#include <exsect/geometry/surface_file.h>

#include <string>

namespace exsect::cli {

/// What messages call the file: "standard input" for "-", else the path.
std::string input_name(const std::string& path);

/// The bytes of the file, or of the standard input, which is read once and can be asked for again. Throws
/// InputError as read_text_file does.
std::string input_text(const std::string& path, std::size_t max_bytes);

/// What read_surfaces, read_curve and read_candidate give, from the standard input
/// too: a candidate there is JSON.
SurfaceFile input_surfaces(const std::string& path);
CurveFile input_curve(const std::string& path);
Candidate input_candidate(const std::string& path);

}  // namespace exsect::cli
