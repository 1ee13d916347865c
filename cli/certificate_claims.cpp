#include "certificate_claims.h"

#include <exsect/geometry/number.h>

namespace exsect::cli {

std::string in_list(const char* list, std::size_t i) {
  return std::string("$.") + list + "[" + std::to_string(i) + "]";
}

Json sealed(const std::string& place, Json claim) {
  claim["seal"] = checker::seal(place + claim.dump());
  return claim;
}

Json exact_numbers(const std::vector<double>& numbers) {
  Json result = Json::array();
  for (const double a : numbers) result.push_back(to_string(from_double(a)));
  return result;
}

const char* letter(std::size_t parameter) { return name(all_parameters[parameter]); }

Json patch_claim(const std::string& place, const std::string& name, const BezierPatch& patch) {
  Json points = Json::array();
  for (const auto& row : patch.net()) {
    Json list = Json::array();
    for (const Point& p : row) list.push_back({to_string(p[0]), to_string(p[1]), to_string(p[2])});
    points.push_back(list);
  }
  return sealed(place, {{"name", name}, {"points", points}});
}

namespace {

/// What the tube's curve is.
std::string curve(const Tube& tube) {
  if (tube.line >= 0) return "line" + std::to_string(tube.line);
  return tube.chart == Chart::pair ? "pair" : tube.chart == Chart::first ? "first" : "second";
}

}  // namespace

Json tube_claims(const NearPair& pair, const std::vector<Tube>& tubes) {
  Json result = Json::array();
  for (const Tube& t : tubes) {
    Json rows = Json::array();
    for (auto row : t.inverse) {
      for (double& a : row) a /= pair.scale;
      rows.push_back(exact(row));
    }
    result.push_back(sealed(in_list("tubes", result.size()), {{"centre", exact(t.centre)},
                                                              {"axis", letter(t.axis)},
                                                              {"slope", exact(t.slope)},
                                                              {"reach", to_string(from_double(t.reach))},
                                                              {"width", to_string(from_double(t.width))},
                                                              {"inverse", rows},
                                                              {"curve", curve(t)}}));
  }
  return result;
}

Json cover_claims(const std::vector<std::string>& entries) {
  Json result = Json::array();
  for (const std::string& entry : entries)
    result.push_back(entry + " #" + checker::seal(in_list("cover", result.size()) + entry));
  return result;
}

std::string claims_text(const Json& document) {
  std::string result = "{";
  for (const auto& [key, value] : document.items()) {
    result += (result.size() == 1 ? "" : ",\n ") + Json(key).dump() + ": ";
    if (!value.is_array() || value.empty()) {
      result += value.dump();
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i) result += (i == 0 ? "[\n  " : ",\n  ") + value[i].dump();
    result += "]";
  }
  return result + "}\n";
}

NoCertificate not_accepted(const checker::Rejected& rejected) {
  return NoCertificate("a claim that is not accepted: " + rejected.place() + ": " + rejected.what());
}

std::string confirmed(const std::string& certificate) {
  try {
    checker::check_certificate(certificate);
    return certificate;
  } catch (const checker::Rejected& rejected) {
    throw not_accepted(rejected);
  }
}

}  // namespace exsect::cli
