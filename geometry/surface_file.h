// Patch files whose entries are patches or surfaces given by their equations (docs/formats.md).
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch_file.h>

#include <string>
#include <variant>
#include <vector>

namespace exsect {

struct NamedSurface {
  std::string name;
  std::variant<RationalPatch, ImplicitSurface> surface;

  /// nullptr for a surface given by its equation.
  const RationalPatch* patch() const { return std::get_if<RationalPatch>(&surface); }
  /// nullptr for a patch.
  const ImplicitSurface* equation() const { return std::get_if<ImplicitSurface>(&surface); }
};

/// Names are distinct and not empty; at least one surface.
struct SurfaceFile {
  std::string title;
  std::string source;
  std::vector<NamedSurface> surfaces;
};

/// The content of a patches/1 as parse_rational_patches describes it, with entries {"name", "type", ...} for
/// surfaces beside the patches. Lengths of round surfaces are given as such, or by their squares, as
/// "radius_squared". Throws InputError for what that function refuses, and for what the makers of
/// ImplicitSurface refuse.
SurfaceFile parse_surfaces(const std::string& text, const std::string& filename);

/// The same from a file, of the form patches/1, or BPT (geometry/bpt_file.h) if its name ends in ".bpt".
SurfaceFile read_surfaces(const std::string& path);

}  // namespace exsect
