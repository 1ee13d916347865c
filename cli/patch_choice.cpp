#include "cli/patch_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cli/input_file.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

std::string shown_names(const std::vector<std::string>& names) {
  constexpr std::size_t most = 20;
  std::vector<std::string> quoted;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    quoted.push_back("\"" + printable(names[i]) + "\"");
  return joined(quoted, ", ") + (names.size() > most ? ", ..." : "");
}

template <class Named>
std::string names(const std::vector<Named>& entries) {
  std::vector<std::string> names;
  for (const Named& entry : entries) names.push_back(entry.name);
  return shown_names(names);
}

template <class Named>
const Named& named(const std::vector<Named>& entries, const std::string& path, const std::string& name,
                   const char* option) {
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const Named& candidate) { return candidate.name == name; });
  if (entry == entries.end()) {
    throw InputError(
        input_name(path), "$.patches",
        fmt::format("{}: no patch is named \"{}\"; there are {}", option, printable(name), names(entries)));
  }
  return *entry;
}

NamedRationalPatch patch_only(const NamedSurface& named, const std::string& path) {
  if (named.equation() != nullptr)
    throw InputError(input_name(path), "$.patches",
                     fmt::format("\"{}\" is given by its equation ({}); only patches are taken here",
                                 printable(named.name), name(named.equation()->kind())));
  return {named.name, *named.patch()};
}

}  // namespace

PatchPair read_pair(const std::string& path, const std::string& first, const std::string& second) {
  const RationalPair pair = read_rational_pair(path, first, second);
  return {biquadratic(pair.x, input_name(path), ""), biquadratic(pair.y, input_name(path), ""), pair.title};
}

SurfacePair read_surface_pair(const std::string& path, const std::string& first, const std::string& second) {
  const SurfaceFile file = input_surfaces(path);
  const std::vector<NamedSurface>& entries = file.surfaces;
  if (!first.empty() && first == second) {
    throw InputError(input_name(path), "$.patches",
                     fmt::format("--first and --second both name \"{}\"; two different patches are needed",
                                 printable(first)));
  }
  const NamedSurface* x = first.empty() ? nullptr : &named(entries, path, first, "--first");
  const NamedSurface* y = second.empty() ? nullptr : &named(entries, path, second, "--second");
  if ((x == nullptr || y == nullptr) && entries.size() != 2) {
    throw InputError(input_name(path), "$.patches",
                     entries.size() < 2
                         ? "holds one patch; two are needed"
                         : fmt::format("holds {} patches ({}): choose with --first and --second",
                                       entries.size(), names(entries)));
  }
  const NamedSurface* front = &entries.front();
  if (x == nullptr) x = y == front ? &entries.back() : front;
  if (y == nullptr) y = x == front ? &entries.back() : front;
  return {*x, *y, file.title};
}

RationalPair read_rational_pair(const std::string& path, const std::string& first,
                                const std::string& second) {
  return patches_only(read_surface_pair(path, first, second), path);
}

RationalPair patches_only(const SurfacePair& pair, const std::string& path) {
  return {patch_only(pair.x, path), patch_only(pair.y, path), pair.title};
}

SurfacePair read_surface_pair(const std::string& path, const std::string& first, const std::string& second,
                              const char* chosen_by) {
  const SurfaceFile file = input_surfaces(path);
  for (const std::string& name : {first, second})
    if (!name.empty()) named(file.surfaces, path, name, chosen_by);
  return read_surface_pair(path, first, second);
}

std::optional<PatchAndEquation> patch_and_equation(const SurfacePair& pair) {
  if ((pair.x.patch() != nullptr) == (pair.y.patch() != nullptr)) return std::nullopt;
  const NamedSurface& patch = pair.x.patch() != nullptr ? pair.x : pair.y;
  const NamedSurface& other = pair.x.patch() != nullptr ? pair.y : pair.x;
  return PatchAndEquation{{patch.name, *patch.patch()}, other.name, *other.equation(), pair.title};
}

std::string place_beyond_doubles(const RationalPatch& patch) {
  const auto beyond = [](const Rational& number) { return !std::isfinite(to_double(number)); };
  for (int i = 0; i <= patch.degree_u(); ++i) {
    for (int j = 0; j <= patch.degree_v(); ++j) {
      if (beyond(patch.weight(i, j))) return fmt::format("weights[{}][{}]", i, j);
      const Point point = patch.point(i, j);
      for (std::size_t c = 0; c < 3; ++c)
        if (beyond(point[c])) return fmt::format("points[{}][{}][{}]", i, j, c);
    }
  }
  return "";
}

namespace {

/// The same for the data of a surface given by its equation.
std::string place_beyond_doubles(const ImplicitSurface& surface) {
  if (!surface.data()) return "";
  const SurfaceKind kind = surface.kind();
  const bool is_torus = kind == SurfaceKind::torus;
  const char* point = kind == SurfaceKind::cone                 ? "apex"
                      : kind == SurfaceKind::sphere || is_torus ? "centre"
                                                                : "point";
  for (std::size_t c = 0; c < 3; ++c)
    if (!std::isfinite(to_double(surface.data()->point[c]))) return fmt::format("{}[{}]", point, c);
  const Rational most = from_double(std::numeric_limits<double>::max());
  if (surface.data()->squared > most * most)
    return kind == SurfaceKind::cone ? "slope" : is_torus ? "major" : "radius";
  return surface.data()->minor_squared > most * most ? "minor" : "";
}

}  // namespace

void refuse_beyond_doubles(const std::string& path, const std::string& reason) {
  const SurfaceFile file = input_surfaces(path);
  for (std::size_t k = 0; k < file.surfaces.size(); ++k) {
    const RationalPatch* patch = file.surfaces[k].patch();
    const std::string place =
        patch != nullptr ? place_beyond_doubles(*patch) : place_beyond_doubles(*file.surfaces[k].equation());
    if (!place.empty()) throw InputError(input_name(path), fmt::format("$.patches[{}].{}", k, place), reason);
  }
}

ChosenRationalPatch read_rational_patch(const std::string& path, const std::string& name) {
  const SurfaceFile file = input_surfaces(path);
  const std::vector<NamedSurface>& entries = file.surfaces;
  if (name.empty() && entries.size() != 1) {
    throw InputError(
        input_name(path), "$.patches",
        fmt::format("holds {} patches ({}): choose with --patch", entries.size(), names(entries)));
  }
  const NamedSurface& chosen = name.empty() ? entries.front() : named(entries, path, name, "--patch");
  return {patch_only(chosen, path), file.title};
}

ChosenPatch read_patch(const std::string& path, const std::string& name) {
  const ChosenRationalPatch chosen = read_rational_patch(path, name);
  return {biquadratic(chosen.patch, input_name(path), ""), chosen.title};
}

}  // namespace exsect::cli
