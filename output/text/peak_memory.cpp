#include "output/text/peak_memory.h"

#include <fstream>
#include <string>

namespace exsect::cli {

void reset_peak_memory() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5";  // resets VmHWM; without the file or the right to write it nothing happens
}

std::optional<long> peak_memory_kib() {
  std::ifstream file("/proc/self/status");
  std::string key;
  while (file >> key) {
    long value = 0;
    if (key == "VmHWM:" && file >> value) return value;
    std::getline(file, key);
  }
  return std::nullopt;
}

}  // namespace exsect::cli
