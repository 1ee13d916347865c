#include "output/options/option_values.h"

#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "output/options/output_files.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

Rational number(const std::string& option, const std::string& text) {
  try {
    return parse_number(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + ": " + printable(error.what()));
  }
}

}  // namespace

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 40;
  return printable(text.size() <= longest ? text : text.substr(0, longest) + "...");
}

Rational parameter_value(const std::string& option, const std::string& text) {
  const Rational value = number(option, text);
  if (value < 0 || value > 1) throw UsageError(option + ": " + shortened(text) + " is not in [0,1]");
  return value;
}

double positive_value(const std::string& option, const std::string& text) {
  const Rational value = number(option, text);
  if (value <= 0) throw UsageError(option + ": " + shortened(text) + " is not positive");
  const double nearest = to_double(value);
  if (!std::isfinite(nearest)) throw UsageError(option + ": " + shortened(text) + " is too large");
  const double below = from_double(nearest) <= value ? nearest : std::nextafter(nearest, 0.0);
  if (below <= 0) throw UsageError(option + ": " + shortened(text) + " is too small");
  return below;
}

Point vector_value(const std::string& option, const std::string& text) {
  std::vector<Rational> numbers;
  std::istringstream stream(text + ",");
  for (std::string item; std::getline(stream, item, ',');) {
    if (numbers.size() < 3)
      numbers.push_back(number(option, item));
    else
      throw UsageError(option + ": " + shortened(text) + " has more than three coordinates");
  }
  if (numbers.size() != 3) throw UsageError(option + ": " + shortened(text) + " is not x,y,z");
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<Parameter> parameter_list(const std::string& option, const std::string& text,
                                      const ParameterNames& names) {
  std::vector<Parameter> list;
  if (text == "none") return list;
  const std::string why = option + ": \"" + shortened(text) + "\" is not a list of " +
                          joined({names.begin(), names.end()}, ", ") + ", each at most once";
  std::istringstream stream(text + ",");
  std::string item;
  while (std::getline(stream, item, ',')) {
    const auto parameter = std::find_if(all_parameters.begin(), all_parameters.end(),
                                        [&](Parameter p) { return item == name(p, names); });
    if (parameter == all_parameters.end()) throw UsageError(why);
    if (std::find(list.begin(), list.end(), *parameter) != list.end()) throw UsageError(why);
    list.push_back(*parameter);
  }
  return list;
}

}  // namespace exsect::cli
