// exsect_manual FOLDER: writes the manual page and the completion for bash that are installed with the
// program.
#include <exsect/geometry/text_file.h>

#include <iostream>
#include <string>

#include "cli/command_line.h"
#include "cli/manual/bash_completion.h"
#include "cli/manual/manual_page.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "exsect_manual: a folder is needed\n";
    return 2;
  }
  try {
    CLI::App app("", "exsect");
    exsect::cli::Commands commands;
    exsect::cli::add_commands(app, commands);
    const std::string folder = argv[1];
    exsect::write_file_atomically(folder + "/exsect.1", exsect::cli::manual_page(app, EXSECT_VERSION));
    exsect::write_file_atomically(folder + "/exsect.bash", exsect::cli::bash_completion(app));
  } catch (const std::exception& error) {
    std::cerr << "exsect_manual: " << error.what() << "\n";
    return 2;
  }
}
