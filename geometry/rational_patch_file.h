// Patch files with patches of every bidegree up to (3,3), with or without weights (docs/formats.md).
#pragma once

#include <exsect/geometry/patch_file.h>
#include <exsect/geometry/rational_patch.h>

#include <string>
#include <vector>

namespace exsect {

/// A patch in the shape that it was given in, with its name.
struct NamedRationalPatch {
  std::string name;
  RationalPatch patch;

  friend bool operator==(const NamedRationalPatch&, const NamedRationalPatch&) = default;
};

/// As PatchFile, with patches of every kind.
struct RationalPatchFile {
  std::string title;
  std::string source;
  std::vector<NamedRationalPatch> patches;

  friend bool operator==(const RationalPatchFile&, const RationalPatchFile&) = default;
};

/// The content of a patches/1 as parse_patches describes it, with degrees from 1 to 3 and, where a patch has
/// them, "weights": [[...n+1 numbers], ...m+1 rows]. Points are Cartesian, not multiplied by their weights.
/// Throws InputError for what parse_patches refuses, for what RationalPatch refuses, and for a surface given
/// by its equation (geometry/surface_file.h reads these).
RationalPatchFile parse_rational_patches(const std::string& text, const std::string& filename);

/// The same from a file, of the form patches/1, or BPT (geometry/bpt_file.h) if its name ends in ".bpt".
RationalPatchFile read_rational_patches(const std::string& path);

/// The text of a patches/1 that parse_rational_patches gives back; std::invalid_argument as for PatchFile,
/// and for a control point at infinity.
std::string format_patches(const RationalPatchFile& file);
void write_patches(const RationalPatchFile& file, const std::string& path);

/// The patch for methods that take polynomial patches of bidegree at most (2,2) only. Throws InputError with
/// file and place ("$.patches[3]", or empty) for every other, which it names: "bidegree (2,2) with weights".
NamedPatch biquadratic(const NamedRationalPatch& named, const std::string& file, const std::string& where);

}  // namespace exsect
