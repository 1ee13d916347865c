// replay FILE...: checks the kept cases, pairs and first patches with themselves, files of bytes as the fuzz
// target takes them, or patch files
// (*.json). replay --random KIND FIRST COUNT: checks COUNT random pairs of the kind (a first byte; -1: of all
// kinds) and reports how many end incomplete, by reason; --random-self: of the first patch with itself;
// --sides FAMILY FIRST COUNT: of pairs with a side on the other patch (a place in side_pairs::all);
// --features FIRST COUNT: pairs with a feature of a size from 2^-20 to 2^-300 and a known answer. Exit
// status 1 if something does not hold.
#include <exsect/geometry/patch_file.h>
#include <exsect/geometry/text_file.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "fuzz/fuzzed_pair.h"
#include "support/side_pairs.h"
#include "support/small_features.h"

namespace {

using namespace exsect;

constexpr double kMaxSeconds = 20;

random_pairs::Pair pair_in(const std::string& path) {
  if (path.ends_with(".json")) {
    const PatchFile file = read_patches(path);
    return {file.patches.at(0).patch, file.patches.at(1).patch};
  }
  const std::string text = read_text_file(path, 4096);
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  return fuzz::pair(bytes);
}

int replay(const std::vector<std::string>& paths) {
  int wrong = 0;
  for (const std::string& path : paths) {
    const random_pairs::Pair pair = pair_in(path);
    for (const std::string& violation :
         {fuzz::check(pair, kMaxSeconds).violation, fuzz::check_self(pair.x, kMaxSeconds).violation}) {
      if (violation.empty()) continue;
      ++wrong;
      std::cout << path << ": " << violation << "\n";
    }
  }
  std::cout << paths.size() << " cases, " << wrong << " wrong\n";
  return wrong == 0 ? 0 : 1;
}

std::vector<std::uint8_t> random_bytes(int kind, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<std::uint8_t> bytes(1 + 9 * 3 * 2 + 8);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(generator() % 240);
  if (kind >= 0) bytes[0] = static_cast<std::uint8_t>(kind);
  return bytes;
}

struct Statistics {
  int complete = 0;
  int wrong = 0;
  int lines = 0;
  double slowest = 0;
  std::map<std::string, std::pair<int, std::uint64_t>> reasons;  // how often, an example's seed
};

random_pairs::Pair random_pair(const std::string& mode, int kind, std::uint64_t seed) {
  if (mode != "--sides") return fuzz::pair(random_bytes(kind, seed));
  random_pairs::Generator generator(seed);
  return side_pairs::all.at(static_cast<std::size_t>(kind))(generator);
}

int statistics(const std::string& mode, int kind, std::uint64_t first, std::uint64_t count) {
  const bool self = mode == "--random-self";
  Statistics sum;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const auto start = std::chrono::steady_clock::now();
    const random_pairs::Pair pair = random_pair(mode, kind, seed);
    const fuzz::Verdict verdict =
        self ? fuzz::check_self(pair.x, kMaxSeconds) : fuzz::check(pair, kMaxSeconds);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    sum.slowest = std::max(sum.slowest, time.count());
    if (!verdict.violation.empty()) {
      ++sum.wrong;
      std::cout << "seed " << seed << ": " << verdict.violation << std::endl;
    }
    sum.lines += verdict.compared_lines;
    if (verdict.result.status == Status::complete) {
      ++sum.complete;
    } else {
      const auto entry = sum.reasons.try_emplace(verdict.result.incomplete.at(0).why, 0, seed).first;
      ++entry->second.first;
    }
  }
  std::cout << count << " pairs: " << sum.complete << " complete, " << sum.wrong << " wrong; " << sum.lines
            << " lines compared; slowest " << sum.slowest << " s\n";
  for (const auto& [reason, entry] : sum.reasons) {
    std::cout << "  " << entry.first << " incomplete: " << reason << " (seed " << entry.second << ")\n";
  }
  return sum.wrong == 0 ? 0 : 1;
}

/// Seed by seed the next family, of a random size.
int features(std::uint64_t first, std::uint64_t count) {
  struct Sum {
    int count = 0;
    double seconds = 0;
    double slowest = 0;
  };
  const auto& families = small_features::families();
  std::vector<Sum> sums(families.size());
  std::uint64_t failures = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const auto& family = families[seed % families.size()];
    const int bits = 20 + static_cast<int>(std::mt19937_64(seed)() % 281);
    const auto start = std::chrono::steady_clock::now();
    const std::string failure = small_features::failure(family, bits, seed, false);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    Sum& sum = sums[seed % families.size()];
    ++sum.count;
    sum.seconds += time.count();
    sum.slowest = std::max(sum.slowest, time.count());
    if (failure.empty()) continue;
    ++failures;
    std::cout << "seed " << seed << ", " << family.name << ", 2^-" << bits << ": " << failure << std::endl;
  }
  for (std::size_t i = 0; i < families.size(); ++i) {
    std::cout << families[i].name << ": " << sums[i].count << " pairs, " << sums[i].seconds / sums[i].count
              << " s each, slowest " << sums[i].slowest << " s\n";
  }
  std::cout << count << " features, " << failures << " not as expected\n";
  return failures == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 4 &&
      (arguments[0] == "--random" || arguments[0] == "--random-self" || arguments[0] == "--sides")) {
    return statistics(arguments[0], std::stoi(arguments[1]), std::stoull(arguments[2]),
                      std::stoull(arguments[3]));
  }
  if (arguments.size() == 3 && arguments[0] == "--features") {
    return features(std::stoull(arguments[1]), std::stoull(arguments[2]));
  }
  if (arguments.size() == 3 && (arguments[0] == "--show" || arguments[0] == "--show-sides")) {
    const auto pair = random_pair(arguments[0] == "--show" ? "--random" : "--sides", std::stoi(arguments[1]),
                                  std::stoull(arguments[2]));
    std::cout << format_patches({"", "", {{"x", {2, 2}, pair.x}, {"y", {2, 2}, pair.y}}});
    return 0;
  }
  return replay(arguments);
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
