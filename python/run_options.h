// Options of a call as arguments of Python functions, and exports by the name of their format.
#pragma once

#include <exsect/solver/options.h>
#include <pybind11/pybind11.h>

#include <functional>
#include <string>

#include "output/drawing/scene.h"
#include "output/text/parameter_names.h"

namespace exsect::python {

/// Throws cli::UsageError for what is no option.
IntersectOptions options_of(const std::string& turning, const std::string& tolerance,
                            const std::string& max_seconds, const cli::ParameterNames& names);

/// Between two steps: the caller's progress function, which must outlive it, and an interrupt from the
/// keyboard.
std::function<void(double, const char*)> watched(const pybind11::object& progress);

/// "obj", "ply" or "vtp"; std::invalid_argument for any other.
std::string scene_text(const cli::Scene& scene, const std::string& format);

}  // namespace exsect::python
