#include <exsect/geometry/model_file.h>

#include <fstream>

#include "scratch_directory.h"
#include "support/catch.h"

namespace exsect::model_file_test {
namespace {

const std::string points = R"([[[0,0,0],[0,1,0.1]],[[1,0,0],["1/3",1,0]]])";

std::string patch(const std::string& name) {
  return R"({"name": ")" + name + R"(", "degree": [1,1], "points": )" + points + "}";
}

struct Content {
  std::vector<NamedRationalPatch> patches;
  ModelFile file;
};

Content read(const std::string& path) {
  std::vector<NamedRationalPatch> patches;
  ModelFile file(path, [&](const NamedRationalPatch& p) { patches.push_back(p); });
  return {std::move(patches), std::move(file)};
}

std::string written(const ScratchDirectory& scratch, const std::string& text) {
  const std::string path = scratch.path("model.ndjson");
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string refusal(const std::string& text) {
  const ScratchDirectory scratch;
  const std::string path = written(scratch, text);
  try {
    read(path);
  } catch (const InputError& error) {
    return std::string(error.what()).substr(path.size());
  }
  return "";
}

TEST_CASE("a model has the patches of the patch file with the same lines") {
  const ScratchDirectory scratch;
  for (const char* numbers : {"decimal", "binary64"}) {
    const std::string kind = R"("title": "t", "numbers": ")" + std::string(numbers) + "\"";
    const RationalPatchFile expected = parse_rational_patches(
        R"({"exsect": "patches/1", )" + kind + R"(, "patches": [)" + patch("a") + "," + patch("b") + "]}",
        "");
    for (const char* end : {"\n", "\r\n", "\n\n"}) {
      const std::string path =
          written(scratch, R"({"exsect": "model/1", )" + kind + "}" + end + patch("a") + end + patch("b"));
      const Content content = read(path);
      CHECK(content.patches == expected.patches);
      CHECK(content.file.size() == 2);
      CHECK(content.file.title() == "t");
      CHECK(content.file.patch(1) == expected.patches[1]);
      CHECK(content.file.patch(0) == expected.patches[0]);
    }
  }
}

TEST_CASE("a patch file is a model, on one line too") {
  const ScratchDirectory scratch;
  for (const char* space : {" ", "\n"}) {
    const std::string text =
        std::string("{\"exsect\": \"patches/1\",") + space + "\"patches\": [" + patch("a") + "]}";
    const Content content = read(written(scratch, text));
    CHECK(content.patches == parse_rational_patches(text, "").patches);
    CHECK(content.file.patch(0) == content.patches[0]);
  }
}

TEST_CASE("what is not a model is refused with its line") {
  const std::string head = "{\"exsect\": \"model/1\"}\n";
  CHECK(refusal("").find("not valid JSON") != std::string::npos);
  CHECK(refusal(head) == ": must hold at least one patch");
  CHECK(refusal(head + patch("a") + "\n" + patch("a")) == R"(:3: $.name: name "a" given to two patches)");
  CHECK(refusal(head + patch("a") + "\n{\"name\"").starts_with(":3: $.name: not valid JSON"));
  CHECK(refusal(head + patch("a") + patch("b")).starts_with(":2: "));
  CHECK(refusal(head + patch("")) == ":2: $.name: must not be empty");
  CHECK(refusal("{\"exsect\": \"model/1\", \"patches\": []}").starts_with(":1: $: unknown key"));
  CHECK(refusal("{\"exsect\": \"model/1\", \"numbers\": \"x\"}").starts_with(":1: $.numbers: "));
  CHECK(refusal("{\"exsect\": \"model/2\"}").find("unknown version") != std::string::npos);
  CHECK(refusal(head + std::string(max_model_line_bytes + 1, ' ')).starts_with(":2: line longer than"));
  CHECK_THROWS_AS(read("/nowhere/model"), InputError);
  CHECK_THROWS_AS(read("/"), InputError);
}

TEST_CASE("a model that is cut while it is open is refused") {
  const ScratchDirectory scratch;
  const std::string path = written(scratch, "{\"exsect\": \"model/1\"}\n" + patch("a") + "\n" + patch("b"));
  const Content content = read(path);
  std::ofstream(path, std::ios::binary).flush();
  CHECK_THROWS_AS(content.file.patch(1), InputError);
}

}  // namespace
}  // namespace exsect::model_file_test
