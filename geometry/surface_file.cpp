#include "surface_file.h"

#include <cstddef>
#include <set>

#include "bpt_file.h"
#include "json_value.h"
#include "patch_value.h"
#include "surface_value.h"

namespace exsect {
namespace {

NamedSurface read_named_surface(const JsonValue& value, NumberReader read) {
  if (value.has("type")) return {read_name(value), read_implicit_surface(value, read)};
  NamedRationalPatch named = read_named_patch(value, read);
  return {std::move(named.name), std::move(named.patch)};
}

}  // namespace

SurfaceFile parse_surfaces(const std::string& text, const std::string& filename) {
  if (text.size() > max_patch_file_bytes)
    throw InputError(filename, "", "longer than " + std::to_string(max_patch_file_bytes) + " bytes");
  const JsonTree tree = parse_json(text, filename, max_depth_of_files);
  const JsonValue root(tree, filename, "$");
  root.require_form(patches_version);
  root.require_object({"exsect", "title", "source", "numbers", "patches"});
  SurfaceFile file;
  if (root.has("title")) file.title = root.member("title").string();
  if (root.has("source")) file.source = root.member("source").string();
  const NumberReader read = number_reader(root);
  const JsonValue entries = root.member("patches");
  if (entries.size() == 0) entries.fail("must hold at least one patch");
  std::set<std::string> names;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    file.surfaces.push_back(read_named_surface(entries.at(i), read));
    const std::string& name = file.surfaces.back().name;
    if (!names.insert(name).second)
      entries.at(i).member("name").fail("name \"" + printable(name) + "\" given to two patches");
  }
  return file;
}

SurfaceFile read_surfaces(const std::string& path) {
  const std::string text = read_text_file(path, max_patch_file_bytes);
  if (!is_bpt(path)) return parse_surfaces(text, path);
  RationalPatchFile patches = parse_bpt(text, path);
  SurfaceFile file = {std::move(patches.title), std::move(patches.source), {}};
  for (NamedRationalPatch& named : patches.patches)
    file.surfaces.push_back({std::move(named.name), std::move(named.patch)});
  return file;
}

}  // namespace exsect
