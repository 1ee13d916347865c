// Gives kept texts to their readers: exsect_replay_readers FOLDER, which holds a folder for each reader with
// its texts. Each text is given as it is, and cut after each of its first bytes. Status 1 if something does
// not hold.
#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "fuzz/readers.h"

namespace {

namespace fs = std::filesystem;
using exsect::fuzz::Reader;

constexpr std::size_t longest_cut = 400;

std::string content(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> texts_of(const fs::path& folder) {
  std::vector<fs::path> paths(fs::directory_iterator(folder), {});
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const fs::path& path : paths) texts.push_back(content(path));
  return texts;
}

/// Makes a text out of kept ones: some bytes changed, left out, repeated, taken from another text, or words
/// put in on which numbers and strings tend to fail.
class Changes {
 public:
  Changes(const std::vector<std::string>& texts, std::uint64_t seed) : texts_(texts), random_(seed) {}

  std::string next() {
    std::string text = texts_[below(texts_.size())];
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  void change(std::string& text) {
    static const std::string words[] = {"1e999", "-1",   "0x1p-1074", "1/0",     "18446744073709551616",
                                        "nan",   "\"",   "\\",        "\\u202e", "[",
                                        "]",     "{",    "}",         "\n",      "\t",
                                        ",",     "null", "\xff",      "1e-400"};
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(below(9), text.size() - at);
    switch (below(6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3: {
        const std::string& other = texts_[below(texts_.size())];
        const std::size_t from = below(other.size() + 1);
        text.replace(at, length, other.substr(from, below(33)));
        break;
      }
      case 4:
        text.insert(at, words[below(std::size(words))]);
        break;
      default:
        text.replace(at, length, words[below(std::size(words))]);
    }
  }

  const std::vector<std::string>& texts_;
  std::mt19937_64 random_;
};

/// Whether everything holds for the text; says what does not.
bool passes(const Reader& reader, const std::string& text) {
  try {
    reader.read(text);
    return true;
  } catch (const std::exception& error) {
    std::cerr << reader.name << ": " << error.what() << "\n" << text << "\n";
    return false;
  }
}

bool passes_all(const Reader& reader, const std::vector<std::string>& texts, std::uint64_t count,
                std::uint64_t seed) {
  bool passed = true;
  for (const std::string& text : texts) {
    passed = passes(reader, text) && passed;
    for (std::size_t i = 0; i < std::min(text.size(), longest_cut); ++i)
      passed = passes(reader, text.substr(0, i)) && passed;
  }
  Changes changes(texts, seed);
  for (std::uint64_t i = 0; i < count && passed; ++i) passed = passes(reader, changes.next());
  return passed;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const std::uint64_t seed = argc > 3 ? std::stoull(argv[3]) : 1;
  const std::string only = argc > 4 ? argv[4] : "";
  bool passed = true;
  for (const Reader& reader : exsect::fuzz::readers()) {
    if (!only.empty() && only != reader.name) continue;
    const std::vector<std::string> texts = texts_of(fs::path(argv[1]) / reader.name);
    passed = passes_all(reader, texts, std::stoull(argv[2]), seed) && passed;
    std::cout << reader.name << ": " << texts.size() << " texts, " << argv[2] << " changed ones, seed "
              << seed << std::endl;
  }
  return passed ? 0 : 1;
}
