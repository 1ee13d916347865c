#include <exsect/geometry/number.h>
#include <exsect/solver/intersect.h>

#include <iostream>

int main() {
  using exsect::Rational;
  // In: integers, fractions, text as in patch files, and doubles, each exactly what it is.
  const Rational third = Rational(1) / 3;
  const Rational tenth = exsect::parse_number("0.1");
  const Rational near_tenth = exsect::from_double(0.1);
  std::cout << exsect::to_string(tenth) << ", " << exsect::to_string(near_tenth) << '\n';

  // A bilinear patch (u, v, u v) and the plane z = 1/3 over the same square.
  const auto x = exsect::BezierPatch::elevated({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}});
  const auto y =
      exsect::BezierPatch::elevated({{{0, 0, third}, {0, 1, third}}, {{1, 0, third}, {1, 1, third}}});

  // Out: each end of the hyperbola u v = 1/3 has a box with exact ends that holds this one point.
  for (const exsect::Node& node : exsect::intersect(x, y).graph.nodes) {
    for (const exsect::Side& side : node.on) std::cout << name(side.parameter) << '=' << side.value << ' ';
    std::cout << "u in [" << exsect::to_string(node.box[0].lower) << ", "
              << exsect::to_string(node.box[0].upper) << "]\n";
  }
}
