#include "patch_file.h"

#include <cstddef>
#include <set>

#include "json_value.h"
#include "patch_value.h"

namespace exsect {
namespace {

constexpr const char* version = "patches/1";
constexpr std::size_t max_depth = 16;

int read_degree(const JsonValue& value) {
  if (value.is_bare("1")) return 1;
  if (value.is_bare("2")) return 2;
  value.fail("degree must be 1 or 2");
}

BezierPatch read_points(const JsonValue& points, const std::array<int, 2>& degree, NumberReader read) {
  std::vector<std::vector<Point>> rows;
  points.require_size(static_cast<std::size_t>(degree[0]) + 1, "rows for this degree");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const JsonValue row = points.at(i);
    row.require_size(static_cast<std::size_t>(degree[1]) + 1, "points for this degree");
    rows.emplace_back();
    for (std::size_t j = 0; j < row.size(); ++j) {
      const JsonValue point = row.at(j);
      point.require_size(3, "coordinates");
      rows.back().push_back(Point{read_number(point.at(0), read), read_number(point.at(1), read),
                                  read_number(point.at(2), read)});
    }
  }
  return BezierPatch::elevated(rows);
}

std::string format_point(const Point& p) {
  return "[" + format_json_number(p[0]) + ", " + format_json_number(p[1]) + ", " + format_json_number(p[2]) +
         "]";
}

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

std::string format_patch(const NamedPatch& named) {
  std::string text = "  {\"name\": " + json_string(named.name) + ", \"degree\": [" +
                     std::to_string(named.degree[0]) + ", " + std::to_string(named.degree[1]) +
                     "], \"points\": [";
  const char* before_row = "\n   [";
  for (const std::vector<Point>& row : points_of_degree(named)) {
    text += before_row;
    before_row = ",\n   [";
    for (std::size_t j = 0; j < row.size(); ++j) text += (j == 0 ? "" : ", ") + format_point(row[j]);
    text += "]";
  }
  return text + "]}";
}

}  // namespace

NamedPatch read_named_patch(const JsonValue& value, NumberReader read) {
  value.require_object({"name", "degree", "points"});
  const JsonValue name = value.member("name");
  if (name.string().empty()) name.fail("must not be empty");
  if (name.string().size() > max_name_bytes)
    name.fail("must not be longer than " + std::to_string(max_name_bytes) + " bytes");
  const JsonValue degrees = value.member("degree");
  degrees.require_size(2, "degrees");
  const std::array<int, 2> degree = {read_degree(degrees.at(0)), read_degree(degrees.at(1))};
  return {name.string(), degree, read_points(value.member("points"), degree, read)};
}

PatchFile parse_patches(const std::string& text, const std::string& filename) {
  if (text.size() > max_patch_file_bytes)
    throw InputError(filename, "", "longer than " + std::to_string(max_patch_file_bytes) + " bytes");
  const JsonTree tree = parse_json(text, filename, max_depth);
  const JsonValue root(tree, filename, "$");
  root.require_form(version);
  root.require_object({"exsect", "title", "source", "numbers", "patches"});
  PatchFile file;
  if (root.has("title")) file.title = root.member("title").string();
  if (root.has("source")) file.source = root.member("source").string();
  const NumberReader read = number_reader(root);
  const JsonValue patches = root.member("patches");
  if (patches.size() == 0) patches.fail("must hold at least one patch");
  std::set<std::string> names;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    file.patches.push_back(read_named_patch(patches.at(i), read));
    if (!names.insert(file.patches.back().name).second)
      patches.at(i).member("name").fail("name \"" + printable(file.patches.back().name) +
                                        "\" given to two patches");
  }
  return file;
}

PatchFile read_patches(const std::string& path) {
  return parse_patches(read_text_file(path, max_patch_file_bytes), path);
}

std::string format_patches(const PatchFile& file) {
  if (file.patches.empty()) throw std::invalid_argument("patch file: must hold at least one patch");
  std::string text = "{\n \"exsect\": " + json_string(version);
  if (!file.title.empty()) text += ",\n \"title\": " + json_string(file.title);
  if (!file.source.empty()) text += ",\n \"source\": " + json_string(file.source);
  text += ",\n \"patches\": [\n";
  std::set<std::string> names;
  const char* before_patch = "";
  for (const NamedPatch& named : file.patches) {
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

void write_patches(const PatchFile& file, const std::string& path) {
  write_file_atomically(path, format_patches(file));
}

}  // namespace exsect
