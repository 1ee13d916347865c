#include "json_value.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "number.h"
#include "text_file.h"

namespace exsect {

using Kind = JsonTree::Kind;

void JsonValue::fail(const std::string& reason) const { throw InputError(file_, path_, reason); }

const std::string& JsonValue::string() const {
  if (tree_.kind != Kind::string) fail("must be a string");
  return tree_.text;
}

const std::string& JsonValue::number_text() const {
  if (tree_.kind != Kind::string && tree_.kind != Kind::number) fail("must be a number, quoted or not");
  return tree_.text;
}

std::string_view JsonValue::bare_number() const {
  return tree_.kind == Kind::number ? std::string_view(tree_.text) : std::string_view();
}

bool JsonValue::boolean() const {
  if (tree_.kind != Kind::boolean) fail("must be true or false");
  return tree_.text == "true";
}

int JsonValue::small_integer(int least, int most, const char* what) const {
  for (int n = least; n <= most; ++n)
    if (is_bare(std::to_string(n))) return n;
  fail(std::string(what) + " must be an integer from " + std::to_string(least) + " to " +
       std::to_string(most));
}

std::size_t JsonValue::size() const {
  if (tree_.kind != Kind::array) fail("must be an array");
  return tree_.elements.size();
}

void JsonValue::require_size(std::size_t n, const char* what) const {
  if (size() != n)
    fail("must be an array of " + std::to_string(n) + " " + what + ", has " +
         std::to_string(tree_.elements.size()));
}

JsonValue JsonValue::at(std::size_t i) const {
  return {tree_.elements[i], file_, path_ + "[" + std::to_string(i) + "]"};
}

JsonValue JsonValue::member(const char* key) const {
  const auto it = find(key);
  if (it == tree_.keys.end()) fail("key \"" + std::string(key) + "\" is missing");
  const auto i = static_cast<std::size_t>(it - tree_.keys.begin());
  return {tree_.elements[i], file_, path_ + "." + key};
}

void JsonValue::require_object(std::initializer_list<std::string_view> known) const {
  if (tree_.kind != Kind::object) fail("must be an object");
  for (const std::string& key : tree_.keys)
    if (std::find(known.begin(), known.end(), key) == known.end())
      fail("unknown key \"" + printable(key) + "\"");
}

void JsonValue::require_form(const char* form) const {
  if (tree_.kind != Kind::object) fail("must be an object");
  const JsonValue stated = member("exsect");
  if (stated.string() != form) stated.fail(wrong_form(stated.string(), form));
}

std::vector<std::string>::const_iterator JsonValue::find(std::string_view key) const {
  return std::find(tree_.keys.begin(), tree_.keys.end(), key);
}

NumberReader number_reader(const JsonValue& root) {
  if (!root.has("numbers")) return parse_number;
  const JsonValue numbers = root.member("numbers");
  if (numbers.string() == "decimal") return parse_number;
  if (numbers.string() == "binary64") return parse_binary64;
  numbers.fail("must be \"decimal\" or \"binary64\"");
}

Rational read_number(const JsonValue& value, NumberReader read) {
  try {
    return read(value.number_text());
  } catch (const std::invalid_argument& error) {
    value.fail(error.what());
  }
}

std::string json_string(const std::string& text) {
  try {
    return nlohmann::json(text).dump();
  } catch (const nlohmann::json::type_error&) {
    throw std::invalid_argument("title, source and names must be UTF-8");
  }
}

std::string format_json_number(const Rational& q) {
  std::string text = to_string(q);
  parse_number(text);  // throws beyond the sizes a reader accepts
  return "\"" + text + "\"";
}

}  // namespace exsect
