#include "revolution_mesh.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "curve/short_rational.h"

namespace exsect {
namespace {

struct PlanePoint {
  Rational r;
  Rational z;
};

/// At least the squared distance of p from the segment a b, exactly it unless the foot lies outside.
Rational squared_distance_to_segment(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
  const Rational dr = b.r - a.r, dz = b.z - a.z;
  const Rational length = dr * dr + dz * dz;
  Rational t = length == 0 ? Rational(0) : Rational(((p.r - a.r) * dr + (p.z - a.z) * dz) / length);
  t = std::clamp(t, Rational(0), Rational(1));
  const Rational r = p.r - a.r - t * dr, z = p.z - a.z - t * dz;
  return r * r + z * z;
}

/// The largest squared distance of curve and chord over each of the equal parts. The curve lies in the hull
/// of its control points, the distance from a segment is convex, and every point of the chord is the foot
/// of a point of the curve.
Rational squared_chord_error(const HomogeneousCurve& curve, int along, int degree) {
  Rational largest = 0;
  for (int i = 0; i < along; ++i) {
    const Rational from(i, along), to(i + 1, along);
    const auto coefficients = [&](const Polynomial& f) {
      return bernstein_coefficients(f, degree, from, to);
    };
    const auto r = coefficients(curve.numerators[0]), z = coefficients(curve.numerators[1]),
               w = coefficients(curve.denominator);
    std::vector<PlanePoint> control;
    for (std::size_t k = 0; k < r.size(); ++k) {
      if (w[k] <= 0)
        throw std::domain_error("revolution mesh: the weights of a part are not positive; take more parts");
      control.push_back({r[k] / w[k], z[k] / w[k]});
    }
    for (const PlanePoint& p : control)
      largest = std::max(largest, squared_distance_to_segment(p, control.front(), control.back()));
  }
  return largest;
}

/// Rational points (cos, sin) of the unit circle near equally spaced angles, counterclockwise from (1,0).
std::vector<PlanePoint> circle_points(int around) {
  std::vector<PlanePoint> points;
  for (int k = 0; k < around; ++k) {
    const double angle = 2 * std::numbers::pi * k / around;
    if (2 * k == around) {
      points.push_back({-1, 0});
      continue;
    }
    const Rational t = from_double(std::ldexp(std::round(std::ldexp(std::tan(angle / 2), 20)), -20));
    points.push_back({(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)});
  }
  return points;
}

/// At least 1 - cos(D/2), D the largest angle between neighbours: (1 - c)/(2 (1 + c)) for c = cos D >= 0.
Rational sagitta(const std::vector<PlanePoint>& circle) {
  Rational least_cosine = 1;
  for (std::size_t k = 0; k < circle.size(); ++k) {
    const PlanePoint& a = circle[k];
    const PlanePoint& b = circle[(k + 1) % circle.size()];
    least_cosine = std::min(least_cosine, Rational(a.r * b.r + a.z * b.z));
  }
  return (1 - least_cosine) / (2 * (1 + std::max(least_cosine, Rational(0)))) + (least_cosine < 0 ? 1 : 0);
}

}  // namespace

TriangleMesh revolution_mesh(const BezierCurve& profile, int along, int around) {
  return in_nearest_rounding([&] {
    if (along < 1 || around < 4)
      throw std::invalid_argument("revolution mesh: along >= 1 and around >= 4 are needed");
    const HomogeneousCurve curve = homogeneous(profile);
    const std::vector<PlanePoint> circle = circle_points(around);
    TriangleMesh mesh;
    Rational largest_r = 0, largest = 0;
    for (int i = 0; i <= along; ++i) {
      const std::vector<Rational> p = profile(Rational(i, along));
      if (p[0] < 0) throw std::invalid_argument("revolution mesh: the profile leaves r >= 0");
      largest_r = std::max(largest_r, p[0]);
      largest = std::max({largest, p[0], Rational(abs(p[1]))});
      for (const PlanePoint& c : circle)
        mesh.vertices.push_back({to_double(p[0] * c.r), to_double(p[0] * c.z), to_double(p[1])});
    }
    for (int i = 0; i < along; ++i)
      for (int k = 0; k < around; ++k) {
        const int a = i * around + k, b = i * around + (k + 1) % around;
        mesh.triangles.push_back({a, b, b + around});
        mesh.triangles.push_back({a, b + around, a + around});
      }
    // A point of a triangle is a mean of points (r_k, z_k) turned by angles at most D apart: its own r is
    // between cos(D/2) m and m, m the same mean of the r_k, and (m, mean of the z_k) lies on a chord. The
    // corners are rounded by at most 2^-53 of their coordinates, or half the least positive double.
    const int degree = std::max(profile.degree(), curve.degree());
    const Rational rounding = 2 * (power_of_two(-53) * largest + power_of_two(-1074));
    mesh.distance = rounded_up(Rational(root_above(squared_chord_error(curve, along, degree)) +
                                        largest_r * sagitta(circle) + rounding));
    return mesh;
  });
}

std::string obj_text(const TriangleMesh& mesh, const std::vector<std::string>& comments) {
  return in_nearest_rounding([&] {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    for (const std::string& line : comments) text << "# " << line << "\n";
    for (const auto& v : mesh.vertices) text << "v " << v[0] << " " << v[1] << " " << v[2] << "\n";
    for (const auto& t : mesh.triangles)
      text << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
    return text.str();
  });
}

}  // namespace exsect
