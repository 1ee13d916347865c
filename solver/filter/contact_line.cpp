#include "filter/contact_line.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "answer/rim_arc.h"
#include "filter/homogeneous.h"

namespace exsect::filter {

namespace {

using Ball4 = std::array<DoubleBall, 4>;
using LineRange = Part::Interval;

/// How near a simple value of the parameter is looked for.
constexpr std::array<long, 3> kRooms = {10, 20, 30};

/// The covector that vanishes on a, b and c, up to its sign.
template <class Number>
std::array<Number, 4> vanishing_on(const std::array<Number, 4>& a, const std::array<Number, 4>& b,
                                   const std::array<Number, 4>& c) {
  const auto minor = [&](std::size_t i, std::size_t j) { return a[i] * b[j] - a[j] * b[i]; };
  const auto of = [&](std::size_t i, std::size_t j, std::size_t k) {
    return minor(i, j) * c[k] - minor(i, k) * c[j] + minor(j, k) * c[i];
  };
  return {of(1, 2, 3), -of(0, 2, 3), of(0, 1, 3), -of(0, 1, 2)};
}
template <class Number, class Other>
Other product(const std::array<Number, 4>& a, const std::array<Other, 4>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}
std::array<double, 4> middle_of(const Ball4& v) {
  return {v[0].approximation(), v[1].approximation(), v[2].approximation(), v[3].approximation()};
}

DoubleBall centred(const LineRange& t) {
  return DoubleBall::between(t.lower - 0.5, t.upper - 0.5).widened(0x1p-52);
}
DoubleBall centred(const Rational& t) { return DoubleBall::enclosing(t - Rational(1, 2)); }

template <class K>
std::array<Ball4, K::count> coefficients(const PatchOf<K>& patch) {
  std::array<Ball4, K::count> result;
  for (std::size_t i = 0; i < K::count; ++i) {
    for (std::size_t c = 0; c < K::rows; ++c)
      result[i][c] = DoubleBall(patch.power[i][c]).widened(patch.error[i]);
    if (!K::weighted) result[i][3] = i == 0 ? 1.0 : 0.0;
  }
  return result;
}

/// The derivative of order a in h and b in k, both at most 2, over all (h,k) in the balls.
template <class K>
Ball4 derivative(const std::array<Ball4, K::count>& patch, std::size_t a, std::size_t b, const DoubleBall& h,
                 const DoubleBall& k) {
  constexpr std::array<std::array<double, 4>, 3> factors = {{{1, 1, 1, 1}, {0, 1, 2, 3}, {0, 0, 2, 6}}};
  Ball4 result;
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t i = K::side; i-- > a;) {
      DoubleBall row;
      for (std::size_t j = K::side; j-- > b;)
        row = row * k + DoubleBall(factors[a][i] * factors[b][j]) * patch[K::side * i + j][c];
      result[c] = result[c] * h + row;
    }
  return result;
}

/// Where the line and two parts are, centred.
struct Places {
  DoubleBall along;                   // t
  DoubleBall across;                  // the line's value and the owner's part
  std::array<DoubleBall, 2> on_line;  // of the carrier, for these t
  std::array<DoubleBall, 2> carrier;  // these and the carrier's part
};
template <class K>
Places places(const ContactLineOf<K>& line, const Part& x, const Part& y) {
  const Part& owner = line.path.of_x ? x : y;
  const Part& carrier = line.path.of_x ? y : x;
  const LineRange& t = owner.range[1 - line.path.parameter];
  // (14.84): five operations on positive numbers; the ratio is rounded once.
  const DoubleBall f =
      DoubleBall::between(along_path(line.ratio, t.lower), along_path(line.ratio, t.upper)).widened(0x1p-48);
  Places result = {centred(t), hull(line.value, centred(owner.range[line.path.parameter])), {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    result.on_line[i] = line.ends[0][i] + f * (line.ends[1][i] - line.ends[0][i]);
    result.carrier[i] = hull(result.on_line[i], centred(carrier.range[i]));
  }
  return result;
}

/// The tangent planes at all points of the line: [Y, Y_r, Y_s, X_a], of degree 7 n at most in t.
template <class K>
bool has_contact_along(const ExactPatch<K>& owner, const ExactPatch<K>& carrier, const LinePath& path) {
  constexpr int degree = 7 * static_cast<int>(K::degree);
  for (int i = 0; i <= degree; ++i) {
    const auto at = path.at(Rational(i, degree));
    const std::size_t own = path.of_x ? 0 : 2;
    const FirstOrder<K> x(owner, at[own], at[own + 1]);
    const FirstOrder<K> y(carrier, at[2 - own], at[3 - own]);
    if (determinant(y.value, y.derivative[0], y.derivative[1], x.derivative[path.parameter]) != 0)
      return false;
  }
  return true;
}

/// Contains all z with M z = C right for matrices M in C (columns), modulo `normal`, C being rows dual to the
/// middles of the columns and of `normal` (14.85); empty if M may be singular.
std::optional<std::array<DoubleBall, 3>> solution(const std::array<Ball4, 3>& columns, const Ball4& normal,
                                                  const Ball4& right) {
  const std::array<std::array<double, 4>, 3> c = {middle_of(columns[0]), middle_of(columns[1]),
                                                  middle_of(columns[2])};
  const std::array<double, 4> n = middle_of(normal);
  const std::array<std::array<double, 4>, 3> dual = {vanishing_on(c[1], c[2], n), vanishing_on(c[2], c[0], n),
                                                     vanishing_on(c[0], c[1], n)};
  std::array<DoubleBall, 3> result;
  std::array<double, 3> off;  // row sums of |M - 1|
  double contraction = 0, greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double scale = 1 / product(dual[i], c[i]);
    Ball4 row;
    for (std::size_t k = 0; k < 4; ++k) row[k] = scale * dual[i][k];
    off[i] = 0;
    for (std::size_t j = 0; j < 3; ++j)
      off[i] += (product(row, columns[j]) - DoubleBall(i == j ? 1.0 : 0.0)).upper_magnitude();
    result[i] = product(row, right);
    contraction = larger_bound(contraction, kSlack * off[i]);
    greatest = larger_bound(greatest, result[i].upper_magnitude());
  }
  if (!(contraction < 1)) return std::nullopt;
  greatest = kSlack * greatest / (1 - contraction);
  for (std::size_t i = 0; i < 3; ++i) result[i] = result[i].widened(kSlack * greatest * off[i]);
  return result;
}

}  // namespace

template <class K>
std::optional<ContactLineOf<K>> contact_line_near(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                  const PairOf<K>& pair, const Vec4& near) {
  for (std::size_t fixed = 0; fixed < 4; ++fixed) {
    std::optional<Rational> last;
    for (const long room : kRooms) {
      const Rational at = from_double(near[fixed]) + Rational(1, 2);
      const Rational value = simplest_between(at - power_of_two(-room), at + power_of_two(-room));
      if (value < 0 || value > 1 || value == last) continue;
      last = value;
      const auto path = line_path_near<K>(x, y, pair, fixed, value, near);
      if (!path || !(path->of_x ? has_contact_along<K>(x, y, *path) : has_contact_along<K>(y, x, *path)))
        continue;
      ContactLineOf<K> line = {*path, centred(value), {}, to_double(path->ratio), {}, {}};
      for (std::size_t end = 0; end < 2; ++end)
        for (std::size_t i = 0; i < 2; ++i) line.ends[end][i] = centred(path->ends[end][i]);
      line.owner = coefficients<K>(path->of_x ? pair.x : pair.y);
      line.carrier = coefficients<K>(path->of_x ? pair.y : pair.x);
      return line;
    }
  }
  return std::nullopt;
}

template <class K>
bool meet_on_line(const ContactLineOf<K>& line, const Part& x, const Part& y) {
  const Places at = places(line, x, y);
  const auto of_owner = [&](std::size_t across, std::size_t along, const DoubleBall& where) {
    return line.path.parameter == 0 ? derivative<K>(line.owner, across, along, where, at.along)
                                    : derivative<K>(line.owner, along, across, at.along, where);
  };
  const auto of_carrier = [&](std::size_t a, std::size_t b) {
    return derivative<K>(line.carrier, a, b, at.carrier[0], at.carrier[1]);
  };
  const Ball4 normal =
      vanishing_on(of_owner(0, 0, line.value), of_owner(1, 0, line.value), of_owner(0, 1, line.value));
  const auto slope = solution(
      {derivative<K>(line.carrier, 0, 0, at.on_line[0], at.on_line[1]), of_carrier(1, 0), of_carrier(0, 1)},
      normal, of_owner(1, 0, at.across));
  if (!slope) return false;
  const auto& [value, r, s] = *slope;
  const DoubleBall bend = product(normal, of_carrier(2, 0)) * r * r +
                          DoubleBall(2.0) * product(normal, of_carrier(1, 1)) * r * s +
                          product(normal, of_carrier(0, 2)) * s * s;
  const DoubleBall weight = of_owner(0, 0, at.across)[3], weight_of_carrier = of_carrier(0, 0)[3];
  const DoubleBall gap =  // (14.86)
      product(normal, of_owner(2, 0, at.across)) * weight - bend * weight_of_carrier;
  return weight.is_positive() && weight_of_carrier.is_positive() && gap.certain_sign() != 0;
}

template <class K>
bool may_touch(const ContactLineOf<K>& line, const Part& x, const Part& y) {
  const Places at = places(line, x, y);
  const Part& carrier = line.path.of_x ? y : x;
  const auto are_apart = [](const DoubleBall& a, const DoubleBall& b) { return (a - b).certain_sign() != 0; };
  const Part& owner = line.path.of_x ? x : y;
  return !are_apart(line.value, centred(owner.range[line.path.parameter])) &&
         !are_apart(at.on_line[0], centred(carrier.range[0])) &&
         !are_apart(at.on_line[1], centred(carrier.range[1]));
}

template <class K>
ContactArc contact_arc(const ExactPatch<K>& x, const ExactPatch<K>& y, const LinePath& path,
                       double tolerance) {
  const std::array<std::array<Rational, 4>, 2> at = {path.at(path.common.lower), path.at(path.common.upper)};
  const auto of_owner = [&](const std::array<Rational, 4>& p) {
    return path.of_x ? p : std::array<Rational, 4>{p[2], p[3], p[0], p[1]};
  };
  const bool on_side =
      path.value == 0 || path.value == 1 || std::ranges::any_of(std::array{0, 1}, [&](std::size_t i) {
        return path.ends[0][i] == path.ends[1][i] && (path.ends[0][i] == 0 || path.ends[0][i] == 1);
      });
  ContactArc result = {rim_arc(rational_patch(path.of_x ? x : y), {of_owner(at[0]), 0}, {of_owner(at[1]), 0},
                               on_side ? ArcPlace::patch_boundary : ArcPlace::interior, tolerance),
                       {rim_node(at[0]), rim_node(at[1])}};
  const std::size_t own = path.of_x ? 0 : 2;
  const double ratio = to_double(path.ratio);
  for (PolylineVertex& vertex : result.arc.polyline) {
    auto& p = vertex.parameters;
    if (!path.of_x) std::rotate(p.begin(), p.begin() + 2, p.end());
    const double t = p[own + 1 - path.parameter];
    const double f = along_path(ratio, t);
    for (std::size_t i = 0; i < 2; ++i)
      p[2 - own + i] =
          std::clamp(std::lerp(to_double(path.ends[0][i]), to_double(path.ends[1][i]), f), 0.0, 1.0);
  }
  for (std::size_t end = 0; end < 2; ++end) {
    PolylineVertex& vertex = end == 0 ? result.arc.polyline.front() : result.arc.polyline.back();
    vertex.parameters = result.ends[end].approx;
    result.ends[end].point = vertex.point;
  }
  return result;
}

#define EXSECT_INSTANTIATE(K)                                                                               \
  template std::optional<ContactLineOf<K>> contact_line_near<K>(const ExactPatch<K>&, const ExactPatch<K>&, \
                                                                const PairOf<K>&, const Vec4&);             \
  template bool meet_on_line<K>(const ContactLineOf<K>&, const Part&, const Part&);                         \
  template bool may_touch<K>(const ContactLineOf<K>&, const Part&, const Part&);                            \
  template ContactArc contact_arc<K>(const ExactPatch<K>&, const ExactPatch<K>&, const LinePath&, double);
EXSECT_FILTER_OTHER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
