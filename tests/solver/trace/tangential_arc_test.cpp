#include "trace/tangential_arc.h"

#include <exsect/geometry/patch_file.h>

#include "support/bent_contact.h"

namespace exsect::tangential_arc_test {
namespace {

using System = PairSystem<DoubleBall>;
using Point4 = BallPoint<DoubleBall>;

}  // namespace

TEST_CASE("tangential arc: a contact curve is traced to both its ends", "[trace]") {
  const auto pair = read_patches(std::string(EXSECT_EXAMPLES) + "/touching-curve.json").patches;
  const System system(pair[0].patch, pair[1].patch, {0, 0, 0}, 0);
  const auto at = [](double u) {
    const double v = 1.5 - 2 * u;
    return Point4{u, v, (u + 0.1) / 1.2, (v + 0.1) / 1.2};
  };
  const auto around = [](Point4 p) {
    for (DoubleBall& c : p) c = c.widened(1e-14);
    return p;
  };
  const Landmarks<DoubleBall> ends = {around(at(0.75)), around(at(0.25)), around({0.1, 0.2, 0.3, 0.4})};
  const auto outcome = trace_contact(system, ends, around(at(0.4)), {});
  REQUIRE(std::holds_alternative<TangentialArc<DoubleBall>>(outcome));
  const auto& arc = std::get<TangentialArc<DoubleBall>>(outcome);
  CHECK(arc.start + arc.end == 1);
  for (double u = 0.26; u < 0.75; u += 0.03) {
    CHECK(passes_through(arc, around(at(u))));
    Point4 beside = at(u);
    beside[1] = beside[1] + DoubleBall(0.1);
    CHECK_FALSE(passes_through(arc, beside));
  }
  const int rising = arc.end == 0 ? 1 : -1;
  for (const int which : {0, 1}) {
    CHECK(certain_direction(system, arc, which, 0) == rising);
    CHECK(certain_direction(system, arc, which, 1) == -rising);
  }
  // Without the landmark at the end the curve leaves the domain, which is noticed.
  CHECK(std::holds_alternative<TraceFailure>(trace_contact(system, {ends[0]}, around(at(0.4)), {})));
}

TEST_CASE("tangential arc: to an irrational end, and directions where a parameter turns", "[trace]") {
  const testing::BentContact contact;
  const auto arc = contact.traced();
  REQUIRE(arc.start + arc.end == 1);
  const int to_one = arc.end == 0 ? 1 : -1;  // u grows towards the first landmark
  for (const int which : {0, 1})
    for (const std::size_t j : {0U, 1U, 3U})
      CHECK(certain_direction(contact.system, arc, which, j) == to_one);
  // r' = 3 - 4 u, which is -1 at u = 1 and positive at the other end.
  CHECK(certain_direction(contact.system, arc, arc.end == 0 ? 1 : 0, 2) == -to_one);
  CHECK(certain_direction(contact.system, arc, arc.end == 0 ? 0 : 1, 2) == to_one);
  CHECK(passes_through(arc, testing::ball_point<DoubleBall>(testing::BentContact::at({3, 4}))));
  CHECK(std::holds_alternative<TraceFailure>(
      trace_contact(contact.system, contact.ends,
                    testing::ball_point<DoubleBall>(testing::BentContact::at({1, 2})), [] { return true; })));
}

}  // namespace exsect::tangential_arc_test
