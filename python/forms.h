// The forms in which every result crosses to Python.
#pragma once

#include <pybind11/pybind11.h>

#include "numbers.h"

namespace exsect::python {

/// Adds tree(), json(), svg(title) and report(title) of a type with json(), svg and report.
template <class Solved>
void add_forms(pybind11::class_<Solved>& type) {
  namespace py = pybind11;
  type.def("tree", [](const Solved& solved) { return python_of(solved.json()); });
  type.def("json", [](const Solved& solved) { return cli::json_text(solved.json()); });
  type.def("svg", &Solved::svg, py::arg("title"));
  type.def("report", &Solved::report, py::arg("title"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace exsect::python
