#include "parameter_names.h"

#include <algorithm>

namespace exsect {

namespace {

class Renamer {
 public:
  explicit Renamer(const ParameterNames& names) : names_(names) {}

  void operator()(Node& node) const {
    permute(node.box);
    permute(node.approx);
    rename(node.wrt);
    rename(node.free);
    for (Side& side : node.on) side.parameter = names_[index(side.parameter)];
    std::sort(node.on.begin(), node.on.end(), [](const Side& a, const Side& b) {
      return std::pair(a.parameter, a.value) < std::pair(b.parameter, b.value);
    });
  }
  void operator()(Arc& arc) const {
    rename(arc.free);
    for (PolylineVertex& vertex : arc.polyline) permute(vertex.parameters);
  }
  void operator()(Incomplete& region) const { permute(region.where); }

 private:
  template <class T>
  void permute(std::array<T, 4>& values) const {
    const std::array<T, 4> old = values;
    for (std::size_t i = 0; i < 4; ++i) values[index(names_[i])] = old[i];
  }
  void rename(std::vector<Parameter>& parameters) const {
    for (Parameter& p : parameters) p = names_[index(p)];
    std::sort(parameters.begin(), parameters.end());
  }

  const ParameterNames& names_;
};

}  // namespace

void rename_parameters(IntersectResult& result, const ParameterNames& names) {
  const Renamer renamer(names);
  std::for_each(result.graph.nodes.begin(), result.graph.nodes.end(), renamer);
  std::for_each(result.graph.arcs.begin(), result.graph.arcs.end(), renamer);
  for (Overlap& overlap : result.graph.overlaps)
    for (std::vector<Arc>& chain : overlap.chains) std::for_each(chain.begin(), chain.end(), renamer);
  std::for_each(result.incomplete.begin(), result.incomplete.end(), renamer);
}

}  // namespace exsect
