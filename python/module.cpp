// The compiled part of the Python module exsect; python/exsect/__init__.py is what users import.
#include <exsect/geometry/curve_file.h>
#include <exsect/geometry/number.h>
#include <exsect/geometry/rational_patch_file.h>
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <cctype>

#include "certificate/search.h"
#include "numbers.h"
#include "output/options/output_files.h"
#include "solutions.h"

namespace exsect::python {
namespace {

namespace py = pybind11;

/// Rows of what `element` makes of i and j.
template <class Element>
py::tuple rows_of(const RationalPatch& patch, Element element) {
  py::tuple rows(static_cast<std::size_t>(patch.degree_u()) + 1);
  for (int i = 0; i <= patch.degree_u(); ++i) {
    py::tuple row(static_cast<std::size_t>(patch.degree_v()) + 1);
    for (int j = 0; j <= patch.degree_v(); ++j) row[static_cast<std::size_t>(j)] = element(i, j);
    rows[static_cast<std::size_t>(i)] = row;
  }
  return rows;
}

py::tuple net_of(const RationalPatch& patch) {
  return rows_of(patch, [&](int i, int j) {
    const Point p = patch.point(i, j);
    return fractions_of({p[0], p[1], p[2]});
  });
}

py::tuple weights_of(const RationalPatch& patch) {
  return rows_of(patch, [&](int i, int j) { return fraction_of(patch.weight(i, j)); });
}

bool has_weights(const RationalPatch& patch) {
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j)
      if (patch.weight(i, j) != 1) return true;
  return false;
}

py::tuple points_of(const BezierCurve& curve) {
  py::tuple points(curve.points().size());
  for (std::size_t i = 0; i < curve.points().size(); ++i) points[i] = fractions_of(curve.points()[i]);
  return points;
}

/// "(0, 1/2, 0.123457)": what is long as an exact number is rounded to six digits.
std::string short_point(const std::vector<Rational>& point) {
  std::string text = "(";
  for (std::size_t i = 0; i < point.size(); ++i) {
    const std::string exact = to_string(point[i]);
    text += (i == 0 ? "" : ", ");
    text += exact.size() <= 8 ? exact : fmt::format("{:.6g}", to_double(point[i]));
  }
  return text + ")";
}

std::string short_patch(const RationalPatch& patch) {
  const int m = patch.degree_u(), n = patch.degree_v();
  const auto corner = [&](int i, int j) {
    const Point p = patch.point(i, j);
    return short_point({p[0], p[1], p[2]});
  };
  std::string kind = m == 2 && n == 2 ? "" : fmt::format("of bidegree ({}, {}) ", m, n);
  if (has_weights(patch)) kind += "with weights, ";
  return "<Patch " + kind + "with corners " + corner(0, 0) + ", " + corner(0, n) + ", " + corner(m, 0) +
         ", " + corner(m, n) + ">";
}

std::string short_curve(const BezierCurve& curve) {
  return fmt::format("<{} curve of degree {} from {} to {}>", curve.dimension() == 2 ? "Planar" : "Space",
                     curve.degree(), short_point(curve.points().front()), short_point(curve.points().back()));
}

void add_patch(py::module_& module) {
  py::class_<RationalPatch>(module, "Patch",
                            R"(A Bezier patch with exact control points, with or without weights.

Patch(points, weights=None) takes m+1 rows of n+1 points [x, y, z], m and n in {1, 2, 3}; the row belongs to the
first parameter (u or r), the column to the second (v or s). Coordinates are int, fractions.Fraction,
decimal.Decimal, or strings: "3/7", "0.1" (exactly 1/10), "0x1.8p-3". Floats are refused: see from_floats.
Weights are m+1 rows of n+1 numbers; points are not multiplied by them. Without weights lower degrees than 2
are raised exactly, if none is above. ValueError for other shapes, and for weights with which the denominator
is not positive on the whole square.)")
      .def(py::init([](const py::object& points, const py::object& weights) {
             return patch_of(points, weights, Numbers::exact);
           }),
           py::arg("points"), py::arg("weights") = py::none())
      .def_static(
          "from_floats",
          [](const py::object& points, const py::object& weights) {
            return patch_of(points, weights, Numbers::floats);
          },
          py::arg("points"), py::arg("weights") = py::none(),
          "The patch whose coordinates and weights are the binary64 numbers that the floats are, exactly: "
          "0.1 is\n"
          "3602879701896397/2**55. Lists, or arrays of numpy.")
      .def_property_readonly("points", &net_of, "The rows of control points, tuples of Fraction.")
      .def_property_readonly("weights", &weights_of,
                             "The rows of weights, tuples of Fraction; 1 without weights.")
      .def_property_readonly(
          "degree",
          [](const RationalPatch& patch) { return py::make_tuple(patch.degree_u(), patch.degree_v()); },
          "The degrees of the net in the first and in the second parameter.")
      .def(
          "__call__",
          [](const RationalPatch& patch, const py::object& first, const py::object& second) {
            const Rational u = rational_of(first, Numbers::exact, "first parameter");
            const Rational v = rational_of(second, Numbers::exact, "second parameter");
            if (patch.homogeneous_at(u, v)[3] == 0)
              throw std::invalid_argument("the denominator vanishes at these parameters");
            const Point p = patch(u, v);
            return fractions_of({p[0], p[1], p[2]});
          },
          py::arg("first"), py::arg("second"), "The point at exact parameters, in the square or not.")
      .def(
          "__eq__", [](const RationalPatch& a, const RationalPatch& b) { return a == b; }, py::is_operator())
      .def("__repr__", &short_patch)
      .def(py::pickle(
          [](const RationalPatch& patch) {
            return py::make_tuple(net_of(patch),
                                  has_weights(patch) ? py::object(weights_of(patch)) : py::none());
          },
          [](const py::tuple& state) {
            // Before there were weights, the state was the 3 rows of points.
            if (state.size() == 3) return patch_of(state, py::none(), Numbers::exact);
            return patch_of(state[0], state[1], Numbers::exact);
          }));
}

void add_curve(py::module_& module) {
  py::class_<BezierCurve>(module, "Curve", R"(A rational Bezier curve of the plane or of space.

Curve(points, weights=None) takes n+1 points of 2 or 3 exact coordinates, as Patch does, and n+1 weights > 0;
without weights all are 1.)")
      .def(py::init([](const py::object& points, const py::object& weights) {
             return curve_of(points, weights, Numbers::exact);
           }),
           py::arg("points"), py::arg("weights") = py::none())
      .def_static(
          "from_floats",
          [](const py::object& points, const py::object& weights) {
            return curve_of(points, weights, Numbers::floats);
          },
          py::arg("points"), py::arg("weights") = py::none(),
          "The curve whose coordinates and weights are the binary64 numbers that the floats are, exactly.")
      .def_property_readonly("points", &points_of, "The control points, tuples of Fraction.")
      .def_property_readonly(
          "weights", [](const BezierCurve& curve) { return fractions_of(curve.weights()); },
          "The weights, a tuple of Fraction.")
      .def_property_readonly("degree", &BezierCurve::degree)
      .def_property_readonly("dimension", &BezierCurve::dimension, "2 or 3.")
      .def(
          "__call__",
          [](const BezierCurve& curve, const py::object& t) {
            return fractions_of(curve(rational_of(t, Numbers::exact, "t")));
          },
          py::arg("t"), "The point at an exact parameter.")
      .def(
          "__eq__", [](const BezierCurve& a, const BezierCurve& b) { return a == b; }, py::is_operator())
      .def("__repr__", &short_curve)
      .def(py::pickle(
          [](const BezierCurve& curve) {
            return py::make_tuple(points_of(curve), fractions_of(curve.weights()));
          },
          [](const py::tuple& state) { return curve_of(state[0], state[1], Numbers::exact); }));
}

void add_files(py::module_& module) {
  module.def("read_patches", [](const std::string& path) {
    const RationalPatchFile file = read_rational_patches(path);
    py::dict patches;
    for (const NamedRationalPatch& named : file.patches) {
      const bool raised =
          std::max(named.patch.degree_u(), named.patch.degree_v()) <= 2 && !has_weights(named.patch);
      patches[py::str(named.name)] = raised ? named.patch.elevated(2, 2) : named.patch;
    }
    return patches;
  });
  module.def("write_patches", [](const std::string& path, const py::dict& patches, const std::string& title) {
    RationalPatchFile file{title, "", {}};
    for (const auto& [name, patch] : patches)
      file.patches.push_back({name.cast<std::string>(), patch.cast<RationalPatch>()});
    write_patches(file, path);
  });
  module.def("read_curve", [](const std::string& path) { return read_curve(path).curve; });
}

/// The options of the program as arguments of functions: "--max-seconds" is max_seconds.
std::string in_python(const std::string& message) {
  std::string text;
  for (std::size_t i = 0; i < message.size(); ++i) {
    const bool begins_option = message.compare(i, 2, "--") == 0 && i + 2 < message.size() &&
                               std::isalpha(static_cast<unsigned char>(message[i + 2])) != 0;
    if (!begins_option) {
      text += message[i];
      continue;
    }
    for (i += 2; i < message.size(); ++i) {
      const auto c = static_cast<unsigned char>(message[i]);
      if (std::isalnum(c) == 0 && c != '-') break;
      text += c == '-' ? '_' : message[i];
    }
    --i;
  }
  return text;
}

void add_exceptions(py::module_& module) {
  static py::exception<cli::NoCertificate> no_certificate(module, "NoCertificate", PyExc_ValueError);
  no_certificate.attr("__doc__") = "A result that no certificate can say, and why.";
  static py::exception<InputError> input_error(module, "InputError", PyExc_ValueError);
  input_error.attr("__doc__") = "A bad file: what is wrong, in which file, and where in it.";
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const InputError& error) {
      input_error(error.what());
    } catch (const cli::UsageError& error) {
      PyErr_SetString(PyExc_ValueError, in_python(error.what()).c_str());
    } catch (const cli::NoCertificate& error) {
      no_certificate(error.what());
    } catch (const OutputError& error) {
      PyErr_SetString(PyExc_OSError, error.what());
    }
  });
}

}  // namespace
}  // namespace exsect::python

PYBIND11_MODULE(_core, module) {
  using namespace exsect::python;
  module.attr("__version__") = EXSECT_VERSION;
  add_exceptions(module);
  add_patch(module);
  add_curve(module);
  add_files(module);
  add_intersections(module);
  add_surfaces(module);
  add_implicitizations(module);
  add_verifications(module);
}
