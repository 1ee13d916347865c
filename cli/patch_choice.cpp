#include "cli/patch_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/input_file.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

std::string names(const RationalPatchFile& file) {
  constexpr std::size_t most = 20;
  std::vector<std::string> quoted;
  for (const NamedRationalPatch& patch : file.patches) {
    if (quoted.size() < most) quoted.push_back("\"" + printable(patch.name) + "\"");
  }
  return joined(quoted, ", ") + (file.patches.size() > most ? ", ..." : "");
}

const NamedRationalPatch& named(const RationalPatchFile& file, const std::string& path,
                                const std::string& name, const char* option) {
  const auto patch =
      std::find_if(file.patches.begin(), file.patches.end(),
                   [&](const NamedRationalPatch& candidate) { return candidate.name == name; });
  if (patch == file.patches.end()) {
    throw InputError(
        input_name(path), "$.patches",
        fmt::format("{}: no patch is named \"{}\"; there are {}", option, printable(name), names(file)));
  }
  return *patch;
}

}  // namespace

PatchPair read_pair(const std::string& path, const std::string& first, const std::string& second) {
  const RationalPair pair = read_rational_pair(path, first, second);
  return {biquadratic(pair.x, input_name(path), ""), biquadratic(pair.y, input_name(path), ""), pair.title};
}

RationalPair read_rational_pair(const std::string& path, const std::string& first,
                                const std::string& second) {
  const RationalPatchFile file = input_patches(path);
  const std::size_t count = file.patches.size();
  if (!first.empty() && first == second) {
    throw InputError(input_name(path), "$.patches",
                     fmt::format("--first and --second both name \"{}\"; two different patches are needed",
                                 printable(first)));
  }
  const NamedRationalPatch* x = first.empty() ? nullptr : &named(file, path, first, "--first");
  const NamedRationalPatch* y = second.empty() ? nullptr : &named(file, path, second, "--second");
  if ((x == nullptr || y == nullptr) && count != 2) {
    throw InputError(input_name(path), "$.patches",
                     count < 2 ? "holds one patch; two are needed"
                               : fmt::format("holds {} patches ({}): choose with --first and --second", count,
                                             names(file)));
  }
  const NamedRationalPatch* front = &file.patches.front();
  if (x == nullptr) x = y == front ? &file.patches.back() : front;
  if (y == nullptr) y = x == front ? &file.patches.back() : front;
  return {*x, *y, file.title};
}

RationalPair read_rational_pair(const std::string& path, const std::string& first, const std::string& second,
                                const char* chosen_by) {
  const RationalPatchFile file = input_patches(path);
  for (const std::string& name : {first, second})
    if (!name.empty()) named(file, path, name, chosen_by);
  return read_rational_pair(path, first, second);
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

void refuse_beyond_doubles(const std::string& path, const std::string& reason) {
  const RationalPatchFile file = input_patches(path);
  for (std::size_t k = 0; k < file.patches.size(); ++k) {
    const std::string place = place_beyond_doubles(file.patches[k].patch);
    if (!place.empty()) throw InputError(input_name(path), fmt::format("$.patches[{}].{}", k, place), reason);
  }
}

ChosenPatch read_patch(const std::string& path, const std::string& name) {
  const RationalPatchFile file = input_patches(path);
  if (name.empty() && file.patches.size() != 1) {
    throw InputError(
        input_name(path), "$.patches",
        fmt::format("holds {} patches ({}): choose with --patch", file.patches.size(), names(file)));
  }
  const NamedRationalPatch& patch = name.empty() ? file.patches.front() : named(file, path, name, "--patch");
  return {biquadratic(patch, input_name(path), ""), file.title};
}

}  // namespace exsect::cli
