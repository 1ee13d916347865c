// BPT files: lists of Bézier patches, as the teapot is passed on.
#pragma once

#include <exsect/geometry/rational_patch_file.h>

#include <string>

namespace exsect {

/// The content of a BPT file: the number of patches, and for each its degrees m and n and (m+1) (n+1) points
/// x y z, row by row of n+1; separated by blanks and line ends, with comments from "#" to the end of a line.
/// The patches are named "1", "2", ...; a number means what parse_number reads in it. Throws InputError, with
/// the line ("line 17"), for anything else.
RationalPatchFile parse_bpt(const std::string& text, const std::string& filename);

/// True if the name ends in ".bpt", in whatever case.
bool is_bpt(const std::string& path);

}  // namespace exsect
