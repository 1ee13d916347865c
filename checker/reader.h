// Certificates are read from left to right; what is not of the required form fails where it stands. Internal
// to checker/.
#pragma once

#include <charconv>
#include <initializer_list>
#include <type_traits>

#include "certificate.h"

namespace exsect::checker {

/// FNV-1a, 64 bits, of the text after what has the hash given.
inline std::uint64_t hash(std::string_view text, std::uint64_t before = 0xcbf29ce484222325U) {
  for (const char c : text) before = (before ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return before;
}
std::string hexadecimal(std::uint64_t hash);
bool is_json(const std::string& text);

/// A word such as star0u+, u=0 or t5, taken apart from left to right.
class Word {
 public:
  explicit Word(std::string_view text) : rest_(text) {}
  bool empty() const { return rest_.empty(); }
  bool skip(std::string_view prefix) {
    const bool there = rest_.substr(0, prefix.size()) == prefix;
    if (there) rest_.remove_prefix(prefix.size());
    return there;
  }
  Parameter parameter() {
    const std::size_t i = empty() ? std::string_view::npos : std::string_view("uvrs").find(rest_[0]);
    require(i != std::string_view::npos, "must name u, v, r or s");
    rest_.remove_prefix(1);
    return {i};
  }
  /// As std::to_string writes it.
  int integer() {
    int n = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), n);
    const auto length = static_cast<std::size_t>(end - rest_.data());
    require(error == std::errc() && std::to_string(n).size() == length, "must have an integer here");
    rest_.remove_prefix(length);
    return n;
  }
  int count() {
    const int n = integer();
    require(n >= 0, "must be an integer >= 0");
    return n;
  }
  void end() const { require(empty(), "must be one of the documented words"); }

 private:
  std::string_view rest_;
};

/// A member of an object that need not be there: `read` is called if it is.
template <class Read>
struct Optional {
  Read read;
};
template <class Read>
Optional(Read) -> Optional<Read>;
template <class Value>
inline constexpr bool is_optional = false;
template <class Read>
inline constexpr bool is_optional<Optional<Read>> = true;

/// A place in a text that should be JSON: where it is not, something fails.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  /// JSON path of what is being read, or of what failed.
  std::string place() const {
    std::string result = "$";
    for (const auto& [key, index] : path_)
      result += key ? std::string(".") + key : "[" + std::to_string(index) + "]";
    return result;
  }

  std::string_view string() {
    take('"', "must be a string");
    const std::string_view rest = text_.substr(at_);
    std::size_t length = std::min(rest.find('"'), rest.size());
    if (rest.substr(0, length).find('\\') != std::string_view::npos)
      for (length = 0; length < rest.size() && rest[length] != '"';) length += rest[length] == '\\' ? 2 : 1;
    require(length < rest.size(), "must end");
    const std::string_view result = rest.substr(0, length);
    hash_ = hash(result, hash_);
    at_ += length;
    take('"', "");
    return result;
  }
  /// A string that need not be of any form: JSON's own.
  void text() {
    const std::string content(string());
    require(is_json("\"" + content + "\""), "must be a text of JSON");
  }
  /// One more entry of a subdivision.
  void count_entry() { require(++entries_ <= max_entries, "more than 1048576 entries of subdivisions"); }
  bool at_list() { return next() == '['; }
  std::size_t count() {
    next();
    std::size_t n = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), n);
    require(error == std::errc(), "must be an integer >= 0");
    const auto length = static_cast<std::size_t>(end - text_.data()) - at_;
    require(length == 1 || text_[at_] != '0', "must be an integer without leading zeros");
    hash_ = hash(text_.substr(at_, length), hash_);
    at_ += length;
    return n;
  }
  /// Calls each(i) for each element, to read it; how many there are.
  template <class Each>
  std::size_t list(const Each& each) {
    take('[', "must be an array");
    std::size_t n = 0;
    for (; next() != ']'; ++n) {
      if (n > 0) take(',', "must be an integer >= 0");
      path_.push_back({nullptr, n});
      each(n);
      path_.pop_back();
    }
    take(']', "");
    return n;
  }
  /// The members of an object, with these keys in this order: `values` are read, or called to do it.
  template <class... Values>
  void members(std::initializer_list<const char*> keys, Values&&... values) {
    const char* const* key = keys.begin();
    (member(*key++, values), ...);
  }
  void begin() { take('{', "must be an object"); }
  void end() { take('}', "must have the documented keys and no others"); }
  void finish() { require(next() == '\0' && at_ == text_.size(), "must end here"); }
  /// An object with these members and, last, a seal over its place and them.
  template <class... Values>
  void claim(std::initializer_list<const char*> keys, Values&&... values) {
    hash_ = hash(place());
    begin();
    members(keys, values...);
    const std::string expected = hexadecimal(hash("}", hash_));
    std::string_view said;
    members({"seal"}, [&] { said = string(); });
    require(said == expected, "the seal does not fit the claim", Violation::seal);
    end();
  }
  /// What is read again, from the position on.
  std::size_t position() const { return at_; }
  Reader again(std::size_t position) const {
    Reader result(text_);
    result.at_ = position;
    return result;
  }

 private:
  /// The next character that is no blank; 0 at the end.
  char next() {
    const auto is_blank = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  void take(char c, const char* reason) {
    require(next() == c, reason);
    hash_ = hash({&c, 1}, hash_);
    ++at_;
  }
  /// What follows is a further member, with this key.
  bool has_member(const char* key) const {
    Reader ahead = again(at_);
    if (ahead.next() != ',') return false;
    ahead.take(',', "");
    return ahead.next() == '"' && ahead.string() == key;
  }
  template <class Value>
  void member(const char* key, Value& value) {
    if constexpr (is_optional<std::remove_const_t<Value>>) {
      if (has_member(key)) member(key, value.read);
    } else {
      required_member(key, value);
    }
  }
  template <class Value>
  void required_member(const char* key, Value& value) {
    if (text_[at_ - 1] != '{') take(',', "must have the documented keys");
    require(next() == '"' && string() == key, "must have the documented keys in their order");
    take(':', "");
    path_.push_back({key, 0});
    if constexpr (std::is_invocable_v<Value>)
      value();
    else
      read(*this, value);
    path_.pop_back();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::uint64_t hash_ = 0;
  std::size_t entries_ = 0;
  std::vector<std::pair<const char*, std::size_t>> path_;  // keys, or indices
};

}  // namespace exsect::checker
