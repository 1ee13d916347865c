#include "support/exact_case.h"

#include <functional>

#include "support/case_file.h"
#include "support/catch.h"
#include "support/families.h"

namespace exsect::exact_case_test {
namespace {

/// Every one of these differs from the cap's loop, and is told from it.
std::vector<std::function<void(ExactCase&)>> wrong_answers() {
  return {[](ExactCase& c) { c.graph.nodes[1].at[0] = Rational(1, 2) + Rational(1, 1000000000); },
          [](ExactCase& c) { c.graph.nodes[0].at[3] = RealAlgebraic(1); },
          [](ExactCase& c) { c.graph.nodes[2].wrt = {Parameter::u}; },
          [](ExactCase& c) { c.graph.nodes[2].kind = NodeKind::cusp; },
          [](ExactCase& c) { c.graph.nodes[2].free = {Parameter::v}; },
          [](ExactCase& c) {
            c.graph.nodes.push_back({{0, 0, 0, 0}});
          },
          [](ExactCase& c) { c.graph.arcs.pop_back(); },
          [](ExactCase& c) { c.graph.arcs[1].contact = Contact::tangential; },
          [](ExactCase& c) { c.graph.arcs[1].place = ArcPlace::patch_boundary; },
          [](ExactCase& c) { c.graph.arcs[1].to = 3; },
          [](ExactCase& c) { c.graph.arcs[0].samples = c.graph.arcs[2].samples; },
          [](ExactCase& c) { c.graph.overlaps = {{}}; }};
}

}  // namespace

TEST_CASE("exact case: a wrong answer is seen") {
  const ExactCase right = families::cap(Rational(1, 10), families::Plane::square);
  IntersectOptions options;
  options.tolerance = 1e-5;
  const IntersectResult result = intersect(right.x, right.y, options);
  CHECK(difference(result, right) == "");
  for (const auto& change : wrong_answers()) {
    ExactCase wrong = right;
    change(wrong);
    CHECK(difference(result, wrong) != "");
  }
  IntersectResult undecided = result;
  undecided.status = Status::incomplete;
  undecided.incomplete = {{ParameterBox{}, "for a test"}};
  CHECK(difference(undecided, right) == "incomplete: for a test");
  IntersectResult more = result;
  more.graph.isolated_points = {0};
  CHECK(difference(more, right) != "");
  more.graph.isolated_points = {};
  more.graph.components[0].shape = ComponentShape::open;
  CHECK(difference(more, right) != "");
}

TEST_CASE("exact case: an isolated point that is missing is seen") {
  const ExactCase nothing = families::cap(Rational(-1, 10), families::Plane::square);
  ExactCase touch = nothing;
  touch.graph.nodes = {{{Rational(1, 2), Rational(1, 2), Rational(1, 2), Rational(1, 2)}, NodeKind::touch}};
  CHECK(failure(nothing) == "");
  CHECK(failure(touch) != "");
}

TEST_CASE("exact case: files keep every family") {
  for (const ExactCase& c : families::specimens()) {
    INFO(c.name);
    const ExactCase again = parse_case(patches_text(c), expected_text(c));
    CHECK(patches_text(again) == patches_text(c));
    CHECK(expected_text(again) == expected_text(c));
  }
}

}  // namespace exsect::exact_case_test
