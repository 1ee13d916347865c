#include "run_options.h"

#include "output/drawing/scene_obj.h"
#include "output/drawing/scene_ply.h"
#include "output/drawing/scene_vtp.h"
#include "output/options/option_values.h"

namespace exsect::python {

namespace py = pybind11;

std::string scene_text(const cli::Scene& scene, const std::string& format) {
  if (format == "obj") return cli::obj_text(scene);
  if (format == "ply") return cli::ply_text(scene);
  if (format == "vtp") return cli::vtp_text(scene);
  throw std::invalid_argument("format: \"" + format + "\" is not one of obj, ply, vtp, csv");
}

IntersectOptions options_of(const std::string& turning, const std::string& tolerance,
                            const std::string& max_seconds, const cli::ParameterNames& names) {
  IntersectOptions options;
  options.turning = cli::parameter_list("turning", turning, names);
  options.tolerance = cli::positive_value("tolerance", tolerance);
  if (!max_seconds.empty()) options.max_seconds = cli::positive_value("max_seconds", max_seconds);
  return options;
}

std::function<void(double, const char*)> watched(const py::object& progress) {
  return [&progress](double fraction, const char* step) {
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress.is_none()) progress(fraction, step);
  };
}

}  // namespace exsect::python
