#include <exsect/geometry/number.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/line_patch.h>

#include <iostream>

int main() {
  using exsect::Rational;
  const auto pair = exsect::read_patches("examples/chapter9-first.json").patches;
  const exsect::LineQuery half = {exsect::Parameter::u, Rational(1) / 2};
  const auto line = exsect::intersect_line(pair[0].patch, pair[1].patch, half);
  std::cout << line.solution.points.size() << " points, eliminant of degree " << line.eliminant.degree()
            << '\n';

  for (const exsect::CertifiedPoint& point : line.solution.points) {
    // The closed box holds the point; any width can be asked for.
    const exsect::ParameterBox box = point.refined_to(exsect::power_of_two(-100)).box();
    const exsect::RationalInterval& s = box[index(exsect::Parameter::s)];
    // The eliminant changes its sign between the ends of s: exact signs, so a root lies between them.
    std::cout << "s near " << exsect::to_double(s.lower) << ", signs " << line.eliminant.sign_at(s.lower)
              << ' ' << line.eliminant.sign_at(s.upper) << (point.multiplicity() == 1 ? ", transversal" : "")
              << '\n';
  }
}
