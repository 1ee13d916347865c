// Candidates for patches of any degrees, with and without weights: made from the result, changed on purpose,
// and the same under maps of the patches that keep the intersection.
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/verify/verify.h>

#include <algorithm>
#include <cmath>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::verify_rational_test {
namespace {

using random_nets::Generator;

struct Subject {
  RationalPatch x;
  RationalPatch y;
};

/// Every arc as one curve: in space, in (u,v) and in (r,s).
Candidate candidate_of(const IntersectionGraph& graph) {
  Candidate candidate;
  for (const Arc& arc : graph.arcs) {
    std::array<std::vector<std::array<double, 3>>, 3> points;
    for (const PolylineVertex& v : arc.polyline) {
      points[0].push_back(v.point);
      points[1].push_back({v.parameters[0], v.parameters[1], 0});
      points[2].push_back({v.parameters[2], v.parameters[3], 0});
    }
    candidate.curves.push_back({});
    candidate.curves.back().space = polyline(points[0]);
    candidate.curves.back().first = polyline(points[1]);
    candidate.curves.back().second = polyline(points[2]);
  }
  return candidate;
}

IntersectResult fine(const Subject& pair) {
  IntersectOptions options;
  options.tolerance = 1e-5;
  options.turning = {};
  return intersect(pair.x, pair.y, options);
}

Verdict verdict_of(const Candidate& candidate, const Subject& pair) {
  VerifyOptions options;
  options.tolerance = 1e-3;
  return verify(candidate, pair.x, pair.y, options).verdict;
}

std::string text(const Verdict& verdict) {
  std::string result = name(verdict.agreement);
  for (const Difference& d : verdict.differences) result += std::string("; ") + name(d.kind) + ": " + d.text;
  for (const std::string& open : verdict.undecided) result += "; ? " + open;
  return result;
}

std::vector<Subject> subjects(Generator& generator) {
  std::vector<Subject> result;
  for (const auto& degrees :
       std::vector<std::array<int, 4>>{{3, 3, 3, 3}, {1, 3, 3, 2}, {2, 2, 2, 2}, {3, 3, 1, 2}}) {
    const auto nets = random_nets::crossing(generator, degrees, true);
    if (degrees[0] != 2) result.push_back({nets.first(), nets.second()});
    result.push_back({random_nets::weighted(generator, nets.x), nets.second()});
    result.push_back({random_nets::weighted(generator, nets.x), random_nets::weighted(generator, nets.y)});
  }
  const auto loop = random_nets::loop(generator, {3, 3, 3, 3});
  result.push_back({loop.first(), loop.second()});
  return result;
}

}  // namespace

TEST_CASE("verify, weights and degree three: the result agrees, a changed one does not") {
  const unsigned seed = 21;
  INFO("seed " << seed);
  Generator generator(seed);
  int compared = 0;
  for (const Subject& pair : subjects(generator)) {
    INFO("pair " << compared);
    const IntersectResult result = fine(pair);
    if (result.status != Status::complete || result.graph.arcs.empty()) continue;
    ++compared;
    const Candidate right = candidate_of(result.graph);
    CHECK(text(verdict_of(right, pair)) == "agrees");

    Candidate one_less = right;
    one_less.curves.pop_back();
    CHECK(verdict_of(one_less, pair).agreement == Agreement::disagrees);

    for (const std::size_t square : {1U, 2U}) {  // the curve of one patch's parameters alone, and moved
      Candidate alone = right;
      for (CandidateCurve& curve : alone.curves) {
        curve.space.reset();
        (square == 1 ? curve.second : curve.first).reset();
      }
      CHECK(text(verdict_of(alone, pair)) == "agrees");
      for (CandidateCurve& curve : alone.curves)
        for (auto& p : (square == 1 ? curve.first : curve.second)->points)
          p[0] = std::clamp(p[0] + (p[0] < 0.5 ? 0.02 : -0.02), 0., 1.);
      CHECK(verdict_of(alone, pair).agreement == Agreement::disagrees);
    }

    Candidate off = right;
    for (auto& p : off.curves.front().space->points) p[2] += 0.01;
    CHECK(verdict_of(off, pair).agreement == Agreement::disagrees);
  }
  CHECK(compared >= 9);
}

TEST_CASE(
    "verify, weights and degree three: a projective map of both patches keeps the curves of parameters") {
  const unsigned seed = 22;
  INFO("seed " << seed);
  Generator generator(seed);
  const auto nets = random_nets::crossing(generator, {2, 2, 2, 2}, true);
  const Subject plain = {nets.first(), nets.second()};
  // w = 1 + x/8 + y/16 + z/8
  const auto mapped = [](const RationalPatch& patch) {
    std::vector<std::vector<HomogeneousPoint>> net;
    for (int i = 0; i <= patch.degree_u(); ++i) {
      net.emplace_back();
      for (int j = 0; j <= patch.degree_v(); ++j) {
        HomogeneousPoint p = patch.homogeneous(i, j);
        p[3] += p[0] / 8 + p[1] / 16 + p[2] / 8;
        net.back().push_back(p);
      }
    }
    return RationalPatch::from_homogeneous(net);
  };
  const Subject projected = {mapped(plain.x), mapped(plain.y)};
  IntersectOptions options;
  options.tolerance = 1e-6;
  const IntersectResult result = intersect(plain.x, plain.y, options);
  REQUIRE(result.status == Status::complete);
  Candidate candidate = candidate_of(result.graph);
  for (CandidateCurve& curve : candidate.curves) curve.space.reset();
  CHECK(text(verdict_of(candidate, plain)) == "agrees");
  CHECK(text(verdict_of(candidate, projected)) == "agrees");
  for (const auto degree : {2, 3})
    CHECK(text(verdict_of(candidate, {projected.x.elevated(3, degree), plain.y})) != "agrees");
  CHECK(text(verdict_of(candidate, {projected.x.elevated(3, 2), projected.y.elevated(2, 3)})) == "agrees");
}

}  // namespace exsect::verify_rational_test
