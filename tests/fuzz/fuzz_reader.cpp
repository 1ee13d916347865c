// The libFuzzer target of one reader, EXSECT_READER: stops at the first text for which something does not
// hold.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "fuzz/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto all = exsect::fuzz::readers();
  const auto reader =
      std::find_if(all.begin(), all.end(), [](const auto& r) { return r.name == EXSECT_READER; });
  try {
    reader->read({reinterpret_cast<const char*>(data), size});
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    std::abort();
  }
  return 0;
}
