#include "cli/progress.h"

#include <sstream>
#include <string>

#include "support/catch.h"

namespace exsect::cli::progress_test {
namespace {

using namespace std::chrono_literals;

TEST_CASE("progress is one line that is wiped in the end") {
  std::ostringstream stream;
  {
    Progress progress(stream, true, 0s);
    progress.report(0.123, "tracing");
    progress.report(0.5, "too soon after the first");
    CHECK(stream.str() == "\r\x1b[Kexsect:  12 % tracing");
  }
  CHECK(stream.str() == "\r\x1b[Kexsect:  12 % tracing\r\x1b[K");
}

TEST_CASE("a fraction out of range is shown within it") {
  for (double fraction : {-1.0, 2.0}) {
    std::ostringstream stream;
    Progress progress(stream, true, 0s);
    progress.report(fraction, "step");
    CHECK(stream.str() == std::string("\r\x1b[Kexsect: ") + (fraction < 0 ? "  0" : "100") + " % step");
  }
}

TEST_CASE("short work and unwatched streams show nothing") {
  std::ostringstream stream;
  {
    Progress quick(stream, true);
    quick.report(0.5, "step");
    Progress unwatched(stream, false, 0s);
    unwatched.report(0.5, "step");
  }
  CHECK(stream.str().empty());
}

}  // namespace
}  // namespace exsect::cli::progress_test
