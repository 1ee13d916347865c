// Curve files (docs/formats.md): JSON with exact numbers.
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/text_file.h>

#include <string>

namespace exsect {

/// Title and source are free text, possibly empty.
struct CurveFile {
  std::string title;
  std::string source;
  BezierCurve curve;

  friend bool operator==(const CurveFile&, const CurveFile&) = default;
};

/// Curves of a higher degree are refused.
inline constexpr int max_curve_degree = 20;

/// Files longer than this, in bytes, are refused.
inline constexpr std::size_t max_curve_file_bytes = std::size_t{8} << 20;

/// The content of a curve file:
///
///     {"exsect": "curve/1", "title": "...", "source": "...", "numbers": "decimal" | "binary64",
///      "degree": n, "points": [["3/10", "3/10"], ...n+1 points], "weights": ["1", ...n+1 weights]}
///
/// title, source, numbers and weights may be missing. All points have 2 coordinates or all have 3; weights
/// are > 0; numbers as in patch files. Throws InputError (file, JSON path, reason) for anything else, as
/// parse_patches does.
CurveFile parse_curve(const std::string& text, const std::string& filename);

/// The same from a file; InputError also if it is missing, a directory or unreadable.
CurveFile read_curve(const std::string& path);

/// The text of a curve file with exact rationals in lowest terms: parse_curve gives the same CurveFile back.
/// Weights that are all 1 are left out. Throws std::invalid_argument if there is none: text that is not
/// UTF-8, a degree or a number beyond the sizes a reader accepts.
std::string format_curve(const CurveFile& file);

/// The value of the key "exsect" of a JSON file, "" if it is no object with such a string: "curve/1",
/// "patches/1", ... Throws InputError for text that is no JSON.
std::string file_version(const std::string& text, const std::string& filename);

}  // namespace exsect
