// Tables from the lines of all programs. PAIRS REFERENCE OTHER...: files of pairs and of results; exsect's
// results are the reference. Markdown on the standard output.
//
//     --verdicts FILE   one line of JSON for each pair and program
//     --lines           results of line queries
//     --save PAIR PROGRAM DIRECTORY NAME   writes NAME.json and NAME.candidate.json: the pair and the answer
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>

#include "judge.h"

namespace peers {
namespace {

using nlohmann::json;

/// One line of results.
struct Result {
  std::string name;
  std::string program;
  json line;

  bool done() const { return line.at("status") == "done"; }
  double milliseconds() const { return done() ? line.at("milliseconds").get<double>() : 0; }
};

std::vector<Result> read_results(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::vector<Result> results;
  for (std::string text; std::getline(file, text);) {
    json line = json::parse(text);
    results.push_back({line.at("name"), line.at("program"), line});
  }
  return results;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string family(const std::string& name) { return name.substr(0, name.find('/')); }

/// What one program did in one family.
struct Row {
  int pairs = 0;
  int answered = 0;
  int timeouts = 0;
  int failed = 0;  // crash or error
  int judged = 0;  // answered, and the reference is complete
  int right = 0;
  double bound = 0;
  double worst = 0;
  std::vector<double> times;
  std::vector<double> ratios;  // exsect's time over this program's, both answered
  Verdict sum;
};

struct Tables {
  std::map<std::string, PatchPair> pairs;
  std::map<std::string, Result> references;
  std::vector<std::string> families;
  std::vector<std::string> programs;
  std::map<std::pair<std::string, std::string>, Row> rows;

  Row& row(const Result& result) {
    const auto remember = [](std::vector<std::string>& list, const std::string& text) {
      if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
    };
    remember(families, family(result.name));
    remember(programs, result.program);
    return rows[{family(result.name), result.program}];
  }
};

/// Times and outcome; true if there is an answer.
bool count(const Result& result, Row& row) {
  ++row.pairs;
  if (!result.done()) {
    ++(result.line.at("status") == "timeout" ? row.timeouts : row.failed);
    return false;
  }
  ++row.answered;
  row.times.push_back(result.milliseconds());
  row.worst = std::max(row.worst, result.milliseconds());
  return true;
}

void count_reference(const Result& result, Row& row) {
  if (!count(result, row)) return;
  const Reference reference = reference_from_json(result.line.at("reference"));
  if (reference.complete) {
    ++row.judged;
    ++row.right;
    row.sum.components += static_cast<int>(reference.components.size());
    row.sum.found += static_cast<int>(reference.components.size());
    row.sum.isolated += static_cast<int>(reference.isolated.size());
    row.sum.isolated_found += static_cast<int>(reference.isolated.size());
  }
  row.bound = std::max(row.bound, result.line.at("bound").get<double>());
  row.sum.residual = std::max(row.sum.residual, result.line.at("residual").get<double>());
  row.sum.distance = std::max(row.sum.distance, result.line.at("distance").get<double>());
}

/// Of a peer, or of exsect in another mode.
Answer answer(const Result& result) {
  if (!result.line.contains("reference")) return answer_from_json(result.line);
  const Reference reference = reference_from_json(result.line.at("reference"));
  Answer all = {{}, reference.isolated};
  for (const Component& component : reference.components) {
    all.curves.insert(all.curves.end(), component.curves.begin(), component.curves.end());
  }
  return all;
}

/// The verdict, if both answered and the reference is complete.
std::optional<Verdict> verdict(const Tables& tables, const Result& result) {
  const Result& proved = tables.references.at(result.name);
  if (!result.done() || !proved.done()) return std::nullopt;
  const Reference reference = reference_from_json(proved.line.at("reference"));
  if (!reference.complete) return std::nullopt;
  return judge(tables.pairs.at(result.name), reference, answer(result));
}

void count_other(const Tables& tables, const Result& result, Row& row, std::ostream* verdicts) {
  if (!count(result, row)) return;
  const Result& proved = tables.references.at(result.name);
  if (proved.done()) row.ratios.push_back(proved.milliseconds() / std::max(result.milliseconds(), 1e-6));
  const auto judged = verdict(tables, result);
  if (!judged) return;
  ++row.judged;
  if (judged->right()) ++row.right;
  row.sum += *judged;
  const double asked = result.line.at("tolerance").get<double>() * tables.pairs.at(result.name).size();
  row.bound = std::max(row.bound, result.line.value("bound", asked));
  if (verdicts == nullptr) return;
  *verdicts << json{{"name", result.name},
                    {"program", result.program},
                    {"right", judged->right()},
                    {"components", judged->components},
                    {"found", judged->found},
                    {"partly", judged->partly},
                    {"lost", judged->lost},
                    {"as_points", judged->as_points},
                    {"isolated", judged->isolated},
                    {"isolated_found", judged->isolated_found},
                    {"invented_curves", judged->invented_curves},
                    {"invented_points", judged->invented_points},
                    {"wrong_connections", judged->wrong_connections}}
                   .dump()
            << "\n";
}

void print(const Tables& tables) {
  for (const std::string& name : tables.families) {
    const Row& proved = tables.rows.at({name, tables.programs.front()});
    fmt::print("\n**{}**: {} pairs, {} curves and {} touch points in the {} that exsect completes\n\n", name,
               proved.pairs, proved.sum.components, proved.sum.isolated, proved.judged);
    fmt::print(
        "| program | answered | time-outs / errors | right | median / worst ms | exsect/peer | found / "
        "partly / lost | "
        "as points | invented curves / points | wrong connections | touch points | residual | bound | "
        "distance |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const std::string& program : tables.programs) {
      const Row& row = tables.rows.at({name, program});
      const Verdict& sum = row.sum;
      const std::string ratio = row.ratios.empty() ? "" : fmt::format("{:.2g}", median(row.ratios));
      fmt::print(
          "| {} | {} | {} / {} | {} of {} | {:.3g} / {:.3g} | {} | {} / {} / {} | {} | {} / {} | {} | {} | "
          "{:.0e} | {:.0e} | {:.0e} |\n",
          program, row.answered, row.timeouts, row.failed, row.right, row.judged, median(row.times),
          row.worst, ratio, sum.found, sum.partly, sum.lost, sum.as_points, sum.invented_curves,
          sum.invented_points, sum.wrong_connections, sum.isolated_found, sum.residual, row.bound,
          sum.distance);
    }
  }
}

/// The results of line queries: microseconds a query.
void print_lines(const Tables& tables, const std::vector<Result>& others) {
  constexpr double queries = 15;
  struct LineRow {
    std::vector<double> times;
    LineVerdict sum;
    int failed = 0;
  };
  std::map<std::pair<std::string, std::string>, LineRow> rows;
  const auto add = [&](const Result& result) {
    LineRow& row = rows[{family(result.name), result.program}];
    const Result& proved = tables.references.at(result.name);
    if (!result.done() || !proved.done()) {
      ++row.failed;
      return;
    }
    row.times.push_back(1e3 * result.milliseconds() / queries);
    const auto points = [](const Result& r) {
      return r.line.at("lines").get<std::vector<std::vector<Point>>>();
    };
    const LineVerdict verdict = judge_lines(points(proved), points(result));
    row.sum.points += verdict.points;
    row.sum.lost += verdict.lost;
    row.sum.invented += verdict.invented;
  };
  for (const auto& [name, result] : tables.references) add(result);
  for (const Result& result : others) add(result);
  fmt::print(
      "\n| family | program | pairs failed | median µs a line | worst µs | points | lost | invented |\n");
  fmt::print("|---|---|---|---|---|---|---|---|\n");
  for (const auto& [key, row] : rows) {
    const double worst = row.times.empty() ? 0 : *std::max_element(row.times.begin(), row.times.end());
    fmt::print("| {} | {} | {} | {:.0f} | {:.0f} | {} | {} | {} |\n", key.first, key.second, row.failed,
               median(row.times), worst, row.sum.points, row.sum.lost, row.sum.invented);
  }
}

struct Save {
  std::string pair;
  std::string program;
  std::string directory;
  std::string name;
};

/// The line of the pair, and the answer as candidate/1.
void save(const Save& wanted, const std::string& pairs, const std::vector<Result>& results) {
  constexpr std::size_t most_vertices = 200;
  const auto write = [&](const std::string& name, const nlohmann::ordered_json& content) {
    std::ofstream(wanted.directory + "/" + name) << content.dump() << "\n";
  };
  std::ifstream file(pairs);
  for (std::string line; std::getline(file, line);) {
    nlohmann::ordered_json pair = nlohmann::ordered_json::parse(line);
    if (pair.at("title") == wanted.pair) write(wanted.name + ".json", pair);
  }
  for (const Result& result : results) {
    if (result.name != wanted.pair || result.program != wanted.program) continue;
    Answer answer = answer_from_json(result.line);
    for (Curve& curve : answer.curves) curve = thinned(curve, most_vertices);
    nlohmann::ordered_json candidate = {
        {"exsect", "candidate/1"}, {"patches", {"x", "y"}}, {"source", wanted.program}};
    candidate.update(to_json(answer));
    write(wanted.name + ".candidate.json", candidate);
  }
}

struct Arguments {
  std::vector<std::string> files;
  std::string verdicts;
  bool lines = false;
  std::optional<Save> save;
};

Arguments parse(int argc, char** argv) {
  Arguments arguments;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--verdicts") {
      arguments.verdicts = words.at(++i);
    } else if (words[i] == "--lines") {
      arguments.lines = true;
    } else if (words[i] == "--save") {
      arguments.save = {words.at(i + 1), words.at(i + 2), words.at(i + 3), words.at(i + 4)};
      i += 4;
    } else {
      arguments.files.push_back(words[i]);
    }
  }
  if (arguments.files.size() < 2) throw std::invalid_argument("usage: PAIRS REFERENCE OTHER...");
  return arguments;
}

void compare(const Arguments& arguments) {
  Tables tables;
  for (PatchPair& pair : read_pairs(arguments.files[0])) tables.pairs.emplace(pair.name, pair);
  const std::vector<Result> references = read_results(arguments.files[1]);
  for (const Result& result : references) tables.references.emplace(result.name, result);
  std::vector<Result> others;
  for (std::size_t i = 2; i < arguments.files.size(); ++i) {
    const std::vector<Result> more = read_results(arguments.files[i]);
    others.insert(others.end(), more.begin(), more.end());
  }
  if (arguments.save) return save(*arguments.save, arguments.files[0], others);
  if (arguments.lines) return print_lines(tables, others);
  std::ofstream verdicts;
  if (!arguments.verdicts.empty()) verdicts.open(arguments.verdicts);
  for (const Result& result : references) count_reference(result, tables.row(result));
  for (const Result& result : others) {
    count_other(tables, result, tables.row(result), verdicts.is_open() ? &verdicts : nullptr);
  }
  print(tables);
}

}  // namespace
}  // namespace peers

int main(int argc, char** argv) {
  try {
    peers::compare(peers::parse(argc, argv));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << argv[0] << ": " << error.what() << "\n";
    return 2;
  }
}
