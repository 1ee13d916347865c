#include "patch_file.h"

#include <algorithm>

#include "json_tree.h"
#include "rational_patch_file.h"

namespace exsect {
namespace {

/// Index of the control point of the elevated net that is control point i for the given degree.
std::size_t elevated_index(std::size_t i, int degree) { return degree == 1 ? 2 * i : i; }

std::vector<std::vector<Point>> points_of_degree(const NamedPatch& named) {
  const auto [m, n] = named.degree;
  if (m < 1 || m > 2 || n < 1 || n > 2)
    throw std::invalid_argument("patch file: degree of \"" + named.name + "\" must be 1 or 2");
  std::vector<std::vector<Point>> points(static_cast<std::size_t>(m) + 1);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j <= static_cast<std::size_t>(n); ++j)
      points[i].push_back(named.patch.net()[elevated_index(i, m)][elevated_index(j, n)]);
  if (BezierPatch::elevated(points) != named.patch)
    throw std::invalid_argument("patch file: \"" + named.name + "\" is not of the degree it is named with");
  return points;
}

PatchFile biquadratic(const RationalPatchFile& file, const std::string& filename) {
  PatchFile result{file.title, file.source, {}};
  for (std::size_t i = 0; i < file.patches.size(); ++i)
    result.patches.push_back(biquadratic(file.patches[i], filename, "$.patches[" + std::to_string(i) + "]"));
  return result;
}

}  // namespace

NamedPatch biquadratic(const NamedRationalPatch& named, const std::string& file, const std::string& where) {
  const RationalPatch& patch = named.patch;
  const std::optional<BezierPatch> biquadratic = patch.biquadratic();
  if (!biquadratic)
    throw InputError(file, where,
                     "patch \"" + printable(named.name) + "\": not supported here: " + kind_of(patch) +
                         ", only polynomial patches of bidegree up to (2,2)");
  const RationalPatch& shape = std::max(patch.degree_u(), patch.degree_v()) <= 2 ? patch : patch.reduced();
  return {named.name, {shape.degree_u(), shape.degree_v()}, *biquadratic};
}

PatchFile parse_patches(const std::string& text, const std::string& filename) {
  return biquadratic(parse_rational_patches(text, filename), filename);
}

PatchFile read_patches(const std::string& path) { return biquadratic(read_rational_patches(path), path); }

std::string format_patches(const PatchFile& file) {
  RationalPatchFile general{file.title, file.source, {}};
  for (const NamedPatch& named : file.patches)
    general.patches.push_back({named.name, RationalPatch(points_of_degree(named))});
  return format_patches(general);
}

void write_patches(const PatchFile& file, const std::string& path) {
  write_file_atomically(path, format_patches(file));
}

}  // namespace exsect
