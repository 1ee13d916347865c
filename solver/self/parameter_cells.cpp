#include "self/parameter_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace exsect {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double below(const Rational& q) { return std::nextafter(to_double(q), -kInfinity); }
double above(const Rational& q) { return std::nextafter(to_double(q), kInfinity); }

ParameterCell make_cell(const ParameterRectangle& where, RationalPatch piece, int level) {
  const Rational half(1, 2);
  const PieceBox box = box_of(piece);
  return {where,
          std::move(piece),
          {{below(where.u.lower - half), below(where.v.lower - half)},
           {above(where.u.upper - half), above(where.v.upper - half)}},
          box,
          level,
          0};
}

/// Of few bits.
constexpr std::array<int, 11> kSixtyFourths = {26, 38, 30, 33, 35, 28, 22, 42, 24, 40, 32};
constexpr std::size_t kUsual = 6;  // of these, near 1/2

}  // namespace

/// Every point of a piece with positive weights is a convex combination of its control points.
PieceBox box_of(const RationalPatch& piece) {
  PieceBox box;
  box.lower.fill(kInfinity);
  box.upper.fill(-kInfinity);
  for (int i = 0; i <= piece.degree_u(); ++i) {
    for (int j = 0; j <= piece.degree_v(); ++j) {
      const HomogeneousPoint& p = piece.homogeneous(i, j);
      const bool is_positive = p[3] > 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const Rational at = is_positive ? Rational(p[c] / p[3]) : Rational(0);
        box.lower[c] = std::min(box.lower[c], is_positive ? below(at) : -kInfinity);
        box.upper[c] = std::max(box.upper[c], is_positive ? above(at) : kInfinity);
      }
    }
  }
  return box;
}

CellTree::CellTree(const RationalPatch& patch, unsigned grid, ParameterLines lines,
                   std::vector<std::array<double, 2>> inside)
    : lines_(std::move(lines)), grid_(grid), inside_(std::move(inside)) {
  cells_.push_back(make_cell({{0, 1}, {0, 1}}, patch, 0));
}

std::optional<CellTree::Division> CellTree::line_inside(std::size_t cell) const {
  const ParameterRectangle& where = cells_[cell].where;
  for (const std::size_t side : {0U, 1U}) {
    const RationalInterval& range = side == 0 ? where.u : where.v;
    for (const Rational& value : lines_[side])
      if (range.lower < value && value < range.upper)
        return Division{side, (value - range.lower) / range.width()};
  }
  return std::nullopt;
}

Rational CellTree::cut_place(std::size_t i, std::size_t side) const {
  const std::size_t mixed = ((i + 1) * 0x9E3779B97F4A7C15ULL + grid_ * 0xC2B2AE3D27D4EB4FULL) >> 40U;
  const filter::Rectangle& cell = cells_[i].centred;
  const double lower = cell.lower[side], width = cell.upper[side] - lower;
  int best = kSixtyFourths[mixed % kUsual];
  double room = 0;
  for (std::size_t k = 0; k < kSixtyFourths.size(); ++k) {
    const int candidate = kSixtyFourths[(mixed + k) % kSixtyFourths.size()];
    double nearest = kInfinity;
    for (const std::array<double, 2>& place : inside_) {
      const bool is_near = std::ranges::all_of(std::array{0, 1}, [&](int j) {
        const auto c = static_cast<std::size_t>(j);
        return place[c] - 0.5 >= cell.lower[c] && place[c] - 0.5 <= cell.upper[c];
      });
      if (is_near)
        nearest = std::min(nearest, std::fabs((place[side] - 0.5 - lower) / width - candidate / 64.0));
    }
    if (nearest < kInfinity && nearest > room) {
      room = nearest;
      best = candidate;
    }
  }
  return Rational(best, 64);
}

std::size_t CellTree::split(std::size_t i) {
  if (cells_[i].children != 0) return cells_[i].children;
  const ParameterCell cell = cells_[i];
  const auto line = line_inside(i);
  const bool in_u = line ? line->side == 0 : cell.where.u.width() >= cell.where.v.width();
  const Rational t = line ? line->place : cut_place(i, in_u ? 0 : 1);
  const RationalInterval& range = in_u ? cell.where.u : cell.where.v;
  const Rational cut = range.lower + t * range.width();
  for (const bool upper : {false, true}) {
    ParameterRectangle part = cell.where;
    (in_u ? part.u : part.v) =
        upper ? RationalInterval{cut, range.upper} : RationalInterval{range.lower, cut};
    const Rational from = upper ? t : Rational(0);
    const Rational to = upper ? Rational(1) : t;
    cells_.push_back(make_cell(
        part, in_u ? cell.piece.restricted_to(from, to, 0, 1) : cell.piece.restricted_to(0, 1, from, to),
        cell.level + 1));
  }
  return cells_[i].children = cells_.size() - 2;
}

bool touch(const ParameterCell& a, const ParameterCell& b) {
  const auto meet = [](const RationalInterval& s, const RationalInterval& t) {
    return s.lower <= t.upper && t.lower <= s.upper;
  };
  return meet(a.where.u, b.where.u) && meet(a.where.v, b.where.v);
}

bool are_apart(const PieceBox& a, const PieceBox& b) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (a.upper[c] < b.lower[c] || b.upper[c] < a.lower[c]) return true;
  }
  return false;
}

filter::Rectangle hull(const ParameterCell& a, const ParameterCell& b) {
  filter::Rectangle result;
  for (std::size_t i = 0; i < 2; ++i) {
    result.lower[i] = std::min(a.centred.lower[i], b.centred.lower[i]);
    result.upper[i] = std::max(a.centred.upper[i], b.centred.upper[i]);
  }
  return result;
}

}  // namespace exsect
