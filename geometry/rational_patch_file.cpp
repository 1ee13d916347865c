#include "rational_patch_file.h"

#include <cstddef>
#include <set>

#include "bpt_file.h"
#include "json_value.h"
#include "patch_value.h"
#include "surface_file.h"

namespace exsect {
namespace {

int read_degree(const JsonValue& value) {
  for (int degree = 1; degree <= max_patch_degree; ++degree)
    if (value.is_bare(std::to_string(degree))) return degree;
  const std::string given(value.bare_number());
  value.fail(given.empty() ? "degree must be 1, 2 or 3"
                           : "degree " + given.substr(0, 20) + " is not supported: must be 1, 2 or 3");
}

Point read_point(const JsonValue& point, NumberReader read) {
  point.require_size(3, "coordinates");
  return {read_number(point.at(0), read), read_number(point.at(1), read), read_number(point.at(2), read)};
}

/// The entries of a net of this bidegree; `row_holds` says what is missing where their number is wrong.
template <class Entry>
std::vector<std::vector<Entry>> read_net(const JsonValue& net, const std::array<int, 2>& degree,
                                         NumberReader read,
                                         Entry (*read_entry)(const JsonValue&, NumberReader),
                                         const char* row_holds) {
  std::vector<std::vector<Entry>> rows;
  net.require_size(static_cast<std::size_t>(degree[0]) + 1, "rows for this degree");
  for (std::size_t i = 0; i < net.size(); ++i) {
    const JsonValue row = net.at(i);
    row.require_size(static_cast<std::size_t>(degree[1]) + 1, row_holds);
    rows.emplace_back();
    for (std::size_t j = 0; j < row.size(); ++j) rows.back().push_back(read_entry(row.at(j), read));
  }
  return rows;
}

std::string format_point(const Point& p) {
  return "[" + format_json_number(p[0]) + ", " + format_json_number(p[1]) + ", " + format_json_number(p[2]) +
         "]";
}

/// Rows of numbers or points, [[...], [...]], each row on a line of its own.
template <class Format>
std::string format_rows(const RationalPatch& patch, Format format) {
  std::string text = "[";
  for (int i = 0; i <= patch.degree_u(); ++i) {
    text += i == 0 ? "\n   [" : ",\n   [";
    for (int j = 0; j <= patch.degree_v(); ++j) text += (j == 0 ? "" : ", ") + format(i, j);
    text += "]";
  }
  return text + "]";
}

std::string format_patch(const NamedRationalPatch& named) {
  const RationalPatch& patch = named.patch;
  bool has_weights = false;
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j) {
      const HomogeneousPoint& p = patch.homogeneous(i, j);
      const bool at_infinity = p[3] == 0 && !is_zero({p[0], p[1], p[2]});
      if (at_infinity)
        throw std::invalid_argument("patch file: \"" + named.name + "\" has a control point at infinity");
      has_weights = has_weights || p[3] != 1;
    }
  std::string text =
      "  {\"name\": " + json_string(named.name) + ", \"degree\": [" + std::to_string(patch.degree_u()) +
      ", " + std::to_string(patch.degree_v()) +
      "], \"points\": " + format_rows(patch, [&](int i, int j) { return format_point(patch.point(i, j)); });
  if (has_weights)
    text += ",\n   \"weights\": " +
            format_rows(patch, [&](int i, int j) { return format_json_number(patch.weight(i, j)); });
  return text + "}";
}

}  // namespace

const std::string& read_name(const JsonValue& value) {
  const JsonValue name = value.member("name");
  if (name.string().empty()) name.fail("must not be empty");
  if (name.string().size() > max_name_bytes)
    name.fail("must not be longer than " + std::to_string(max_name_bytes) + " bytes");
  return name.string();
}

NamedRationalPatch read_named_patch(const JsonValue& value, NumberReader read) {
  value.require_object({"name", "degree", "points", "weights"});
  const std::string& name = read_name(value);
  const JsonValue degrees = value.member("degree");
  degrees.require_size(2, "degrees");
  const std::array<int, 2> degree = {read_degree(degrees.at(0)), read_degree(degrees.at(1))};
  const auto points = read_net(value.member("points"), degree, read, read_point, "points for this degree");
  const auto weights = value.has("weights") ? read_net(value.member("weights"), degree, read, read_number,
                                                       "weights for this degree")
                                            : std::vector<std::vector<Rational>>();
  try {
    return {name, RationalPatch(points, weights)};
  } catch (const PatchError& error) {
    value.member(error.where().c_str()).fail(error.reason());
  }
}

namespace {

RationalPatchFile patches_only(SurfaceFile file, const std::string& filename) {
  RationalPatchFile result = {std::move(file.title), std::move(file.source), {}};
  for (std::size_t i = 0; i < file.surfaces.size(); ++i) {
    const NamedSurface& named = file.surfaces[i];
    if (named.equation() != nullptr)
      throw InputError(filename, "$.patches[" + std::to_string(i) + "]",
                       "\"" + printable(named.name) + "\" is given by its equation (" +
                           name(named.equation()->kind()) + "); only patches are taken here");
    result.patches.push_back({named.name, *named.patch()});
  }
  return result;
}

}  // namespace

RationalPatchFile parse_rational_patches(const std::string& text, const std::string& filename) {
  return patches_only(parse_surfaces(text, filename), filename);
}

RationalPatchFile read_rational_patches(const std::string& path) {
  const std::string text = read_text_file(path, max_patch_file_bytes);
  return is_bpt(path) ? parse_bpt(text, path) : parse_rational_patches(text, path);
}

std::string format_patches(const RationalPatchFile& file) {
  if (file.patches.empty()) throw std::invalid_argument("patch file: must hold at least one patch");
  std::string text = "{\n \"exsect\": " + json_string(patches_version);
  if (!file.title.empty()) text += ",\n \"title\": " + json_string(file.title);
  if (!file.source.empty()) text += ",\n \"source\": " + json_string(file.source);
  text += ",\n \"patches\": [\n";
  std::set<std::string> names;
  const char* before_patch = "";
  for (const NamedRationalPatch& named : file.patches) {
    if (named.name.empty() || !names.insert(named.name).second)
      throw std::invalid_argument("patch file: names must be distinct and not empty");
    if (named.name.size() > max_name_bytes)
      throw std::invalid_argument("patch file: names must not be longer than " +
                                  std::to_string(max_name_bytes) + " bytes");
    text += before_patch + format_patch(named);
    before_patch = ",\n";
  }
  text += "\n ]\n}\n";
  if (text.size() > max_patch_file_bytes)
    throw std::invalid_argument("patch file: longer than " + std::to_string(max_patch_file_bytes) + " bytes");
  return text;
}

void write_patches(const RationalPatchFile& file, const std::string& path) {
  write_file_atomically(path, format_patches(file));
}

}  // namespace exsect
