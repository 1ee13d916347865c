#include "output/options/implicitize_options.h"

#include <exsect/geometry/number.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "output/options/option_values.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

constexpr std::array planar_methods = {PlanarMethod::exact,     PlanarMethod::least_squares,
                                       PlanarMethod::bernstein, PlanarMethod::legendre,
                                       PlanarMethod::chebyshev, PlanarMethod::lagrange};
constexpr std::array space_methods = {SpaceMethod::cylinders, SpaceMethod::orthogonal,
                                      SpaceMethod::root_free};
constexpr std::array spaces = {SpaceKind::monomial, SpaceKind::bernstein, SpaceKind::b_spline};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text + ",");
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

template <class Values>
std::vector<std::string> names_of(const Values& values) {
  std::vector<std::string> names;
  for (const auto value : values) names.emplace_back(name(value));
  return names;
}

PlanarMethod planar_method(const ImplicitizeCommand& command) {
  if (command.method.empty())
    return command.degree.empty() ? PlanarMethod::exact : PlanarMethod::least_squares;
  return planar_methods[choice("--method", command.method, names_of(planar_methods))];
}

std::optional<FitWeights> fit_weights(const ImplicitizeCommand& command, SpaceKind space) {
  if (command.w1.empty() && command.w2.empty()) return std::nullopt;
  FitWeights weights = {1, space == SpaceKind::b_spline ? Rational(1, 1000) : Rational(0)};
  if (!command.w1.empty()) weights.w1 = number_value("--w1", command.w1);
  if (!command.w2.empty()) weights.w2 = number_value("--w2", command.w2);
  if (weights.w1 <= 0) throw UsageError("--w1: " + shortened(command.w1) + " is not > 0");
  if (weights.w2 < 0) throw UsageError("--w2: " + shortened(command.w2) + " is not >= 0");
  return weights;
}

void refuse_space_options(const ImplicitizeCommand& command) {
  const char* why = "only for curves of space";
  refuse_option("--axis", command.axis, why);
  refuse_option("--factor-degree", command.factor_degree, why);
  refuse_option("--epsilon", command.epsilon, why);
}

void refuse_fit_options(const ImplicitizeCommand& command, const std::string& why) {
  refuse_option("--space", command.space, why);
  refuse_option("--cells", command.cells, why);
  refuse_option("--samples", command.samples, why);
  refuse_option("--w1", command.w1, why);
  refuse_option("--w2", command.w2, why);
}

}  // namespace

void refuse_option(const std::string& option, const std::string& text, const std::string& why) {
  if (!text.empty()) throw UsageError(option + ": " + why);
}

std::size_t choice(const std::string& option, const std::string& text,
                   const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end())
    throw UsageError(option + ": \"" + shortened(text) + "\" is not one of " + joined(names, ", "));
  return static_cast<std::size_t>(found - names.begin());
}

Rational number_value(const std::string& option, const std::string& text) {
  try {
    return parse_number(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + ": " + printable(error.what()));
  }
}

int integer_value(const std::string& option, const std::string& text, int least, int most) {
  const bool digits = !text.empty() && text.size() <= 6 &&
                      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  const int value = digits ? std::stoi(text) : least - 1;
  if (value < least || value > most)
    throw UsageError(option + ": \"" + shortened(text) + "\" is not an integer from " +
                     std::to_string(least) + " to " + std::to_string(most));
  return value;
}

std::vector<Rational> number_list(const std::string& option, const std::string& text, std::size_t count) {
  const std::vector<std::string> parts = split(text);
  if (parts.size() != count)
    throw UsageError(option + ": needs " + std::to_string(count) + " numbers with commas between them");
  std::vector<Rational> numbers;
  for (const std::string& part : parts) numbers.push_back(number_value(option, part));
  return numbers;
}

std::vector<RationalInterval> box_sides(const std::string& option, const std::string& text,
                                        std::size_t sides) {
  const std::vector<Rational> ends = number_list(option, text, 2 * sides);
  std::vector<RationalInterval> result;
  for (std::size_t i = 0; i < sides; ++i) {
    result.push_back({ends[2 * i], ends[2 * i + 1]});
    if (result.back().lower >= result.back().upper)
      throw UsageError(option + ": every lower end must be less than its upper end");
  }
  return result;
}

std::vector<std::string> variable_names(const ImplicitizeCommand& command,
                                        const std::vector<std::string>& standard) {
  if (command.variables.empty()) return standard;
  const std::vector<std::string> names = split(command.variables);
  const auto is_name = [](const std::string& text) {
    return !text.empty() && text.size() <= 20 && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
           std::all_of(text.begin(), text.end(),
                       [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; });
  };
  if (names.size() != standard.size() || !std::all_of(names.begin(), names.end(), is_name) ||
      std::count(names.begin(), names.end(), names[0]) != 1)
    throw UsageError("--variables: needs " + std::to_string(standard.size()) +
                     " different names of letters and digits with commas between them");
  return names;
}

PlanarOptions planar_options(const ImplicitizeCommand& command) {
  PlanarOptions options;
  refuse_option("--patch", command.patch, "only for patch files");
  refuse_space_options(command);
  options.method = planar_method(command);
  if (options.method == PlanarMethod::exact) {
    const std::string why = "not an option of the method exact, which finds the degree itself";
    refuse_option("--degree", command.degree, why);
    refuse_fit_options(command, why);
    refuse_option("--digits", command.digits, why);
  } else if (command.degree.empty()) {
    throw UsageError("--degree: needed for the method " + std::string(name(options.method)));
  } else {
    options.degree = integer_value("--degree", command.degree, 1, 12);
  }
  if (!command.space.empty()) options.space = spaces[choice("--space", command.space, names_of(spaces))];
  const bool spline = options.space == SpaceKind::b_spline;
  if (options.method != PlanarMethod::least_squares) {
    const std::string why = "only for the method least-squares";
    if (spline) throw UsageError("--space: b-spline " + why);
    refuse_option("--samples", command.samples, why);
    refuse_option("--w1", command.w1, why);
    refuse_option("--w2", command.w2, why);
  }
  if (spline && options.degree < 2) throw UsageError("--degree: B-splines need degree 2 or more");
  if (!spline) refuse_option("--cells", command.cells, "only for the space b-spline");
  if (!command.cells.empty()) options.cells = integer_value("--cells", command.cells, 1, 64);
  if (spline) options.samples = std::max(options.samples, 6 * options.cells);
  if (!command.samples.empty()) options.samples = integer_value("--samples", command.samples, 2, 10000);
  options.weights = fit_weights(command, options.space);
  if (!command.digits.empty()) options.digits = integer_value("--digits", command.digits, 1, 100);
  if (!command.box.empty()) {
    const std::vector<RationalInterval> sides = box_sides("--box", command.box, 2);
    options.box = PlanarBox{sides[0], sides[1]};
  }
  options.arithmetic = command.exact_arithmetic ? Arithmetic::exact : Arithmetic::floating;
  return options;
}

SpaceOptions space_options(const ImplicitizeCommand& command) {
  SpaceOptions options;
  refuse_option("--patch", command.patch, "only for patch files");
  refuse_option("--variables", command.variables, "only for planar curves");
  if (!command.method.empty())
    options.method = space_methods[choice("--method", command.method, names_of(space_methods))];
  if (!command.axis.empty()) options.axis = static_cast<int>(choice("--axis", command.axis, {"x", "y", "z"}));
  if (!command.box.empty()) {
    const std::vector<RationalInterval> sides = box_sides("--box", command.box, 3);
    options.box = SpaceBox{sides[0], sides[1], sides[2]};
  }
  const bool has_factors = options.method == SpaceMethod::orthogonal;
  if (!has_factors) {
    refuse_option("--factor-degree", command.factor_degree, "only for the method orthogonal");
    refuse_option("--epsilon", command.epsilon, "only for the method orthogonal");
  }
  if (!command.factor_degree.empty())
    options.factor_degree = integer_value("--factor-degree", command.factor_degree, 0, 8);
  if (!command.epsilon.empty()) options.epsilon = number_value("--epsilon", command.epsilon);
  if (options.epsilon <= 0) throw UsageError("--epsilon: " + shortened(command.epsilon) + " is not > 0");
  // The projections are planar curves with options of their own.
  ImplicitizeCommand projections = command;
  projections.method.clear();
  projections.axis.clear();
  projections.factor_degree.clear();
  projections.epsilon.clear();
  projections.box.clear();
  options.planar = planar_options(projections);
  if (options.planar->space == SpaceKind::b_spline)
    throw UsageError("--space: b-spline is only for planar curves");
  return options;
}

PatchOptions patch_options(const ImplicitizeCommand& command) {
  const std::string why = "only for curves";
  refuse_space_options(command);
  refuse_fit_options(command, why);
  refuse_option("--digits", command.digits, why);
  refuse_option("--box", command.box, why);
  refuse_option("--variables", command.variables, why);
  PatchOptions options;
  const std::vector<std::string> methods = {"exact", name(PatchFit::dokken), name(PatchFit::conics)};
  const std::size_t method =
      command.method.empty() ? (command.degree.empty() ? 0 : 1) : choice("--method", command.method, methods);
  if (method == 0)
    refuse_option("--degree", command.degree,
                  "not an option of the method exact, which finds the degree itself");
  else
    options.fit = method == 1 ? PatchFit::dokken : PatchFit::conics;
  if (!command.degree.empty())
    options.degree = integer_value("--degree", command.degree, 1, options.fit == PatchFit::conics ? 5 : 7);
  return options;
}

}  // namespace exsect::cli
