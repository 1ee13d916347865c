#include "self/cell_pairs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "answer/left_open.h"
#include "answer/parameter_box.h"
#include "answer/whitened_pieces.h"
#include "filter/filter.h"
#include "self/coincident_lines.h"
#include "self/pinch_exclusion.h"
#include "self/pinch_guesses.h"

namespace exsect {
namespace {

constexpr long kMostPairs = 20000;
/// Cuts of one cell: of those with no other question, and of those about a
/// pinch point for its curve's sake.
constexpr int kDeepestCell = 44;
constexpr int kFinestPinch = 26;
/// Pairs of pieces that are not decided and divided again; more of them are
/// left open.
constexpr int kMostFailures = 8;
constexpr std::size_t kMostProblems = 4;
/// Of the extent of a pair of pieces, for its polylines.
constexpr double kCoarsestPiece = 0x1p-4;
/// Of the hull of two cells, by their widths.
constexpr double kNearHull = 1.5;
/// Of the curve from a pinch point; with more the cell is divided.
constexpr double kMostPinchChords = 500;
/// Of the tolerance, for whitened pieces; and their extent, or more: of some 18
/// to 32 points with mean square 1.
constexpr double kWhitenedShare = 0.9;
constexpr double kWhitenedExtent = 8;

double extent_of(const ParameterCell& a, const ParameterCell& b) {
  double extent = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double lower = std::min(a.box.lower[c], b.box.lower[c]);
    extent = std::max(extent, std::max(a.box.upper[c], b.box.upper[c]) - lower);
  }
  return extent;
}

/// The parameter of the square.
RationalInterval placed(const RationalInterval& t, const RationalInterval& in) {
  return {in.lower + t.lower * in.width(), in.lower + t.upper * in.width()};
}

class Cover {
 public:
  Cover(const RationalPatch& patch, const InjectiveRectangle& is_injective, unsigned grid,
        const ParameterLines& lines, double extent, const Run& run,
        const std::vector<std::array<double, 2>>& guesses)
      : found_{CellTree(patch, grid, lines, guesses), poles_of(patch), {}, {}, {}},
        patch_(patch),
        is_injective_(is_injective),
        run_(run),
        pinches_(known_pinches(patch, guesses)),
        extent_(extent),
        tolerance_(run.drawn_tolerance(extent)) {
    for (const std::size_t fixed : {0U, 1U})
      if (const auto coincident = coincident_lines(patch, fixed)) coincident_.push_back(*coincident);
  }

  CellPairs run() {
    std::vector<std::pair<std::size_t, std::size_t>> stack = {{0, 0}};
    while (!stack.empty() && found_.problems.size() < kMostProblems) {
      const auto [a, b] = stack.back();
      stack.pop_back();
      if (is_done(a, b)) continue;
      if (run_.out_of_time()) {
        found_.problems.push_back(out_of_time(whole_domain()));
        break;
      }
      if (!may_divide(a, b)) {
        leave_open(a, b);
        continue;
      }
      if (a == b) {
        const std::size_t child = found_.cells.split(a);
        for (const auto& [i, j] : {std::pair(0U, 0U), std::pair(1U, 1U), std::pair(0U, 1U)})
          stack.emplace_back(child + i, child + j);
      } else {
        const bool first = found_.cells[a].level <= found_.cells[b].level;
        const std::size_t child = found_.cells.split(first ? a : b);
        for (const std::size_t i : {0U, 1U}) stack.emplace_back(first ? child + i : a, first ? b : child + i);
      }
    }
    return std::move(found_);
  }

 private:
  bool is_done(std::size_t a, std::size_t b) {
    ++found_.pairs;
    failure_ = {};
    const ParameterCell &first = found_.cells[a], &second = found_.cells[b];
    const bool touching = touch(first, second);
    if (!touching && are_apart(first.box, second.box)) return true;
    if (is_injective_(hull(first, second))) return true;
    const bool adjacent = touching || is_near(first, second);
    if (meet_in_poles_only(first, second, adjacent)) return true;
    if (adjacent && is_excluded(first, second)) return true;
    if (found_.cells.has_line_inside(a) || found_.cells.has_line_inside(b)) return false;
    if (a == b) return is_pinch(a);
    return !touching && solve(a, b);
  }

  /// Their hull is hardly larger than they are.
  static bool is_near(const ParameterCell& a, const ParameterCell& b) {
    const filter::Rectangle both = hull(a, b);
    return std::ranges::all_of(std::array{0U, 1U}, [&](std::size_t i) {
      const double widths = a.centred.upper[i] - a.centred.lower[i] + b.centred.upper[i] - b.centred.lower[i];
      return both.upper[i] - both.lower[i] < kNearHull * widths;
    });
  }

  /// The smallest rectangle around both.
  static ParameterRectangle around(const ParameterCell& a, const ParameterCell& b) {
    const auto hull_of_ranges = [](const RationalInterval& s, const RationalInterval& t) {
      return RationalInterval{std::min(s.lower, t.lower), std::max(s.upper, t.upper)};
    };
    return {hull_of_ranges(a.where.u, b.where.u), hull_of_ranges(a.where.v, b.where.v)};
  }

  RationalPatch piece_around(const ParameterCell& a, const ParameterCell& b) const {
    if (&a == &b) return a.piece;
    const ParameterRectangle where = around(a, b);
    return patch_.restricted_to(where.u.lower, where.u.upper, where.v.lower, where.v.upper);
  }

  /// Cells that are not adjacent have no common point.
  bool meet_in_poles_only(const ParameterCell& a, const ParameterCell& b, bool adjacent) const {
    return std::ranges::any_of(found_.poles, [&](const Pole& pole) {
      const bool first = reaches(a.where, pole), second = reaches(b.where, pole);
      if (first && second && !touch(a, b) && are_apart_but_for(pole, a.piece, b.piece)) return true;
      return adjacent && (first || second) && is_injective_but_for(pole, piece_around(a, b));
    });
  }

  /// Of the pairs in both, no midpoint is one of pairs of the hull with one
  /// point of space.
  bool is_excluded(const ParameterCell& a, const ParameterCell& b) const {
    const auto middles = [](const RationalInterval& s, const RationalInterval& t,
                            const RationalInterval& in) {
      const Rational lower = (s.lower + t.lower) / 2 - in.lower, upper = (s.upper + t.upper) / 2 - in.lower;
      return DoubleBall::enclosing(RationalInterval{lower / in.width(), upper / in.width()});
    };
    const ParameterRectangle both = around(a, b);
    return has_no_pairs(piece_around(a, b), origin_of(a),
                        {middles(a.where.u, b.where.u, both.u), middles(a.where.v, b.where.v, both.v)});
  }

  bool is_pinch(std::size_t a) {
    const ParameterCell& cell = found_.cells[a];
    std::vector<KnownPinch> known;
    std::ranges::copy_if(pinches_, std::back_inserter(known),
                         [&](const KnownPinch& pinch) { return contains(cell.where, pinch); });
    const int sides = (cell.where.u.lower == 0) + (cell.where.u.upper == 1) + (cell.where.v.lower == 0) +
                      (cell.where.v.upper == 1);
    const auto on = std::ranges::find_if(known, &KnownPinch::is_on_side);
    if (sides > 0 && on == known.end()) return false;
    auto proof = PinchProof::of(cell.piece, origin_of(cell));
    if (!proof) return false;
    if (sides == 0) return keeps_pinch({a, *std::move(proof), {}}, known);
    bool begins = sides == 1, along = sides == 1;
    for (const KnownPinch& pinch : known) {
      if (!pinch.is_on_side()) continue;
      const PinchProof::AtSide at_side = proof->at_side(
          pinch.fixed, pinch.value == 0 ? 0 : 1, pinch.rests[1 - pinch.fixed], pinch.is_on_straight_line);
      if (at_side == PinchProof::AtSide::none) return true;
      begins = begins && at_side == PinchProof::AtSide::begins;
      along = along && at_side == PinchProof::AtSide::along;
    }
    return (begins || along) && keeps_pinch({a, *std::move(proof), *on, along}, known);
  }

  /// If its curve is monotone in what is to be so, and short enough to be drawn.
  bool keeps_pinch(PinchCell pinch, const std::vector<KnownPinch>& known) {
    const double chords = 0.25 * std::sqrt(pinch.proof.bend() / tolerance_);
    const auto rests = [&](std::size_t j) {
      return std::ranges::any_of(known, [&](const KnownPinch& at) { return at.rests[j]; });
    };
    const bool is_monotone = std::ranges::all_of(run_.turning(), [&](Parameter p) {
      const std::size_t j = index(p) % 2;
      if (pinch.along && j == pinch.on->fixed) return true;
      return pinch.proof.is_monotone(j) || (rests(1 - j) && pinch.proof.is_monotone_from_rest(j));
    });
    if (!is_monotone) return false;
    if (!(chords < kMostPinchChords) && found_.cells[pinch.cell].level < kFinestPinch) return false;
    found_.pinches.push_back(std::move(pinch));
    return true;
  }

  bool solve(std::size_t a, std::size_t b) {
    const ParameterCell &first = found_.cells[a], &second = found_.cells[b];
    IntersectResult result = meeting_of(first, second);
    if (result.status == Status::complete && result.graph.overlaps.empty()) {
      if (!result.graph.nodes.empty()) found_.solved.push_back({a, b, std::move(result.graph)});
      return true;
    }
    ++failures_;
    failure_ = result.incomplete.empty()
                   ? Incomplete{whole_domain(), "two pieces of the patch lie on one surface"}
                   : result.incomplete.front();
    return false;
  }

  /// A parameter that is constant along a curve is not proved to be so in
  /// doubles: where coincident lines pass, and there is one curve, it is them,
  /// and has no turning point of that parameter.
  IntersectResult meeting_of(const ParameterCell& first, const ParameterCell& second) const {
    const auto whitening = Whitening::of(first.piece, second.piece);
    for (const CoincidentLines& lines : coincident_) {
      if (!lines.pass(first.where, second.where)) continue;
      std::vector<Parameter> turning;
      for (const Parameter p : run_.turning())
        if (index(p) % 2 != lines.fixed) turning.push_back(p);
      IntersectResult result = meeting_of(first, second, whitening, run_.with_turning(std::move(turning)));
      if (result.status == Status::complete && result.graph.arcs.size() == 1) return result;
    }
    return meeting_of(first, second, whitening, run_);
  }

  /// Near a pinch point pieces are far longer in one direction than in the
  /// others, until they are whitened.
  IntersectResult meeting_of(const ParameterCell& first, const ParameterCell& second,
                             const std::optional<Whitening>& whitening, const Run& run) const {
    const auto within = [&](double tolerance) {
      return run.with_tolerance(tolerance < kCoarsestPiece ? tolerance : kCoarsestPiece);
    };
    if (!whitening) {
      const double extent = std::min(extent_of(first, second), extent_);
      return intersect_in_doubles(first.piece, second.piece, within(tolerance_ / extent));
    }
    const double tolerance = kWhitenedShare * tolerance_ / whitening->stretch();
    const RationalPatch x = (*whitening)(first.piece), y = (*whitening)(second.piece);
    if (are_apart(box_of(x), box_of(y))) return {Status::complete, {}, {}, {}};
    IntersectResult result = intersect_in_doubles(x, y, within(tolerance / kWhitenedExtent));
    whitening->restore(result.graph);
    return result;
  }

  bool may_divide(std::size_t a, std::size_t b) const {
    return std::max(found_.cells[a].level, found_.cells[b].level) < kDeepestCell &&
           found_.pairs < kMostPairs && failures_ < kMostFailures;
  }

  void leave_open(std::size_t a, std::size_t b) {
    const ParameterRectangle &first = found_.cells[a].where, &second = found_.cells[b].where;
    Incomplete problem{{first.u, first.v, second.u, second.v},
                       "whether the patch meets itself near a place, or has a "
                       "cuspidal point there, not decided"};
    if (failure_) {
      problem.why = failure_->why;
      problem.reason = failure_->reason;
      for (std::size_t j = 0; j < 4; ++j) problem.where[j] = placed(failure_->where[j], problem.where[j]);
    }
    found_.problems.push_back(std::move(problem));
  }

  CellPairs found_;
  std::vector<CoincidentLines> coincident_;
  const RationalPatch& patch_;
  const InjectiveRectangle& is_injective_;
  const Run& run_;
  std::vector<KnownPinch> pinches_;  // exactly
  double extent_;
  double tolerance_;
  int failures_ = 0;
  std::optional<Incomplete> failure_;  // of the pair that was looked at last
};

}  // namespace

CellPairs cell_pairs(const RationalPatch& patch, const InjectiveRectangle& is_injective, unsigned grid,
                     const ParameterLines& lines, double extent, const Run& run) {
  return Cover(patch, is_injective, grid, lines, extent, run, pinch_guesses(patch)).run();
}

Point origin_of(const ParameterCell& cell) {
  Point origin;
  for (std::size_t c = 0; c < 3; ++c) {
    const double middle = 0.5 * cell.box.lower[c] + 0.5 * cell.box.upper[c];
    origin[c] = std::isfinite(middle) ? from_double(middle) : Rational(0);
  }
  return origin;
}

}  // namespace exsect
