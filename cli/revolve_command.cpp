#include "cli/revolve_command.h"

#include <exsect/geometry/curve_file.h>
#include <exsect/implicit/revolution_mesh.h>
#include <fmt/format.h>

#include <stdexcept>

#include "cli/export_files.h"
#include "cli/input_file.h"
#include "cli/patch_choice.h"
#include "output/drawing/revolution_svg.h"
#include "output/drawing/scene_obj.h"
#include "output/options/implicitize_options.h"
#include "output/options/option_values.h"
#include "output/report/method_reports.h"
#include "output/text/implicit_json.h"
#include "output/text/revolution_output.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

/// Bad curves and options are the user's: the statement that they violate, with the file's name.
Revolution solved(const std::string& file, const BezierCurve& profile, const RevolveOptions& options) {
  try {
    return revolve(profile, options);
  } catch (const std::invalid_argument& error) {
    throw InputError(file, "", error.what());
  } catch (const std::domain_error& error) {
    throw InputError(file, "", error.what());
  }
}

/// The mesh and its proved distance from the implicit surface: a sum of two.
struct BoundedMesh {
  TriangleMesh mesh;
  Rational from_profile;  // of the implicit surface
};

BoundedMesh bounded_mesh(const RevolveCommand& command, const ShownRevolution& shown) {
  const auto bound = shown.revolution.bounds.one_sided.distance;
  if (!bound) throw UsageError("--mesh: no distance of profile and surface was proved");
  const std::size_t comma = command.mesh_size.find(',');
  if (comma == std::string::npos) throw UsageError("--mesh-size: must be M,N");
  const int along = integer_value("--mesh-size", command.mesh_size.substr(0, comma), 1, 4096);
  const int around = integer_value("--mesh-size", command.mesh_size.substr(comma + 1), 4, 4096);
  return {revolution_mesh(shown.profile, along, around), *bound};
}

std::string mesh_text(const RevolveCommand& command, const ShownRevolution& shown, const std::string& title) {
  const auto [mesh, bound] = bounded_mesh(command, shown);
  const Rational distance = bound + mesh.distance;
  return obj_text(mesh, {"exsect revolve: " + printable(title.empty() ? command.file : title),
                         fmt::format("method {}", name(shown.method)),
                         "every point of the mesh is within " + rounded_up(to_double(distance)) +
                             " of the implicit surface (proved): " + rounded_up(to_double(mesh.distance)) +
                             " from the revolved profile, " + rounded_up(to_double(bound)) + " from there"});
}

Scene surface_scene(const RevolveCommand& command, const ShownRevolution& shown, const std::string& title) {
  const auto [mesh, bound] = bounded_mesh(command, shown);
  return mesh_scene(mesh, double_not_below(bound + mesh.distance), title);
}

void check_more(const RevolveCommand& command) {
  check(command.output, command.file);
  if (command.patch_file.empty() && (!command.patch.empty() || !command.lines.empty()))
    throw UsageError("--patch and --u need --patch-file");
  if (command.mesh.empty()) return;
  OutputFiles mesh;
  mesh.svg = command.mesh;
  try {
    check(mesh, command.file);
  } catch (const UsageError& error) {
    throw UsageError("--mesh" + std::string(error.what()).substr(5));  // instead of "--svg"
  }
  const ExportFiles& exports = command.output.exports;
  for (const std::string& other : {command.output.json, command.output.svg, command.output.report,
                                   exports.ply, exports.vtp, command.patch_file})
    if (other == command.mesh) throw UsageError("--mesh: " + command.mesh + " is named twice");
}

}  // namespace

ExitStatus run(const RevolveCommand& command, const Streams& streams) {
  const RevolveOptions checked = revolve_options(command);
  check_more(command);
  const CurveFile file = input_curve(command.file);
  ShownRevolution shown{checked.method, file.curve, solved(command.file, file.curve, checked), std::nullopt};
  if (!command.patch_file.empty())
    shown.patch =
        shown_on_patch(command.lines, shown.revolution, read_patch(command.patch_file, command.patch).patch);
  const std::string json = command.output.json.empty() ? "" : json_text(revolution_json(shown));
  const std::string svg = command.output.svg.empty() ? "" : revolution_svg(shown, file.title);
  const std::string mesh = command.mesh.empty() ? "" : mesh_text(command, shown, file.title);
  write_exports(
      command.output.exports, [&] { return surface_scene(command, shown, file.title); },
      [] { return std::string(); });
  if (!command.output.json.empty() && !command.output.json_to_stdout()) {
    write_file_atomically(command.output.json, json);
  }
  if (!svg.empty()) write_file_atomically(command.output.svg, svg);
  std::vector<std::string> inputs = {command.file};
  if (!command.patch_file.empty()) inputs.push_back(command.patch_file);
  if (!command.output.report.empty())
    write_file_atomically(command.output.report,
                          revolution_report_html(shown, origin_of(file.title, command.output.line, inputs)));
  if (!mesh.empty()) write_file_atomically(command.mesh, mesh);
  if (command.output.json_to_stdout()) {
    streams.out << json;
  } else if (!command.quiet) {
    streams.out << heading(input_name(command.file), file.title) << revolution_summary(shown);
  }
  return shown.is_complete() ? ExitStatus::complete : ExitStatus::incomplete;
}

}  // namespace exsect::cli
