// Equal patches and overlapping pieces of patches with weights or of degree three.
#include <exsect/solver/intersect_rational.h>

#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace exsect::pieces_of_every_kind_test {

namespace {

using Ends = std::array<Rational, 4>;

Rational q(long n, long d) { return Rational(n, d); }

RationalPatch piece(const RationalPatch& x, const Ends& ends) {
  return x.restricted_to(ends[0], ends[1], ends[2], ends[3]);
}

/// The four corners of the only overlap, as (u,v) in the parameters of x, are those of the rectangle, and
/// there are as many poles in common.
void check_overlap(const RationalPatch& x, const RationalPatch& y, const Ends& rectangle,
                   std::size_t poles = 0) {
  const IntersectResult result = intersect(x, y);
  CHECK(result.status == Status::complete);
  REQUIRE(result.graph.overlaps.size() == 1);
  CHECK(result.graph.arcs.empty());
  CHECK(result.graph.isolated_points.size() == poles);
  for (const int id : result.graph.isolated_points)
    CHECK(result.graph.nodes[static_cast<std::size_t>(id)].free.size() == 2);
  REQUIRE(result.graph.overlaps[0].chains.size() == 1);
  const std::vector<Arc>& chain = result.graph.overlaps[0].chains[0];
  REQUIRE(chain.size() == 4);
  for (const Arc& arc : chain) {
    const Node& node = result.graph.nodes[static_cast<std::size_t>(arc.from)];
    const auto& [u, v, r, s] = node.box;
    CHECK((u.lower == rectangle[0] || u.lower == rectangle[1]));
    CHECK((v.lower == rectangle[2] || v.lower == rectangle[3]));
    // Both patches have the same point there, exactly.
    CHECK(x(u.lower, v.lower) == y(r.lower, s.lower));
    for (const PolylineVertex& vertex : arc.polyline) {
      // The vertex is near the point of x at its parameters: at most by the bound, up to their rounding.
      const Point p = x(from_double(vertex.parameters[0]), from_double(vertex.parameters[1]));
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(std::fabs(to_double(p[k]) - vertex.point[k]) <= arc.error_bound + 0x1p-45);
    }
  }
}

void check_kind(const RationalPatch& x) {
  const Ends whole = {0, 1, 0, 1};
  check_overlap(x, x, whole);
  check_overlap(x, x.transposed(), whole);
  check_overlap(x, piece(x, {1, 0, 0, 1}), whole);
  check_overlap(x, piece(x, {q(1, 3), 1, q(1, 4), 1}), {q(1, 3), 1, q(1, 4), 1});
  check_overlap(x, piece(x, {q(3, 4), q(1, 2), q(1, 8), q(7, 8)}).transposed(),
                {q(1, 2), q(3, 4), q(1, 8), q(7, 8)});
  // In the parameters of the piece [0,2/3] x [0,1], and from a piece to the whole patch.
  check_overlap(piece(x, {0, q(2, 3), 0, 1}), piece(x, {q(1, 3), 1, q(1, 4), 1}), {q(1, 2), 1, q(1, 4), 1});
  check_overlap(piece(x, {q(1, 3), 1, q(1, 4), 1}), x, whole);
}

random_nets::Net mapped(const random_nets::Net& net, const Rational& scale, const Rational& shift) {
  random_nets::Net result = net;
  for (auto& row : result)
    for (Point& p : row)
      for (Rational& c : p) c = scale * c + shift;
  return result;
}

}  // namespace

namespace {

/// The same surface in other parameters, each a Moebius map of the given one that keeps 0 and 1.
RationalPatch changed(const RationalPatch& x, const Rational& k, const Rational& l) {
  return random_nets::reparametrised(random_nets::reparametrised(x, k).transposed(), l).transposed();
}

void check_moebius_pieces(const RationalPatch& x, const Rational& k, const Rational& l) {
  INFO("k " << k << ", l " << l);
  const Ends whole = {0, 1, 0, 1};
  check_overlap(x, changed(x, k, l), whole);
  check_overlap(changed(x, k, l), x, whole);
  check_overlap(x, changed(piece(x, {q(1, 3), 1, q(1, 4), 1}), k, l), {q(1, 3), 1, q(1, 4), 1});
  check_overlap(x, changed(piece(x, {q(3, 4), q(1, 2), q(1, 8), q(7, 8)}), k, l).transposed(),
                {q(1, 2), q(3, 4), q(1, 8), q(7, 8)});
  check_overlap(piece(x, {0, q(2, 3), 0, 1}), changed(piece(x, {q(1, 3), 1, 1, q(1, 4)}), k, l),
                {q(1, 2), 1, q(1, 4), 1});
}

}  // namespace

TEST_CASE("pieces of every kind: equal patches, halves and quarters overlap") {
  random_nets::Generator generator(41);
  for (const std::array<int, 2> degree : {std::array{1, 3}, std::array{3, 2}, std::array{3, 3}}) {
    INFO("seed 41, bidegree " << degree[0] << " " << degree[1]);
    const auto net = random_nets::crossing(generator, {degree[0], degree[1], 1, 1}, true).x;
    check_kind(RationalPatch(net));
    check_kind(RationalPatch(mapped(net, q(127, 5), 100000000)));
  }
  for (const std::array<int, 2> degree : {std::array{1, 2}, std::array{2, 2}, std::array{3, 3}}) {
    INFO("seed 41, bidegree " << degree[0] << " " << degree[1] << " with weights");
    const auto net = random_nets::crossing(generator, {degree[0], degree[1], 1, 1}, true).x;
    check_kind(random_nets::weighted(generator, net));
  }
}

TEST_CASE("pieces of every kind: strips, of which one parameter changes little in space") {
  random_nets::Generator generator(48);
  for (const std::array<int, 2> degree : {std::array{2, 2}, std::array{3, 1}, std::array{3, 3}}) {
    for (const bool weighted : {false, true}) {
      if (!weighted && degree[0] == 2) continue;  // the exact solution encloses its nodes
      INFO("seed 48, bidegree " << degree[0] << " " << degree[1] << ", weighted " << weighted);
      const auto net = random_nets::crossing(generator, {degree[0], degree[1], 1, 1}, true).x;
      const RationalPatch x = weighted ? random_nets::weighted(generator, net) : RationalPatch(net);
      const RationalPatch strip = piece(x, {0, 1, q(1, 2), q(513, 1024)});
      check_overlap(strip, piece(x, {q(1, 3), q(2, 3), q(1, 2), q(1025, 2048)}),
                    {q(1, 3), q(2, 3), 0, q(1, 2)});
      check_overlap(strip, piece(x, {q(1, 3), q(2, 3), 0, 1}), {q(1, 3), q(2, 3), 0, 1});
    }
  }
}

TEST_CASE("pieces of every kind: height fields") {
  random_nets::Generator generator(49);
  random_nets::Net field(4);
  random_nets::Weights weights(4);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      field[static_cast<std::size_t>(i)].push_back(
          {q(i, 3), q(j, 2), q(random_pairs::integer(generator, -6, 6), 16)});
      weights[static_cast<std::size_t>(i)].push_back(q(j == 1 ? 3 : 4, 4));
    }
  }
  check_kind(RationalPatch(field));
  check_kind(RationalPatch(field, weights));
}

TEST_CASE("pieces of every kind: an elevated patch is the same one") {
  random_nets::Generator generator(42);
  const auto net = random_nets::crossing(generator, {2, 2, 1, 1}, true).x;
  const RationalPatch weighted = random_nets::weighted(generator, net);
  check_overlap(weighted, weighted.elevated(3, 3), {0, 1, 0, 1});
  check_overlap(weighted.elevated(3, 2), piece(weighted, {0, q(1, 2), 0, 1}), {0, q(1, 2), 0, 1});
}

TEST_CASE("pieces of every kind: halves that share a side or a corner have no overlap") {
  random_nets::Generator generator(43);
  for (const bool weighted : {false, true}) {
    INFO("seed 43, weighted " << weighted);
    const auto net = random_nets::crossing(generator, {3, 3, 1, 1}, true).x;
    const RationalPatch x = weighted ? random_nets::weighted(generator, net) : RationalPatch(net);
    const IntersectResult side = intersect(piece(x, {0, q(1, 2), 0, 1}), piece(x, {q(1, 2), 1, 0, 1}));
    CHECK(side.status == Status::complete);
    CHECK(side.graph.overlaps.empty());
    CHECK(side.graph.arcs.size() == 1);
    const IntersectResult corner =
        intersect(piece(x, {0, q(1, 2), 0, q(1, 2)}), piece(x, {q(1, 2), 1, q(1, 2), 1}));
    CHECK(corner.status == Status::complete);
    CHECK(corner.graph.overlaps.empty());
    CHECK(corner.graph.isolated_points.size() == 1);
  }
}

TEST_CASE("pieces of every kind: nearly equal patches do not overlap") {
  random_nets::Generator generator(44);
  for (const long exponent : {-10, -30, -60}) {
    INFO("seed 44, 2^" << exponent);
    auto net = random_nets::crossing(generator, {3, 3, 1, 1}, true).x;
    const RationalPatch x(net);
    net[1][2][2] += power_of_two(exponent);
    CHECK(intersect(x, RationalPatch(net)).graph.overlaps.empty());
  }
}

namespace {

/// Patches whose side u = 1 is one point: an eighth of a sphere, as it is and moved, and a bicubic dome.
std::vector<RationalPatch> domes() {
  const random_nets::Net sphere = {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                   {{1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                                   {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
  const Point top = {0, 0, 2};
  const random_nets::Net dome = {{{3, 0, 0}, {3, 3, 0}, {0, 3, 0}},
                                 {{3, 0, 1}, {3, 4, 1}, {0, 3, 1}},
                                 {{2, 0, 2}, {2, 2, 2}, {0, 2, 2}},
                                 {top, top, top}};
  return {RationalPatch(sphere, {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}}), RationalPatch(dome),
          RationalPatch(mapped(sphere, q(127, 5), 100000000), {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}})};
}

/// A loop that crosses itself, along the third axis: x takes one value at two u.
std::vector<RationalPatch> swept_loops() {
  const std::array<std::array<int, 2>, 4> loop = {{{0, 0}, {3, 2}, {-2, 2}, {1, 0}}};
  random_nets::Net net(4);
  random_nets::Weights weights(4);
  for (std::size_t i = 0; i < 4; ++i) {
    for (int j = 0; j < 2; ++j) {
      net[i].push_back({loop[i][0], loop[i][1], j});
      weights[i].push_back(i == 1 ? q(3, 2) : q(1, 1));
    }
  }
  return {RationalPatch(net), RationalPatch(net, weights)};
}

}  // namespace

TEST_CASE("pieces of every kind: pieces that reach a pole have it in common as well") {
  for (const RationalPatch& x : domes()) {
    check_overlap(x, x, {0, 1, 0, 1}, 1);
    check_overlap(x, x.transposed(), {0, 1, 0, 1}, 1);
    check_overlap(x, piece(x, {1, 0, 0, 1}), {0, 1, 0, 1}, 1);
    check_overlap(x, piece(x, {q(1, 2), 1, q(1, 4), q(3, 4)}), {q(1, 2), 1, q(1, 4), q(3, 4)}, 1);
    check_overlap(piece(x, {0, 1, 0, q(1, 2)}), piece(x, {0, 1, q(1, 3), 1}), {0, 1, q(2, 3), 1}, 1);
    check_overlap(piece(x, {0, q(2, 3), 0, 1}), piece(x, {q(1, 3), 1, q(1, 4), 1}), {q(1, 2), 1, q(1, 4), 1},
                  0);
    check_overlap(x, x.elevated(3, 3), {0, 1, 0, 1}, 1);
    check_overlap(x, changed(piece(x, {q(1, 3), 1, 0, q(1, 2)}), q(2, 3), 3), {q(1, 3), 1, 0, q(1, 2)}, 1);
  }
}

TEST_CASE("pieces of every kind: domes that are nearly equal do not overlap") {
  random_nets::Net net = {{{3, 0, 0}, {3, 3, 0}, {0, 3, 0}},
                          {{3, 0, 1}, {3, 4, 1}, {0, 3, 1}},
                          {{2, 0, 2}, {2, 2, 2}, {0, 2, 2}},
                          {{0, 0, 2}, {0, 0, 2}, {0, 0, 2}}};
  const RationalPatch x(net);
  for (const long exponent : {-10, -40, -70}) {
    INFO("2^" << exponent);
    net[1][1][2] = 1 + power_of_two(exponent);
    CHECK(intersect(x, RationalPatch(net)).graph.overlaps.empty());
  }
}

TEST_CASE("pieces of every kind: equal patches that meet themselves") {
  const std::array<std::size_t, 4> same = {0, 1, 2, 3};
  for (const RationalPatch& x : swept_loops()) {
    const IntersectionGraph itself = self_intersect(x).graph;
    REQUIRE(itself.arcs.size() == 1);
    const IntersectResult result = intersect(x, x);
    CHECK(result.status == Status::complete);
    CHECK(result.graph.overlaps.size() == 1);
    CHECK(result.graph.components.size() == 2);
    CHECK(result.graph.arcs.size() == 2);
    // The two orders of the pairs.
    CHECK(difference(result.graph, intersect(x, x).graph, {{2, 3, 0, 1}, {}}) == "");
    CHECK(difference(result.graph, intersect(x, x.transposed()).graph, {{0, 1, 3, 2}, {}}) == "");
    CHECK(difference(result.graph, intersect(x, piece(x, {1, 0, 0, 1})).graph,
                     {same, {false, false, true, false}}) == "");
    CHECK(difference(result.graph, intersect(x.elevated(3, 3), x).graph, {}) == "");
  }
}

TEST_CASE("pieces of every kind: other pieces of a surface that meets itself") {
  for (const RationalPatch& x : swept_loops()) {
    const Arc itself = self_intersect(x).graph.arcs.at(0);
    const auto [lower, upper] =
        std::minmax(itself.polyline[0].parameters[0], itself.polyline[0].parameters[2]);
    CHECK(lower < 0.1);
    CHECK(upper > 0.9);
    for (const Rational& end : {q(1, 2), q(19, 20)}) {
      const IntersectResult result = intersect(x, piece(x, {0, end, 0, 1}));
      CHECK(result.status == Status::complete);
      CHECK(result.graph.overlaps.size() == 1);
      // The point of the second patch is near u = 0, or near u = 1 as well.
      CHECK(result.graph.arcs.size() == (to_double(end) < upper ? 1 : 2));
    }
  }
}

TEST_CASE("pieces of every kind: parameters that are Moebius maps of each other") {
  random_nets::Generator generator(45);
  const std::array<Rational, 4> ratios = {2, q(1, 3), q(17, 11), q(1234, 4321)};
  int i = 0;
  for (const std::array<int, 2> degree :
       {std::array{1, 1}, std::array{1, 2}, std::array{2, 2}, std::array{3, 1}, std::array{3, 3}}) {
    for (const bool weighted : {false, true}) {
      INFO("seed 45, bidegree " << degree[0] << " " << degree[1] << ", weighted " << weighted);
      const auto net = random_nets::crossing(generator, {degree[0], degree[1], 1, 1}, i % 3 == 0).x;
      const RationalPatch x = weighted ? random_nets::weighted(generator, net) : RationalPatch(net);
      check_moebius_pieces(x, ratios[static_cast<std::size_t>(i) % 4],
                           ratios[static_cast<std::size_t>(i + 1) % 4]);
      ++i;
    }
  }
  const auto net = random_nets::crossing(generator, {2, 2, 1, 1}, true).x;
  check_moebius_pieces(random_nets::weighted(generator, mapped(net, q(127, 5), 100000000)), 1, q(3, 2));
  // Ratios with as many digits as doubles have, and more.
  const RationalPatch x = random_nets::weighted(generator, net);
  check_moebius_pieces(x, from_double(0.7), from_double(1.9) / from_double(0.3));
  check_moebius_pieces(x, 1 + power_of_two(-100), 3);
}

TEST_CASE("pieces of every kind: a quarter of a cylinder by two sets of weights") {
  // Weights 1, 1, 2 and 2, 1, 1: the same quarter of a circle, t' = t / (2 - t).
  const random_nets::Net net = {{{1, 0, 0}, {1, 0, 2}}, {{1, 1, 0}, {1, 1, 2}}, {{0, 1, 0}, {0, 1, 2}}};
  const RationalPatch x(net, {{1, 1}, {1, 1}, {2, 2}});
  const RationalPatch y(net, {{2, 2}, {1, 1}, {1, 1}});
  REQUIRE(x(q(1, 2), 0) == y(q(2, 3), 0));
  check_overlap(x, y, {0, 1, 0, 1});
  check_overlap(x, piece(y, {q(2, 3), 1, 0, q(1, 2)}), {q(1, 2), 1, 0, q(1, 2)});
}

TEST_CASE("pieces of every kind: Moebius parameters, a part of a side, a corner, or nothing in common") {
  random_nets::Generator generator(46);
  for (const bool weighted : {false, true}) {
    INFO("seed 46, weighted " << weighted);
    const auto net = random_nets::crossing(generator, {3, 2, 1, 1}, true).x;
    const RationalPatch x = weighted ? random_nets::weighted(generator, net) : RationalPatch(net);
    const auto beside = [&](const Ends& ends) {
      return intersect(piece(x, {0, q(1, 2), 0, q(1, 2)}), changed(piece(x, ends), q(2, 3), 3)).graph;
    };
    const IntersectionGraph side = beside({q(1, 2), 1, q(1, 4), 1});
    CHECK(side.overlaps.empty());
    REQUIRE(side.arcs.size() == 1);
    for (const int id : {side.arcs[0].from, side.arcs[0].to}) {
      const ParameterBox& box = side.nodes[static_cast<std::size_t>(id)].box;
      CHECK(box[0].lower == 1);
      CHECK((box[1].lower == q(1, 2) || box[1].lower == 1));
      // v/2 = 1/4 + 3/4 t, the map back of which is s = 3 t / (1 - t + 3 t) for l = 3.
      const Rational t = (box[1].lower / 2 - q(1, 4)) / q(3, 4);
      CHECK(box[3].lower == 3 * t / (1 - t + 3 * t));
    }
    CHECK(beside({q(1, 2), 1, q(1, 2), 1}).isolated_points.size() == 1);
    CHECK(beside({q(2, 3), 1, 0, 1}).nodes.empty());
  }
}

TEST_CASE("pieces of every kind: the same graph exchanged, and after a projective map") {
  random_nets::Generator generator(47);
  for (const std::array<int, 2> degree : {std::array{2, 2}, std::array{3, 1}, std::array{3, 3}}) {
    for (const bool moebius : {false, true}) {
      INFO("seed 47, bidegree " << degree[0] << " " << degree[1] << ", Moebius " << moebius);
      const auto net = random_nets::crossing(generator, {degree[0], degree[1], 1, 1}, true).x;
      const RationalPatch whole = random_nets::weighted(generator, net);
      const RationalPatch x = piece(whole, {0, q(2, 3), 0, 1});
      const RationalPatch part = piece(whole, {q(1, 3), 1, q(1, 4), 1});
      const RationalPatch y = moebius ? changed(part, 2, q(1, 3)) : part;
      const IntersectionGraph expected = intersect(x, y).graph;
      REQUIRE(expected.overlaps.size() == 1);
      CHECK(difference(expected, intersect(y, x).graph, {{2, 3, 0, 1}, {}}) == "");
      const auto map = random_nets::projective_map(generator);
      CHECK(difference(expected, intersect(random_nets::image(x, map), random_nets::image(y, map)).graph,
                       {}) == "");
    }
  }
}

}  // namespace exsect::pieces_of_every_kind_test
