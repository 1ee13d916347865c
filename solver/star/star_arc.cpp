#include "star/star_arc.h"

// The arcs of a star between its ports and its centre.
#include <algorithm>

#include "answer/exact_source.h"
#include "answer/parameter_box.h"
#include "line/line_points_in.h"

namespace exsect {

bool add_layers(StarNeighbourhood& star, const BezierPatch& x, const BezierPatch& y, const RealAlgebraic& at,
                int count, const StopRequest& stop) {
  const Rational fine = star.box[index(star.sweep)].width() * power_of_two(-20);
  const RationalInterval centre = at.refined_to(std::min<Rational>(fine, power_of_two(-100))).interval();
  for (const int side : {-1, 1}) {
    const auto ports = std::count_if(star.ports.begin(), star.ports.end(), [&](const Port& port) {
      return port.across == star.sweep && port.side == side;
    });
    const RationalInterval& slab = star.box[index(star.sweep)];
    const Rational end = side < 0 ? slab.lower : slab.upper;
    const Rational step = ((side < 0 ? centre.lower : centre.upper) - end) / (count + 1);
    for (int i = 1; i <= count && ports > 0; ++i) {
      if (is_stopped(stop)) {
        return false;
      }
      const Rational about = end + step * i;
      const Rational value = simplest_between(about - abs(step) / 4, about + abs(step) / 4);
      auto points = line_points_in(x, y, {star.sweep, value}, star.box);
      if (!points || static_cast<std::ptrdiff_t>(points->size()) != ports) {
        return false;
      }
      star.layers[side < 0 ? 0 : 1].push_back(*std::move(points));
    }
  }
  return true;
}

namespace {

ParameterBox hull(const std::vector<CertifiedPoint>& points) {
  ParameterBox result = points.front().box();
  for (const CertifiedPoint& point : points) {
    for (std::size_t j = 0; j < 4; ++j) {
      result[j] = {std::min(result[j].lower, point.box()[j].lower),
                   std::max(result[j].upper, point.box()[j].upper)};
    }
  }
  return result;
}

double squared_distance(const CertifiedPoint& a, const CertifiedPoint& b) {
  double sum = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    const double d = to_double(a.box()[j].midpoint() - b.box()[j].midpoint());
    sum += d * d;
  }
  return sum;
}

/// Whether parameter p of a port lies before (-1) or behind (+1) that of the centre, or equals it; empty if
/// that is not decided.
std::optional<int> side_of_centre(const StarNeighbourhood& star, const Port& port, Parameter p) {
  for (Rational width = power_of_two(-100); width > power_of_two(-2000); width *= width) {
    const RationalInterval at = port.point.refined_to(width).box()[index(p)];
    const RationalInterval centre = star.centre.refined_to(width).box()[index(p)];
    if (at.upper < centre.lower || centre.upper < at.lower) {
      return at.upper < centre.lower ? -1 : 1;
    }
  }
  const RationalInterval centre = star.centre.box()[index(p)];
  const auto exact = port.point.exact();
  const bool equal = centre.width() == 0 && exact && takes_value(*exact, index(p), centre.lower);
  return equal ? std::optional(0) : std::nullopt;
}

}  // namespace

std::optional<std::vector<Parameter>> turning_parameters(const StarNeighbourhood& star) {
  std::vector<Parameter> result;
  for (const Parameter p : all_parameters) {
    const auto first = side_of_centre(star, star.ports.at(0), p);
    const auto second = side_of_centre(star, star.ports.at(1), p);
    if (!first || !second) {
      return std::nullopt;
    }
    if (*first * *second > 0) {
      result.push_back(p);
    }
  }
  return result;
}

// The arc is monotone in all parameters: its point in a layer is in the hull of one of its possible points in
// the layer before and the centre, and between the layers it lies in the hull of all these points.
StarArc star_arc(const StarNeighbourhood& star, const Port& port) {
  StarArc result;
  if (port.across != star.sweep) {
    result.hulls.push_back(hull({port.point, star.centre}));
    return result;
  }
  std::vector<CertifiedPoint> possible = {port.point};
  CertifiedPoint last = port.point;
  for (const std::vector<CertifiedPoint>& layer : star.layers[port.side < 0 ? 0 : 1]) {
    std::vector<CertifiedPoint> inner;
    for (const CertifiedPoint& point : layer) {
      if (std::any_of(possible.begin(), possible.end(), [&](const CertifiedPoint& outer) {
            return meet(point.box(), hull({outer, star.centre}));
          })) {
        inner.push_back(point);
      }
    }
    last =
        *std::min_element(inner.begin(), inner.end(), [&](const CertifiedPoint& a, const CertifiedPoint& b) {
          return squared_distance(a, last) < squared_distance(b, last);
        });
    possible.insert(possible.end(), inner.begin(), inner.end());
    result.vertices.push_back(last);
    result.hulls.push_back(hull(possible));
    possible = std::move(inner);
  }
  possible.push_back(star.centre);
  result.hulls.push_back(hull(possible));
  return result;
}

}  // namespace exsect
