// Patch files (docs/formats.md): JSON with exact numbers.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/text_file.h>

#include <array>
#include <string>
#include <vector>

namespace exsect {

/// A patch with its name and the bidegree it was given in, each of the two degrees 1 or 2. The patch itself
/// always has the elevated net of bidegree (2,2).
struct NamedPatch {
  std::string name;
  std::array<int, 2> degree;
  BezierPatch patch;

  friend bool operator==(const NamedPatch&, const NamedPatch&) = default;
};

/// Names longer than this, in bytes of UTF-8, are refused: each is written with many parts of a result.
inline constexpr std::size_t max_name_bytes = 1000;

/// Title and source are free text, possibly empty. Names are not empty, at most `max_name_bytes` long and
/// distinct.
struct PatchFile {
  std::string title;
  std::string source;
  std::vector<NamedPatch> patches;

  friend bool operator==(const PatchFile&, const PatchFile&) = default;
};

/// Files longer than this, in bytes, are refused.
inline constexpr std::size_t max_patch_file_bytes = std::size_t{8} << 20;

/// The content of a patch file:
///
///     {"exsect": "patches/1", "title": "...", "source": "...", "numbers": "decimal" | "binary64",
///      "patches": [{"name": "x", "degree": [2,2], "points": [[["1/7","0","3/5"], ...3 points], ...3 rows]},
///      ...]}
///
/// title, source and numbers may be missing. A string is read by parse_number; a bare number, read from its
/// text, means the decimal as written. With "numbers": "binary64" decimals, in strings or bare, mean the
/// nearest IEEE double. Degree [m,n] goes with m+1 rows of n+1 points. A patch of a higher degree or with
/// weights (rational_patch_file.h) is taken where it is the same as one without, in the degree that it has
/// then. Throws InputError (file, JSON path,
/// reason) for anything else: wrong shape, NaN, infinity, zero denominator, numbers beyond the sizes in
/// number.h, empty, too long or duplicate names, duplicate, unknown or missing keys, another version, no
/// patch at all, a patch of another kind, truncated text, text after the end, deep nesting, excessive length.
PatchFile parse_patches(const std::string& text, const std::string& filename);

/// The same from a file; InputError also if it is missing, a directory or unreadable.
PatchFile read_patches(const std::string& path);

/// The text of a patch file with exact rationals in lowest terms: parse_patches gives the same PatchFile
/// back. Throws std::invalid_argument if there is none: no patch, empty, too long or duplicate names, a
/// degree other than 1 or 2 or below the patch's true degree, text that is not UTF-8, a number beyond
/// `max_number_digits`.
std::string format_patches(const PatchFile& file);

/// format_patches written by write_file_atomically.
void write_patches(const PatchFile& file, const std::string& path);

}  // namespace exsect
