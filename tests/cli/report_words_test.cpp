// What a page says without a script.
#include "output/report/report_words.h"

#include <exsect/geometry/patch_file.h>
#include <exsect/geometry/text_file.h>
#include <exsect/solver/intersect.h>

#include <filesystem>

#include "output/report/report_html.h"
#include "output/report/sha256.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::report_words_test {
namespace {

TEST_CASE("durations have two digits below ten") {
  CHECK(cli::duration_text(0.0523) == "0.052 ms");
  CHECK(cli::duration_text(0.5) == "0.5 ms");
  CHECK(cli::duration_text(3.14159) == "3.1 ms");
  CHECK(cli::duration_text(9.96) == "10 ms");
  CHECK(cli::duration_text(417.6) == "418 ms");
  CHECK(cli::duration_text(3140) == "3.1 s");
  CHECK(cli::duration_text(31400) == "31 s");
}

TEST_CASE("the verdict, the counts and the picture stand in the HTML") {
  const std::string path = example("chapter9-first.json");
  const PatchFile file = read_patches(path);
  const BezierPatch& x = file.patches[0].patch;
  const BezierPatch& y = file.patches[1].patch;
  const cli::ReportOrigin origin = cli::origin_of(file.title, "exsect intersect <first>", {path});
  const std::string page = cli::report_html(intersect(x, y, {}), x, y, {"x", "y"}, origin);
  const std::string before_scripts = page.substr(0, page.find("<script"));
  for (const char* words : {"<span class=\"complete\">Complete, proved.</span> Patches x and y intersect in "
                            "2 components (1 closed, 1 open).",
                            "<dt>nodes</dt><dd>12</dd>", "<dt>turning in v</dt><dd>3</dd>",
                            "<figure id=\"still\">", "<svg xmlns"})
    CHECK(before_scripts.find(words) != std::string::npos);
  CHECK(before_scripts.find("<?xml") == std::string::npos);
  CHECK(page.find(R"("line":"exsect intersect \u003cfirst>")") != std::string::npos);
  CHECK(page.find(cli::sha256(read_text_file(path, 1 << 20))) != std::string::npos);
}

TEST_CASE("an input that is no regular file has no hash") {
  CHECK(cli::origin_of("", "", {"/dev/null"}).inputs[0].sha256.empty());
  CHECK(cli::origin_of("", "", {"no such file"}).inputs[0].sha256.empty());
}

TEST_CASE("an approximate equation is not called complete") {
  const cli::Json fit = {{"command", "implicitize"},
                         {"result",
                          {{"status", "complete"},
                           {"method", "least-squares"},
                           {"exact", false},
                           {"equations", {{{"name", "f"}, {"degree", 3}}}},
                           {"proved", {{{"name", "one-sided"}, {"approx", 0.00665}}}}}}};
  const cli::ReportWords words = cli::report_words(fit);
  CHECK(words.verdict == "Approximate; distance proved.");
  CHECK(words.answer == "Approximate implicit equation of degree 3; one-sided distance at most 6.65e-03.");
  CHECK(words.good);
  cli::Json precise = fit;
  precise["result"]["exact"] = true;
  CHECK(cli::report_words(precise).verdict == "Complete, proved.");
  precise["result"]["status"] = "incomplete";
  CHECK(cli::report_words(precise).verdict == "Incomplete.");
  CHECK_FALSE(cli::report_words(precise).good);
}

}  // namespace
}  // namespace exsect::report_words_test
