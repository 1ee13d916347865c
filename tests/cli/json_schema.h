// A small validator for the part of JSON Schema (draft 7) that docs/schemas uses.
#pragma once

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

namespace exsect {

class JsonSchema {
 public:
  using Json = nlohmann::json;

  explicit JsonSchema(Json schema) : root_(std::move(schema)) {}
  /// docs/schemas/<name>.schema.json.
  static JsonSchema named(const std::string& name) {
    std::ifstream file(std::string(EXSECT_SCHEMAS) + "/" + name + ".schema.json");
    return JsonSchema(Json::parse(file));
  }

  /// The first violation as "path: reason", or an empty text. Throws std::logic_error for a keyword it does
  /// not know.
  std::string violation(const Json& value) const { return check(root_, value, "$"); }

 private:
  std::string check(const Json& schema, const Json& value, const std::string& path) const {
    for (const auto& [keyword, rule] : schema.items()) {
      const std::string found = apply(keyword, rule, schema, value, path);
      if (!found.empty()) return found;
    }
    return "";
  }

  std::string apply(const std::string& keyword, const Json& rule, const Json& schema, const Json& value,
                    const std::string& path) const {
    static const std::set<std::string> silent = {"$schema", "title", "definitions", "additionalProperties"};
    if (silent.contains(keyword))
      return keyword == "additionalProperties" ? properties(schema, value, path) : "";
    if (keyword == "$ref")
      return check(root_.at(Json::json_pointer(rule.get<std::string>().substr(1))), value, path);
    if (keyword == "anyOf") {
      const bool any = std::any_of(rule.begin(), rule.end(),
                                   [&](const Json& option) { return check(option, value, path).empty(); });
      return any ? "" : path + ": no alternative fits";
    }
    if (keyword == "properties") return properties(schema, value, path);
    if (keyword == "items") return items(rule, value, path);
    return holds(keyword, rule, value) ? "" : path + ": violates " + keyword + " " + rule.dump();
  }

  std::string properties(const Json& schema, const Json& value, const std::string& path) const {
    if (!value.is_object()) return "";
    const Json known = schema.value("properties", Json::object());
    const Json others = schema.value("additionalProperties", Json(true));
    for (const auto& [key, member] : value.items()) {
      const std::string at = path + "." + key;
      if (!known.contains(key) && others == false) return at + ": unknown key";
      const Json& rule = known.contains(key) ? known.at(key) : others;
      const std::string found = rule.is_object() ? check(rule, member, at) : "";
      if (!found.empty()) return found;
    }
    return "";
  }

  std::string items(const Json& rule, const Json& value, const std::string& path) const {
    if (!value.is_array()) return "";
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (rule.is_array() && i >= rule.size()) break;
      const std::string found =
          check(rule.is_array() ? rule[i] : rule, value[i], path + "[" + std::to_string(i) + "]");
      if (!found.empty()) return found;
    }
    return "";
  }

  static bool is_of_type(const std::string& type, const Json& value) {
    if (type == "integer") return value.is_number_integer();
    return type == (value.is_number() ? "number" : value.type_name());
  }

  static bool holds(const std::string& keyword, const Json& rule, const Json& value) {
    if (keyword == "type") {
      if (rule.is_string()) return is_of_type(rule, value);
      return std::any_of(rule.begin(), rule.end(), [&](const Json& type) { return is_of_type(type, value); });
    }
    if (keyword == "const") return value == rule;
    if (keyword == "enum") return std::find(rule.begin(), rule.end(), value) != rule.end();
    if (keyword == "required") {
      return std::all_of(rule.begin(), rule.end(),
                         [&](const Json& key) { return value.contains(key.get<std::string>()); });
    }
    if (keyword == "pattern") return !value.is_string() || matches(value.get<std::string>(), rule);
    if (keyword == "minLength") return !value.is_string() || value.get<std::string>().size() >= rule;
    if (keyword == "minimum") return !value.is_number() || value >= rule;
    if (keyword == "maximum") return !value.is_number() || value <= rule;
    if (keyword == "minItems") return !value.is_array() || value.size() >= rule;
    if (keyword == "maxItems") return !value.is_array() || value.size() <= rule;
    if (keyword == "minProperties") return !value.is_object() || value.size() >= rule;
    if (keyword == "maxProperties") return !value.is_object() || value.size() <= rule;
    if (keyword == "uniqueItems")
      return !value.is_array() || std::set<Json>(value.begin(), value.end()).size() == value.size();
    throw std::logic_error("unknown keyword " + keyword);
  }

  /// std::regex recurses on long texts: the two repetitive patterns of rationals are matched by hand.
  static bool matches(const std::string& text, const std::string& pattern) {
    if (pattern == "^-?[0-9]+(/[1-9][0-9]*)?$") return is_rational(text, true);
    if (pattern == "^-?[0-9]+$") return is_rational(text, false);
    return std::regex_search(text, std::regex(pattern));
  }

  static bool is_rational(const std::string& text, bool fraction) {
    const auto digits = [](const std::string& part) {
      return !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
    };
    const std::string magnitude = text.substr(text.starts_with('-') ? 1 : 0);
    const std::size_t slash = magnitude.find('/');
    if (slash == std::string::npos) return digits(magnitude);
    const std::string denominator = magnitude.substr(slash + 1);
    return fraction && digits(magnitude.substr(0, slash)) && digits(denominator) && denominator[0] != '0';
  }

  Json root_;
};

}  // namespace exsect
