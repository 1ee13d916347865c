// Writes pairs of one family, one patch file a line: FAMILY COUNT SEED.
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "pair_families.h"

namespace {

std::string line(const std::string& title, const nlohmann::ordered_json& entries) {
  return nlohmann::ordered_json{{"exsect", "patches/1"}, {"title", title}, {"patches", entries}}.dump();
}

const peers::Family& family(const std::string& name) {
  for (const peers::Family& candidate : peers::families())
    if (candidate.name == name) return candidate;
  throw std::invalid_argument("no family " + name);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw std::invalid_argument("usage: FAMILY COUNT SEED");
    const peers::Family& members = family(argv[1]);
    const int count = std::stoi(argv[2]);
    const unsigned long seed = std::stoul(argv[3]);
    for (int i = 0; i < count; ++i) {
      // Each pair has a generator of its own, so that a prefix of a longer run is the shorter one.
      std::seed_seq seeds{seed, static_cast<unsigned long>(i)};
      peers::Generator generator(seeds);
      std::cout << line(members.name + "/" + std::to_string(i), members.member(generator)) << "\n";
    }
    return 0;
  } catch (const std::exception& error) {
    std::cerr << argv[0] << ": " << error.what() << "\n";
    return 2;
  }
}
