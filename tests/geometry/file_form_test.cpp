#include <exsect/geometry/file_form.h>

#include <filesystem>

#include "support/catch.h"

namespace exsect::file_form_test {
namespace {

TEST_CASE("every form that has a schema is told by what it holds") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(EXSECT_EXAMPLES "/../docs/schemas")) {
    std::string form = entry.path().filename().string();
    form = form.substr(0, form.find(".schema"));
    form.replace(form.rfind('-'), 1, "/");
    INFO(form);
    CHECK(wrong_form(form, "other/1").starts_with("holds "));
    CHECK(wrong_form(form, "other/1").ends_with(", " + form + "; needed is other/1"));
    ++count;
  }
  CHECK(count > 10);
}

TEST_CASE("a form that is not known is an unknown version") {
  CHECK(wrong_form("patches/2", "patches/1") == "unknown version, must be patches/1");
  CHECK(wrong_form("", "patches/1") == "unknown version, must be patches/1");
  CHECK(wrong_form("\x1b[31m", "curve/1") == "unknown version, must be curve/1");
}

}  // namespace
}  // namespace exsect::file_form_test
