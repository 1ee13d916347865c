// Reading a JSON tree strictly, writing numbers and strings. Internal to geometry/.
#pragma once

#include <exsect/algebra/rational.h>

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "file_form.h"
#include "json_tree.h"

namespace exsect {

/// One value of a file together with its JSON path. Every refusal is an InputError with file, path and
/// reason. Tree and file name must outlive it.
class JsonValue {
 public:
  JsonValue(const JsonTree& tree, const std::string& file, std::string path)
      : tree_(tree), file_(file), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& reason) const;

  const std::string& string() const;
  /// The text of a number, quoted or bare.
  const std::string& number_text() const;
  bool is_bare(std::string_view number) const { return bare_number() == number; }
  /// The text of a number that is not quoted; empty for any other value.
  std::string_view bare_number() const;
  bool is_array() const { return tree_.kind == JsonTree::Kind::array; }
  /// true or false.
  bool boolean() const;
  /// A bare integer in [least, most], written without sign, point or exponent.
  int small_integer(int least, int most, const char* what) const;

  std::size_t size() const;
  void require_size(std::size_t n, const char* what) const;
  JsonValue at(std::size_t i) const;

  bool has(std::string_view key) const { return find(key) != tree_.keys.end(); }
  JsonValue member(const char* key) const;
  void require_object(std::initializer_list<std::string_view> known) const;
  /// Refuses anything but an object whose key "exsect" is `form`; the refusal says what another file holds.
  void require_form(const char* form) const;

 private:
  std::vector<std::string>::const_iterator find(std::string_view key) const;

  const JsonTree& tree_;
  const std::string& file_;
  std::string path_;
};

using NumberReader = Rational (*)(std::string_view);

/// What decimals mean in this file: parse_number, or parse_binary64 if "numbers" is "binary64".
NumberReader number_reader(const JsonValue& root);
Rational read_number(const JsonValue& value, NumberReader read);

/// The text as a JSON string; throws std::invalid_argument unless it is UTF-8.
std::string json_string(const std::string& text);
/// The canonical text of q in quotes; throws std::invalid_argument beyond the sizes a reader accepts.
std::string format_json_number(const Rational& q);

}  // namespace exsect
