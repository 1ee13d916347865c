#include "output/report/report_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

using Counts = std::vector<std::pair<std::string, std::string>>;

std::string text_of(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

std::string number_text(const Json& object, const char* key) { return text_of(object.at(key)); }

/// The graph stands in the result itself, or beside a verdict or a comparison.
const Json& graph_of(const Json& data) { return data.contains("graph") ? data["graph"] : data["result"]; }

std::string patch_name(const Json& data, std::size_t which) {
  return data["patches"].at(which)["name"].get<std::string>();
}

/// "2 components (1 open, 1 closed), 1 isolated point".
std::string shapes(const Json& graph) {
  const Json& summary = graph["summary"];
  std::vector<std::string> parts;
  for (const char* shape : {"closed", "open", "branched"})
    if (summary[shape].get<std::size_t>() > 0) parts.push_back(number_text(summary, shape) + " " + shape);
  std::string text = counted(summary["components"].get<std::size_t>(), "component");
  if (!parts.empty()) text += " (" + joined(parts, ", ") + ")";
  for (const auto& [key, noun] : {std::pair("isolated", "isolated point"), std::pair("overlaps", "overlap")})
    if (const auto number = summary[key].get<std::size_t>()) text += ", " + counted(number, noun);
  return text;
}

/// Of all polylines, rims of overlaps included.
double largest_bound(const Json& graph) {
  double largest = 0;
  for (const Json& arc : graph["arcs"]) largest = std::max(largest, arc["error_bound"].get<double>());
  for (const Json& overlap : graph["overlaps"])
    for (const Json& chain : overlap["chains"])
      for (const Json& arc : chain) largest = std::max(largest, arc["error_bound"].get<double>());
  return largest;
}

Counts graph_counts(const Json& graph) {
  const Json& summary = graph["summary"];
  Counts counts = {{"nodes", std::to_string(graph["nodes"].size())},
                   {"arcs", std::to_string(graph["arcs"].size())},
                   {"boundary points", number_text(summary, "boundary")}};
  for (const auto& [parameter, number] : summary["turning"].items())
    counts.emplace_back("turning in " + parameter, text_of(number));
  counts.emplace_back("polylines within, proved", rounded_up(largest_bound(graph)));
  counts.emplace_back("computed in", duration_text(graph["work"]["milliseconds"].get<double>()));
  return counts;
}

std::string equation_name(const Json& equation) {
  return "the " + equation["kind"].get<std::string>() + " " + equation["name"].get<std::string>();
}

/// What two surfaces, each a patch or given by its equation, have in common.
std::string intersection_answer(const Json& data) {
  const Json equations = data.value("equations", Json::array());
  if (equations.empty())
    return fmt::format("Patches {} and {} intersect in {}", patch_name(data, 0), patch_name(data, 1),
                       shapes(graph_of(data)));
  if (equations.size() == 1)
    return fmt::format("Patch {} and {} intersect in {}", patch_name(data, 0), equation_name(equations[0]),
                       shapes(graph_of(data)));
  return fmt::format("In common of {} and {}: {}", equation_name(equations[0]), equation_name(equations[1]),
                     number_text(data["result"], "summary"));
}

/// Of two surfaces given by their equations.
Counts surfaces_counts(const Json& result) {
  double largest = 0;
  for (const Json& arc : result["arcs"]) largest = std::max(largest, arc["error_bound"].get<double>());
  return {{"curves", std::to_string(result["curves"].size())},
          {"nodes", std::to_string(result["nodes"].size())},
          {"arcs", std::to_string(result["arcs"].size())},
          {"polylines within, proved", rounded_up(largest)},
          {"computed in", duration_text(result["work"]["milliseconds"].get<double>())}};
}

Counts line_counts(const Json& data) {
  const Json& result = data["result"];
  if (result["pullback"].contains("cubic"))
    return {{"points", std::to_string(result["points"].size())},
            {"shape of the line", number_text(result, "shape")}};
  return {{"points", std::to_string(result["points"].size())},
          {"phantom roots", std::to_string(data["fibres"][0]["phantoms"].size())},
          {"shape of the line", number_text(result, "shape")},
          {"degree of the eliminant", number_text(result["eliminant"], "degree")}};
}

std::string line_answer(const Json& result) {
  const auto fixed = result["fixed"].items().begin();
  const std::size_t pieces = result["on_patch"].size();
  return fmt::format("The line {} = {} meets the other patch in {}{}.", fixed.key(), text_of(fixed.value()),
                     counted(result["points"].size(), "point"),
                     pieces == 0 ? "" : " and " + counted(pieces, "piece"));
}

/// The smallest statement that holds in both directions, else in one.
const Json* proved_distance(const Json& result) {
  const Json* best = nullptr;
  for (const char* name : {"one-sided", "two-sided"})
    for (const Json& statement : result["proved"])
      if (statement["name"] == name && statement.contains("approx") && statement["approx"].is_number())
        best = &statement;
  return best;
}

/// Of implicit equations and surfaces of revolution; the distance is called by the name of its statement.
std::string equation_answer(const Json& data) {
  const Json& result = data["result"];
  const bool revolved = data["command"] == "revolve";
  const Json& equations = result["equations"];
  std::string text = result["exact"].get<bool>() ? "Exact " : "Approximate ";
  text += revolved                ? "surface of revolution by " + number_text(result, "method")
          : equations.size() == 1 ? "implicit equation"
                                  : "implicit equations";
  if (!equations.empty()) text += " of degree " + number_text(equations.back(), "degree");
  if (result["exact"].get<bool>()) return text + ".";
  const Json* distance = proved_distance(result);
  if (distance == nullptr) return text + ".";
  return text + fmt::format("; {} distance at most {}.", number_text(*distance, "name"),
                            rounded_up((*distance)["approx"].get<double>()));
}

Counts equation_counts(const Json& data) {
  const Json& result = data["result"];
  Counts counts = {{"method", number_text(result, "method")},
                   {"equation", result["exact"].get<bool>() ? "exact" : "approximate"}};
  if (result.contains("rings"))
    counts.emplace_back("singular rings",
                        result["rings"].is_array() ? std::to_string(result["rings"].size()) : "none");
  const char* of = data["command"] == "revolve" ? "degree of the " : "degree of ";
  for (const Json& equation : result["equations"])
    counts.emplace_back(of + number_text(equation, "name"), number_text(equation, "degree"));
  for (const Json& statement : result["proved"])
    if (statement.contains("approx") && statement["approx"].is_number() &&
        (statement["name"] == "one-sided" || statement["name"] == "two-sided"))
      counts.emplace_back(number_text(statement, "name") + " distance",
                          rounded_up(statement["approx"].get<double>()));
  return counts;
}

std::string verdict_answer(const Json& data) {
  const Json& result = data["result"];
  const std::size_t points = data["candidate"]["points"].size();
  const std::string source = number_text(result, "source");
  const std::string claimed = fmt::format("The candidate{}, {}{}", source.empty() ? "" : " of " + source,
                                          counted(data["candidate"]["curves"].size(), "curve"),
                                          points == 0 ? "" : " and " + counted(points, "point"));
  if (result["verdict"] == "agrees")
    return fmt::format("{}, is within {} of the true curve and joined in the same way.", claimed,
                       rounded_up(result["tolerance"].get<double>()));
  if (result["verdict"] == "disagrees")
    return fmt::format("{}, differs from the true curve in {}.", claimed,
                       counted(result["differences"].size(), "way"));
  std::vector<std::string> reasons;
  for (const Json& reason : result["undecided"]) reasons.push_back(reason.get<std::string>());
  return claimed + ": " + (reasons.empty() ? "not decided" : joined(reasons, "; ")) + ".";
}

Counts verdict_counts(const Json& data) {
  return {{"components", std::to_string(data["result"]["components"].size())},
          {"curves claimed", std::to_string(data["candidate"]["curves"].size())},
          {"points claimed", std::to_string(data["candidate"]["points"].size())},
          {"differences", std::to_string(data["result"]["differences"].size())},
          {"tolerance", rounded_up(data["result"]["tolerance"].get<double>())}};
}

void say(const std::string& command, const Json& data, ReportWords& words) {
  const Json& result = data["result"];
  if (command == "intersect" || command == "compare") {
    words.answer = intersection_answer(data);
    words.counts = result["exsect"] == "surfaces/1" ? surfaces_counts(result) : graph_counts(graph_of(data));
  }
  if (command == "intersect") words.answer += ".";
  if (command == "self") {
    words.answer = fmt::format("Patch {} meets itself in {}.", patch_name(data, 0), shapes(result));
    words.counts = graph_counts(result);
  }
  if (command == "compare") {
    words.answer += fmt::format("; {} methods side by side.", result["methods"].size());
    words.counts = {{"components", number_text(graph_of(data)["summary"], "components")},
                    {"methods", std::to_string(result["methods"].size())},
                    {"check lines", number_text(result, "check_lines")}};
  }
  if (command == "line") {
    words.answer = line_answer(result);
    words.counts = line_counts(data);
  }
  if (command == "implicitize" || command == "revolve") {
    words.answer = equation_answer(data);
    words.counts = equation_counts(data);
  }
  if (command == "verify") {
    words.answer = verdict_answer(data);
    words.counts = verdict_counts(data);
  }
}

std::string verdict(const std::string& command, const Json& result) {
  if (result.contains("verdict"))
    return result["verdict"] == "agrees"      ? "Agrees, proved."
           : result["verdict"] == "disagrees" ? "Disagrees, proved."
                                              : "Not decided.";
  if (result.value("status", "") != "complete") return "Incomplete.";
  if (command == "compare") return "Complete.";
  if (result.contains("proved") && result["exact"] == false)
    return proved_distance(result) != nullptr ? "Approximate; distance proved."
                                              : "Approximate; bounds proved.";
  return "Complete, proved.";
}

}  // namespace

std::string duration_text(double milliseconds) {
  if (milliseconds >= 9999.5) return fmt::format("{:.0f} s", milliseconds / 1000);
  if (milliseconds >= 999.5) return fmt::format("{:.1f} s", milliseconds / 1000);
  if (milliseconds >= 9.95) return fmt::format("{:.0f} ms", milliseconds);
  return fmt::format("{:.2g} ms", milliseconds);
}

ReportWords report_words(const Json& data) {
  const auto command = data.value("command", std::string());
  ReportWords words = {true, "", "", "", {}};
  if (!data.contains("result")) return words;
  const Json& result = data["result"];
  words.good =
      result.contains("verdict") ? result["verdict"] == "agrees" : result.value("status", "") == "complete";
  words.verdict = verdict(command, result);
  words.origin = "exsect " + command;
  if (const auto file = data.value("file", std::string()); !file.empty()) words.origin += " \u00b7 " + file;
  say(command, data, words);
  return words;
}

}  // namespace exsect::cli
