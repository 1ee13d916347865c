#include "output/text/shown_line.h"

#include "output/text/json_forms.h"

namespace exsect::cli {

const char* name(LineShape shape) {
  switch (shape) {
    case LineShape::conic:
      return "conic";
    case LineShape::straight:
      return "straight";
    case LineShape::folded:
      return "folded";
    case LineShape::plane_cubic:
      return "plane cubic";
    case LineShape::twisted_cubic:
      return "twisted cubic";
    case LineShape::point:
      break;
  }
  return "point";
}

Parameter partner(Parameter p) {
  constexpr std::array<Parameter, 4> partners = {Parameter::v, Parameter::u, Parameter::s, Parameter::r};
  return partners[index(p)];
}

std::vector<ShownPoint> shown_points(const LinePoints& solution, const RationalPatch& x) {
  std::vector<ShownPoint> shown;
  for (const CertifiedPoint& point : solution.points) {
    const CertifiedPoint fine = point.refined_to(shown_width());
    std::array<Rational, 4> middle;
    std::array<double, 4> parameters;
    for (Parameter p : all_parameters) {
      middle[index(p)] = fine.box()[index(p)].midpoint();
      parameters[index(p)] = to_double(middle[index(p)]);
    }
    const Point space = x(middle[index(Parameter::u)], middle[index(Parameter::v)]);
    shown.push_back({fine, parameters, {to_double(space[0]), to_double(space[1]), to_double(space[2])}});
  }
  return shown;
}

}  // namespace exsect::cli
