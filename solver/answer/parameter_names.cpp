#include "answer/parameter_names.h"

#include <algorithm>

#include "answer/parameter_box.h"

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

class Reverser {
 public:
  explicit Reverser(Parameter p) : p_(p) {}

  void operator()(Node& node) const {
    reverse(node.box);
    node.approx[index(p_)] = 1 - node.approx[index(p_)];
    for (Side& side : node.on)
      if (side.parameter == p_) side.value = 1 - side.value;
  }
  void operator()(Arc& arc) const {
    for (PolylineVertex& vertex : arc.polyline)
      vertex.parameters[index(p_)] = 1 - vertex.parameters[index(p_)];
  }
  void operator()(Incomplete& region) const { reverse(region.where); }

 private:
  void reverse(ParameterBox& box) const { box[index(p_)] = reversed(box[index(p_)]); }

  Parameter p_;
};

/// The map is increasing, 0 and 1 stay.
class Changer {
 public:
  Changer(Parameter p, const Rational& k) : p_(p), k_(k), rounded_k_(to_double(k)) {}

  void operator()(Node& node) const {
    change(node.box);
    change(node.approx);
  }
  void operator()(Arc& arc) const {
    for (PolylineVertex& vertex : arc.polyline) change(vertex.parameters);
  }
  void operator()(Incomplete& region) const { change(region.where); }

 private:
  template <class Number>
  static Number changed(const Number& t, const Number& k) {
    return t / (k * (1 - t) + t);
  }
  void change(ParameterBox& box) const {
    RationalInterval& t = box[index(p_)];
    t = {changed(t.lower, k_), changed(t.upper, k_)};
  }
  void change(std::array<double, 4>& parameters) const {
    double& t = parameters[index(p_)];
    t = changed(t, rounded_k_);
  }

  Parameter p_;
  const Rational& k_;
  double rounded_k_;
};

/// From the unit squares to a box inside of them.
class Placer {
 public:
  explicit Placer(const ParameterBox& over) : over_(over) {
    for (std::size_t i = 0; i < 4; ++i) rounded_[i] = {to_double(over[i].lower), to_double(over[i].width())};
  }

  void operator()(Node& node) const {
    place(node.box);
    place(node.approx);
    node.on.clear();
  }
  void operator()(Arc& arc) const {
    for (PolylineVertex& vertex : arc.polyline) place(vertex.parameters);
  }
  void operator()(Incomplete& region) const { place(region.where); }

 private:
  void place(ParameterBox& box) const {
    for (std::size_t i = 0; i < 4; ++i) {
      const Rational width = over_[i].width();
      box[i] = {over_[i].lower + width * box[i].lower, over_[i].lower + width * box[i].upper};
    }
  }
  void place(std::array<double, 4>& parameters) const {
    for (std::size_t i = 0; i < 4; ++i) parameters[i] = rounded_[i][0] + rounded_[i][1] * parameters[i];
  }

  const ParameterBox& over_;
  std::array<std::array<double, 2>, 4> rounded_;  // lower end and width
};

template <class Change>
void change_all(IntersectResult& result, const Change& change) {
  std::for_each(result.graph.nodes.begin(), result.graph.nodes.end(), change);
  std::for_each(result.graph.arcs.begin(), result.graph.arcs.end(), change);
  for (Overlap& overlap : result.graph.overlaps)
    for (std::vector<Arc>& chain : overlap.chains) std::for_each(chain.begin(), chain.end(), change);
  std::for_each(result.incomplete.begin(), result.incomplete.end(), change);
}

}  // namespace

void rename_parameters(IntersectResult& result, const ParameterNames& names) {
  change_all(result, Renamer(names));
}
void rename_parameters(Node& node, const ParameterNames& names) { Renamer{names}(node); }
void rename_parameters(Arc& arc, const ParameterNames& names) { Renamer{names}(arc); }

void reverse_parameter(IntersectResult& result, Parameter p) { change_all(result, Reverser(p)); }

void change_parameter(IntersectResult& result, Parameter p, const Rational& k) {
  change_all(result, Changer(p, k));
}

void place_parameters(IntersectResult& result, const ParameterBox& over) { change_all(result, Placer(over)); }

}  // namespace exsect
