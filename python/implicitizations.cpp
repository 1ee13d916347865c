#include <exsect/implicit/implicitize_curve.h>
#include <exsect/implicit/implicitize_space_curve.h>
#include <pybind11/stl.h>

#include <map>

#include "numbers.h"
#include "output/drawing/implicit_svg.h"
#include "output/drawing/revolution_svg.h"
#include "output/drawing/space_implicit_svg.h"
#include "output/options/implicitize_options.h"
#include "output/options/revolve_options.h"
#include "output/report/method_reports.h"
#include "output/text/implicit_json.h"
#include "output/text/implicit_summary.h"
#include "output/text/patch_implicit_output.h"
#include "output/text/revolution_output.h"
#include "output/text/space_implicit_output.h"
#include "solutions.h"

namespace exsect::python {
namespace {

namespace py = pybind11;

using Options = std::map<std::string, std::string>;

/// JSON and picture of an implicit equation or surface, made while the interpreter was free for others.
struct Solved {
  cli::Json json;
  std::function<std::string(const std::string&)> picture;  // of a title; empty if there is none
  std::function<std::string(const std::string&)> page;     // of a title

  std::string svg(const std::string& title) const {
    if (!picture) throw std::invalid_argument("svg: there is no picture of a patch's equation");
    return picture(title);
  }
  std::string report(const std::string& title) const { return page(title); }
};

/// The equation of a curve, or of a patch, which has no picture.
Solved solved(const cli::Json& json, const std::function<std::string(const std::string&)>& picture,
              const std::optional<BezierCurve>& curve, const std::optional<NamedPatch>& patch) {
  return {
      json, picture, [json, picture, curve, patch](const std::string& title) {
        return cli::implicit_report_html(json, {picture ? picture(title) : "", curve, patch}, {title, ""});
      }};
}

cli::ImplicitizeCommand implicitize_command(const Options& options) {
  cli::ImplicitizeCommand command;
  const std::map<std::string, std::string*> texts = {{"method", &command.method},
                                                     {"degree", &command.degree},
                                                     {"space", &command.space},
                                                     {"cells", &command.cells},
                                                     {"samples", &command.samples},
                                                     {"w1", &command.w1},
                                                     {"w2", &command.w2},
                                                     {"digits", &command.digits},
                                                     {"box", &command.box},
                                                     {"axis", &command.axis},
                                                     {"epsilon", &command.epsilon},
                                                     {"factor_degree", &command.factor_degree},
                                                     {"variables", &command.variables}};
  for (const auto& [key, text] : options) {
    if (key == "exact_arithmetic")
      command.exact_arithmetic = text == "True";
    else
      *texts.at(key) = text;
  }
  return command;
}

Solved implicitize_curve(const BezierCurve& curve, const Options& given) {
  const cli::ImplicitizeCommand command = implicitize_command(given);
  const py::gil_scoped_release release;
  if (curve.dimension() == 3) {
    const SpaceOptions options = cli::space_options(command);
    const SpaceImplicit result = implicitize_space(curve, options);
    const auto picture = [result, curve](const std::string& title) {
      return cli::space_implicit_svg(result, curve, title);
    };
    return solved(cli::space_implicit_json(result, options), picture, curve, std::nullopt);
  }
  const PlanarOptions options = cli::planar_options(command);
  const std::vector<std::string> variables = cli::variable_names(command, {"x", "y"});
  const PlanarImplicit result = implicitize(curve, options);
  const std::string subtitle = cli::planar_subtitle(result, options);
  const auto picture = [result, curve, subtitle, variables](const std::string& title) {
    return cli::planar_implicit_svg(result, curve, subtitle, variables, title);
  };
  return solved(cli::planar_implicit_json(result, options, variables), picture, std::nullopt, std::nullopt);
}

Solved implicitize_one_patch(const RationalPatch& shape, const Options& given) {
  const BezierPatch patch = biquadratic_of(shape, "patch");
  const cli::PatchOptions options = cli::patch_options(implicitize_command(given));
  const py::gil_scoped_release release;
  const cli::Json json = cli::patch_implicit_json(cli::implicitize_patch(patch, options), options);
  return solved(json, {}, std::nullopt, NamedPatch{"patch", {2, 2}, patch});
}

Solved revolve_profile(const BezierCurve& profile, const Options& given,
                       const std::optional<RationalPatch>& patch, const std::string& patch_name,
                       const std::vector<std::string>& lines) {
  cli::RevolveCommand command;
  const std::map<std::string, std::string*> texts = {
      {"method", &command.method},   {"degree", &command.degree}, {"cells", &command.cells},
      {"samples", &command.samples}, {"w1", &command.w1},         {"w2", &command.w2},
      {"region", &command.region}};
  for (const auto& [key, text] : given) *texts.at(key) = text;
  command.lines = lines;
  std::optional<NamedPatch> named;
  if (patch) named.emplace(NamedPatch{patch_name, {2, 2}, biquadratic_of(*patch, patch_name)});
  const py::gil_scoped_release release;
  const RevolveOptions options = cli::revolve_options(command);
  cli::ShownRevolution shown{options.method, profile, revolve(profile, options), std::nullopt};
  if (named) shown.patch = cli::shown_on_patch(command.lines, shown.revolution, *named);
  return {cli::revolution_json(shown),
          [shown](const std::string& title) { return cli::revolution_svg(shown, title); },
          [shown](const std::string& title) {
            return cli::revolution_report_html(shown, {title, ""});
          }};
}

}  // namespace

void add_implicitizations(py::module_& module) {
  py::class_<Solved>(module, "Solved")
      .def("tree", [](const Solved& solved) { return python_of(solved.json); })
      .def("json", [](const Solved& solved) { return cli::json_text(solved.json); })
      .def("svg", &Solved::svg, py::arg("title"))
      .def("report", &Solved::report, py::arg("title"), py::call_guard<py::gil_scoped_release>());
  module.def("implicitize", &implicitize_curve);
  module.def("implicitize", &implicitize_one_patch);
  module.def("revolve", &revolve_profile);
}

}  // namespace exsect::python
