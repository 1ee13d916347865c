#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/line_patch.h>
#include <pybind11/stl.h>

#include "certificate/certificate_text.h"
#include "certificate/line.h"
#include "forms.h"
#include "numbers.h"
#include "output/drawing/intersection_svg.h"
#include "output/drawing/line_svg.h"
#include "output/options/option_values.h"
#include "output/report/report_html.h"
#include "output/text/line_json.h"
#include "output/text/node_csv.h"
#include "output/text/shown_line.h"
#include "run_options.h"
#include "solutions.h"

namespace exsect::python {
namespace {

namespace py = pybind11;

/// Of two patches, or of one patch with itself: then `second` is empty.
struct SolvedPair {
  IntersectResult result;
  RationalPatch first;
  std::optional<RationalPatch> second;
  cli::PatchNames names;

  cli::Json json() const {
    return second ? cli::intersection_json(result, names) : cli::self_json(result, names.first);
  }
  std::string svg(const std::string& title) const { return cli::intersection_svg(result, names, title); }
  std::string report(const std::string& title) const {
    return second ? cli::report_html(result, first, *second, names, {title, ""})
                  : cli::self_report_html(result, first, names.first, {title, ""});
  }
  std::string certificate() const {
    return second ? cli::certificate_text(first, *second, names, result)
                  : cli::self_certificate_text(first, names, result);
  }
  std::string exported(const std::string& format, const std::string& title, int cells) const {
    if (format == "csv") return cli::node_csv(result.graph, names.parameters);
    return scene_text(second ? cli::intersection_scene(result, first, *second, names, title, cells)
                             : cli::self_scene(result, first, names.first, title, cells),
                      format);
  }
};

struct SolvedLine {
  LineIntersection line;
  RationalPatch first;
  RationalPatch second;
  cli::PatchNames names;

  cli::Json json() const { return cli::line_json(line, first); }
  std::string svg(const std::string& title) const { return cli::line_svg(line, first, title); }
  std::string report(const std::string& title) const {
    return cli::line_report_html(line, first, second, names, {title, ""});
  }
  std::string certificate() const { return cli::certificate_text(first, second, names, line); }
  std::string exported(const std::string& format, const std::string& title, int cells) const {
    if (format == "csv") return cli::point_csv(line, first);
    return scene_text(cli::line_scene(line, first, second, names, title, cells), format);
  }
  /// The box of the i-th point at most `width` wide, as four pairs of Fraction.
  py::tuple box(std::size_t i, const py::object& width) const {
    const Rational most = rational_of(width, Numbers::exact, "width");
    if (most <= 0) throw std::invalid_argument("width: must be > 0");
    const CertifiedPoint point = [&] {
      const py::gil_scoped_release release;
      return line.solution.points.at(i).refined_to(most);
    }();
    py::tuple sides(4);
    for (std::size_t k = 0; k < 4; ++k)
      sides[k] = py::make_tuple(fraction_of(point.box()[k].lower), fraction_of(point.box()[k].upper));
    return sides;
  }
};

SolvedPair intersect_patches(const RationalPatch& x, const RationalPatch& y,
                             const std::array<std::string, 2>& names, const std::string& turning,
                             const std::string& tolerance, const std::string& max_seconds, bool exact,
                             const py::object& progress) {
  IntersectOptions options = options_of(turning, tolerance, max_seconds, cli::pair_names);
  options.exact = exact;
  options.progress = watched(progress);
  const py::gil_scoped_release release;
  return {intersect(x, y, options), x, y, {names[0], names[1]}};
}

SolvedPair self_intersect_patch(const RationalPatch& x, const std::string& name, const std::string& turning,
                                const std::string& tolerance, const std::string& max_seconds,
                                const py::object& progress) {
  IntersectOptions options = options_of(turning, tolerance, max_seconds, cli::self_names);
  options.progress = watched(progress);
  const py::gil_scoped_release release;
  return {self_intersect(x, options), x, std::nullopt, {name, name, cli::self_names}};
}

SolvedLine intersect_parameter_line(const RationalPatch& first, const RationalPatch& second,
                                    const std::array<std::string, 2>& names, const std::string& parameter,
                                    const py::object& value) {
  const std::vector<Parameter> fixed = cli::parameter_list("parameter", parameter);
  if (fixed.size() != 1) throw std::invalid_argument("parameter: one of u, v, r, s is needed");
  const LineQuery query{fixed.front(), rational_of(value, Numbers::exact, parameter)};
  const py::gil_scoped_release release;
  return {intersect_line(first, second, query), first, second, {names[0], names[1]}};
}

/// What intersections and lines have beside the common forms.
template <class Solved>
void add_exports(py::class_<Solved>& type) {
  add_forms(type);
  type.def("exported", &Solved::exported, py::arg("format"), py::arg("title"), py::arg("cells"));
  type.def("certificate", &Solved::certificate, py::call_guard<py::gil_scoped_release>());
}

}  // namespace

void add_intersections(py::module_& module) {
  py::class_<SolvedPair> pair(module, "SolvedPair");
  add_exports(pair);
  py::class_<SolvedLine> line(module, "SolvedLine");
  add_exports(line);
  line.def("box", &SolvedLine::box, py::arg("index"), py::arg("width"));
  module.def("intersect", &intersect_patches);
  module.def("self_intersect", &self_intersect_patch);
  module.def("line", &intersect_parameter_line);
}

}  // namespace exsect::python
