#include "numbers.h"

#include <exsect/geometry/number.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace exsect::python {
namespace {

namespace py = pybind11;

Integer integer_of(py::handle number) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(number.ptr()));
  if (!index) throw py::error_already_set();
  const auto text = py::reinterpret_steal<py::str>(PyNumber_ToBase(index.ptr(), 16));
  if (!text) throw py::error_already_set();
  const std::string digits = text;  // "0x1f", "-0x1f"
  return digits.starts_with('-') ? Integer(-Integer(digits.substr(1))) : Integer(digits);
}

py::object python_integer(const Integer& value) {
  const std::string digits = Integer(abs(value)).str(0, std::ios_base::hex);
  auto result = py::reinterpret_steal<py::object>(PyLong_FromString(digits.c_str(), nullptr, 16));
  if (!result) throw py::error_already_set();
  return value < 0 ? -result : result;
}

Rational ratio(py::handle numerator, py::handle denominator, const std::string& where) {
  const Integer below = integer_of(denominator);
  if (below == 0) throw std::invalid_argument(where + ": zero denominator");
  return Rational(integer_of(numerator), below);
}

[[noreturn]] void refuse(py::handle number, const std::string& where, const std::string& why) {
  throw py::type_error(where + ": " + std::string(py::repr(number)).substr(0, 60) + " " + why);
}

Rational exact_number(py::handle number, const std::string& where) {
  if (PyBool_Check(number.ptr())) refuse(number, where, "is no number");
  if (PyFloat_Check(number.ptr()))
    refuse(number, where, "is a float: write it as a string or a Fraction, or use from_floats");
  if (py::isinstance<py::str>(number)) {
    try {
      return parse_number(std::string(py::reinterpret_borrow<py::str>(number)));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(where + ": " + error.what());
    }
  }
  if (PyIndex_Check(number.ptr())) return Rational(integer_of(number));
  if (py::hasattr(number, "numerator") && py::hasattr(number, "denominator"))
    return ratio(number.attr("numerator"), number.attr("denominator"), where);
  if (py::isinstance(number, py::module_::import("decimal").attr("Decimal"))) {
    if (!number.attr("is_finite")().cast<bool>()) throw std::invalid_argument(where + ": is not finite");
    const py::tuple parts = number.attr("as_integer_ratio")();
    return ratio(parts[0], parts[1], where);
  }
  refuse(number, where, "is no exact number");
}

Rational float_number(py::handle number, const std::string& where) {
  if (py::isinstance<py::str>(number)) refuse(number, where, "is no float");
  const double value = PyFloat_AsDouble(number.ptr());
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    refuse(number, where, "is no float");
  }
  try {
    return from_double(value);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(where + ": " + error.what());
  }
}

std::string at(const std::string& where, std::size_t index) {
  return where + "[" + std::to_string(index) + "]";
}

/// The elements of a list, a tuple or another sequence that is no text.
std::vector<py::object> elements(const py::object& list, const std::string& where) {
  if (py::isinstance<py::str>(list) || PySequence_Check(list.ptr()) == 0) refuse(list, where, "is no list");
  std::vector<py::object> result;
  for (const py::handle element : list) result.push_back(py::reinterpret_borrow<py::object>(element));
  return result;
}

std::vector<Rational> numbers_of(const py::object& list, Numbers numbers, const std::string& where) {
  std::vector<Rational> result;
  for (const py::object& number : elements(list, where))
    result.push_back(rational_of(number, numbers, at(where, result.size())));
  return result;
}

/// A text of a result that is a number, "-12/7", as json_number writes it.
bool is_rational(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto digits = [](std::string_view part) {
    return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const std::string_view whole = text;
  const std::string_view numerator = whole.substr(text.starts_with('-') ? 1 : 0);
  if (slash == std::string::npos) return digits(numerator);
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  return digits(whole.substr(sign, slash - sign)) && digits(whole.substr(slash + 1));
}

/// Keys whose values are names or sentences, whatever they look like.
bool holds_text(const std::string& key) {
  constexpr std::array<std::string_view, 7> texts = {"first", "second", "patch",    "name",
                                                     "why",   "text",   "statement"};
  return std::find(texts.begin(), texts.end(), key) != texts.end();
}

}  // namespace

Rational rational_of(py::handle number, Numbers numbers, const std::string& where) {
  return numbers == Numbers::exact ? exact_number(number, where) : float_number(number, where);
}

py::object fraction_of(const Rational& value) {
  return py::module_::import("fractions")
      .attr("Fraction")(python_integer(numerator(value)), python_integer(denominator(value)));
}

py::tuple fractions_of(const std::vector<Rational>& values) {
  py::tuple result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) result[i] = fraction_of(values[i]);
  return result;
}

RationalPatch patch_of(const py::object& points, const py::object& weights, Numbers numbers) {
  std::vector<std::vector<Point>> net;
  for (const py::object& row : elements(points, "points")) {
    const std::string where = at("points", net.size());
    net.emplace_back();
    for (const py::object& point : elements(row, where)) {
      const std::string place = at(where, net.back().size());
      const std::vector<Rational> coordinates = numbers_of(point, numbers, place);
      if (coordinates.size() != 3) throw std::invalid_argument(place + ": needs 3 coordinates");
      net.back().push_back({coordinates[0], coordinates[1], coordinates[2]});
    }
  }
  if (!weights.is_none()) {
    std::vector<std::vector<Rational>> rows;
    for (const py::object& row : elements(weights, "weights"))
      rows.push_back(numbers_of(row, numbers, at("weights", rows.size())));
    if (rows.empty()) throw std::invalid_argument("weights: must be as many rows as there are of points");
    return RationalPatch(net, rows);
  }
  const RationalPatch patch(net);
  return std::max(patch.degree_u(), patch.degree_v()) > 2 ? patch : patch.elevated(2, 2);
}

BezierPatch biquadratic_of(const RationalPatch& patch, const std::string& name) {
  const std::optional<BezierPatch> result = patch.biquadratic();
  if (!result)
    throw std::invalid_argument("patch \"" + name + "\": not supported here: " + kind_of(patch) +
                                ", only polynomial patches of bidegree up to (2,2)");
  return *result;
}

BezierCurve curve_of(const py::object& points, const py::object& weights, Numbers numbers) {
  std::vector<std::vector<Rational>> control;
  for (const py::object& point : elements(points, "points"))
    control.push_back(numbers_of(point, numbers, at("points", control.size())));
  if (weights.is_none()) return BezierCurve(control);
  return BezierCurve(control, numbers_of(weights, numbers, "weights"));
}

py::object python_of(const cli::Json& json) {
  switch (json.type()) {
    case cli::Json::value_t::object: {
      py::dict result;
      for (const auto& [key, value] : json.items())
        result[py::str(key)] =
            value.is_string() && holds_text(key) ? py::str(value.get<std::string>()) : python_of(value);
      return result;
    }
    case cli::Json::value_t::array: {
      py::list result;
      for (const cli::Json& value : json) result.append(python_of(value));
      return result;
    }
    case cli::Json::value_t::string: {
      const std::string text = json.get<std::string>();
      if (is_rational(text)) return fraction_of(Rational(text));
      return py::str(text);
    }
    case cli::Json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case cli::Json::value_t::number_float:
      return py::float_(json.get<double>());
    case cli::Json::value_t::number_integer:
    case cli::Json::value_t::number_unsigned:
      return py::int_(json.get<long long>());
    default:
      return py::none();
  }
}

}  // namespace exsect::python
