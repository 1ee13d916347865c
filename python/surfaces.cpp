#include <exsect/geometry/surface_file.h>
#include <exsect/solver/intersect_equations.h>
#include <exsect/solver/intersect_surface.h>
#include <exsect/solver/patch_ray.h>
#include <pybind11/stl.h>

#include "certificate/certificate_text.h"
#include "equation.h"
#include "forms.h"
#include "numbers.h"
#include "output/drawing/intersection_svg.h"
#include "output/drawing/surfaces_svg.h"
#include "output/report/report_html.h"
#include "output/text/chart_json.h"
#include "output/text/node_csv.h"
#include "output/text/ray_output.h"
#include "run_options.h"
#include "solutions.h"

namespace exsect::python {
namespace {

namespace py = pybind11;

/// Throws std::invalid_argument with the key at fault and the reason.
Equation equation_of(const std::string& entry) {
  const std::string place = "$.patches[0].";
  try {
    const SurfaceFile file =
        parse_surfaces(R"({"exsect": "patches/1", "patches": [)" + entry + "]}", "surface");
    if (const ImplicitSurface* surface = file.surfaces.front().equation()) return {entry, *surface};
  } catch (const InputError& error) {
    const std::string& where = error.where();
    throw std::invalid_argument((where.starts_with(place) ? where.substr(place.size()) : where) + ": " +
                                error.reason());
  }
  throw std::invalid_argument("type: a surface given by its equation is needed");
}

struct SolvedEquation {
  IntersectResult result;
  ImplicitSurface surface;
  RationalPatch patch;
  cli::PatchNames names;

  cli::Json json() const {
    cli::Json tree = cli::intersection_json(result, names);
    cli::add_charts(tree, result.graph, patch, surface);
    return tree;
  }
  std::string svg(const std::string& title) const { return cli::intersection_svg(result, names, title); }
  std::string report(const std::string& title) const {
    return cli::equation_report_html(result, patch, surface, names, {title, ""});
  }
  std::string certificate() const { return cli::certificate_text(surface, patch, names, result); }
  std::string exported(const std::string& format, const std::string& title, int cells) const {
    if (format == "csv") return cli::node_csv(result.graph, names.parameters);
    return scene_text(cli::surface_scene(result, patch, names, title, cells), format);
  }
};

SolvedEquation intersect_equation(const Equation& equation, const RationalPatch& patch,
                                  const std::array<std::string, 2>& names, const std::string& turning,
                                  const std::string& tolerance, const std::string& max_seconds,
                                  const py::object& progress) {
  IntersectOptions options = options_of(turning, tolerance, max_seconds, cli::pair_names);
  options.progress = watched(progress);
  const py::gil_scoped_release release;
  return {intersect(equation.surface, patch, options),
          equation.surface,
          patch,
          {names[0], names[1], cli::one_patch_names, name(equation.surface.kind())}};
}

/// Of two surfaces given by their equations.
struct SolvedSurfaces {
  SurfaceIntersection result;
  ImplicitSurface first;
  ImplicitSurface second;
  cli::SurfaceNames names;

  cli::DrawnSurfaces drawn() const { return {result, first, second, names}; }
  cli::Json json() const {
    cli::Json tree = cli::surfaces_json(result, names);
    cli::add_charts(tree, result, first, second);
    return tree;
  }
  std::string svg(const std::string& title) const { return cli::surfaces_svg(drawn(), title); }
  std::string report(const std::string& title) const {
    return cli::surfaces_report_html(drawn(), {title, ""});
  }
  std::string certificate() const {
    throw std::invalid_argument("certificate: not supported yet with two surfaces given by their equations");
  }
  std::string exported(const std::string& format, const std::string& title, int cells) const {
    if (format == "csv") return cli::space_node_csv(result);
    return scene_text(cli::surfaces_scene(drawn(), title, cells), format);
  }
};

SolvedSurfaces intersect_surfaces(const Equation& first, const Equation& second,
                                  const std::array<std::string, 2>& names, const std::string& tolerance,
                                  const std::string& max_seconds, const py::object& progress) {
  IntersectOptions options = options_of("none", tolerance, max_seconds, cli::pair_names);
  options.progress = watched(progress);
  const py::gil_scoped_release release;
  return {intersect(first.surface, second.surface, options),
          first.surface,
          second.surface,
          {names[0], names[1], name(first.surface.kind()), name(second.surface.kind())}};
}

/// What the results with an equation have beside the common forms.
template <class Solved>
void add_solved(py::module_& module, const char* type_name) {
  py::class_<Solved> solved(module, type_name);
  add_forms(solved);
  solved.def("exported", &Solved::exported, py::arg("format"), py::arg("title"), py::arg("cells"));
  solved.def("certificate", &Solved::certificate);
}

Point vector_of(const py::sequence& numbers, const std::string& where) {
  if (numbers.size() != 3) throw std::invalid_argument(where + ": must be three numbers");
  Point p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = rational_of(numbers[k], Numbers::exact, where);
  return p;
}

py::object ray_tree(const py::sequence& origin, const py::sequence& direction, const py::dict& surfaces) {
  cli::ShownRay ray = {vector_of(origin, "origin"), vector_of(direction, "direction"), {}};
  if (is_zero(ray.direction)) throw std::invalid_argument("direction: the vector is zero");
  for (const auto& [name, surface] : surfaces) {
    const bool is_patch = py::isinstance<RationalPatch>(surface);
    const auto common = [&](const auto& shape) {
      const py::gil_scoped_release release;
      return intersect_ray(ray.origin, ray.direction, shape);
    };
    ray.surfaces.push_back({py::str(name), is_patch ? common(surface.cast<const RationalPatch&>())
                                                    : common(surface.cast<const Equation&>().surface)});
  }
  return python_of(cli::ray_json(ray));
}

}  // namespace

void add_surfaces(py::module_& module) {
  py::class_<Equation>(module, "Surface",
                       "A surface given by its exact equation: made by plane, cylinder, cone, sphere, torus "
                       "and implicit.")
      .def(py::init(&equation_of), py::arg("entry"))
      .def_readonly("entry", &Equation::entry, "The entry of a patch file (formats.md), as JSON.")
      .def_property_readonly(
          "kind", [](const Equation& equation) { return name(equation.surface.kind()); },
          "plane, cylinder, cone, sphere, torus or implicit.")
      .def(
          "__contains__",
          [](const Equation& equation, const py::sequence& point) {
            return equation.surface.contains(vector_of(point, "point"));
          },
          py::arg("point"), "Whether the exact point is on it.")
      .def(
          "__eq__", [](const Equation& a, const Equation& b) { return a.entry == b.entry; },
          py::is_operator())
      .def("__repr__", [](const Equation& equation) { return "<Surface " + equation.entry + ">"; })
      .def(py::pickle([](const Equation& equation) { return equation.entry; }, &equation_of));
  add_solved<SolvedEquation>(module, "SolvedEquation");
  add_solved<SolvedSurfaces>(module, "SolvedSurfaces");
  module.def("intersect_equation", &intersect_equation);
  module.def("intersect_surfaces", &intersect_surfaces);
  module.def("ray", &ray_tree);
}

}  // namespace exsect::python
