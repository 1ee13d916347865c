#include "trace/landmark_node.h"

#include "support/known_curves.h"

namespace exsect::landmark_node_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

}  // namespace

TEST_CASE("landmark node: the box as it is, doubles near it, the point of space by the frame", "[trace]") {
  // The scaled point times 4, from (10, -3, 1/2).
  const ModelFrame frame = {{10, -3, 0.5}, 2};
  const Rational third(1, 3), e = power_of_two(-60);
  const ParameterBox box = {{{third - e, third + e}, {0, 0}, {third - e, third + e}, {0, 0}}};
  const Node node = landmark_node(system_of<DoubleBall>(kParabola), frame, on_diagonal(third, 0), box,
                                  {{Parameter::v, 0}, {Parameter::s, 0}});
  for (std::size_t j = 0; j < 4; ++j) {
    CHECK(node.box[j].lower == box[j].lower);
    CHECK(node.box[j].upper == box[j].upper);
  }
  CHECK(node.approx == std::array<double, 4>{1.0 / 3, 0, 1.0 / 3, 0});
  CHECK(node.point[0] == Approx(10 + 4.0 / 3));
  CHECK(node.point[1] == -3);
  CHECK(node.on.size() == 2);
  CHECK(node.kinds == std::vector<NodeKind>{NodeKind::boundary});
  const ParameterBox inside = {{{third, third}, {third, third}, {third, third}, {third, third}}};
  CHECK(landmark_node(system_of<DoubleBall>(kParabola), frame, on_diagonal(third, third), inside, {})
            .on.empty());
}

}  // namespace exsect::landmark_node_test
