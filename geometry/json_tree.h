// JSON as a tree that keeps the text of every number. Internal to geometry/.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace exsect {

/// One JSON value. Numbers and strings are both text; nothing is rounded.
struct JsonTree {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  std::string text;                // number, string, true or false
  std::vector<JsonTree> elements;  // array; values of an object
  std::vector<std::string> keys;   // object: keys[i] belongs to elements[i], all distinct
};

/// Enough for every file that exsect reads.
inline constexpr std::size_t max_depth_of_files = 16;

/// Throws InputError with the JSON path for anything that is not one JSON value: syntax errors with line and
/// column, invalid UTF-8, truncated text, anything but blanks after the value, an object key given twice,
/// arrays and objects nested deeper than max_depth, a number beyond the range of long double without quotes.
JsonTree parse_json(const std::string& text, const std::string& file, std::size_t max_depth);

/// What a message may repeat of bad input: the first 300 characters, anything but printable ASCII replaced by
/// "?".
std::string printable(std::string_view text);

}  // namespace exsect
