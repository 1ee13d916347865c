#include "cli/nearest_word.h"

#include "support/catch.h"

namespace exsect::cli::nearest_word_test {
namespace {

TEST_CASE("the edit distance of words") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "line") == 4);
  CHECK(edit_distance("line", "line") == 0);
  CHECK(edit_distance("intersct", "intersect") == 1);
  CHECK(edit_distance("lien", "line") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("sitting", "kitten") == 3);
}

TEST_CASE("a misspelt word is near a known one, another word is not") {
  const std::vector<std::string> known = {"intersect", "line", "self", "batch", "batch-merge"};
  CHECK(nearest_word("intersct", known) == "intersect");
  CHECK(nearest_word("INTERSECT", known).empty());
  CHECK(nearest_word("lin", known) == "line");
  CHECK(nearest_word("bach", known) == "batch");
  CHECK(nearest_word("batchmerge", known) == "batch-merge");
  CHECK(nearest_word("model.json", known).empty());
  CHECK(nearest_word("inter", known) == "intersect");
  CHECK(nearest_word("in", known).empty());
  CHECK(nearest_word("x", {"u", "v"}).empty());
  CHECK(nearest_word("", known).empty());
  CHECK(nearest_word(std::string(5000, 'a'), known).empty());
}

}  // namespace
}  // namespace exsect::cli::nearest_word_test
