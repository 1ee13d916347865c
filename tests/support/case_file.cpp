#include "support/case_file.h"

#include <exsect/geometry/patch_file.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace exsect {
namespace {

using Json = nlohmann::ordered_json;

Json json(const RealAlgebraic& a) {
  if (a.is_rational()) return a.rational().str();
  Json coefficients = Json::array();
  for (const Rational& c : a.polynomial().coefficients()) coefficients.push_back(c.str());
  return {{"root_of", coefficients}, {"between", {a.interval().lower.str(), a.interval().upper.str()}}};
}

RealAlgebraic number(const Json& json) {
  if (json.is_string()) return {Rational(json.get<std::string>())};
  std::vector<Rational> coefficients;
  for (const Json& c : json.at("root_of")) coefficients.emplace_back(c.get<std::string>());
  const Json& between = json.at("between");
  return RealAlgebraic::root_of(Polynomial(coefficients), {Rational(between.at(0).get<std::string>()),
                                                           Rational(between.at(1).get<std::string>())});
}

Json json(const std::vector<Parameter>& list) {
  Json result = Json::array();
  for (const Parameter p : list) result.push_back(name(p));
  return result;
}

std::vector<Parameter> parameters(const Json& json) {
  std::vector<Parameter> result;
  for (const Json& entry : json) {
    for (const Parameter p : all_parameters) {
      if (entry == name(p)) result.push_back(p);
    }
  }
  return result;
}

/// The one of the values that has this name.
template <typename Value>
Value named(const Json& json, std::initializer_list<Value> values) {
  for (const Value value : values) {
    if (json == name(value)) return value;
  }
  throw std::runtime_error("unknown name " + json.dump());
}

Json json(const ExactNode& node) {
  Json at = Json::array();
  for (const RealAlgebraic& a : node.at) at.push_back(json(a));
  Json result = {{"at", at}};
  if (node.kind) result["kind"] = name(*node.kind);
  if (!node.wrt.empty()) result["wrt"] = json(node.wrt);
  if (!node.free.empty()) result["free"] = json(node.free);
  return result;
}

ExactNode node(const Json& json) {
  ExactNode result = {{number(json.at("at").at(0)), number(json.at("at").at(1)), number(json.at("at").at(2)),
                       number(json.at("at").at(3))}};
  using enum NodeKind;
  if (json.contains("kind")) result.kind = named(json.at("kind"), {touch, crossing, cusp, end_of_overlap});
  if (json.contains("wrt")) result.wrt = parameters(json.at("wrt"));
  if (json.contains("free")) result.free = parameters(json.at("free"));
  return result;
}

Json json(const ExactArc& arc) {
  return {{"from", arc.from},
          {"to", arc.to},
          {"on", name(arc.place)},
          {"contact", name(arc.contact)},
          {"samples", arc.samples}};
}

ExactArc arc(const Json& json) {
  return {json.at("from").get<std::size_t>(), json.at("to").get<std::size_t>(),
          named(json.at("on"), {ArcPlace::interior, ArcPlace::patch_boundary}),
          named(json.at("contact"), {Contact::transversal, Contact::tangential}),
          json.at("samples").get<std::vector<std::array<double, 4>>>()};
}

Json json(const std::vector<ExactArc>& chain);
Json json(const std::vector<std::vector<ExactArc>>& chains);

template <typename Item>
Json list(const std::vector<Item>& items) {
  Json result = Json::array();
  for (const Item& item : items) result.push_back(json(item));
  return result;
}

Json json(const std::vector<ExactArc>& chain) { return list(chain); }
Json json(const std::vector<std::vector<ExactArc>>& chains) { return list(chains); }

}  // namespace

std::string case_stem(const ExactCase& c) {
  std::string stem = c.name;
  std::transform(stem.begin(), stem.end(), stem.begin(), [](unsigned char letter) {
    return letter == ' ' ? '-' : static_cast<char>(std::tolower(letter));
  });
  return stem;
}

std::string patches_text(const ExactCase& c) {
  return format_patches({c.name, "", {{"x", {2, 2}, c.x}, {"y", {2, 2}, c.y}}});
}

std::string expected_text(const ExactCase& c) {
  const Json expected = {{"case", case_stem(c) + ".json"},
                         {"turning", json(c.turning)},
                         {"nodes", list(c.graph.nodes)},
                         {"arcs", list(c.graph.arcs)},
                         {"overlaps", list(c.graph.overlaps)}};
  return expected.dump(1) + "\n";
}

ExactCase parse_case(const std::string& patches, const std::string& expected) {
  const PatchFile pair = parse_patches(patches, "patches");
  const Json answer = Json::parse(expected);
  ExactCase c = {pair.title, pair.patches.at(0).patch, pair.patches.at(1).patch, {}};
  c.turning = parameters(answer.at("turning"));
  for (const Json& n : answer.at("nodes")) c.graph.nodes.push_back(node(n));
  for (const Json& a : answer.at("arcs")) c.graph.arcs.push_back(arc(a));
  for (const Json& overlap : answer.at("overlaps")) {
    auto& chains = c.graph.overlaps.emplace_back();
    for (const Json& chain : overlap) {
      auto& arcs = chains.emplace_back();
      for (const Json& a : chain) arcs.push_back(arc(a));
    }
  }
  return c;
}

ExactCase read_case(const std::string& path) {
  const std::string stem = path.substr(0, path.size() - std::string(".json").size());
  return parse_case(read_text_file(path, max_patch_file_bytes),
                    read_text_file(stem + ".expected.json", max_patch_file_bytes));
}

}  // namespace exsect
