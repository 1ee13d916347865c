#include <exsect/checker/check_certificate.h>
#include <exsect/geometry/candidate_file.h>
#include <exsect/solver/verify.h>
#include <pybind11/stl.h>

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

/// A candidate for the intersection of two patches, and what was proved of it.
struct SolvedVerdict {
  Verification verification;
  Candidate candidate;
  RationalPatch first;
  RationalPatch second;
  cli::PatchNames names;

  cli::Json json() const { return cli::verdict_json(verification, candidate, names); }
  std::string svg(const std::string& title) const {
    return cli::verdict_svg(verification, candidate, names, title);
  }
  std::string report(const std::string& title) const {
    return cli::verdict_report_html(verification, candidate, first, second, names, {title, ""});
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
SolvedVerdict verify_candidate(const std::string& text, const std::string& filename,
                               const RationalPatch& first, const RationalPatch& second,
                               const std::array<std::string, 2>& names, const std::string& tolerance,
                               const std::string& max_seconds) {
  const Candidate candidate = parse_candidate(text, filename, candidate_format(filename));
  VerifyOptions options;
  options.tolerance = cli::positive_value("tolerance", tolerance);
  if (!max_seconds.empty()) options.max_seconds = cli::positive_value("max_seconds", max_seconds);
  options.progress = [](double, const char*) {
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
  const py::gil_scoped_release release;
  return {verify(candidate, first, second, options), candidate, first, second, {names[0], names[1]}};
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
  py::class_<SolvedVerdict> verdict(module, "SolvedVerdict");
  add_forms(verdict);
  py::class_<SolvedComparison> comparison(module, "SolvedComparison");
  add_forms(comparison);
  module.def("verify", &verify_candidate);
  module.def("compare", &compare_methods);
  module.def("check", &check_text);
}

}  // namespace exsect::python
