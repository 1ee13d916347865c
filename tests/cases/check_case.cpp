// check_case FILE.json: whether the intersection of the file's patches is the one in FILE.expected.json, or
// has the numbers stated there. check_case --write DIRECTORY: writes one member of each family.
#include <exsect/geometry/patch_file.h>
#include <exsect/geometry/text_file.h>

#include <exception>
#include <iostream>
#include <string>

#include "support/case_file.h"
#include "support/counted_case.h"
#include "support/families.h"

int main(int argc, char** argv) try {
  using namespace exsect;
  if (argc == 3 && std::string(argv[1]) == "--write") {
    for (const ExactCase& c : families::specimens()) {
      const std::string stem = std::string(argv[2]) + "/" + case_stem(c);
      write_file_atomically(stem + ".json", patches_text(c));
      write_file_atomically(stem + ".expected.json", expected_text(c));
    }
    return 0;
  }
  if (argc != 2) {
    std::cerr << "usage: check_case FILE.json | check_case --write DIRECTORY\n";
    return 2;
  }
  const std::string path = argv[1];
  const std::string stem = path.substr(0, path.size() - std::string(".json").size());
  const std::string expected = read_text_file(stem + ".expected.json", max_patch_file_bytes);
  const std::string difference = states_numbers(expected)
                                     ? counted_failure(read_text_file(path, max_patch_file_bytes), expected)
                                     : failure(read_case(path));
  std::cout << (difference.empty() ? "as expected" : difference) << "\n";
  return difference.empty() ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
