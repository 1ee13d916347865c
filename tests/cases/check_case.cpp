// check_case FILE.json: whether the intersection of the file's patches is the one in FILE.expected.json.
// check_case --write DIRECTORY: writes one member of each family.
#include <exsect/geometry/text_file.h>

#include <exception>
#include <iostream>
#include <string>

#include "support/case_file.h"
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
  const std::string difference = failure(read_case(argv[1]));
  std::cout << (difference.empty() ? "as expected" : difference) << "\n";
  return difference.empty() ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
