#include "cli/ray_command.h"

#include <exsect/geometry/text_file.h>
#include <exsect/solver/patch_ray.h>
#include <fmt/format.h>

#include "cli/input_file.h"
#include "output/options/option_values.h"
#include "output/text/ray_output.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

/// The surfaces that are asked for: the one of that name, or all.
std::vector<NamedSurface> chosen_surfaces(const RayCommand& command, const SurfaceFile& file) {
  if (command.surface.empty()) return file.surfaces;
  for (const NamedSurface& named : file.surfaces)
    if (named.name == command.surface) return {named};
  throw InputError(input_name(command.file), "$.patches",
                   fmt::format("--surface: none is named \"{}\"", printable(command.surface)));
}

RayIntersection common_points_of(const ShownRay& ray, const NamedSurface& named) {
  return std::visit([&](const auto& surface) { return intersect_ray(ray.origin, ray.direction, surface); },
                    named.surface);
}

}  // namespace

ExitStatus run(const RayCommand& command, const Streams& streams) {
  ShownRay ray = {
      vector_value("--origin", command.origin), vector_value("--direction", command.direction), {}};
  if (is_zero(ray.direction)) throw UsageError("--direction: the vector is zero");
  check(command.output, command.file);
  const SurfaceFile file = input_surfaces(command.file);
  for (const NamedSurface& named : chosen_surfaces(command, file))
    ray.surfaces.push_back({named.name, common_points_of(ray, named)});
  const std::string json = command.output.json.empty() ? "" : json_text(ray_json(ray));
  if (!command.output.json.empty() && !command.output.json_to_stdout())
    write_file_atomically(command.output.json, json);
  if (command.output.json_to_stdout())
    streams.out << json;
  else if (!command.quiet)
    streams.out << heading(input_name(command.file), file.title) << ray_summary(ray, command.verbose);
  return ray.is_complete() ? ExitStatus::complete : ExitStatus::incomplete;
}

}  // namespace exsect::cli
