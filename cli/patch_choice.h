// Which patches of a file are meant.
#pragma once

#include <exsect/geometry/rational_patch_file.h>
#include <exsect/geometry/surface_file.h>

#include <optional>
#include <string>

namespace exsect::cli {

/// x(u,v) and y(r,s), and the title of their file.
struct PatchPair {
  NamedPatch x;
  NamedPatch y;
  std::string title;
};

/// The same for methods that take patches of every kind.
struct RationalPair {
  NamedRationalPatch x;
  NamedRationalPatch y;
  std::string title;
};

/// Two surfaces, patches or given by their equations.
struct SurfacePair {
  NamedSurface x;
  NamedSurface y;
  std::string title;
};

/// A patch and a surface given by its equation, whichever comes first.
struct PatchAndEquation {
  NamedRationalPatch patch;
  std::string surface;
  ImplicitSurface equation;
  std::string title;
};
/// Empty for two patches and for two equations.
std::optional<PatchAndEquation> patch_and_equation(const SurfacePair& pair);

/// Reads the file and chooses: by name where a name is not empty, else in the order of the file, which then
/// must hold exactly two patches. Throws InputError for a bad file, an unknown name, the same name twice, or
/// no clear choice.
SurfacePair read_surface_pair(const std::string& path, const std::string& first, const std::string& second);
/// The same where `chosen_by`, and not --first and --second, gives the names.
SurfacePair read_surface_pair(const std::string& path, const std::string& first, const std::string& second,
                              const char* chosen_by);
/// The same of patches; InputError if one of them is given by its equation.
RationalPair read_rational_pair(const std::string& path, const std::string& first, const std::string& second);
/// The pair of the file as patches; InputError as above.
RationalPair patches_only(const SurfacePair& pair, const std::string& path);
/// The same for methods that take polynomial patches of bidegree at most (2,2) only; InputError for others.
PatchPair read_pair(const std::string& path, const std::string& first, const std::string& second);

/// One patch, and the title of its file.
struct ChosenPatch {
  NamedPatch patch;
  std::string title;
};

/// The same for methods that take patches of every kind.
struct ChosenRationalPatch {
  NamedRationalPatch patch;
  std::string title;
};

/// Reads the file and chooses the patch of the given name; without a name the file must hold exactly one.
/// Throws InputError for a bad file, an unknown name, no clear choice, or one that is given by its equation.
ChosenRationalPatch read_rational_patch(const std::string& path, const std::string& name);
/// The same for methods that take polynomial patches of bidegree at most (2,2) only; InputError for others.
ChosenPatch read_patch(const std::string& path, const std::string& name);

/// "points[i][j][c]" or "weights[i][j]", as in a patch file, of the first coordinate or weight beyond the
/// range of doubles; "" if there is none.
std::string place_beyond_doubles(const RationalPatch& patch);
/// Throws InputError that names the first control point of the file, or datum of a surface given by its
/// equation, beyond the range of doubles, and `reason`; returns if there is none.
void refuse_beyond_doubles(const std::string& path, const std::string& reason);

}  // namespace exsect::cli
