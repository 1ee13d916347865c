// JSON with its places, of which everything that is not of the required form is rejected. Internal to
// checker/.
#pragma once

#include <exsect/geometry/number.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <set>

#include "certificate.h"

namespace exsect::checker {

using Json = nlohmann::ordered_json;

inline constexpr std::string_view parameter_letters = "uvrs";

/// The double that the text p/q, p/2^n or p is, if it is short: |p| <= 2^53, q a power of two.
inline std::optional<double> short_number(const std::string& text) {
  const char* end = text.data() + text.size();
  std::int64_t p = 0;
  std::int64_t q = 1;
  const auto numerator = std::from_chars(text.data(), end, p);
  if (numerator.ec != std::errc() || std::abs(p) > std::int64_t{1} << 53) return std::nullopt;
  if (std::string_view(numerator.ptr, end).substr(0, 3) == "/2^") {
    int n = 0;
    const auto power = std::from_chars(numerator.ptr + 3, end, n);
    if (power.ec != std::errc() || p % 2 == 0 || n < 1 || n > 1000) return std::nullopt;
    const bool canonical = text == std::to_string(p) + "/2^" + std::to_string(n);
    return canonical ? std::optional(std::ldexp(static_cast<double>(p), -n)) : std::nullopt;
  }
  if (numerator.ptr != end) {
    const auto denominator = std::from_chars(std::min(numerator.ptr + 1, end), end, q);
    if (denominator.ec != std::errc() || q < 2 || (q & (q - 1)) != 0 || p % 2 == 0) return std::nullopt;
  }
  const bool canonical = text == std::to_string(p) + (q == 1 ? "" : "/" + std::to_string(q));
  return canonical ? std::optional(static_cast<double>(p) / static_cast<double>(q)) : std::nullopt;
}

/// A value with its place. Everything that is not of the required form is rejected.
class Value {
 public:
  explicit Value(const Json& root) : json_(root) {}

  /// JSON path.
  std::string place() const {
    if (!parent_) return "$";
    return parent_->place() + (key_ ? std::string(".") + key_ : "[" + std::to_string(index_) + "]");
  }
  [[noreturn]] void reject(const std::string& reason) const { throw Rejected(place(), reason); }
  void require(bool holds, const char* reason) const {
    if (!holds) reject(reason);
  }

  /// The member of an object whose keys are exactly these, in this order.
  Value operator[](const char* key) const { return {json_.at(key), this, key, 0}; }
  void require_keys(std::initializer_list<const char*> keys, const char* last) const {
    require(json_.is_object() && json_.size() == keys.size() + 1,
            "must be an object with the documented keys");
    auto it = json_.begin();
    for (const char* key : keys) {
      require(it.key() == key, "must be an object with the documented keys in their order");
      ++it;
    }
    require(it.key() == last, "must be an object with the documented keys in their order");
  }

  std::size_t size() const {
    require(json_.is_array(), "must be an array");
    return json_.size();
  }
  Value operator[](std::size_t i) const { return {json_[i], this, nullptr, i}; }
  void require_size(std::size_t n) const {
    if (size() != n) reject("must have " + std::to_string(n) + " elements");
  }
  /// read(element) for every element.
  template <class Read>
  auto list(const Read& read) const {
    std::vector<decltype(read(*this))> result;
    for (std::size_t i = 0; i < size(); ++i) result.push_back(read((*this)[i]));
    return result;
  }
  template <std::size_t n, class Read>
  auto array(const Read& read) const {
    require_size(n);
    std::array<decltype(read(*this)), n> result;
    for (std::size_t i = 0; i < n; ++i) result[i] = read((*this)[i]);
    return result;
  }

  const std::string& text() const {
    require(json_.is_string(), "must be a string");
    return json_.get_ref<const std::string&>();
  }
  std::size_t count() const {
    require(json_.is_number_unsigned(), "must be an integer >= 0");
    return json_.get<std::size_t>();
  }
  std::size_t parameter() const {
    const std::size_t i = parameter_letters.find(text());
    require(text().size() == 1 && i != std::string_view::npos, "must be u, v, r or s");
    return i;
  }
  template <class N>
  N number() const {
    if constexpr (std::is_same_v<N, Enclosure>)
      if (const auto exact = short_number(text())) return N(*exact);
    try {
      return N(number_of(text()));
    } catch (const std::invalid_argument& error) {
      reject(error.what());
    }
  }
  template <class N, std::size_t n>
  std::array<N, n> numbers() const {
    return array<n>([](const Value& v) { return v.number<N>(); });
  }

  /// All of a text, an integer as std::to_string writes it; here >= 0.
  int integer(std::string_view digits, bool negative = false) const {
    int n = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
    require(error == std::errc() && std::to_string(n) == digits && (negative || n >= 0),
            "must be one of the documented words or numbers");
    return n;
  }

  /// A claim: an object with these keys and, last, a seal over its place and its other members.
  void require_claim(std::initializer_list<const char*> keys) const {
    require_keys(keys, "seal");
    const std::string& said = (*this)["seal"].text();
    const std::string text = json_.dump();
    const std::string members =
        text.substr(0, text.size() - (",\"seal\":}" + Json(said).dump()).size()) + "}";
    require(said == seal(place() + members), "the seal does not fit the claim");
  }

 private:
  Value(const Json& json, const Value* parent, const char* key, std::size_t index)
      : json_(json), parent_(parent), key_(key), index_(index) {}

  const Json& json_;
  const Value* parent_ = nullptr;  // outlives this value
  const char* key_ = nullptr;
  std::size_t index_ = 0;
};

/// The document; a key that is given twice is not one.
inline Json parse(const std::string& text) {
  std::vector<std::set<std::string>> keys;
  const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
      throw Unreadable("key \"" + parsed.get<std::string>() + "\" given twice");
    return true;
  };
  try {
    return Json::parse(text, watch);
  } catch (const Json::exception& error) {
    throw Unreadable(std::string("not valid JSON: ") + error.what());
  }
}

}  // namespace exsect::checker
