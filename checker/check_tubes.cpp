// Tubes, relations and nodes.
#include <algorithm>

#include "replay.h"

namespace exsect::checker {
namespace {

/// q rounded up to a multiple of 2^-128.
Rational rounded_up(const Rational& q) {
  const Integer scaled = numerator(q) << 128;
  Integer quotient;
  Integer remainder;
  divide_qr(scaled, denominator(q), quotient, remainder);
  return Rational(remainder > 0 ? quotient + 1 : quotient) * power_of_two(-128);
}

std::array<Rational, 3> residual(const Tube<Rational>& tube, const Pair<Rational>& pair,
                                 const Vector4<Rational>& at) {
  const auto value = [](const Net<Rational>& c, std::size_t d, const Rational& u, const Rational& v) {
    const auto row = [&](std::size_t i) { return Rational(c[i][0][d] + v * (c[i][1][d] + v * c[i][2][d])); };
    return Rational(row(0) + u * (row(1) + u * row(2)));
  };
  std::array<Rational, 3> f;
  for (std::size_t d = 0; d < 3; ++d) f[d] = value(pair.x, d, at[0], at[1]) + value(pair.y, d, at[2], at[3]);
  std::array<Rational, 3> result;
  for (std::size_t d = 0; d < 3; ++d) result[d] = dot(tube.inverse[d], f);
  return result;
}

/// The coefficients of direction . c in the parameter, or nothing if the other parameter occurs as well.
std::optional<std::array<Rational, 3>> in_one_parameter(const Net<Rational>& c, const Relation& relation,
                                                        std::size_t parameter) {
  std::array<Rational, 3> f;
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
bool monotone(const std::array<Rational, 3>& f) { return sign(f[1]) * sign(Rational(f[1] + 2 * f[2])) > 0; }

class NodeCheck {
 public:
  NodeCheck(const Certificate& certificate, const Pair<Rational>& pair, const std::vector<ProvedTube>& tubes)
      : certificate_(certificate), pair_(pair), tubes_(tubes) {}

  void check(std::size_t i) const {
    const std::string where = place("nodes", i);
    const Node& node = certificate_.nodes[i];
    const ProvedTube& tube = element(tubes_, node.tube, where, "names no tube");
    require(node.on.empty() != node.wrt.empty(), where, "neither on a side only nor a turning point only");
    const Vector4<Rational> radius = {node.radius, node.radius, node.radius, node.radius};
    require(node.radius > 0 && tube.claim.contains(node.at, radius), where, "its box is not in its tube");
    for (std::size_t j = 0; j < 4; ++j) check_parameter(node, j, where);
    const Rational near = distance(tube, pair_, node.at, where);
    if (node.on.empty())
      check_turning(node, tube, near, where);
    else
      check_sides(node, tube, near, where);
    for (std::size_t k = 0; k < i; ++k)
      require(disjoint(node, certificate_.nodes[k]), where, "its box meets the box of an earlier node");
  }

 private:
  /// On one of the two sides or strictly between them.
  void check_parameter(const Node& node, std::size_t j, const std::string& where) const {
    const auto on =
        std::count_if(node.on.begin(), node.on.end(), [&](const Side& s) { return s.parameter == j; });
    if (on == 0)
      require(node.at[j] - node.radius > 0 && node.at[j] + node.radius < 1, where, "its box leaves (0,1)");
    else
      require(on == 1, where, "on two sides of one parameter");
  }

  static bool disjoint(const Node& a, const Node& b) {
    for (std::size_t j = 0; j < 4; ++j)
      if (magnitude(Rational(a.at[j] - b.at[j])) > a.radius + b.radius) return true;
    return false;
  }

  /// There is a relation between i and j, and, if sides are meant, i = a exactly where j = b.
  bool related(std::size_t i, std::size_t j, const std::optional<std::array<int, 2>>& values) const {
    if (i > j) return related(j, i, values ? std::optional(std::array{(*values)[1], (*values)[0]}) : values);
    return std::any_of(certificate_.relations.begin(), certificate_.relations.end(),
                       [&](const Relation& relation) {
                         if (relation.first != i || relation.second != j) return false;
                         if (!values) return true;
                         const auto f = *in_one_parameter(pair_.x, relation, i);
                         const auto g = *in_one_parameter(pair_.y, relation, j);
                         const auto value = [](const std::array<Rational, 3>& p, int t) {
                           return Rational(t == 0 ? p[0] : p[0] + p[1] + p[2]);
                         };
                         return value(f, (*values)[0]) + value(g, (*values)[1]) == 0;
                       });
  }

  /// The axis is one of the sides; all other sides follow from it by relations.
  void check_sides(const Node& node, const ProvedTube& tube, const Rational& near,
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
      require(next != open.end(), where, "a side does not follow from that of the tube's axis");
      known.push_back(*next);
      open.erase(next);
    }
  }

  /// w' has exactly one zero on the tube's curve, and it is in the node's box.
  void check_turning(const Node& node, const ProvedTube& tube, const Rational& near,
                     const std::string& where) const {
    const std::size_t i = node.wrt[0];
    const Ball<Rational>& second = tube.bounds.second[i];
    require(i != tube.claim.axis && second.sign() != 0, where, "the second derivative may vanish");
    for (std::size_t j = 1; j < node.wrt.size(); ++j) {
      require(node.wrt[j - 1] < node.wrt[j], where, "parameters not in order");
      require(std::any_of(node.wrt.begin(), node.wrt.begin() + static_cast<std::ptrdiff_t>(j),
                          [&](std::size_t k) { return related(k, node.wrt[j], std::nullopt); }),
              where, "no relation makes the parameters turn together");
    }
    const std::array<Ball<Rational>, 4> t = tangent(pair_.at(node.at), {near, near, near, near});
    const Ball<Rational>& along = t[tube.claim.axis];
    require(along.sign() != 0, where, "no derivative here");
    // |w'| / min|w''| bounds the distance from the zero, along the axis.
    const Rational away = t[i].magnitude() / ((magnitude(along.middle) - along.radius) *
                                              (magnitude(second.middle) - second.radius));
    const Rational axis = node.at[tube.claim.axis] - tube.claim.centre[tube.claim.axis];
    require(magnitude(axis) + away <= tube.claim.reach, where, "the turning point may be outside its tube");
    for (std::size_t j = 0; j < 4; ++j)
      require(near + away * tube.bounds.first[j].magnitude() <= node.radius, where,
              "its box may miss the turning point");
  }

  const Certificate& certificate_;
  const Pair<Rational>& pair_;
  const std::vector<ProvedTube>& tubes_;
};

}  // namespace

Pair<Rational> power_basis(const std::array<BezierPatch, 2>& patches) {
  Pair<Rational> pair = {patches[0].power_basis(), patches[1].power_basis()};
  for (auto& row : pair.y)
    for (auto& p : row)
      for (Rational& q : p) q = -q;
  return pair;
}

std::vector<ProvedTube> check_tubes(const Certificate& certificate, const Pair<Rational>& pair) {
  std::vector<ProvedTube> result;
  for (const Tube<Rational>& tube : certificate.tubes) {
    const std::string where = place("tubes", result.size());
    require(tube.slope[tube.axis] == 1 && tube.reach > 0 && tube.width > 0, where, "not a tube");
    const Pair<Rational> local = pair.at(tube.centre).times(tube.inverse);
    for (const Rational& slack : contraction(tube, local)) require(slack > 0, where, "no contraction");
    const Vector4<Rational> extent = tube.extent();
    result.push_back({tube, curve_bounds(local, tube.axis, extent)});
    const CurveBounds<Rational>& bounds = result.back().bounds;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool inside = tube.centre[i] >= extent[i] && tube.centre[i] + extent[i] <= 1;
      require(bounds.first[i].sign() != 0 || (bounds.second[i].sign() != 0 && inside), where,
              "a parameter may turn more than once, or outside the domain");
    }
  }
  return result;
}

Rational distance(const ProvedTube& tube, const Pair<Rational>& pair, const Vector4<Rational>& at,
                  const std::string& where) {
  require(tube.claim.contains(at, {}), where, "a point is not in its tube");
  Rational most = 0;
  for (const Rational& q : residual(tube.claim, pair, at)) most = larger(most, magnitude(q));
  return rounded_up(most / (1 - tube.bounds.defect));
}

void check_relations(const Certificate& certificate, const Pair<Rational>& pair) {
  for (std::size_t i = 0; i < certificate.relations.size(); ++i) {
    const Relation& relation = certificate.relations[i];
    const std::string where = place("relations", i);
    require(relation.first < 2 && relation.second >= 2, where, "not between a parameter of either patch");
    const auto f = in_one_parameter(pair.x, relation, relation.first);
    const auto g = in_one_parameter(pair.y, relation, relation.second);
    require(f && g, where, "a third parameter occurs");
    require(monotone(*f) && monotone(*g), where, "not monotone");
  }
}

void check_nodes(const Certificate& certificate, const Pair<Rational>& pair,
                 const std::vector<ProvedTube>& tubes) {
  const NodeCheck nodes(certificate, pair, tubes);
  for (std::size_t i = 0; i < certificate.nodes.size(); ++i) nodes.check(i);
}

}  // namespace exsect::checker
