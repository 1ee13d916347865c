#include "curve_file.h"

#include <algorithm>

#include "json_value.h"

namespace exsect {
namespace {

constexpr const char* curve_version = "curve/1";

std::vector<Rational> read_numbers(const JsonValue& values, NumberReader read) {
  std::vector<Rational> numbers;
  for (std::size_t i = 0; i < values.size(); ++i) numbers.push_back(read_number(values.at(i), read));
  return numbers;
}

std::vector<std::vector<Rational>> read_points(const JsonValue& values, std::size_t count,
                                               NumberReader read) {
  values.require_size(count, "points for this degree");
  const std::size_t dimension = values.at(0).size();
  if (dimension != 2 && dimension != 3) values.at(0).fail("must have 2 or 3 coordinates");
  std::vector<std::vector<Rational>> points;
  for (std::size_t i = 0; i < count; ++i) {
    values.at(i).require_size(dimension, "coordinates");
    points.push_back(read_numbers(values.at(i), read));
  }
  return points;
}

std::vector<Rational> read_weights(const JsonValue& values, std::size_t count, NumberReader read) {
  values.require_size(count, "weights for this degree");
  std::vector<Rational> weights = read_numbers(values, read);
  for (std::size_t i = 0; i < count; ++i)
    if (weights[i] <= 0) values.at(i).fail("a weight must be > 0");
  return weights;
}

std::string format_numbers(const std::vector<Rational>& numbers) {
  std::string text = "[";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += (i == 0 ? "" : ", ") + format_json_number(numbers[i]);
  return text + "]";
}

}  // namespace

CurveFile parse_curve(const std::string& text, const std::string& filename) {
  if (text.size() > max_curve_file_bytes)
    throw InputError(filename, "", "longer than " + std::to_string(max_curve_file_bytes) + " bytes");
  const JsonTree tree = parse_json(text, filename, max_depth_of_files);
  const JsonValue root(tree, filename, "$");
  root.require_form(curve_version);
  root.require_object({"exsect", "title", "source", "numbers", "degree", "points", "weights"});
  const NumberReader read = number_reader(root);
  const int degree = root.member("degree").small_integer(1, max_curve_degree, "the degree of a curve");
  const std::size_t count = static_cast<std::size_t>(degree) + 1;
  std::vector<Rational> weights;
  if (root.has("weights")) weights = read_weights(root.member("weights"), count, read);
  return {root.has("title") ? root.member("title").string() : "",
          root.has("source") ? root.member("source").string() : "",
          BezierCurve(read_points(root.member("points"), count, read), std::move(weights))};
}

CurveFile read_curve(const std::string& path) {
  return parse_curve(read_text_file(path, max_curve_file_bytes), path);
}

std::string format_curve(const CurveFile& file) {
  if (file.curve.degree() > max_curve_degree)
    throw std::invalid_argument("curve file: the degree is above " + std::to_string(max_curve_degree));
  std::string text = "{\n \"exsect\": " + json_string(curve_version);
  if (!file.title.empty()) text += ",\n \"title\": " + json_string(file.title);
  if (!file.source.empty()) text += ",\n \"source\": " + json_string(file.source);
  text += ",\n \"degree\": " + std::to_string(file.curve.degree()) + ",\n \"points\": [";
  const char* before_point = "\n  ";
  for (const std::vector<Rational>& point : file.curve.points()) {
    text += before_point + format_numbers(point);
    before_point = ",\n  ";
  }
  text += "\n ]";
  const std::vector<Rational>& weights = file.curve.weights();
  if (std::any_of(weights.begin(), weights.end(), [](const Rational& w) { return w != 1; }))
    text += ",\n \"weights\": " + format_numbers(weights);
  return text + "\n}\n";
}

std::string file_version(const std::string& text, const std::string& filename) {
  const JsonTree tree = parse_json(text, filename, max_depth_of_files);
  if (tree.kind != JsonTree::Kind::object) return "";
  for (std::size_t i = 0; i < tree.keys.size(); ++i)
    if (tree.keys[i] == "exsect" && tree.elements[i].kind == JsonTree::Kind::string)
      return tree.elements[i].text;
  return "";
}

}  // namespace exsect
