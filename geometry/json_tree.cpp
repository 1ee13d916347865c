#include "json_tree.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "text_file.h"

namespace exsect {
namespace {

/// The parser reads each number as a long double before it hands over its text, and refuses an infinite one.
/// So a bare number may be as long as a quoted one where a long double reaches 10^4932 (max_number_digits is
/// 3000).
using ParsedJson =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, long double>;

/// Builds the tree from nlohmann's events; knows at every event where in the text's structure it is.
class Builder : public nlohmann::json_sax<ParsedJson> {
 public:
  Builder(const std::string& file, std::size_t max_depth) : file_(file), max_depth_(max_depth) {}

  JsonTree take() { return std::move(root_); }

  bool null() override { return add({JsonTree::Kind::null, "", {}, {}}); }
  bool boolean(bool value) override {
    return add({JsonTree::Kind::boolean, value ? "true" : "false", {}, {}});
  }
  bool number_integer(number_integer_t value) override { return add_number(std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add_number(std::to_string(value)); }
  /// Called with the text for every decimal, and for integers of more than 64 bits.
  bool number_float(number_float_t, const string_t& text) override {
    std::string plain = text;  // nlohmann may have put in the decimal point of the C locale in force
    for (char& c : plain)
      if (std::string_view("0123456789+-eE").find(c) == std::string_view::npos) c = '.';
    return add_number(plain);
  }
  bool string(string_t& text) override { return add({JsonTree::Kind::string, text, {}, {}}); }
  bool binary(binary_t&) override { return false; }  // not in JSON text

  bool start_object(std::size_t) override { return open(JsonTree::Kind::object); }
  bool start_array(std::size_t) override { return open(JsonTree::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    if (!keys_.back().insert(key).second)
      throw InputError(file_, path(), "key \"" + printable(key) + "\" given twice");
    open_.back()->keys.push_back(key);
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override {
    std::string_view what = error.what();
    what.remove_prefix(std::min(what.find("] ") + 2, what.size()));  // the library's own error number
    throw InputError(file_, path(), "not valid JSON: " + printable(what));
  }

 private:
  bool add_number(std::string text) { return add({JsonTree::Kind::number, std::move(text), {}, {}}); }

  JsonTree& place(JsonTree value) {
    if (open_.empty()) return root_ = std::move(value);
    open_.back()->elements.push_back(std::move(value));
    return open_.back()->elements.back();
  }

  bool add(JsonTree value) {
    place(std::move(value));
    return true;
  }

  bool open(JsonTree::Kind kind) {
    if (open_.size() == max_depth_)
      throw InputError(file_, path(), "nested deeper than " + std::to_string(max_depth_) + " levels");
    // Stays where it is while it is open: its parent gets no further element meanwhile.
    open_.push_back(&place({kind, "", {}, {}}));
    keys_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  /// Of the value that is being read.
  std::string path() const {
    std::string result = "$";
    for (const JsonTree* tree : open_) {
      const bool child_is_open = tree != open_.back();
      if (tree->kind == JsonTree::Kind::array) {
        const std::size_t index = child_is_open ? tree->elements.size() - 1 : tree->elements.size();
        result += "[" + std::to_string(index) + "]";
      } else if (!tree->keys.empty() && (child_is_open || tree->keys.size() > tree->elements.size())) {
        result += "." + printable(tree->keys.back());
      }
    }
    return result;
  }

  std::string file_;
  std::size_t max_depth_;
  JsonTree root_;
  std::vector<JsonTree*> open_;
  std::vector<std::unordered_set<std::string>> keys_;  // of each open value, to find one that comes again
};

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::size_t shown = 300;
  std::string result(text.substr(0, shown));
  for (char& c : result)
    if (c < ' ' || c > '~') c = '?';
  return text.size() > shown ? result + "..." : result;
}

JsonTree parse_json(const std::string& text, const std::string& file, std::size_t max_depth) {
  Builder builder(file, max_depth);
  ParsedJson::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace exsect
