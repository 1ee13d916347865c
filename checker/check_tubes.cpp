// Tubes, relations and nodes.
#include <algorithm>

#include "replay.h"

namespace exsect::checker {
namespace {

/// q rounded up to a multiple of 2^-128: short numbers.
Rational rounded_up(const Rational& q) {
  const Integer scaled = numerator(q) << 128;
  Integer quotient;
  Integer remainder;
  divide_qr(scaled, denominator(q), quotient, remainder);
  return Rational(remainder > 0 ? quotient + 1 : quotient) * power_of_two(-128);
}
Enclosure rounded_up(const Enclosure& a) { return a; }

template <class N>
Vector3<N> residual(const Tube<N>& tube, const Pair<N>& pair, const Vector4<N>& at) {
  Vector3<N> f;
  for (std::size_t d = 0; d < 3; ++d) f[d] = value(pair.x, d, at[0], at[1]) + value(pair.y, d, at[2], at[3]);
  return {dot(tube.inverse[0], f), dot(tube.inverse[1], f), dot(tube.inverse[2], f)};
}

/// The coefficients of direction . c in the parameter, or nothing if the other parameter occurs as well.
std::optional<Vector3<Rational>> in_one_parameter(const Net<Rational>& c, const Relation& relation,
                                                  std::size_t parameter) {
  Vector3<Rational> f;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational product = dot(relation.direction, parameter % 2 == 0 ? c[i][j] : c[j][i]);
      if (j == 0)
        f[i] = product;
      else if (product != 0)
        return std::nullopt;
    }
  }
  return f;
}

/// f' has no zero on [0,1].
bool monotone(const Vector3<Rational>& f) { return sign(f[1]) * sign(Rational(f[1] + 2 * f[2])) > 0; }

template <class N>
class NodeCheck {
 public:
  explicit NodeCheck(const Replay<N>& replay) : replay_(replay), nodes_(replay.certificate.nodes) {}

  void check(std::size_t i) const {
    const std::string where = place("nodes", i);
    const Node<N>& node = nodes_[i];
    const ProvedTube<N>& tube = element(replay_.tubes, node.tube, where, "names no tube");
    require(node.on.empty() != node.wrt.empty(), where, "neither on a side only nor a turning point only");
    const Vector4<N> radius = {node.radius, node.radius, node.radius, node.radius};
    require(node.radius > 0 && tube.claim.contains(node.at, radius), where, "its box is not in its tube");
    for (std::size_t j = 0; j < 4; ++j) check_parameter(node, j, where);
    const N near = distance(tube, replay_.pair, node.at, where);
    if (node.on.empty())
      check_turning(node, tube, near, where);
    else
      check_sides(node, tube, near, where);
    for (std::size_t k = 0; k < i; ++k)
      require(disjoint(node, nodes_[k]), where, "its box meets the box of an earlier node");
  }

 private:
  /// On one of the two sides or strictly between them.
  void check_parameter(const Node<N>& node, std::size_t j, const std::string& where) const {
    const auto on =
        std::count_if(node.on.begin(), node.on.end(), [&](const Side& s) { return s.parameter == j; });
    if (on == 0)
      require(node.at[j] - node.radius > 0 && node.at[j] + node.radius < 1, where, "its box leaves (0,1)");
    else
      require(on == 1, where, "on two sides of one parameter");
  }

  static bool disjoint(const Node<N>& a, const Node<N>& b) {
    for (std::size_t j = 0; j < 4; ++j)
      if (magnitude(N(a.at[j] - b.at[j])) > a.radius + b.radius) return true;
    return false;
  }

  /// There is a relation between i and j, and, if sides are meant, i = a exactly where j = b.
  bool related(std::size_t i, std::size_t j, const std::optional<std::array<int, 2>>& values) const {
    if (i > j) return related(j, i, values ? std::optional(std::array{(*values)[1], (*values)[0]}) : values);
    return std::any_of(replay_.certificate.relations.begin(), replay_.certificate.relations.end(),
                       [&](const Relation& relation) {
                         if (relation.first != i || relation.second != j) return false;
                         if (!values) return true;
                         const auto f = *in_one_parameter(replay_.exact.x, relation, i);
                         const auto g = *in_one_parameter(replay_.exact.y, relation, j);
                         const auto value = [](const Vector3<Rational>& p, int t) {
                           return Rational(t == 0 ? p[0] : p[0] + p[1] + p[2]);
                         };
                         return value(f, (*values)[0]) + value(g, (*values)[1]) == 0;
                       });
  }

  /// The axis is one of the sides; all other sides follow from it by relations, or `at` is a solution.
  void check_sides(const Node<N>& node, const ProvedTube<N>& tube, const N& near,
                   const std::string& where) const {
    require(near <= node.radius, where, "its box may miss the curve");
    for (const Side& side : node.on)
      require(node.at[side.parameter] == side.value, where, "not on the side it is said to be on");
    std::vector<Side> known;
    std::vector<Side> open = node.on;
    const auto is_known = [&](const Side& side) {
      return side.parameter == tube.claim.axis ||
             std::any_of(known.begin(), known.end(), [&](const Side& other) {
               return related(other.parameter, side.parameter, std::array{other.value, side.value});
             });
    };
    while (!open.empty()) {
      const auto next = std::find_if(open.begin(), open.end(), is_known);
      if (next == open.end() && !known.empty() && is_solution(replay_.exact, node.at)) return;
      require(next != open.end(), where, "a side does not follow from that of the tube's axis");
      known.push_back(*next);
      open.erase(next);
    }
  }

  /// w' has exactly one zero on the tube's curve, and it is in the node's box.
  void check_turning(const Node<N>& node, const ProvedTube<N>& tube, const N& near,
                     const std::string& where) const {
    const std::size_t i = node.wrt[0];
    const Ball<N>& second = tube.bounds.second[i];
    require(i != tube.claim.axis && second.sign() != 0, where, "the second derivative may vanish");
    for (std::size_t j = 1; j < node.wrt.size(); ++j) {
      require(node.wrt[j - 1] < node.wrt[j], where, "parameters not in order");
      require(std::any_of(node.wrt.begin(), node.wrt.begin() + static_cast<std::ptrdiff_t>(j),
                          [&](std::size_t k) { return related(k, node.wrt[j], std::nullopt); }),
              where, "no relation makes the parameters turn together");
    }
    const std::array<Ball<N>, 4> t = tangent(replay_.pair.at(node.at), {near, near, near, near});
    const Ball<N>& along = t[tube.claim.axis];
    require(along.sign() != 0, where, "no derivative here");
    // |w'| / min|w''| bounds the distance from the zero, along the axis.
    const N away = t[i].magnitude() /
                   ((magnitude(along.middle) - along.radius) * (magnitude(second.middle) - second.radius));
    const N axis = node.at[tube.claim.axis] - tube.claim.centre[tube.claim.axis];
    require(magnitude(axis) + away <= tube.claim.reach, where, "the turning point may be outside its tube");
    for (std::size_t j = 0; j < 4; ++j)
      require(near + away * tube.bounds.first[j].magnitude() <= node.radius, where,
              "its box may miss the turning point");
  }

  const Replay<N>& replay_;
  const std::vector<Node<N>>& nodes_;
};

}  // namespace

template <class N>
Replay<N> replay(const Certificate<N>& certificate) {
  const auto& [x, y] = certificate.patches;
  Replay<N> result = {certificate, {x.power_basis(), y.power_basis()}, x.net()[1][1], {}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t d = 0; d < 3; ++d) {
        result.exact.y[i][j][d] = -result.exact.y[i][j][d];
        const Rational move = i + j == 0 ? result.origin[d] : Rational(0);
        result.pair.x[i][j][d] = N(Rational(result.exact.x[i][j][d] - move));
        result.pair.y[i][j][d] = N(Rational(result.exact.y[i][j][d] + move));
      }
    }
  }
  return result;
}

template <class N>
bool is_solution(const Pair<Rational>& exact, const Vector4<N>& at) {
  Vector4<Rational> w;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(at[i] == N(approximate(at[i])))) return false;
    w[i] = Rational(approximate(at[i]));
  }
  for (std::size_t d = 0; d < 3; ++d)
    if (value(exact.x, d, w[0], w[1]) + value(exact.y, d, w[2], w[3]) != 0) return false;
  return true;
}

template <class N>
void check_tubes(Replay<N>& replay) {
  for (const Tube<N>& tube : replay.certificate.tubes) {
    const std::string where = place("tubes", replay.tubes.size());
    require(tube.slope[tube.axis] == 1 && tube.reach > 0 && tube.width > 0, where, "not a tube");
    const Pair<N> local = replay.pair.at(tube.centre).times(tube.inverse);
    for (const N& slack : contraction(tube, local)) require(slack > 0, where, "no contraction");
    const Vector4<N> extent = tube.extent();
    const CurveBounds<N> bounds = curve_bounds(local, tube.axis, extent);
    for (std::size_t i = 0; i < 4; ++i) {
      const bool inside = tube.centre[i] >= extent[i] && tube.centre[i] + extent[i] <= 1;
      require(bounds.first[i].sign() != 0 || (bounds.second[i].sign() != 0 && inside), where,
              "a parameter may turn more than once, or outside the domain");
    }
    replay.tubes.push_back({tube, bounds});
  }
}

template <class N>
N distance(const ProvedTube<N>& tube, const Pair<N>& pair, const Vector4<N>& at, const std::string& where) {
  require(tube.claim.contains(at, {}), where, "a point is not in its tube");
  N most = 0;
  for (const N& q : residual(tube.claim, pair, at)) most = larger(most, magnitude(q));
  return rounded_up(most / (1 - tube.bounds.defect));
}

template <class N>
void check_relations(const Replay<N>& replay) {
  for (std::size_t i = 0; i < replay.certificate.relations.size(); ++i) {
    const Relation& relation = replay.certificate.relations[i];
    const std::string where = place("relations", i);
    require(relation.first < 2 && relation.second >= 2, where, "not between a parameter of either patch");
    const auto f = in_one_parameter(replay.exact.x, relation, relation.first);
    const auto g = in_one_parameter(replay.exact.y, relation, relation.second);
    require(f && g, where, "a third parameter occurs");
    require(monotone(*f) && monotone(*g), where, "not monotone");
  }
}

template <class N>
void check_nodes(const Replay<N>& replay) {
  const NodeCheck<N> nodes(replay);
  for (std::size_t i = 0; i < replay.certificate.nodes.size(); ++i) nodes.check(i);
}

template Replay<Rational> replay(const Certificate<Rational>&);
template bool is_solution(const Pair<Rational>&, const Vector4<Rational>&);
template void check_tubes(Replay<Rational>&);
template Rational distance(const ProvedTube<Rational>&, const Pair<Rational>&, const Vector4<Rational>&,
                           const std::string&);
template void check_relations(const Replay<Rational>&);
template void check_nodes(const Replay<Rational>&);
template Replay<Enclosure> replay(const Certificate<Enclosure>&);
template bool is_solution(const Pair<Rational>&, const Vector4<Enclosure>&);
template void check_tubes(Replay<Enclosure>&);
template Enclosure distance(const ProvedTube<Enclosure>&, const Pair<Enclosure>&, const Vector4<Enclosure>&,
                            const std::string&);
template void check_relations(const Replay<Enclosure>&);
template void check_nodes(const Replay<Enclosure>&);

}  // namespace exsect::checker
