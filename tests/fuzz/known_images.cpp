#include "known_images.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace exsect::known_images {
namespace {

using random_nets::ProjectiveMap;

const Rational kMoebius(7, 5);

ProjectiveMap scaled(const Rational& factor) {
  return {{{factor, 0, 0, 0}, {0, factor, 0, 0}, {0, 0, factor, 0}, {0, 0, 0, 1}}};
}

}  // namespace

std::vector<std::pair<std::string, ProjectiveMap>> space_maps() {
  const Rational third(1, 3), fifth(1, 5), sixteenth(1, 16), far(100000000);
  const auto over_15 = [](long a) { return Rational(a, 15); };
  return {{"projective map",
           {{{1, third, 0, 0}, {0, 1, -fifth, 0}, {0, 0, 1, 1}, {sixteenth, sixteenth, -sixteenth, 1}}}},
          // By the quaternion 1 + 2i - j + 3k.
          {"rotated",
           {{{over_15(-5), over_15(-10), over_15(10), 0},
             {over_15(2), over_15(-11), over_15(-10), 0},
             {over_15(14), over_15(-2), over_15(5), 0},
             {0, 0, 0, 1}}}},
          {"times 25.4", scaled(Rational(254, 10))},
          {"moved to 1e8", {{{1, 0, 0, far}, {0, 1, 0, -far}, {0, 0, 1, far}, {0, 0, 0, 1}}}}};
}

RationalPatch multiplied(const RationalPatch& patch) {
  return random_nets::image(patch, {{{7, 0, 0, 0}, {0, 7, 0, 0}, {0, 0, 7, 0}, {0, 0, 0, 7}}});
}

RationalPatch reversed(const RationalPatch& patch) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = patch.degree_u(); i >= 0; --i) {
    net.emplace_back();
    for (int j = 0; j <= patch.degree_v(); ++j) net.back().push_back(patch.homogeneous(i, j));
  }
  return RationalPatch::from_homogeneous(net);
}

RationalPatch reparametrised(const RationalPatch& patch) {
  return random_nets::reparametrised(patch, 1 / kMoebius);
}

IntersectionGraph reparametrised(IntersectionGraph graph, std::size_t i) {
  const auto map = [](const auto& u, const auto& k) { return u / (k + (1 - k) * u); };
  const double k = to_double(kMoebius);
  for (Node& node : graph.nodes) {
    node.box[i] = {Rational(map(node.box[i].lower, kMoebius)), Rational(map(node.box[i].upper, kMoebius))};
    if (std::ranges::count(node.free, static_cast<Parameter>(i)) == 0)
      node.approx[i] = map(node.approx[i], k);
  }
  const auto map_arc = [&](Arc& arc) {
    // A free parameter is shown at 1/2.
    if (std::ranges::count(arc.free, static_cast<Parameter>(i)) != 0) return;
    for (PolylineVertex& vertex : arc.polyline) vertex.parameters[i] = map(vertex.parameters[i], k);
  };
  std::ranges::for_each(graph.arcs, map_arc);
  for (Overlap& overlap : graph.overlaps)
    for (auto& chain : overlap.chains) std::ranges::for_each(chain, map_arc);
  return graph;
}

std::string written(const std::string& name, const std::vector<NamedRationalPatch>& patches) {
  const auto path = std::filesystem::temp_directory_path() / (name + ".json");
  try {
    write_patches({name, "", patches}, path.string());
  } catch (const std::invalid_argument& error) {
    return std::string("not written: ") + error.what();
  }
  return "written to " + path.string();
}

}  // namespace exsect::known_images
