// The command line of the built program: help, version, and every way to use it wrongly.
#include <filesystem>
#include <fstream>

#include "check_refused.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::program_test {
namespace {

using Arguments = std::vector<std::string>;

const std::string first = example("chapter9-first.json");

const std::string patch = R"("degree": [1,1], "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]]]})";

std::string patches(const std::string& list) {
  return R"({"exsect": "patches/1", "patches": [)" + list + "]}";
}

TEST_CASE("help and version go to the standard output") {
  const ProgramRun version = run_program({"--version"});
  CHECK(version.status == 0);
  CHECK(version.out == "exsect " EXSECT_TEST_VERSION "\n");
  CHECK(version.err.empty());
  const ProgramRun help = run_program({"--help"});
  CHECK(help.status == 0);
  for (const char* word : {"intersect", "line", "self", "Exit status", "--version", "chapter9-first.json"}) {
    CHECK(help.out.find(word) != std::string::npos);
  }
  for (const char* command : {"intersect", "line"}) {
    const ProgramRun more = run_program({command, "--help"});
    CHECK(more.status == 0);
    CHECK(more.err.empty());
    for (const char* word :
         {"FILE", "--first", "--second", "--json", "--svg", "--report", "--quiet", "Examples"}) {
      INFO(command << " " << word);
      CHECK(more.out.find(word) != std::string::npos);
    }
  }
}

TEST_CASE("wrong options are refused") {
  check_refused({}, "a command is needed: ");
  check_refused({"intersekt", first}, "intersekt");
  check_refused({"intersect"}, "FILE is required");
  check_refused({"intersect", first, "--colour", "red"}, "--colour");
  check_refused({"intersect", first, first}, "chapter9-first.json");
  check_refused({"intersect", first, "--json"}, "--json");
  check_refused({"intersect", first, "--json", ""}, "--json: empty value");
  check_refused({"intersect", first, "--tolerance", "1", "--tolerance", "2"}, "--tolerance");
  check_refused({"intersect", ""}, "empty value");
}

TEST_CASE("a tolerance must be a positive number") {
  for (const char* text :
       {"0", "-1", "nan", "NaN", "inf", "abc", "1e-6x", "1e", "1/0", " 1", "1e-2000", "1e2000", "1e99999"}) {
    check_refused({"intersect", first, "--tolerance=" + std::string(text)}, "--tolerance: ");
  }
  for (const char* text : {"0", "-1", "nan", "1e-2000"}) {
    check_refused({"intersect", first, "--max-seconds=" + std::string(text)}, "--max-seconds: ");
  }
  check_refused({"intersect", first, "--tolerance", "-1"}, "--tolerance");
  check_refused({"intersect", first, "--tolerance=" + std::string(100000, '1')}, "--tolerance: ");
}

TEST_CASE("turning parameters are a list of u, v, r, s") {
  for (const char* text : {"w", "u,", ",u", "u,u", "u v", "U", ",", "none,u", "u;v"}) {
    check_refused({"intersect", first, "--turning=" + std::string(text)}, "--turning: ");
  }
}

TEST_CASE("misspelt commands and options are met with the nearest ones") {
  check_refused({"intersct", first}, "\"intersct\" is no command; did you mean intersect?");
  check_refused({"verfy"}, "did you mean verify?");
  check_refused({first}, "is no command; these are: intersect, line, ");
  check_refused({"intersect", first, "--tolerence", "1e-3"}, "did you mean --tolerance?");
  check_refused({"intersect", first, "--tolerence=1e-3"}, "did you mean --tolerance?");
  check_refused({"intersect", first, "--tol", "1e-3"},
                "did you mean --tolerance? (see exsect intersect --help)");
  check_refused({"--verson"}, "did you mean --version? (see exsect --help)");
  check_refused({"batch", "-"}, "INPUT: the standard input cannot be read again");
  check_refused({"help", "intersct"}, "did you mean intersect?");
}

TEST_CASE("help is what --help shows") {
  for (const std::vector<std::string>& words : {std::vector<std::string>{}, {"intersect"}, {"batch-merge"}}) {
    std::vector<std::string> help = {"help"};
    help.insert(help.end(), words.begin(), words.end());
    std::vector<std::string> option = words;
    option.emplace_back("--help");
    const ProgramRun run = run_program(help);
    CHECK(run.status == 0);
    CHECK(run.out == run_program(option).out);
    CHECK(run.out.size() > 400);
  }
}

TEST_CASE("the standard input is a file by the name -") {
  const auto piped = [](const std::string& file, const std::string& command) {
    const ScratchDirectory scratch;
    const std::string line = "cat " + quoted(file) + " | " + quoted(EXSECT_PROGRAM) + " " + command + " >" +
                             quoted(scratch.path("out")) + " 2>" + quoted(scratch.path("err"));
    const int ended = std::system(line.c_str());
    return ProgramRun{WEXITSTATUS(ended), content(scratch.path("out")), content(scratch.path("err"))};
  };
  const ProgramRun run = piped(first, "intersect -");
  CHECK(run.status == 0);
  CHECK(run.out.starts_with("standard input: First example"));
  CHECK(piped(first, "line - --u 1/2").status == 0);
  CHECK(piped(example("profile.json"), "implicitize -").status == 0);
  CHECK(piped(example("profile.json"), "revolve - --method product").status == 0);
  CHECK(piped(example("profile.json"), "intersect -").err ==
        "exsect: standard input: $.exsect: holds a curve, curve/1; needed is patches/1\n");
  const std::string right = example("candidates/sisl-right");
  CHECK(
      piped(right + ".candidate.json", "verify - " + quoted(right + ".json") + " --tolerance 1e-4").status ==
      0);
  CHECK(
      piped(right + ".json", "verify " + quoted(right + ".candidate.json") + " - --tolerance 1e-4").status ==
      0);
  CHECK(piped(right + ".json", "verify - -").err ==
        "exsect: CANDIDATE and FILE cannot both be the standard input\n");
  const ScratchDirectory scratch;
  const std::string closed = quoted(EXSECT_PROGRAM) + " intersect - <&- 2>" + quoted(scratch.path("closed"));
  CHECK(WEXITSTATUS(std::system(closed.c_str())) == 2);
  CHECK(content(scratch.path("closed")).starts_with("exsect: standard input: cannot be opened"));
  const std::string proof = scratch.path("proof.json");
  REQUIRE(run_program({"intersect", first, "--certificate", proof, "--quiet"}).status == 0);
  CHECK(piped(proof, "check -").status == 0);
}

TEST_CASE("files of another kind are refused by what they hold") {
  const std::string pair = example("candidates/sisl-right");
  check_refused({"verify", pair + ".json", pair + ".candidate.json"},
                pair + ".json holds patches, not a candidate: are CANDIDATE and FILE the other way round?");
  check_refused({"intersect", example("profile.json")},
                "$.exsect: holds a curve, curve/1; needed is patches/1");
  check_refused({"revolve", first, "--method", "product"},
                "$.exsect: holds patches, patches/1; needed is curve/1");
  check_refused({"implicitize", pair + ".candidate.json"}, "holds curves of another program, candidate/1");
}

TEST_CASE("a line needs one parameter in [0,1]") {
  check_refused({"line", first}, "give one of --u, --v, --r, --s");
  check_refused({"line", first, "--u", "1/2", "--v", "1/2"}, "only one of");
  check_refused({"line", first, "--u", "1/2", "--u", "1/3"}, "--u");
  for (const char* text : {"3/2", "-1/2", "1.0000001", "-0x1p-1000"}) {
    check_refused({"line", first, "--r=" + std::string(text)}, "is not in [0,1]");
  }
  for (const char* text : {"half", "1/0", "1/-2", "0.5.5", "nan", ".5", "1//2", "0x1", "1 /2"}) {
    check_refused({"line", first, "--s=" + std::string(text)}, "--s: ");
  }
  check_refused({"line", first, "--u", "-1/2"}, "");
}

TEST_CASE("a file that is no patch file is refused with path and reason") {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("in.json");
  check_refused({"intersect", file}, file + ": cannot be opened");
  check_refused({"intersect", scratch.path("")}, "is a directory");
  const auto refused = [&](const std::string& text, const std::string& reason) {
    write(file, text);
    check_refused({"intersect", file}, file + ": " + reason);
    check_refused({"line", file, "--u", "0"}, file + ": " + reason);
  };
  const std::string x = R"({"name": "x", )" + patch;
  const std::string y = R"({"name": "y", )" + patch;
  refused("", "");
  refused("{", "");
  refused(patches(x + "," + x), "$.patches[1].name: ");
  refused(
      patches(R"({"name": "x", "degree": [1,1], "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,"1/0"]]]},)" + y),
      "$.patches[0].points[1][1][2]: ");
  refused(
      patches(R"({"name": "x", "degree": [1,1], "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,NaN]]]},)" + y),
      "");
  refused(patches(R"({"name": "x", "degree": [4,1], "points": []},)" + y),
          "$.patches[0].degree[0]: degree 4");
  refused(patches(x + "," + y) + "}", "");
  refused(patches(x), "$.patches: holds one patch; two are needed");
  refused(patches(x + "," + y + R"(, {"name": "z", )" + patch), "$.patches: holds 3 patches");
}

TEST_CASE("patches are chosen by name") {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("three.json");
  write(file,
        patches(R"({"name": "a", )" + patch + R"(,{"name": "b", )" + patch + R"(,{"name": "c", )" + patch));
  check_refused({"intersect", file, "--first", "a"}, "choose with --first and --second");
  check_refused({"intersect", file, "--first", "a", "--second", "a"},
                "$.patches: --first and --second both name \"a\"");
  check_refused({"intersect", file, "--first", "a", "--second", "d"}, "--second: no patch is named \"d\"");
  check_refused({"line", file, "--u", "0", "--first", "\x1b[31m", "--second", "a"},
                "no patch is named \" [31m\"");
  const ProgramRun chosen = run_program({"line", file, "--u", "0", "--first", "c", "--second", "a"});
  CHECK(chosen.status == 0);
}

TEST_CASE("output that cannot be written is refused before anything is printed") {
  const ScratchDirectory scratch;
  const std::string missing = scratch.path("missing/out.json");
  for (const char* option : {"--json", "--svg", "--report", "--obj", "--ply", "--vtp", "--csv"}) {
    check_refused({"intersect", first, option, missing},
                  missing + ": cannot be written: there is no such directory");
    check_refused({"intersect", first, option, scratch.path("")}, "it is a directory");
    check_refused({"line", first, "--u", "0", option, missing}, "there is no such directory");
  }
  CHECK(scratch.number_of_files() == 0);
  const std::string both = scratch.path("both");
  check_refused({"intersect", first, "--json", both, "--svg", both}, "--json and --svg: both name");
  check_refused({"intersect", first, "--json", both, "--svg", scratch.path("./both")}, "both name");
  check_refused({"intersect", first, "--svg", "-"}, "--svg: needs a file");
  check_refused({"line", first, "--u", "0", "--csv", "-"}, "--csv: needs a file");
  check_refused({"intersect", first, "--report", "-"}, "--report: needs a file");
  check_refused({"self", first, "--patch", "x", "--svg", both, "--report", both},
                "--svg and --report: both name");
  check_refused({"self", first, "--patch", "x", "--vtp", both, "--ply", both}, "--ply and --vtp: both name");
  for (const char* cells : {"0", "513", "many", "-1"})
    check_refused({"intersect", first, "--obj", both, "--grid=" + std::string(cells)}, "--grid: ");
  const std::string copy = scratch.path("copy.json");
  std::filesystem::copy_file(first, copy);
  check_refused({"intersect", copy, "--json", copy}, "is the input file");
  std::filesystem::create_symlink(copy, scratch.path("link"));
  check_refused({"intersect", copy, "--json", scratch.path("link")}, "is the input file");
  CHECK(content(copy) == content(first));
  CHECK(scratch.number_of_files() == 2);
}

TEST_CASE("the commands write files for other tools") {
  const ScratchDirectory scratch;
  const auto exports = [&](std::vector<std::string> arguments) {
    for (const char* format : {"obj", "ply", "vtp", "csv"}) {
      arguments.push_back("--" + std::string(format));
      arguments.push_back(scratch.path(format));
    }
    CHECK(run_program(arguments).status == 0);
    CHECK(content(scratch.path("obj")).starts_with("# exsect: "));
    CHECK(content(scratch.path("ply")).starts_with("ply\n"));
    CHECK(content(scratch.path("vtp")).starts_with("<?xml"));
    CHECK(content(scratch.path("csv")).starts_with("id,"));
  };
  exports({"intersect", first});
  CHECK(content(scratch.path("obj")).find("\no arc_0_transversal_interior\n") != std::string::npos);
  exports({"line", first, "--u", "1/2", "--grid", "3"});
  CHECK(content(scratch.path("ply")).find("\nelement face 18\n") != std::string::npos);
  exports({"self", example("chapter9-second.json"), "--patch", "x"});
  CHECK(content(scratch.path("csv")).find(",u1_lower,u1_upper,") != std::string::npos);
  CHECK(scratch.number_of_files() == 4);
}

TEST_CASE("a full device is reported") {
  if (!std::filesystem::exists("/dev/full")) return;
  const ProgramRun to_stdout = run_program({"line", first, "--u", "1/2"}, "/dev/full");
  CHECK(to_stdout.status == 2);
  CHECK(to_stdout.err == "exsect: the standard output cannot be written\n");
  check_refused({"line", first, "--u", "1/2", "--json", "/dev/full"}, "/dev/full: cannot be written");
}

TEST_CASE("bad input leaves existing output alone") {
  const ScratchDirectory scratch;
  const std::string out = scratch.path("out.json");
  write(out, "precious");
  check_refused({"intersect", scratch.path("missing.json"), "--json", out}, "cannot be opened");
  CHECK(content(out) == "precious");
  CHECK(scratch.number_of_files() == 1);
}

}  // namespace
}  // namespace exsect::program_test
