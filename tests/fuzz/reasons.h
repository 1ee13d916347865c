// Why answers of a replay are not complete.
#pragma once

#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <utility>

namespace exsect {

/// How often each reason was given, with a seed that gives it again.
class Reasons {
 public:
  void add(const std::string& why, std::uint64_t seed) {
    ++reasons_.try_emplace(why, 0, seed).first->second.first;
  }

  /// `more(seed)` after each seed.
  template <class More>
  void print(std::ostream& out, const More& more) const {
    for (const auto& [why, entry] : reasons_)
      out << "  " << entry.first << " incomplete: " << why << " (seed " << entry.second << more(entry.second)
          << ")\n";
  }
  friend std::ostream& operator<<(std::ostream& out, const Reasons& reasons) {
    reasons.print(out, [](std::uint64_t) { return ""; });
    return out;
  }

 private:
  std::map<std::string, std::pair<int, std::uint64_t>> reasons_;  // how often, an example's seed
};

}  // namespace exsect
