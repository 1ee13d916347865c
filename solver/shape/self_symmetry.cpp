#include "shape/self_symmetry.h"

#include <exsect/geometry/number.h>

#include "shape/folded_patch.h"

namespace exsect {
namespace {

const Rational half(1, 2);

Rational value(const PlaneForm& form, const PlanePoint& w) {
  return form[0] + form[1] * w[0] + form[2] * w[1];
}

PlanePoint image(const Symmetry& symmetry, const PlanePoint& w) {
  return {value(symmetry.image[0], w), value(symmetry.image[1], w)};
}

bool is_symmetric(const BezierPatch& x) { return x == x.exchanged(); }

bool is_inside(const Rational& c) { return c > 0 && c < 1; }

Symmetry across_first(const Rational& u) { return {{{{2 * u, -1, 0}, {0, 0, 1}}}, {-u, 1, 0}}; }
Symmetry across_second(const Rational& v) { return {{{{0, 1, 0}, {2 * v, 0, -1}}}, {-v, 0, 1}}; }

/// (u,v) - c becomes (v,u) - c.
Symmetry across_diagonal(const PlanePoint& c) {
  return {{{{c[0] - c[1], 0, 1}, {c[1] - c[0], 1, 0}}}, {c[1] - c[0], 1, -1}};
}

Symmetry across_other_diagonal(const PlanePoint& c) {
  const Rational sum = c[0] + c[1];
  return {{{{sum, 0, -1}, {sum, -1, 0}}}, {-sum, 1, 1}};
}

Symmetry half_turn(const PlanePoint& c) { return {{{{2 * c[0], -1, 0}, {2 * c[1], 0, -1}}}, {-c[1], 0, 1}}; }

Symmetry quarter_turn(const PlanePoint& c) {
  return {{{{c[0] + c[1], 0, -1}, {c[1] - c[0], 1, 0}}}, {1, 0, 0}};
}

/// The u inside the square at which all lines v = constant turn.
std::optional<Rational> inner_fold(const BezierPatch& x) {
  const auto folded = folded_patch(x);
  return folded && is_inside(folded->fold) ? std::optional(folded->fold) : std::nullopt;
}

/// Where the terms of odd degree can vanish.
std::optional<PlanePoint> possible_centre(const ControlNet& c) {
  for (std::size_t k = 0; k < 3; ++k)
    if (c[2][2][k] != 0) return {{-c[1][2][k] / (2 * c[2][2][k]), -c[2][1][k] / (2 * c[2][2][k])}};
  std::vector<std::array<Rational, 3>> rows;
  for (std::size_t k = 0; k < 3; ++k) {
    rows.push_back({2 * c[2][0][k], c[1][1][k], -c[1][0][k]});
    rows.push_back({c[1][1][k], 2 * c[0][2][k], -c[0][1][k]});
  }
  for (const auto& p : rows)
    for (const auto& q : rows) {
      const Rational d = p[0] * q[1] - p[1] * q[0];
      if (d != 0) return {{(p[2] * q[1] - p[1] * q[2]) / d, (p[0] * q[2] - p[2] * q[0]) / d}};
    }
  return std::nullopt;
}

/// The part of a convex polygon where f >= 0, f of degree 1.
template <class Form>
std::vector<PlanePoint> part_of(const std::vector<PlanePoint>& polygon, const Form& f) {
  std::vector<PlanePoint> rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanePoint& p = polygon[i];
    const PlanePoint& q = polygon[(i + 1) % polygon.size()];
    const Rational at_p = f(p);
    const Rational at_q = f(q);
    if (at_p >= 0) rest.push_back(p);
    if (sign(at_p) * sign(at_q) < 0) {
      const Rational c = at_p / (at_p - at_q);
      rest.push_back({p[0] + c * (q[0] - p[0]), p[1] + c * (q[1] - p[1])});
    }
  }
  return rest;
}

/// Of two patches without common factors of their components: the vectors are multiples of each other.
bool are_one_map(const RationalPatch& a, const RationalPatch& b) {
  if (a.degree_u() != b.degree_u() || a.degree_v() != b.degree_v()) return false;
  const HomogeneousPoint &p = a.homogeneous(0, 0), &q = b.homogeneous(0, 0);
  for (int i = 0; i <= a.degree_u(); ++i)
    for (int j = 0; j <= a.degree_v(); ++j)
      for (std::size_t c = 0; c < 4; ++c)
        if (a.homogeneous(i, j)[c] * q[3] != b.homogeneous(i, j)[c] * p[3]) return false;
  return true;
}

std::string text(const PlaneForm& form) {
  std::string result;
  for (std::size_t j = 0; j < 3; ++j) {
    if (form[j] == 0) continue;
    if (result.empty()) {
      result = form[j] < 0 ? "-" : "";
    } else {
      result += form[j] < 0 ? " - " : " + ";
    }
    result += j == 0 ? to_string(form[j] < 0 ? -form[j] : form[j]) : j == 1 ? "u" : "v";
  }
  return result;
}

}  // namespace

std::optional<PlanePoint> centre_of_symmetry(const BezierPatch& x) {
  const auto centre = possible_centre(x.power_basis());
  if (!centre || !is_inside((*centre)[0]) || !is_inside((*centre)[1])) return std::nullopt;
  const Rational u = 2 * (*centre)[0];
  const Rational v = 2 * (*centre)[1];
  return x == x.restricted_to(u, u - 1, v, v - 1) ? centre : std::nullopt;
}

std::vector<Symmetry> symmetries(const BezierPatch& x) {
  const auto u = inner_fold(x);
  const auto v = inner_fold(x.exchanged());
  const auto centre = u && v ? std::optional<PlanePoint>({*u, *v}) : centre_of_symmetry(x);
  const PlanePoint c = centre.value_or(PlanePoint{half, half});
  const BezierPatch centred = x.restricted_to(c[0] - half, c[0] + half, c[1] - half, c[1] + half);
  const bool diagonal = is_symmetric(centred);
  const bool other = is_symmetric(centred.reversed_second());
  std::vector<Symmetry> result;
  if (u) result.push_back(across_first(*u));
  if (v) result.push_back(across_second(*v));
  if (diagonal) result.push_back(across_diagonal(c));
  if (other) result.push_back(across_other_diagonal(c));
  if (centre) result.push_back(half_turn(c));
  if (u && diagonal) result.push_back(quarter_turn(c));
  return result;
}

std::vector<Symmetry> symmetries_of_square(const RationalPatch& x) {
  const RationalPatch& reduced = x.reduced();
  const RationalPatch first = reduced.restricted_to(1, 0, 0, 1), second = reduced.restricted_to(0, 1, 1, 0);
  const PlanePoint centre = {half, half};
  std::vector<Symmetry> result;
  const auto add_if = [&](const RationalPatch& image, const Symmetry& symmetry) {
    if (are_one_map(reduced, image)) result.push_back(symmetry);
  };
  add_if(first, across_first(half));
  add_if(second, across_second(half));
  add_if(reduced.transposed(), across_diagonal(centre));
  add_if(first.transposed().restricted_to(1, 0, 0, 1), across_other_diagonal(centre));
  add_if(first.restricted_to(0, 1, 1, 0), half_turn(centre));
  add_if(first.transposed(), quarter_turn(centre));
  return result;
}

std::string image_text(const Symmetry& symmetry) {
  return "(" + text(symmetry.image[0]) + ", " + text(symmetry.image[1]) + ")";
}

std::string covered_more_than_once(const std::vector<Symmetry>& symmetries) {
  std::string why = "the patch covers its image more than once: (u, v)";
  for (const Symmetry& symmetry : symmetries) why += " and " + image_text(symmetry);
  return why + " are one point; its other pairs are not decided";
}

std::vector<ParameterPair> rim(const Symmetry& symmetry) {
  std::vector<PlanePoint> polygon = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  polygon = part_of(polygon, [&](const PlanePoint& w) { return value(symmetry.cut, w); });
  for (const PlaneForm& f : symmetry.image) {
    polygon = part_of(polygon, [&](const PlanePoint& w) { return value(f, w); });
    polygon = part_of(polygon, [&](const PlanePoint& w) -> Rational { return 1 - value(f, w); });
  }
  std::vector<ParameterPair> result;
  const auto add = [&](const PlanePoint& w) {
    const PlanePoint other = image(symmetry, w);
    result.push_back({w[0], w[1], other[0], other[1]});
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanePoint& w = polygon[i];
    const PlanePoint& next = polygon[(i + 1) % polygon.size()];
    add(w);
    if (value(symmetry.cut, w) == 0 && image(symmetry, w) == next)
      add({half * (w[0] + next[0]), half * (w[1] + next[1])});
  }
  return result;
}

bool is_on_cut(const Symmetry& symmetry, const ParameterPair& from, const ParameterPair& to) {
  return value(symmetry.cut, {from[0], from[1]}) == 0 && value(symmetry.cut, {to[0], to[1]}) == 0;
}

}  // namespace exsect
