#include "bpt_file.h"

#include <algorithm>
#include <string_view>

#include "number.h"

namespace exsect {
namespace {

/// The words of a file from left to right, with their lines.
class Words {
 public:
  Words(const std::string& text, const std::string& file) : text_(text), file_(file) { skip(); }

  bool at_end() const { return at_ == text_.size(); }

  std::string_view next(const char* what) {
    if (at_end()) fail(std::string(what) + " expected, the file ends");
    const std::size_t begin = at_;
    while (!at_end() && !is_blank(text_[at_]) && text_[at_] != '#') ++at_;
    const std::string_view word = std::string_view(text_).substr(begin, at_ - begin);
    line_of_word_ = line_;
    skip();
    return word;
  }

  Rational number(const char* what) {
    const std::string_view word = next(what);
    try {
      return parse_number(word);
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
  }

  /// At most `most`.
  int natural(const char* what, int most) {
    const Rational value = number(what);
    if (denominator(value) != 1 || value < 0) fail(std::string(what) + " must be a whole number");
    if (value > most)
      fail(std::string(what) + " " + to_string(value).substr(0, 20) + " is more than " +
           std::to_string(most));
    return numerator(value).convert_to<int>();
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(file_, "line " + std::to_string(line_of_word_), reason);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  void skip() {
    for (bool comment = false; !at_end(); ++at_) {
      if (text_[at_] == '\n') {
        ++line_;
        comment = false;
      } else if (text_[at_] == '#') {
        comment = true;
      } else if (!comment && !is_blank(text_[at_])) {
        return;
      }
    }
  }

  const std::string& text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t line_of_word_ = 1;
};

int read_bpt_degree(Words& words) {
  constexpr int readable = 1000;
  const int degree = words.natural("degree", readable);
  if (degree < 1 || degree > max_patch_degree)
    words.fail("degree " + std::to_string(degree) + " is not supported: must be 1, 2 or 3");
  return degree;
}

RationalPatch read_patch(Words& words) {
  const int m = read_bpt_degree(words);
  const int n = read_bpt_degree(words);
  std::vector<std::vector<Point>> points(static_cast<std::size_t>(m) + 1);
  for (std::vector<Point>& row : points)
    for (int j = 0; j <= n; ++j) {
      const Rational x = words.number("coordinate x");
      const Rational y = words.number("coordinate y");
      row.push_back({x, y, words.number("coordinate z")});
    }
  try {
    return RationalPatch(points);
  } catch (const PatchError& error) {
    words.fail("the patch that ends here: " + error.reason());
  }
}

}  // namespace

RationalPatchFile parse_bpt(const std::string& text, const std::string& filename) {
  if (text.size() > max_patch_file_bytes)
    throw InputError(filename, "", "longer than " + std::to_string(max_patch_file_bytes) + " bytes");
  Words words(text, filename);
  constexpr int most = 1 << 20;
  const int count = words.natural("number of patches", most);
  if (count == 0) words.fail("must hold at least one patch");
  RationalPatchFile file;
  for (int i = 1; i <= count; ++i) file.patches.push_back({std::to_string(i), read_patch(words)});
  if (!words.at_end()) {
    words.next("end of the file");
    words.fail("there is more than " + std::to_string(count) + " patches");
  }
  return file;
}

bool is_bpt(const std::string& path) {
  constexpr std::string_view ending = ".bpt";
  if (path.size() < ending.size()) return false;
  return std::equal(ending.begin(), ending.end(), path.end() - static_cast<std::ptrdiff_t>(ending.size()),
                    [](char expected, char c) {
                      return c == expected || (c >= 'A' && c <= 'Z' && c + ('a' - 'A') == expected);
                    });
}

}  // namespace exsect
