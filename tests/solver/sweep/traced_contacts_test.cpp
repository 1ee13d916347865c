#include "sweep/traced_contacts.h"

#include "support/families.h"
#include "support/known_curves.h"
#include "sweep/traced_curves.h"
#include "swept_pair.h"

namespace exsect::traced_contacts_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

TracedCurves<DoubleBall> traced(SweptPair& pair) {
  return trace_curves(pair.system, pair.landmarks, pair.data, pair.width, {});
}

}  // namespace

TEST_CASE("traced contacts: a curve along which the patches touch") {
  const ExactCase line = families::tangent_curve(q(1, 3), families::Plane::square);
  SweptPair pair(line.x, line.y);
  const TracedCurves<DoubleBall> result = traced(pair);
  CHECK(result.problems.empty());
  CHECK(result.curves.empty());
  REQUIRE(result.contacts.size() == 1);
  // u = v/3 + 1/4.
  CHECK(contacts_through(result, on_diagonal(q(5, 12), q(1, 2))) == 1);
  CHECK(contacts_through(result, on_diagonal(q(1, 2), q(1, 2))) == 0);
}

TEST_CASE("traced contacts: appended to what is traced already, none where patches only cross") {
  SweptPair circle(graph_patch(kCircle), plane_patch());
  TracedCurves<DoubleBall> curves = traced(circle);
  trace_contacts(circle.system, circle.landmarks, circle.data, circle.width, {}, curves);
  CHECK(curves.contacts.empty());
  CHECK(curves.problems.empty());
  CHECK(curves.curves.size() == 1);

  const ExactCase line = families::tangent_curve(q(1, 3), families::Plane::square);
  SweptPair touching(line.x, line.y);
  TracedCurves<DoubleBall> contacts;
  for (int round = 0; round < 2; ++round) {
    trace_contacts(touching.system, touching.landmarks, touching.data, touching.width, {}, contacts);
    CHECK(contacts.problems.empty());
    CHECK(contacts.contacts.size() == 1);  // once: what is on a known curve is not traced again
  }
}

}  // namespace exsect::traced_contacts_test
