// The proved intersection of a pair, as the program of exsect writes it for the comparison.
#pragma once

#include "patch_pair.h"

namespace peers {

struct Component {
  std::string shape;          // open, closed, branched
  std::vector<Curve> curves;  // open and closed: one, from end to end
};

struct Reference {
  bool complete = false;
  std::vector<Component> components;
  std::vector<Vertex> isolated;
  std::vector<Curve> rims;  // of regions where the patches lie on one surface
};

nlohmann::ordered_json to_json(const Reference& reference);
Reference reference_from_json(const nlohmann::json& json);

}  // namespace peers
