#include "reference.h"

namespace peers {

nlohmann::ordered_json to_json(const Reference& reference) {
  nlohmann::ordered_json result = {{"complete", reference.complete},
                                   {"components", nlohmann::ordered_json::array()}};
  for (const Component& component : reference.components) {
    result["components"].push_back(
        {{"shape", component.shape}, {"curves", to_json(Answer{component.curves, {}})["curves"]}});
  }
  result["isolated"] = to_json(Answer{{}, reference.isolated})["points"];
  result["rims"] = to_json(Answer{reference.rims, {}})["curves"];
  return result;
}

Reference reference_from_json(const nlohmann::json& json) {
  Reference result;
  result.complete = json.at("complete").get<bool>();
  for (const auto& component : json.at("components")) {
    result.components.push_back(
        {component.at("shape").get<std::string>(),
         answer_from_json({{"curves", component.at("curves")}, {"points", nlohmann::json::array()}}).curves});
  }
  const Answer rest = answer_from_json({{"curves", json.at("rims")}, {"points", json.at("isolated")}});
  result.isolated = rest.points;
  result.rims = rest.curves;
  return result;
}

}  // namespace peers
