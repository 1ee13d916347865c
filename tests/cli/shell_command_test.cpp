// The command line that a report shows.
#include "cli/shell_command.h"

#include <vector>

#include "support/catch.h"

namespace exsect::shell_command_test {
namespace {

std::string shown(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "/usr/bin/exsect");
  return cli::shell_command(static_cast<int>(arguments.size()), arguments.data());
}

TEST_CASE("a report's command line holds what decides the result") {
  CHECK(shown({"intersect", "model.json", "--tolerance", "1e-9"}) ==
        "exsect intersect model.json --tolerance 1e-9");
  CHECK(shown({"line", "a.json", "--u", "1/2", "--json", "-", "--svg=x.svg", "--report", "page.html",
               "--quiet"}) == "exsect line a.json --u 1/2");
  CHECK(shown({"revolve", "p.json", "--mesh", "m.obj", "--mesh-size", "8,8", "--exact"}) ==
        "exsect revolve p.json --mesh-size 8,8 --exact");
  CHECK(shown({}) == "exsect");
}

TEST_CASE("arguments that a shell would change are quoted") {
  CHECK(shown({"intersect", "my model.json", "--first", "it's"}) ==
        "exsect intersect 'my model.json' --first 'it'\\''s'");
  CHECK(shown({"self", "$(reboot).json", "--patch", ""}) == "exsect self '$(reboot).json' --patch ''");
}

}  // namespace
}  // namespace exsect::shell_command_test
