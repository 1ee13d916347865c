#include <exsect/checker/check_certificate.h>
#include <exsect/geometry/candidate_file.h>
#include <exsect/verify/verify_equation.h>
#include <pybind11/stl.h>

#include <utility>

#include "equation.h"
#include "forms.h"
#include "output/drawing/comparison_svg.h"
#include "output/options/option_values.h"
#include "output/report/method_reports.h"
#include "output/report/verdict_picture.h"
#include "output/report/verdict_report.h"
#include "output/text/comparison.h"
#include "output/text/comparison_json.h"
#include "output/text/verdict_json.h"
#include "solutions.h"

namespace exsect::python {
namespace {

namespace py = pybind11;

/// A candidate for the intersection of two patches, or of a patch and a surface given by its equation, and
/// what was proved of it.
template <class Second>
struct SolvedVerdict {
  Verification verification;
  Candidate candidate;
  RationalPatch first;
  Second second;
  cli::PatchNames names;

  cli::Json json() const { return cli::verdict_json(verification, candidate, names); }
  std::string svg(const std::string& title) const {
    return cli::verdict_svg(verification, candidate, names, title);
  }
  std::string report(const std::string& title) const {
    return cli::verdict_report_html(verification, candidate, first, second, names, {title, ""});
  }
};

/// The same of two surfaces given by their equations.
struct SurfacesVerdict {
  EquationsVerification verification;
  Candidate candidate;
  ImplicitSurface first;
  ImplicitSurface second;
  cli::SurfaceNames names;

  cli::DrawnSurfaces drawn() const { return {verification.surfaces, first, second, names}; }
  cli::Json json() const { return cli::verdict_json(verification, candidate, {names.first, names.second}); }
  std::string svg(const std::string& title) const {
    return cli::verdict_svg(verification, candidate, drawn(), title);
  }
  std::string report(const std::string& title) const {
    return cli::verdict_report_html(verification, candidate, drawn(), {title, ""});
  }
};

struct SolvedComparison {
  cli::Comparison comparison;
  BezierPatch first;
  BezierPatch second;
  cli::PatchNames names;

  cli::Json json() const { return cli::comparison_json(comparison, names); }
  std::string svg(const std::string& title) const { return cli::comparison_svg(comparison, title); }
  std::string report(const std::string& title) const {
    return cli::comparison_report_html(comparison, first, second, names, {title, ""});
  }
};

/// The text of a candidate file, in the form that the end of its name says.
Candidate candidate_of(const std::string& text, const std::string& filename) {
  return parse_candidate(text, filename, candidate_format(filename));
}

VerifyOptions verify_options(const std::string& tolerance, const std::string& max_seconds) {
  VerifyOptions options;
  options.tolerance = cli::positive_value("tolerance", tolerance);
  if (!max_seconds.empty()) options.max_seconds = cli::positive_value("max_seconds", max_seconds);
  options.progress = [](double, const char*) {
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
  return options;
}

SolvedVerdict<RationalPatch> verify_patches(const std::string& text, const std::string& filename,
                                            const RationalPatch& first, const RationalPatch& second,
                                            const std::array<std::string, 2>& names,
                                            const std::string& tolerance, const std::string& max_seconds) {
  const Candidate candidate = candidate_of(text, filename);
  const VerifyOptions options = verify_options(tolerance, max_seconds);
  const py::gil_scoped_release release;
  return {verify(candidate, first, second, options), candidate, first, second, {names[0], names[1]}};
}

/// The names are those of patch and surface, the candidate is for the surface and the patch if
/// `is_exchanged`.
SolvedVerdict<ImplicitSurface> verify_equation(const std::string& text, const std::string& filename,
                                               const RationalPatch& patch, const Equation& equation,
                                               const std::array<std::string, 2>& names, bool is_exchanged,
                                               const std::string& tolerance, const std::string& max_seconds) {
  Candidate candidate = candidate_of(text, filename);
  if (is_exchanged) candidate = exchanged(std::move(candidate));
  const VerifyOptions options = verify_options(tolerance, max_seconds);
  const ImplicitSurface& surface = equation.surface;
  const py::gil_scoped_release release;
  return {verify(candidate, surface, patch, options),
          candidate,
          patch,
          surface,
          {names[0], names[1], cli::one_patch_names, name(surface.kind())}};
}

SurfacesVerdict verify_surfaces(const std::string& text, const std::string& filename, const Equation& first,
                                const Equation& second, const std::array<std::string, 2>& names,
                                const std::string& tolerance, const std::string& max_seconds) {
  const Candidate candidate = candidate_of(text, filename);
  const VerifyOptions options = verify_options(tolerance, max_seconds);
  const py::gil_scoped_release release;
  return {verify(candidate, first.surface, second.surface, options),
          candidate,
          first.surface,
          second.surface,
          {names[0], names[1], name(first.surface.kind()), name(second.surface.kind())}};
}

SolvedComparison compare_methods(const RationalPatch& first, const RationalPatch& second,
                                 const std::array<std::string, 2>& names, int lines, int pieces,
                                 const std::string& fit, const std::string& plane) {
  const BezierPatch x = biquadratic_of(first, names[0]), y = biquadratic_of(second, names[1]);
  cli::ComparisonOptions options;
  if (lines < 1 || lines > 10000) throw std::invalid_argument("lines: must be in 1..10000");
  if (pieces < 0 || pieces > 3) throw std::invalid_argument("pieces: must be in 0..3");
  if (fit != "conics" && fit != "dokken") throw std::invalid_argument("fit: must be conics or dokken");
  if (plane != "u,r" && plane != "v,s") throw std::invalid_argument("plane: must be u,r or v,s");
  options.lines = lines;
  options.pieces = pieces;
  options.fit = fit == "conics" ? PatchFit::conics : PatchFit::dokken;
  options.plane = plane == "u,r" ? cli::ResultantPlane::u_r : cli::ResultantPlane::v_s;
  const py::gil_scoped_release release;
  return {cli::compare(x, y, options), x, y, {names[0], names[1]}};
}

/// {"accepted": .., "place": .., "reason": .., "summary": numbers of what is proved}.
py::dict check_text(const std::string& certificate) {
  py::dict found;
  try {
    const checker::Report report = [&] {
      const py::gil_scoped_release release;
      return checker::check_certificate(certificate);
    }();
    const checker::Summary& summary = report.summary;
    py::dict numbers;
    if (report.fixed) {
      numbers["points"] = summary.claims[3];
    } else {
      numbers["components"] = summary.components;
      numbers["closed"] = summary.closed;
      numbers["open"] = summary.open;
      numbers["branched"] = summary.branched;
      numbers["isolated"] = summary.isolated;
      numbers["nodes"] = summary.claims[3];
      numbers["arcs"] = summary.claims[4];
    }
    found["accepted"] = true;
    found["place"] = py::str("");
    found["reason"] = py::str("");
    found["summary"] = numbers;
  } catch (const checker::Unreadable& unreadable) {
    throw std::invalid_argument(unreadable.what());
  } catch (const checker::Rejected& rejected) {
    found["accepted"] = false;
    found["place"] = rejected.place();
    found["reason"] = std::string(rejected.what());
    found["summary"] = py::dict();
  }
  return found;
}

}  // namespace

void add_verifications(py::module_& module) {
  module.def("candidate_bytes", [](const std::string& path) {
    candidate_format(path);  // refuses a name of no format before the file is read
    return py::bytes(read_text_file(path, max_candidate_file_bytes));
  });
  py::class_<SolvedVerdict<RationalPatch>> of_patches(module, "SolvedVerdict");
  add_forms(of_patches);
  py::class_<SolvedVerdict<ImplicitSurface>> of_equation(module, "EquationVerdict");
  add_forms(of_equation);
  py::class_<SurfacesVerdict> of_surfaces(module, "SurfacesVerdict");
  add_forms(of_surfaces);
  py::class_<SolvedComparison> comparison(module, "SolvedComparison");
  add_forms(comparison);
  module.def("verify", &verify_patches);
  module.def("verify_equation", &verify_equation);
  module.def("verify_surfaces", &verify_surfaces);
  module.def("compare", &compare_methods);
  module.def("check", &check_text);
}

}  // namespace exsect::python
