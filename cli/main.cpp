#include <unistd.h>

#include <iostream>

#include "cli/program.h"

int main(int argc, char** argv) {
  return exsect::cli::run(argc, argv, {std::cout, std::cerr, isatty(STDERR_FILENO) == 1});
}
