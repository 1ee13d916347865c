// What tests of certificates share: writing them, changing them, the verdict of the checker.
#pragma once

#include <exsect/checker/check_certificate.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "certificate/certificate_text.h"
#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::certificates {

using Json = nlohmann::ordered_json;
using checker::check_certificate;
using checker::Rejected;
using checker::Unreadable;

inline const cli::PatchNames names = {"x", "y"};

/// With few vertices: the tests need small certificates.
inline IntersectOptions coarse() {
  IntersectOptions options;
  options.tolerance = 1e-2;
  return options;
}

inline std::string certificate(const BezierPatch& x, const BezierPatch& y) {
  return cli::certificate_text(x, y, names, intersect(x, y, coarse()));
}
/// Of patches of any kind.
inline std::string certificate(const RationalPatch& x, const RationalPatch& y) {
  return cli::certificate_text(x, y, names, intersect(x, y, coarse()));
}

/// Where and why, or nothing if the certificate is accepted.
inline std::string verdict(const std::string& text) {
  try {
    check_certificate(text);
    return "";
  } catch (const Rejected& rejected) {
    CHECK(!rejected.place().empty());
    return rejected.place() + ": " + rejected.what();
  } catch (const Unreadable& unreadable) {
    return std::string("unreadable: ") + unreadable.what();
  }
}

using Generator = random_pairs::Generator;

inline std::size_t below(Generator& generator, std::size_t n) {
  return static_cast<std::size_t>(random_pairs::integer(generator, 0, static_cast<long>(n) - 1));
}

/// Another digit, or the other sign, in a number.
inline std::string other_number(std::string text, Generator& generator) {
  if (below(generator, 5) == 0) return text[0] == '-' ? text.substr(1) : "-" + text;
  std::vector<std::size_t> digits;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] >= '0' && text[i] <= '9') digits.push_back(i);
  char& digit = text[digits[below(generator, digits.size())]];
  digit = static_cast<char>('0' + (digit - '0' + 1 + static_cast<int>(below(generator, 9))) % 10);
  return text;
}

/// Every leaf below `json` but seals.
inline void collect(Json& json, std::vector<Json*>& leaves, bool seals) {
  if (!json.is_structured()) return leaves.push_back(&json);
  for (auto& [key, value] : json.items())
    if (seals || key != "seal") collect(value, leaves, seals);
}

/// Changes one leaf: a digit or sign of a number, a count, a letter.
inline void change_leaf(Json& leaf, Generator& generator) {
  if (leaf.is_boolean()) {
    leaf = !leaf.get<bool>();
  } else if (leaf.is_number()) {
    leaf = leaf.get<std::size_t>() + 1 + below(generator, 3);
  } else {
    std::string text = leaf.get<std::string>();
    if (text.find_first_of("0123456789") != std::string::npos) {
      leaf = other_number(text, generator);
    } else if (text.empty()) {
      leaf = "u";
    } else {
      text[below(generator, text.size())] = "uvrsz"[below(generator, 5)];
      leaf = text == leaf ? text + "u" : text;
    }
  }
}

/// One random change of the document. `seals`: the seals may change as well.
inline std::string mutate(Json& json, Generator& generator, bool seals) {
  std::vector<std::string> lists;
  std::vector<std::string> sealed;
  for (const auto& [key, value] : json.items()) {
    if (value.is_array()) lists.push_back(key);
    if (value.is_structured()) sealed.push_back(key);
  }
  Json& list = json[lists[below(generator, lists.size())]];
  const std::size_t kind = below(generator, 8);
  if (kind == 0) {
    if (!json.contains("second")) {
      json["command"] = "intersect";
      return "another command";
    }
    std::swap(json["first"], json["second"]);
    return "patches swapped";
  }
  if (kind <= 3 && !list.empty()) {
    const std::size_t i = below(generator, list.size());
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(i);
    if (kind == 1) list.erase(at);
    if (kind == 2) list.insert(at, Json(list[i]));
    if (kind == 3 && list.size() > 1 && list[i] != list[(i + 1) % list.size()])
      std::swap(list[i], list[(i + 1) % list.size()]);
    else if (kind == 3)
      list.erase(at);
    return "a claim dropped, repeated or moved";
  }
  std::vector<Json*> leaves;
  while (leaves.empty()) {
    Json& part = json[sealed[below(generator, sealed.size())]];
    if (part.is_array() && !part.empty())
      collect(part[below(generator, part.size())], leaves, seals);
    else
      collect(part, leaves, seals);
  }
  Json& leaf = *leaves[below(generator, leaves.size())];
  const std::string before = leaf.dump();
  change_leaf(leaf, generator);
  return before + " changed to " + leaf.dump();
}

/// The number of entries in all rows of the cover.
inline std::size_t cells(const Json& json) {
  std::size_t count = 0;
  for (const Json& row : json["cover"]) {
    const std::string text = row.get<std::string>();
    count += static_cast<std::size_t>(std::count(text.begin(), text.end(), ' '));
  }
  return count;
}

/// Seals that fit, as a forger would make them.
inline void seal_again(Json& json) {
  const auto seal_claim = [](Json& claim, const std::string& place) {
    claim.erase("seal");
    claim["seal"] = checker::seal(place + claim.dump());
  };
  for (auto& [key, value] : json.items()) {
    for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
      const std::string place = "$." + key + "[" + std::to_string(i) + "]";
      if (value[i].is_object()) {
        seal_claim(value[i], place);
      } else {
        std::string text = value[i].get<std::string>();
        text = text.substr(0, text.find(" #"));
        value[i] = text + " #" + checker::seal(place + text);
      }
    }
    if (value.is_object()) seal_claim(value, "$." + key);
  }
}

/// Single random changes of the certificate, seals included, are all rejected.
inline void reject_changes(const std::string& truth, Generator& generator, int times) {
  for (int i = 0; i < times; ++i) {
    Json json = Json::parse(truth);
    const std::string change = mutate(json, generator, true);
    INFO(i << ": " << change);
    REQUIRE(verdict(json.dump()) != "");
  }
}

/// Changes single leaves of the claims, of the lists in turn, and makes the seals fit: rejected, or the
/// summary is the same. Returns how often it was rejected.
inline int rejected_forgeries(const std::string& text, const std::vector<std::string>& lists,
                              Generator& generator, int times) {
  const Json truth = Json::parse(text);
  int rejected = 0;
  for (int i = 0; i < times; ++i) {
    Json json = truth;
    std::vector<Json*> leaves;
    collect(json[lists[static_cast<std::size_t>(i) % lists.size()]], leaves, false);
    Json& leaf = *leaves[below(generator, leaves.size())];
    const std::string before = leaf.dump();
    change_leaf(leaf, generator);
    INFO(i << ": " << before << " changed to " << leaf.dump());
    seal_again(json);
    if (verdict(json.dump()) != "")
      ++rejected;
    else
      REQUIRE(json["summary"] == truth["summary"]);
  }
  return rejected;
}

/// After the change, with seals that fit, the certificate is rejected: place and reason begin with `where`.
inline void reason(const std::string& truth, const char* where, const std::function<void(Json&)>& change) {
  Json json = Json::parse(truth);
  change(json);
  json["summary"]["claims"][5] = cells(json);
  seal_again(json);
  const std::string said = verdict(json.dump());
  INFO(where << " expected, got " << said);
  CHECK(said.rfind(where, 0) == 0);
}

}  // namespace exsect::certificates
