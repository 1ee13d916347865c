// Candidate files (docs/formats.md): JSON, CSV, Wavefront OBJ, GoTools g2.
#pragma once

#include <exsect/geometry/candidate.h>
#include <exsect/geometry/text_file.h>

namespace exsect {

/// Files longer than this, in bytes, are refused.
inline constexpr std::size_t max_candidate_file_bytes = std::size_t{64} << 20;

enum class CandidateFormat { json, csv, obj, g2 };

/// By the end of the file's name, .json, .csv, .obj or .g2; throws InputError for another one.
CandidateFormat candidate_format(const std::string& filename);

/// The content of a candidate file. Every number means the IEEE double nearest to it. Throws InputError
/// (file, place, reason) for anything that is not of the format: wrong shape, NaN, infinity, truncated text,
/// unknown keys, columns or classes, no curve and no point where the format needs one, parameters outside
/// [-1,2].
Candidate parse_candidate(const std::string& text, const std::string& filename, CandidateFormat format);

/// The same from a file; InputError also if it is missing, a directory or unreadable.
Candidate read_candidate(const std::string& path);

}  // namespace exsect
