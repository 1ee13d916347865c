// The libFuzzer target: stops at the first pair for which something does not hold.
#include <exsect/geometry/patch_file.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>

#include "fuzz/fuzzed_pair.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto pair = exsect::fuzz::pair({data, size});
  auto violation = exsect::fuzz::check(pair, 20).violation;
  if (violation.empty()) violation = exsect::fuzz::check_self(pair.x, 20).violation;
  if (violation.empty()) return 0;
  std::cerr << violation << "\n"
            << exsect::format_patches({"", "", {{"x", {2, 2}, pair.x}, {"y", {2, 2}, pair.y}}});
  std::abort();
}
