// What a page says in words, before any script runs: the verdict and the numbers under it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "output/text/json_forms.h"

namespace exsect::cli {

/// The head of a page. `good`: complete, or the candidate agrees.
struct ReportWords {
  bool good;
  std::string verdict;                                      // "Complete, proved."
  std::string answer;                                       // "Patches x and y intersect in ..."
  std::string origin;                                       // command and file
  std::vector<std::pair<std::string, std::string>> counts;  // a name and a number each
};

/// The words for a page's data, as report_data.h makes them. Data of no known command have no answer.
ReportWords report_words(const Json& data);

/// "0.52 ms", "12 ms", "3.1 s": two digits below ten of a unit.
std::string duration_text(double milliseconds);

}  // namespace exsect::cli
