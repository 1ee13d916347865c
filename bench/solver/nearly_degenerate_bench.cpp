// Pairs at the distance 10^-k from a special position, in exact arithmetic: the time should not depend on k.
#include <benchmark/benchmark.h>
#include <exsect/solver/intersect.h>

#include <string>
#include <utility>
#include <vector>

#include "support/families.h"

namespace {

using namespace exsect;
using families::Plane;
using Member = ExactCase (*)(const Rational& e);

ExactCase lifted(ExactCase c, const Rational& e) {
  ControlNet net = c.x.net();
  for (auto& row : net)
    for (Point& p : row) p[2] += e;
  c.x = BezierPatch(net);
  return c;
}

const std::vector<std::pair<std::string, Member>>& members() {
  static const std::vector<std::pair<std::string, Member>> all = {
      {"touch point", [](const Rational& e) { return families::cap(e, Plane::quadratic); }},
      {"crossing", [](const Rational& e) { return families::near_crossing(e, Plane::quadratic); }},
      {"tangent lines", [](const Rational& e) { return families::near_sheets(e, Plane::quadratic); }},
      {"tangent curve",
       [](const Rational& e) {
         return lifted(families::tangent_curve(Rational(1, 3), Plane::quadratic), -e);
       }},
      {"tangent and transversal",
       [](const Rational& e) { return lifted(families::tangent_and_transversal(Plane::quadratic), e); }},
      {"cusp", [](const Rational& e) { return lifted(families::curve_cusp(Plane::quadratic), e); }},
      {"tangent branches",
       [](const Rational& e) { return lifted(families::tangent_branches(Plane::quadratic), e); }},
      {"lifted copy", [](const Rational& e) { return families::lifted_copy(e); }},
      {"tilted copy", [](const Rational& e) { return families::tilted_copy(e); }},
      {"shared side", [](const Rational& e) { return families::turned_side(e); }}};
  return all;
}

void run(benchmark::State& state, Member member) {
  Integer power = 1;
  for (int i = 0; i < state.range(0); ++i) power *= 10;
  const ExactCase c = member(Rational(1, power));
  IntersectOptions options;
  options.exact = true;
  for (auto _ : state) {
    const IntersectResult result = intersect(c.x, c.y, options);
    if (result.status != Status::complete) state.SkipWithError("incomplete");
  }
}

const bool registered = [] {
  for (const auto& [name, member] : members())
    benchmark::RegisterBenchmark(("nearly/" + name).c_str(), run, member)
        ->Arg(3)
        ->Arg(6)
        ->Arg(9)
        ->Arg(12)
        ->Arg(20)
        ->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
