#include <exsect/geometry/number.h>
#include <exsect/geometry/rational_patch.h>

#include <iostream>

int main() {
  using exsect::RationalPatch;
  // A quarter of a cylinder: the circle (1 - u^2, 2 u) / (1 + u^2) along z.
  const RationalPatch quarter({{{1, 0, 0}, {1, 0, 1}}, {{1, 1, 0}, {1, 1, 1}}, {{0, 1, 0}, {0, 1, 1}}},
                              {{1, 1}, {1, 1}, {2, 2}});
  const exsect::Point p = quarter(exsect::Rational(1) / 2, 0);
  std::cout << exsect::to_string(p[0]) << ' ' << exsect::to_string(p[1]) << ", " << kind_of(quarter) << '\n';

  // A net of another shape: the same map, so every method takes it.
  const auto flat = exsect::BezierPatch::elevated({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}});
  const RationalPatch cubic = RationalPatch(flat).elevated(3, 3);
  std::cout << kind_of(cubic) << ": " << (cubic.biquadratic() == flat ? "the same" : "another") << '\n';

  try {
    RationalPatch({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}}, {{1, -2}, {1, 1}});
  } catch (const exsect::PatchError& error) {
    std::cout << error.what() << '\n';
  }
}
