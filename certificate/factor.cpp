#include "certificate/factor.h"

#include <exsect/algebra/bivariate_factors.h>
#include <exsect/checker/factors.h>
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "certificate/algebraic.h"
#include "certificate/claims.h"
#include "certificate/ruled_factor.h"

namespace exsect::cli {
namespace {

using checker::Factor;
using checker::others;
using checker::Power;

/// The normal of the plane in which the patch is, if it has no weights.
std::optional<Point> normal_of_plane(const RationalPatch& patch) {
  if (!patch.is_polynomial()) return std::nullopt;
  const checker::Net<Rational> c = power_basis(patch).points;
  Point n = {};
  const auto each = [&](const auto& use) {
    c.each([&](std::size_t i, std::size_t j) {
      if (i + j > 0) use(c[i][j]);
    });
  };
  each([&](const Point& a) {
    each([&](const Point& b) {
      if (is_zero(n)) n = cross(a, b);
    });
  });
  bool flat = !is_zero(n);
  each([&](const Point& a) { flat = flat && dot(n, a) == 0; });
  return flat ? std::optional(n) : std::nullopt;
}

/// The products of the irreducible factors of one multiplicity, those in one variable apart.
std::vector<BivariatePower> coprime_parts(const BivariatePolynomial& f) {
  const auto kind = [](const BivariatePower& a) {
    return std::tuple(a.multiplicity, a.factor.degree_r() > 0, a.factor.degree_s() > 0);
  };
  std::vector<BivariatePower> result;
  for (const BivariatePower& irreducible : irreducible_factors(f)) {
    const auto part = std::find_if(result.begin(), result.end(), [&](const BivariatePower& other) {
      return kind(other) == kind(irreducible);
    });
    if (part == result.end())
      result.push_back(irreducible);
    else
      part->factor = part->factor * irreducible.factor;
  }
  return result;
}

/// Divided by a power of 2 that makes its largest coefficient about 1.
Point scaled(const Point& row, const ExactMap& equation) {
  double most = 0;
  for (const auto& term : equation.terms())
    if (term.power != Power{}) most = std::max(most, std::abs(to_double(dot(row, term.c))));
  const Rational factor = power_of_two(most > 0 ? -std::ilogb(most) : 0);
  return {factor * row[0], factor * row[1], factor * row[2]};
}

Factor rows_factor(const std::array<Point, 3>& rows, const ExactMap& equation) {
  Factor result = {equation.times({rows[0], rows[1], rows[2]}), {1, 1, 1}, {}};
  const Rational det = dot(rows[0], cross(rows[1], rows[2]));
  for (std::size_t j = 0; j < 3; ++j) {
    const Point column = cross(rows[(j + 1) % 3], rows[(j + 2) % 3]);
    result.columns[j].add(Power{}, column, 1 / det);
  }
  return result;
}

}  // namespace

Factors::Factors(const Patches& patches, bool self) : equation_(equation_of(patches)) {
  if (self) return;
  Point normal = {};  // of the plane in which a patch is, if one is in a plane
  for (const std::size_t n : {1, 0})
    if (const auto found = normal_of_plane(patches[n]); found && is_zero(normal)) normal = *found;
  std::vector<Point> rows;
  if (!is_zero(normal)) rows.push_back(normal);
  std::vector<Point> more = related_directions(patches);
  const bool related = !more.empty();
  more.insert(more.end(), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  for (const Point& row : more) {
    const bool independent = rows.empty() || (rows.size() == 1 && !is_zero(cross(rows[0], row))) ||
                             (rows.size() == 2 && dot(row, cross(rows[0], rows[1])) != 0);
    if (independent) rows.push_back(row);
  }
  std::rotate(rows.begin(), rows.begin() + 1, rows.end());  // the normal last
  for (std::size_t d = 0; d < 3; ++d) rows_[d] = scaled(rows[d], equation_);
  if (related) related_ = add(rows_factor(rows_, equation_));
  if (!is_zero(normal)) find_parts();
}

Factors::Factors(const ExactMap& section)
    : equation_(section), free_(2), rows_({{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}) {
  find_parts();
  if (parts_.size() == 1 && parts_[0].power == 1) parts_.clear();
}

int Factors::add(Factor factor) {
  for (std::size_t i = 0; i < found_.size(); ++i) {
    ExactMap difference = factor.map;
    for (const auto& term : found_[i].exact.map.terms()) difference.add(term.power, term.c, -1);
    const auto& terms = difference.terms();
    if (found_[i].exact.powers == factor.powers && found_[i].exact.is_surface() == factor.is_surface() &&
        std::all_of(terms.begin(), terms.end(), [](const auto& term) { return is_zero(term.c); }))
      return static_cast<int>(i);
  }
  NearFactor near = {std::move(factor), {}, {}};
  near.walls = checker::walls_of(near.exact);
  near.map = checker::rounded<double>(near.exact.map);
  for (std::size_t j = 0; j < 3; ++j) near.columns[j] = checker::rounded<double>(near.exact.columns[j]);
  found_.push_back(std::move(near));
  return static_cast<int>(found_.size()) - 1;
}

/// n . F depends on one patch alone, if n is normal to the other one: its factors.
void Factors::find_parts() {
  const ExactMap rows = equation_.times({Point{}, Point{}, rows_[2]});
  const auto of_second = [](const auto& term) { return term.c[2] != 0 && term.power[2] + term.power[3] > 0; };
  const std::size_t first = std::any_of(rows.terms().begin(), rows.terms().end(), of_second) ? 2 : 0;
  const BivariatePolynomial f = of_parameters(checker::component(rows, 2), first);
  if (f.is_zero()) return;
  for (const auto& [part, power] : coprime_parts(f)) {
    BivariatePolynomial rest = f;
    for (int n = 0; n < power; ++n) rest = exact_quotient(rest, part);
    parts_.push_back(
        {in_parameters(part, first), static_cast<std::size_t>(power), in_parameters(rest, first)});
  }
}

bool Factors::is_claimable(const Part& part) {
  const int most = std::max(checker::degree(part.polynomial), checker::degree(part.rest));
  return most <= checker::max_factor_degree && part.power <= checker::max_factor_power;
}

/// The factor of the part that vanishes on the arc.
std::optional<Factor> Factors::in_plane(const std::vector<Parameters>& near) const {
  const auto size = [&](const Part& part) {
    double most = 0;
    for (const Parameters& w : near) most = std::max(most, near_value(part.polynomial, w));
    return most;
  };
  const auto best = std::min_element(parts_.begin(), parts_.end(),
                                     [&](const Part& a, const Part& b) { return size(a) < size(b); });
  if (best == parts_.end() || size(*best) > 1e-4 || !is_claimable(*best)) return std::nullopt;
  Factor result = rows_factor(rows_, equation_);
  result.powers[2] = best->power;
  result.map = equation_.times({rows_[0], rows_[1], Point{}});
  for (const auto& [power, q] : best->polynomial) result.map.add(power, {0, 0, 1}, q);
  const Point column = result.columns[2].terms()[0].c;
  result.columns[2] = {};
  for (const auto& [power, q] : best->rest) result.columns[2].add(power, column, q);
  return result;
}

std::optional<Factor> Factors::on_line(const Arc& arc, const Node& from, const Node& to) const {
  const auto line = line_between(equation_, from, to);
  if (!line) return std::nullopt;
  if (touches(arc)) {
    for (const bool surface : {true, false})
      if (auto found = touching_factor(*line, equation_, surface)) return found;
  }
  const auto o = others(line->axis);
  Direction c = {};
  c[o[2]] = 1;
  auto found = factor_in(along_line(*line, o[2], c, o[0]), equation_, 1);
  return found && (!touches(arc) || checker::touches(*found)) ? std::move(found) : std::nullopt;
}

namespace {

/// Which parameters stay where they are, but for less than 10^-6.
std::array<bool, 4> constant_along(const Arc& arc) {
  std::array<bool, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [low, high] =
        std::minmax_element(arc.polyline.begin(), arc.polyline.end(),
                            [&](const auto& a, const auto& b) { return a.parameters[i] < b.parameters[i]; });
    result[i] = high->parameters[i] - low->parameters[i] < 1e-6;
  }
  return result;
}

std::vector<Parameters> places_of(const Arc& arc) {
  std::vector<Parameters> result;
  for (const PolylineVertex& vertex : arc.polyline) result.push_back(vertex.parameters);
  return result;
}

}  // namespace

std::optional<Factor> Factors::of_constants(const Arc& arc, const std::array<bool, 4>& constant,
                                            const Node& from, const Node& to) const {
  const Place c = short_place(from), other = short_place(to);
  for (const std::size_t i : {0, 1}) {
    for (const std::size_t j : {2, 3}) {
      if (!constant[i] || !constant[j]) continue;
      std::optional<Factor> found;
      if (c[i] == other[i] && c[j] == other[j])
        found = touches(arc) ? touching_factor_of_constants(equation_, {i, j}, c, places_of(arc))
                             : factor_of_constants(equation_, {i, j}, c, places_of(arc));
      if (!found && !touches(arc)) found = ruled_factor(equation_, {i, j}, from);
      if (found) return found;
    }
  }
  return std::nullopt;
}

void Factors::add_at(const Place& at, const std::array<bool, 4>& constant) {
  Parameters near;
  for (std::size_t i = 0; i < 4; ++i) near[i] = to_double(at[i]);
  std::optional<Factor> found;
  for (const std::size_t i : {0, 1})
    for (const std::size_t j : {2, 3})
      if (constant[i] && constant[j]) found = factor_of_constants(equation_, {i, j}, at, {near});
  const bool any = std::find(constant.begin(), constant.end(), true) != constant.end();
  if (!found && any) found = in_plane({near});
  if (found) add(std::move(*found));
}

int Factors::along(const Arc& arc, const Node& from, const Node& to) {
  const bool inside = arc.place == ArcPlace::interior;
  const std::array<bool, 4> constant = constant_along(arc);
  const bool any = std::any_of(constant.begin(), constant.begin() + free_, [](bool b) { return b; });
  std::optional<Factor> found;
  if (!touches(arc) && (any || !inside)) found = on_line(arc, from, to);
  if (!found) found = in_plane(places_of(arc));
  if (!found && touches(arc)) found = on_line(arc, from, to);
  if (!found && any) found = of_constants(arc, constant, from, to);
  if (found) return add(std::move(*found));
  if (touches(arc))
    throw NoCertificate("an arc along which the patches touch and for which no factor is found");
  if (!inside) throw NoCertificate("an arc on a side that is no line of parameters of both patches");
  return related_;
}

int Factors::of_plane(const Place& at, const Direction& first, const Direction& second) {
  checker::Matrix4 axes = {};
  for (std::size_t i = 0; i < 4; ++i) {
    axes[i][0] = first[i];
    axes[i][3] = second[i];
  }
  axes[2][1] = axes[3][2] = 1;
  const checker::Matrix4 inverted = inverse(axes);
  Coordinates z;
  for (std::size_t i = 0; i < 4; ++i) {
    z.from[i][Power{}] = at[i];
    Rational middle = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      z.from[i][variable(j)] = axes[i][j].rational();
      z.to[i][variable(j)] = inverted[i][j].rational();
      middle += inverted[i][j].rational() * at[j];
    }
    z.to[i][Power{}] = -middle;
  }
  auto found = factor_in(z, equation_, 0);
  if (!found)
    throw NoCertificate("an overlap of patches whose parameters do not depend on each other linearly");
  return add(std::move(*found));
}

namespace {

Json polynomials(const ExactMap& map) {
  Json result = Json::array();
  for (std::size_t d = 0; d < 3; ++d) {
    Json terms = Json::array();
    for (const auto& [power, c, lower] : map.terms())
      if (c[d] != 0) terms.push_back({to_string(c[d]), power[0], power[1], power[2], power[3]});
    result.push_back(terms);
  }
  return result;
}

}  // namespace

Json Factors::claims() const {
  Json result = Json::array();
  for (const NearFactor& factor : found_) {
    Json columns = Json::array();
    for (const ExactMap& column : factor.exact.columns) columns.push_back(polynomials(column));
    result.push_back(sealed(
        in_list("factors", result.size()),
        {{"map", polynomials(factor.exact.map)}, {"powers", factor.exact.powers}, {"columns", columns}}));
  }
  return result;
}

}  // namespace exsect::cli
