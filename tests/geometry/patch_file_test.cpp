#include <exsect/geometry/number.h>
#include <exsect/geometry/patch_file.h>

#include <clocale>
#include <ctime>
#include <random>
#include <utility>

#include "random_shapes.h"
#include "scratch_directory.h"
#include "support/catch.h"

namespace exsect::patch_file_test {
using Catch::Matchers::Contains;

namespace {

const std::string examples = EXSECT_EXAMPLES;

/// The text of a file with one patch; `members` is everything after the version.
std::string file_with(const std::string& members) { return R"({"exsect": "patches/1", )" + members + "}"; }

std::string bilinear(const std::string& first_number) {
  return R"("patches": [{"name": "x", "degree": [1, 1], "points": [[[)" + first_number +
         R"(, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]}])";
}

Rational first_number_of(const std::string& text) {
  return parse_patches(text, "f").patches.at(0).patch.net()[0][0][0];
}

InputError refusal(const std::string& text) {
  try {
    parse_patches(text, "f.json");
  } catch (const InputError& error) {
    return error;
  }
  FAIL("accepted: " << text);
  throw std::logic_error("unreachable");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("the examples are read", "[patch_file]") {
  const PatchFile file = read_patches(examples + "/chapter9-first.json");
  REQUIRE(file.patches.size() == 2);
  CHECK(file.title == "First example: one closed loop and one open arc");
  CHECK(file.source.find("Jüttler") != std::string::npos);
  CHECK(file.patches[0].name == "x");
  CHECK(file.patches[1].name == "y");
  CHECK(file.patches[0].degree == std::array<int, 2>{2, 2});
  CHECK(file.patches[0].patch.net()[0][2] == Point{1, 0, Rational(7, 10)});
  CHECK(file.patches[0].patch.net()[2][0] == Point{Rational(1, 5), Rational(6, 7), Rational(4, 7)});
  CHECK(file.patches[1].patch.net()[1][2] == Point{Rational(5, 7), Rational(3, 8), Rational(2, 7)});
  for (const char* name : {"/chapter9-second.json", "/touching-curve.json"})
    CHECK(read_patches(examples + name).patches.size() == 2);
}

TEST_CASE("bare numbers are read from their text", "[patch_file]") {
  const std::vector<std::pair<const char*, Rational>> cases = {
      {"0.1", Rational(1, 10)},
      {"-0", 0},
      {"-7", -7},
      {"18446744073709551615", Rational(power_of_two(64) - 1)},
      {"18446744073709551617", Rational(power_of_two(64) + 1)},
      {"-9223372036854775809", Rational(-power_of_two(63) - 1)},
      {"0.1000000000000000000000000000000000000001", Rational(1, 10) + 1 / Rational(pow(Integer(10), 40u))},
      {"1e-400", 1 / Rational(pow(Integer(10), 400u))},
      {"2.5E+2", 250},
      {"\"3/7\"", Rational(3, 7)},
      {"\"0x1.8p-3\"", Rational(3, 16)},
      {"\"0.1\"", Rational(1, 10)},
  };
  for (const auto& [text, value] : cases) {
    INFO(text);
    CHECK(first_number_of(file_with(bilinear(text))) == value);
    CHECK(first_number_of(file_with(R"("numbers": "decimal", )" + bilinear(text))) == value);
  }
  CHECK(first_number_of(file_with(bilinear("0.1") + R"(, "numbers": "binary64")")) == from_double(0.1));
  CHECK(first_number_of(file_with(bilinear("\"0.1\"") + R"(, "numbers": "binary64")")) == from_double(0.1));
  CHECK(first_number_of(file_with(bilinear("\"1/10\"") + R"(, "numbers": "binary64")")) == Rational(1, 10));
  CHECK(first_number_of(file_with(bilinear("9007199254740993") + R"(, "numbers": "binary64")")) ==
        Rational(Integer("9007199254740992")));
}

TEST_CASE("the decimal point of the locale in force does not matter", "[patch_file]") {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "C"}) {
    if (std::setlocale(LC_NUMERIC, locale) == nullptr) continue;
    CHECK(first_number_of(file_with(bilinear("-12.5e-1"))) == Rational(-5, 4));
    CHECK(first_number_of(file_with(bilinear("0.1") + R"(, "numbers": "binary64")")) == from_double(0.1));
  }
  std::setlocale(LC_NUMERIC, before.c_str());
}

TEST_CASE("patches of lower degree are read and elevated", "[patch_file]") {
  const PatchFile file = parse_patches(file_with(R"("patches": [{"name": "x", "degree": [2, 1],
                   "points": [[[0,0,0],[0,1,0]], [["1/2",0,1],["1/2",1,2]], [[1,0,0],[1,1,0]]]}])"),
                                       "f");
  const BezierPatch& patch = file.patches[0].patch;
  CHECK(file.patches[0].degree == std::array<int, 2>{2, 1});
  CHECK(patch(Rational(1, 2), Rational(1, 3)) == Point{Rational(1, 2), Rational(1, 3), Rational(2, 3)});
  CHECK(patch.power_basis()[1][2] == Point{0, 0, 0});
}

TEST_CASE("every kind of bad file is refused with path and reason", "[patch_file]") {
  const std::string x = R"({"name": "x", "degree": [1, 1], "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]]})";
  const auto patches = [](const std::string& list) { return file_with(R"("patches": [)" + list + "]"); };
  const auto zeros = [](int n) {
    std::string path;
    while (n-- > 0) path += "[0]";
    return path;
  };
  struct Case {
    std::string text;
    std::string where;
    const char* reason;
  };
  const std::vector<Case> cases = {
      {"", "$", "not valid JSON"},
      {"[]", "$", "must be an object"},
      {"null", "$", "must be an object"},
      {"{}", "$", "key \"exsect\" is missing"},
      {R"({"exsect": "patches/1"})", "$", "key \"patches\" is missing"},
      {R"({"exsect": "patches/2", "patches": []})", "$.exsect", "unknown version"},
      {R"({"exsect": 1, "patches": []})", "$.exsect", "must be a string"},
      {R"({"exsect": "curve/1", "degree": 1})", "$.exsect", "holds a curve, curve/1; needed is patches/1"},
      {R"({"exsect": "candidate/1"})", "$.exsect", "holds curves of another program, candidate/1"},
      {R"({"nodes": [], "exsect": "intersection/1"})", "$.exsect", "holds a result of exsect intersect"},
      {file_with(R"("patches": {})"), "$.patches", "must be an array"},
      {patches(""), "$.patches", "at least one"},
      {patches(x) + "x", "$", "not valid JSON"},
      {patches(x) + "{}", "$", "not valid JSON"},
      {patches(x).substr(0, 100), "$.patches[0].points[1][0][1]", "not valid JSON"},
      {patches(x + "," + x), "$.patches[1].name", "given to two patches"},
      {patches(replaced(x, "\"x\"", "\"\"")), "$.patches[0].name", "must not be empty"},
      {patches(replaced(x, "\"x\"", "7")), "$.patches[0].name", "must be a string"},
      {patches(replaced(x, "{", R"({"name": "y", )")), "$.patches[0]", "key \"name\" given twice"},
      {patches(replaced(x, "{", R"({"weight": [], )")), "$.patches[0]", "unknown key \"weight\""},
      {file_with(R"("colour": 1, "patches": [)" + x + "]"), "$", "unknown key \"colour\""},
      {file_with(R"("exsect": "patches/1")"), "$", "given twice"},
      {file_with(R"("title": 3, "patches": [)" + x + "]"), "$.title", "must be a string"},
      {file_with(R"("source": null, "patches": [)" + x + "]"), "$.source", "must be a string"},
      {file_with(R"("numbers": "float", "patches": [)" + x + "]"), "$.numbers", "must be"},
      {patches(replaced(x, "[1, 1]", "[1, 4]")), "$.patches[0].degree[1]", "degree 4 is not supported"},
      {patches(replaced(x, "[1, 1]", "[0, 1]")), "$.patches[0].degree[0]", "degree 0 is not supported"},
      {patches(replaced(x, "[1, 1]", "[1, \"1\"]")), "$.patches[0].degree[1]", "1, 2 or 3"},
      {patches(replaced(x, "[1, 1]", "[1, 1.0]")), "$.patches[0].degree[1]", "1, 2 or 3"},
      {patches(replaced(x, "[1, 1]", "[1]")), "$.patches[0].degree", "array of 2"},
      {patches(replaced(x, "[1, 1]", "[2, 1]")), "$.patches[0].points", "array of 3 rows"},
      {patches(replaced(x, "[1, 1]", "[1, 2]")), "$.patches[0].points[0]", "array of 3 points"},
      {patches(replaced(x, ",[0,1,0]]", "]")), "$.patches[0].points[0]", "array of 2 points"},
      {patches(replaced(x, "[1,0,0]", "[1,0]")), "$.patches[0].points[1][0]", "array of 3 coordinates"},
      {patches(replaced(x, "[1,0,0]", "[1,0,0,1]")), "$.patches[0].points[1][0]", "array of 3 coordinates"},
      {patches(replaced(x, "[1,0,0]", "1")), "$.patches[0].points[1][0]", "must be an array"},
      {patches(replaced(x, "[1,0,0]", "[1,0,null]")), "$.patches[0].points[1][0][2]", "must be a number"},
      {patches(replaced(x, "[1,0,0]", "[1,[],0]")), "$.patches[0].points[1][0][1]", "must be a number"},
      {patches(replaced(x, "[1,0,0]", "[true,0,0]")), "$.patches[0].points[1][0][0]", "must be a number"},
      {patches(replaced(x, "[1,0,0]", "[\"1/0\",0,0]")), "$.patches[0].points[1][0][0]", "zero denominator"},
      {patches(replaced(x, "[1,0,0]", "[\"nan\",0,0]")), "$.patches[0].points[1][0][0]", "not a number"},
      {patches(replaced(x, "[1,0,0]", "[0,\"inf\",0]")), "$.patches[0].points[1][0][1]", "not a number"},
      {patches(replaced(x, "[1,0,0]", "[0,NaN,0]")), "$.patches[0].points[1][0][1]", "not valid JSON"},
      {patches(replaced(x, "[1,0,0]", "[0,0,Infinity]")), "$.patches[0].points[1][0][2]", "not valid JSON"},
      {patches(replaced(x, "[1,0,0]", "[0,0,.5]")), "$.patches[0].points[1][0][2]", "not valid JSON"},
      {patches(replaced(x, "[1,0,0]", "[0,0,1e5000]")), "$.patches[0].points[1][0][2]", "overflow"},
      {patches(replaced(x, "[1,0,0]", "[0,0,1e-3001]")), "$.patches[0].points[1][0][2]", "exponent beyond"},
      {patches(replaced(x, "[1,0,0]", "[0,0,\"\xff\"]")), "$.patches[0].points[1][0][2]", "UTF-8"},
      {patches(replaced(x, "[1,0,0]", "[0,0,0,]")), "$.patches[0].points[1][0][3]", "not valid JSON"},
      {std::string(100000, '['), "$" + zeros(16), "nested deeper than"},
      {file_with("\"patches\": " + std::string(1000, '[')), "$.patches" + zeros(15), "nested deeper than"},
  };
  for (const Case& c : cases) {
    INFO(c.text.substr(0, 200));
    const InputError error = refusal(c.text);
    INFO(error.what());
    CHECK(error.file() == "f.json");
    CHECK(error.where() == c.where);
    CHECK_THAT(error.reason(), Contains(c.reason));
    CHECK(std::string(error.what()) == "f.json: " + error.where() + ": " + error.reason());
  }
  CHECK_THAT(refusal(std::string(max_patch_file_bytes + 1, ' ')).what(), Contains("f.json: longer than"));
}

TEST_CASE("bare numbers may be as long as quoted ones", "[patch_file]") {
  const auto with = [](const std::string& number) {
    return parse_patches(
        file_with(
            R"("patches": [{"name": "x", "degree": [1, 1], "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,)" +
            number + "]]]}]"),
        "f");
  };
  for (const std::string& number :
       {"1" + std::string(400, '7'), std::string("-1e400"), "0." + std::string(2900, '3'),
        "9" + std::string(2999, '9'), std::string("1e-400"),
        "-" + std::string(1000, '1') + "." + std::string(900, '9') + "e-1000"}) {
    INFO(number);
    CHECK(with(number) == with("\"" + number + "\""));
    CHECK(with(number).patches[0].patch.net()[2][2][2] == parse_number(number));
  }
}

TEST_CASE("files that cannot be read are refused by name", "[patch_file]") {
  const ScratchDirectory directory;
  CHECK_THROWS_AS(read_patches(directory.path("missing.json")), InputError);
  CHECK_THROWS_WITH(read_patches(directory.path("")), Contains("is a directory"));
  write_file_atomically(directory.path("large"), std::string(max_patch_file_bytes + 1, ' '));
  CHECK_THROWS_WITH(read_patches(directory.path("large")), Contains("longer than"));
}

TEST_CASE("write then read is the identity", "[patch_file]") {
  const ScratchDirectory directory;
  const auto seed = 11u;
  INFO("seed " << seed);
  Random random(seed);
  PatchFile file{"a \"title\"\n\t\\ with ü and \x01", "", {}};
  for (int i = 0; i < 20; ++i) {
    const std::array<int, 2> degree = {1 + i % 2, 1 + i / 2 % 2};
    std::vector<std::vector<Point>> points(static_cast<std::size_t>(degree[0]) + 1);
    for (auto& row : points)
      for (int j = 0; j <= degree[1]; ++j) row.push_back(random_point(random));
    file.patches.push_back({"patch " + std::to_string(i), degree, BezierPatch::elevated(points)});
  }
  ControlNet extreme = random_net(random);
  extreme[0][0] = {from_double(0x1p-1074), from_double(-0x1.fffffffffffffp1023),
                   Rational(1, 3) + power_of_two(-2000)};
  file.patches.push_back({"extreme", {2, 2}, BezierPatch(extreme)});
  write_patches(file, directory.path("p.json"));
  CHECK(read_patches(directory.path("p.json")) == file);
  for (const char* name : {"/chapter9-first.json", "/chapter9-second.json", "/touching-curve.json"}) {
    const PatchFile example = read_patches(examples + name);
    CHECK(parse_patches(format_patches(example), "f") == example);
  }
}

TEST_CASE("what no file can hold is not written", "[patch_file]") {
  const ScratchDirectory directory;
  Random random(3);
  const NamedPatch good{"x", {2, 2}, random_patch(random)};
  const auto refused = [&](const PatchFile& file) {
    CHECK_THROWS_AS(write_patches(file, directory.path("p.json")), std::invalid_argument);
  };
  refused({"", "", {}});
  refused({"", "", {good, good}});
  refused({"\xff", "", {good}});
  refused({"", "", {{"", {2, 2}, good.patch}}});
  refused({"", "", {{"x", {1, 2}, good.patch}}});
  refused({"", "", {{"x", {2, 1}, good.patch}}});
  refused({"", "", {{"x", {3, 2}, good.patch}}});
  ControlNet net = good.patch.net();
  net[1][1][1] = pow(Integer(10), 3000u);
  refused({"", "", {{"x", {2, 2}, BezierPatch(net)}}});
  CHECK(directory.number_of_files() == 0);
  CHECK_THROWS_AS(write_patches({"", "", {good}}, directory.path("no/such/p.json")), OutputError);
}

TEST_CASE("every truncated prefix is refused", "[patch_file]") {
  const std::string text = read_text_file(examples + "/chapter9-first.json", max_patch_file_bytes);
  const std::size_t end = text.find_last_of('}');
  for (std::size_t n = 0; n <= end; ++n)
    if (!refusal(text.substr(0, n)).where().starts_with("$")) FAIL("prefix of " << n << " bytes");
  CHECK(parse_patches(text.substr(0, end + 1), "f").patches.size() == 2);
}

TEST_CASE("damaged files are refused or read, never anything else", "[patch_file]") {
  const std::string original = read_text_file(examples + "/chapter9-first.json", max_patch_file_bytes);
  const std::string alphabet = "{}[]\",:0123456789/.eE+-xp \\untrf";
  std::mt19937_64 random(8);
  int readable = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = original;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      const char c =
          random() % 4 == 0 ? static_cast<char>(random() % 256) : alphabet[random() % alphabet.size()];
      const auto at = random() % text.size();
      if (random() % 3 == 0)
        text.erase(at, 1 + random() % 10);
      else if (random() % 2 == 0)
        text.insert(at, 1, c);
      else
        text[at] = c;
    }
    try {
      const PatchFile file = parse_patches(text, "f");
      ++readable;
      if (parse_patches(format_patches(file), "f") != file) FAIL("no round trip: " << text);
    } catch (const InputError& error) {
      if (!error.where().starts_with("$") || error.reason().empty())
        FAIL("unclear refusal: " << error.what());
    }
  }
  CHECK(readable > 100);
}

TEST_CASE("an object with very many keys takes linear time", "[patch_file]") {
  const auto seconds = [](int keys) {
    std::string text = "{";
    for (int i = 0; i < keys; ++i) text += "\"key" + std::to_string(i) + "\": 1, ";
    const std::clock_t begun = std::clock();
    CHECK_THAT(refusal(text + "\"key0\": 1}").reason(), Contains("given twice"));
    return static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  };
  seconds(1000);
  // Quadratic, it would be 256 times as long.
  CHECK(seconds(160000) < 64 * (seconds(10000) + 0.01));
}

TEST_CASE("names have a greatest length", "[patch_file]") {
  const auto named = [](const std::string& name) {
    return replaced(file_with(bilinear("0")), "\"x\"", "\"" + name + "\"");
  };
  CHECK(parse_patches(named(std::string(max_name_bytes, 'n')), "f").patches[0].name.size() == max_name_bytes);
  const InputError error = refusal(named(std::string(max_name_bytes + 1, 'n')));
  CHECK(error.where() == "$.patches[0].name");
  CHECK_THAT(error.reason(), Contains("longer than 1000 bytes"));
  PatchFile file = parse_patches(named("x"), "f");
  file.patches[0].name = std::string(max_name_bytes + 1, 'n');
  CHECK_THROWS_AS(format_patches(file), std::invalid_argument);
}

}  // namespace exsect::patch_file_test
