#include "line/enclosed_line_points.h"

#include <exsect/algebra/ball_roots.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "line/conic_eliminant.h"
#include "line/line_place.h"
#include "line/line_point.h"
#include "line/point_in_box.h"

namespace exsect {
namespace {

using Ball = DoubleDoubleBall;
using Forms = ConicEliminant<Ball>;
/// c[i][j]: the coefficient of the first parameter's power i times the second's power j.
using Net = std::array<std::array<Forms::Vector, 3>, 3>;

void to_power_basis(Forms::Vector& b0, Forms::Vector& b1, Forms::Vector& b2) {
  for (std::size_t k = 0; k < 3; ++k) {
    b1[k] -= b0[k];
    b2[k] -= b0[k] + b1[k] + b1[k];
    b1[k] += Ball(b1[k]);
  }
}

Net power_basis(const BezierPatch& patch, bool exchanged) {
  Net c;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Point& point = exchanged ? patch.net()[j][i] : patch.net()[i][j];
      for (std::size_t k = 0; k < 3; ++k) c[i][j][k] = Ball::enclosing(point[k]);
    }
  for (std::size_t i = 0; i < 3; ++i) to_power_basis(c[i][0], c[i][1], c[i][2]);
  for (std::size_t j = 0; j < 3; ++j) to_power_basis(c[0][j], c[1][j], c[2][j]);
  return c;
}

/// c(t) = a[0] + a[1] t + a[2] t^2, against `patch`.
struct Problem {
  std::array<Forms::Vector, 3> line;
  Net patch;
};

Problem problem_of(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  const bool of_x = query.fixed == Parameter::u || query.fixed == Parameter::v;
  const bool along_first = query.fixed == Parameter::u || query.fixed == Parameter::r;
  const Net own = power_basis(of_x ? x : y, !along_first);
  const Ball at = Ball::enclosing(query.value);
  Problem result{{}, power_basis(of_x ? y : x, false)};
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      result.line[j][k] = (own[2][j][k] * at + own[1][j][k]) * at + own[0][j][k];
  return result;
}

/// Empty if the line may be straight: the forms mean nothing then.
std::optional<Forms> forms_of(const Problem& problem) {
  const Forms::Vector n = Forms::cross(problem.line[1], problem.line[2]);
  if (std::ranges::all_of(n, [](const Ball& c) { return c.certain_sign() == 0; })) return std::nullopt;
  std::array<Forms::FormVector, 3> w;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 3; ++j) w[i][k].push_back(problem.patch[i][j][k]);
      if (i == 0) w[i][k][0] -= problem.line[0][k];
    }
  return Forms(problem.line[1], problem.line[2], w);
}

Ball value(const Forms::Form& f, const Ball& s) {
  return evaluate(std::span<const Ball>(f.data(), f.size()), s);
}

/// Half the width of a box.
constexpr double kRadius = 0x1p-52;

/// A parameter up to kRadius.
struct Place {
  double middle;
  bool inside;  // of (0,1); otherwise outside of [0,1]
};

std::optional<Place> place(double middle, double radius) {
  if (!(radius <= kRadius)) return std::nullopt;
  if (middle - radius > 0 && middle + radius < 1) return Place{middle, true};
  if (middle + radius < 0 || middle - radius > 1) return Place{middle, false};
  return std::nullopt;
}

/// -n/d, d certainly not zero: |-n/d - q| = |n + q d| / |d|. Far outside, where that is too large, by signs.
std::optional<Place> place_of_ball_ratio(const Ball& n, const Ball& d) {
  if (d.certain_sign() == 0) return std::nullopt;
  const double q = -n.approximation() / d.approximation();
  if (n.certain_sign() == d.certain_sign() || (n + d).certain_sign() == -d.certain_sign())
    return Place{q, false};
  const Ball error = n + Ball(q) * d;
  return place(q, error.upper_magnitude() / d.lower_magnitude() * kSlack);
}

/// A dyadic box around the middle, cut to [0,1].
RationalInterval box_around(const Place& at) {
  const Rational middle = from_double(at.middle);
  const Rational radius = from_double(kRadius);
  return {std::max(middle - radius, Rational(0)), std::min(middle + radius, Rational(1))};
}

class EnclosedPoints {
 public:
  EnclosedPoints(const BezierPatch& x, const BezierPatch& y, const LineQuery& query)
      : x_(x), y_(y), query_(query), roles_(line_place(query).roles) {}

  std::optional<LinePoints> run() {
    const std::optional<Forms> forms = forms_of(problem_of(x_, y_, query_));
    if (!forms) return std::nullopt;
    const auto roots = isolate_ball_roots({forms->eliminant.data(), forms->eliminant.size()});
    if (!roots) return std::nullopt;
    for (const Ball& s : *roots)
      if (!add_point(*forms, s)) return std::nullopt;
    separate(result_.points);
    return std::move(result_);
  }

 private:
  /// A simple root s of the eliminant with s1 != 0; false if it is not certain whether the point is inside.
  bool add_point(const Forms& forms, const Ball& s) {
    const Ball s1 = value(forms.s1, s);
    const auto r = place_of_ball_ratio(value(forms.s0, s), s1);
    if (!r || !r->inside) return r.has_value();
    const auto t = place_of_ball_ratio(value(forms.t_numerator, s), s1);
    if (!t || !t->inside) return t.has_value();
    const auto second = place(s.approximation(), std::fabs(s.remainder()) + s.radius() + 0x1p-60);
    if (!second || !second->inside) return false;
    ParameterBox box;
    box[index(roles_.fixed)] = {query_.value, query_.value};
    box[index(roles_.line)] = box_around(*t);
    box[index(roles_.first)] = box_around(*r);
    box[index(roles_.second)] = box_around(*second);
    if (!problem_) problem_ = std::make_shared<const LineProblem>(LineProblem{x_, y_, query_});
    result_.points.push_back(point_in_box(problem_, box));
    return true;
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  const LineQuery& query_;
  LineRoles roles_;
  std::shared_ptr<const LineProblem> problem_;
  LinePoints result_;
};

}  // namespace

std::optional<LinePoints> enclosed_line_points(const BezierPatch& x, const BezierPatch& y,
                                               const LineQuery& query) {
  return EnclosedPoints(x, y, query).run();
}

}  // namespace exsect
