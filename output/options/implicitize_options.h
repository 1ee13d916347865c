// The options of exsect implicitize as values.
#pragma once

#include <exsect/implicit/implicitize_space_curve.h>

#include <optional>
#include <string>
#include <vector>

#include "output/options/output_files.h"
#include "output/text/patch_implicit_output.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct ImplicitizeCommand {
  std::string file;
  std::string patch;
  std::string method;
  std::string degree;
  std::string space;
  std::string cells;
  std::string samples;
  std::string w1;
  std::string w2;
  std::string digits;
  std::string box;
  std::string variables;
  std::string axis;
  std::string factor_degree;
  std::string epsilon;
  bool exact_arithmetic = false;
  OutputFiles output;
  bool quiet = false;
};

/// Options of a planar curve: without --method, exact, or least squares if --degree is given. Throws
/// UsageError for unknown names, values out of range, and options that the method does not have.
PlanarOptions planar_options(const ImplicitizeCommand& command);

/// Options of a curve of space: without --method, cylinders. Throws UsageError as above.
SpaceOptions space_options(const ImplicitizeCommand& command);

/// Options of a patch: without --method, exact, or Dokken's if --degree is given. Throws UsageError as above.
PatchOptions patch_options(const ImplicitizeCommand& command);

/// The names after --variables, as many as `standard`, which is the answer without the option. Throws
/// UsageError unless they are different identifiers.
std::vector<std::string> variable_names(const ImplicitizeCommand& command,
                                        const std::vector<std::string>& standard);

/// "a,b,c" as numbers. Throws UsageError unless there are `count`.
std::vector<Rational> number_list(const std::string& option, const std::string& text, std::size_t count);
/// A decimal integer in [least, most]. Throws UsageError.
int integer_value(const std::string& option, const std::string& text, int least, int most);
/// A number in the syntax of patch files. Throws UsageError.
Rational number_value(const std::string& option, const std::string& text);
/// Throws UsageError naming the option if the text is not empty.
void refuse_option(const std::string& option, const std::string& text, const std::string& why);
/// The index of the text among the names. Throws UsageError with all names.
std::size_t choice(const std::string& option, const std::string& text, const std::vector<std::string>& names);
/// "lower,upper" per side from consecutive numbers. Throws UsageError unless lower < upper.
std::vector<RationalInterval> box_sides(const std::string& option, const std::string& text,
                                        std::size_t sides);

}  // namespace exsect::cli
