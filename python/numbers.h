// Exact numbers and results between C++ and Python.
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/rational_patch.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "output/text/json_forms.h"

namespace exsect::python {

/// Which Python numbers are taken: exact ones (int, fractions.Fraction and other numbers.Rational,
/// decimal.Decimal, strings as in patch files), or floats, each of which is the binary64 number that it is.
enum class Numbers { exact, floats };

/// The number, exactly; `where` begins the message of an error. Throws py::type_error for a float among exact
/// numbers and for what is no number, std::invalid_argument for text that parse_number refuses, NaN and
/// infinity.
Rational rational_of(pybind11::handle number, Numbers numbers, const std::string& where);
/// fractions.Fraction; integers cross in hexadecimal, which Python does not limit.
pybind11::object fraction_of(const Rational& value);
pybind11::tuple fractions_of(const std::vector<Rational>& values);

/// m+1 rows of n+1 points of 3 coordinates, m and n from 1 to 3; weights are None or as many numbers. A patch
/// without weights of bidegree below (2,2) is elevated to it. Throws std::invalid_argument as RationalPatch.
RationalPatch patch_of(const pybind11::object& points, const pybind11::object& weights, Numbers numbers);
/// The patch for methods that take no other; std::invalid_argument that names it and its kind for any other.
BezierPatch biquadratic_of(const RationalPatch& patch, const std::string& name);
/// n+1 points of 2 or 3 coordinates; weights are None or n+1 numbers.
BezierCurve curve_of(const pybind11::object& points, const pybind11::object& weights, Numbers numbers);

/// Dictionaries and lists in the shape of the JSON, with rationals as Fraction; texts that are names or
/// sentences stay as they are.
pybind11::object python_of(const cli::Json& json);

}  // namespace exsect::python
