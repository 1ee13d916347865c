// T-junctions of cubic and of weighted patches: parts of sides in common.
#include <exsect/solver/intersect.h>
#include <exsect/solver/intersect_rational.h>

#include "filter/filter.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"
#include "support/side_pairs.h"

namespace exsect::parts_of_sides_test {
namespace {

using random_nets::Generator;
using random_nets::Net;

Net part(const Net& net, const RationalInterval& u, const RationalInterval& v) {
  const RationalPatch patch = RationalPatch(net).restricted_to(u.lower, u.upper, v.lower, v.upper);
  Net result = net;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const HomogeneousPoint& p = patch.homogeneous(i, j);
      result[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {p[0] / p[3], p[1] / p[3],
                                                                          p[2] / p[3]};
    }
  return result;
}

/// A bicubic graph over the unit square.
Net sheet(Generator& generator) {
  Net net(4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      net[static_cast<std::size_t>(i)].push_back(
          {Rational(i, 3) + Rational(random_pairs::integer(generator, -8, 8), 128),
           Rational(j, 3) + Rational(random_pairs::integer(generator, -8, 8), 128),
           Rational(random_pairs::integer(generator, -16, 16), 64)});
  return net;
}

/// Under a projective map of space: the same pairs of parameters.
RationalPatch image(const RationalPatch& patch) {
  std::vector<std::vector<HomogeneousPoint>> net(static_cast<std::size_t>(patch.degree_u()) + 1);
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j) {
      const HomogeneousPoint& p = patch.homogeneous(i, j);
      net[static_cast<std::size_t>(i)].push_back(
          {p[0] + p[1] / 3, p[1] - p[2] / 5, p[2] + p[3], p[3] + (p[0] + p[1] - p[2]) / 16});
    }
  return RationalPatch::from_homogeneous(net);
}

/// The arc of the common part, alone, between these values of v and s.
void check(const RationalPatch& x, const RationalPatch& y, const RationalInterval& on_x,
           const RationalInterval& on_y, Contact contact) {
  const IntersectResult result = intersect(x, y);
  REQUIRE(result.status == Status::complete);
  REQUIRE(result.graph.arcs.size() == 1);
  CHECK(result.graph.isolated_points.empty());
  const Arc& arc = result.graph.arcs[0];
  CHECK(arc.place == ArcPlace::patch_boundary);
  CHECK(arc.contact == contact);
  const auto node = [&](int id) -> const Node& { return result.graph.nodes[static_cast<std::size_t>(id)]; };
  const Node& from = node(arc.from);
  const Node& to = node(arc.to);
  const auto is_at = [](const RationalInterval& box, const Rational& value) {
    return box.lower == value && box.upper == value;
  };
  CHECK(is_at(from.box[0], 1));
  CHECK(is_at(from.box[1], on_x.lower));
  CHECK(is_at(from.box[2], 0));
  CHECK(is_at(from.box[3], on_y.lower));
  CHECK(is_at(to.box[1], on_x.upper));
  CHECK(is_at(to.box[3], on_y.upper));
  for (const PolylineVertex& vertex : arc.polyline) {
    const Point p = x(from_double(vertex.parameters[0]), from_double(vertex.parameters[1]));
    const Point q = y(from_double(vertex.parameters[2]), from_double(vertex.parameters[3]));
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(std::abs(to_double(p[c]) - vertex.point[c]) <= arc.error_bound + 1e-13);
      CHECK(std::abs(to_double(q[c]) - vertex.point[c]) <= arc.error_bound + 1e-13);
    }
  }
}

/// Moves rows of control points upwards, the later ones more.
void bend(Net& net, std::size_t first) {
  for (std::size_t i = first; i < 4; ++i)
    for (Point& p : net[i]) p[2] += Rational(static_cast<long>(i), 12);
}

}  // namespace

TEST_CASE("parts of sides: a sheet cut in three, smoothly and along an edge") {
  const Rational half(1, 2);
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Net whole = sheet(generator);
    const Rational cut(random_pairs::integer(generator, 1, 6), 7);
    const RationalPatch x(part(whole, {0, half}, {0, 1}));
    const RationalInterval other = seed % 3 == 0 ? RationalInterval{cut / 2, cut} : RationalInterval{0, cut};
    Net net = part(whole, {half, 1}, other);
    const bool smooth = seed % 2 == 0;
    bend(net, smooth ? 2 : 1);
    const Contact contact = smooth ? Contact::tangential : Contact::transversal;
    check(x, RationalPatch(net), other, {0, 1}, contact);
    check(image(x), image(RationalPatch(net)), other, {0, 1}, contact);
  }
}

TEST_CASE("parts of sides: a side that goes on beyond the other one at both ends") {
  Generator generator(7);
  const Net whole = sheet(generator);
  const RationalInterval lower = {0, Rational(3, 4)};
  const RationalInterval upper = {Rational(1, 4), 1};
  const RationalPatch x(part(whole, {0, Rational(1, 2)}, lower));
  Net net = part(whole, {Rational(1, 2), 1}, upper);
  bend(net, 1);
  check(x, RationalPatch(net), {Rational(1, 3), 1}, {0, Rational(2, 3)}, Contact::transversal);
  check(image(x), image(RationalPatch(net)), {Rational(1, 3), 1}, {0, Rational(2, 3)}, Contact::transversal);
}

TEST_CASE("parts of sides: parameters that differ by a Moebius map, in both directions and orders") {
  const Rational third(1, 3);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Net whole = sheet(generator);
    const RationalPatch x = image(RationalPatch(part(whole, {0, Rational(1, 2)}, {0, Rational(3, 4)})));
    Net net = part(whole, {Rational(1, 2), 1}, {Rational(1, 4), 1});
    bend(net, 1);
    const Rational k(random_pairs::integer(generator, 1, 9), 4);
    const RationalPatch y =
        random_nets::reparametrised(image(RationalPatch(net)).transposed(), k).transposed();
    const Rational end = 2 * k / (1 + 2 * k);  // the place of 2/3
    check(x, y, {third, 1}, {0, end}, Contact::transversal);
    const RationalPatch back = y.restricted_to(0, 1, 1, 0);
    check(x, back, {third, 1}, {1, 1 - end}, Contact::transversal);
    const IntersectResult exchanged = intersect(back, x);
    REQUIRE(exchanged.status == Status::complete);
    CHECK(difference(intersect(x, back).graph, exchanged.graph, {{2, 3, 0, 1}, {}}) == "");
  }
}

TEST_CASE("parts of sides: biquadratic T-junctions with weights or elevated, as exact arithmetic has them") {
  int complete = 0;
  int weighted = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    side_pairs::Generator generator(seed);
    const side_pairs::Pair pair =
        seed % 2 == 0 ? side_pairs::parts_of_sides(generator) : side_pairs::half_sides(generator);
    const IntersectResult expected = intersect(pair.x, pair.y);
    REQUIRE(expected.status == Status::complete);
    for (const int degree : {2, 3}) {
      const IntersectResult other = intersect(image(pair.x).elevated(degree, degree), image(pair.y));
      if (other.status != Status::complete) continue;
      ++weighted;
      CHECK(difference(expected.graph, other.graph, {}) == "");
    }
    const IntersectResult result = intersect_in_doubles(pair.x, pair.y, {});
    if (result.status != Status::complete) continue;
    ++complete;
    CHECK(difference(expected.graph, result.graph, {}) == "");
  }
  CHECK(complete >= 38);
  CHECK(weighted >= 76);
}

TEST_CASE("parts of sides: parts that agree but for 2^-60 are not taken for one") {
  Generator generator(3);
  const Net whole = sheet(generator);
  const RationalPatch x(part(whole, {0, Rational(1, 2)}, {0, 1}));
  Net net = part(whole, {Rational(1, 2), 1}, {0, Rational(1, 3)});
  net[0][1][2] += power_of_two(-60);
  for (const IntersectResult& result :
       {intersect(x, RationalPatch(net)), intersect(image(x), image(RationalPatch(net)))}) {
    for (const Arc& arc : result.graph.arcs) CHECK(arc.place != ArcPlace::patch_boundary);
  }
}

}  // namespace exsect::parts_of_sides_test
