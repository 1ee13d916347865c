#include "resultant_method.h"

#include <exsect/algebra/determinant.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/integer_pair.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "answer/proof_failure.h"
#include "curve/no_zero.h"
#include "curve/plane_curve.h"
#include "eliminant/fibre_projection.h"
#include "line/exact_line_points.h"

namespace exsect {
namespace {

/// R in Z[u][s] as a polynomial in (u,s).
BivariatePolynomial eliminant(const BezierPatch& x, const BezierPatch& y) {
  const FibreProjection projection = project_fibre(symbolic_fibre(integer_pair(x, y)));
  return BivariatePolynomial({projection.r.coefficients.begin(), projection.r.coefficients.end()})
      .exchanged();
}

bool overlap(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

/// For each point the index of the root that its r is; the roots are all there are.
std::vector<std::size_t> roots_of(const std::vector<CertifiedPoint>& points,
                                  std::vector<RealAlgebraic> roots) {
  constexpr std::size_t r = index(Parameter::r);
  std::vector<std::size_t> result;
  for (CertifiedPoint point : points) {
    for (Rational width = power_of_two(-20);; width *= width) {
      std::vector<std::size_t> candidates;
      for (std::size_t i = 0; i < roots.size(); ++i)
        if (overlap(roots[i].interval(), point.box()[r])) candidates.push_back(i);
      if (candidates.empty())
        throw ProofFailure(point.box(), "a point of the intersection lies over no root of the resultant");
      if (candidates.size() == 1) {
        result.push_back(candidates.front());
        break;
      }
      point = point.refined_to(width);
      for (const std::size_t i : candidates) roots[i] = roots[i].refined_to(width);
    }
  }
  return result;
}

/// Small intervals around the u of the boundary points inside (0,1) with v or s in {0,1}.
std::vector<RationalInterval> boundary_events(const BezierPatch& x, const BezierPatch& y,
                                              std::optional<std::string>& incomplete) {
  constexpr std::size_t u = index(Parameter::u);
  const Rational width = power_of_two(-60);
  std::vector<RationalInterval> events;
  for (const Parameter fixed : {Parameter::v, Parameter::s})
    for (const int side : {0, 1}) {
      const LinePoints line = exact_line_points(x, y, {fixed, side});
      if (line.incomplete || !line.on_patch.empty())
        incomplete = std::string("the points on the side ") + name(fixed) + " = " + std::to_string(side) +
                     " are not isolated or not all known";
      for (const CertifiedPoint& point : line.points) {
        if (point.on({Parameter::u, 0}) || point.on({Parameter::u, 1})) continue;
        const RationalInterval at = point.refined_to(width).box()[u];
        events.push_back({std::max(Rational(at.lower - width), width),
                          std::min(Rational(at.upper + width), Rational(1 - width))});
      }
    }
  return events;
}

/// Three or more true arcs that seem to meet in (u,r), told apart by s.
class MeetingSplitter {
 public:
  MeetingSplitter(const BezierPatch& x, const BezierPatch& y, ResultantMethod& method)
      : x_(x), y_(y), method_(method) {}

  void split_all() {
    for (CurveEvent& event : method_.arcs.events) {
      std::vector<CurveMeeting> meetings;
      for (const CurveMeeting& meeting : event.meetings)
        for (CurveMeeting& part : parts(meeting, event.u)) meetings.push_back(std::move(part));
      event.meetings = std::move(meetings);
    }
  }

 private:
  struct End {
    std::size_t arc;
    bool left;
    RationalInterval s;
  };

  std::vector<CurveMeeting> parts(const CurveMeeting& meeting, const RationalInterval& window) {
    CurveMeeting phantoms{meeting.kind, meeting.v, {}, {}};
    std::vector<std::size_t> left, right;
    for (const std::size_t arc : meeting.left) (method_.is_true[arc] ? left : phantoms.left).push_back(arc);
    for (const std::size_t arc : meeting.right)
      (method_.is_true[arc] ? right : phantoms.right).push_back(arc);
    if (left.size() + right.size() <= 2 || window.lower == window.upper) return {meeting};
    std::vector<End> ends;
    if (!add_ends(ends, left, window.lower, true, meeting.v) ||
        !add_ends(ends, right, window.upper, false, meeting.v))
      return {meeting};
    std::vector<CurveMeeting> result = grouped(std::move(ends), window, meeting);
    if (!phantoms.left.empty() || !phantoms.right.empty()) result.push_back(std::move(phantoms));
    return result;
  }

  /// The s of the arcs at one end of the window: the points of its fibre with r in the strip, ordered as the
  /// arcs are, by r. False if they do not fit the arcs.
  bool add_ends(std::vector<End>& ends, const std::vector<std::size_t>& arcs, const Rational& u, bool left,
                const RationalInterval& strip) {
    constexpr std::size_t r = index(Parameter::r), s = index(Parameter::s);
    std::vector<std::pair<RationalInterval, RationalInterval>> points;
    for (const CertifiedPoint& point : exact_line_points(x_, y_, {Parameter::u, u}).points) {
      const ParameterBox box = point.refined_to(power_of_two(-100)).box();
      if (strip.lower <= box[r].lower && box[r].upper <= strip.upper) points.emplace_back(box[r], box[s]);
    }
    if (points.size() != arcs.size()) return false;
    method_.certified_points += points.size();
    std::sort(points.begin(), points.end(),
              [](const auto& a, const auto& b) { return a.first.lower < b.first.lower; });
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0 && points[i - 1].first.upper >= points[i].first.lower) return false;
      ends.push_back({arcs[i], left, points[i].second});
    }
    return true;
  }

  /// No point of the curve crosses a level s = c where the eliminant in (u,s) has no zero in the window.
  std::vector<CurveMeeting> grouped(std::vector<End> ends, const RationalInterval& window,
                                    const CurveMeeting& meeting) {
    if (levels_.is_zero()) levels_ = eliminant(x_, y_);
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.s.lower < b.s.lower; });
    std::vector<CurveMeeting> result = {{meeting.kind, meeting.v, {}, {}}};
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (i > 0 && ends[i - 1].s.upper < ends[i].s.lower &&
          has_no_zero(levels_.at_s(simplest_between(ends[i - 1].s.upper, ends[i].s.lower)), window))
        result.push_back({meeting.kind, meeting.v, {}, {}});
      (ends[i].left ? result.back().left : result.back().right).push_back(ends[i].arc);
    }
    for (CurveMeeting& part : result)
      if (part.left.size() + part.right.size() == 2)
        part.kind = part.left.size() == 1 ? MeetingKind::passes : MeetingKind::folds;
    return result;
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  ResultantMethod& method_;
  BivariatePolynomial levels_;
};

std::vector<bool> opposite(std::vector<bool> flags) {
  flags.flip();
  return flags;
}

/// Fills in the result as far as it can be known.
void solve(const BezierPatch& x, const BezierPatch& y, ResultantMethod& result) {
  const BivariatePolynomial g = eliminant(x, y.exchanged());
  if (g.is_zero()) {
    result.incomplete = "the resultant vanishes identically";
    return;
  }
  result.curve = primitive(squarefree(g));
  const std::vector<RationalInterval> events = boundary_events(x, y, result.incomplete);
  if (result.curve.at_s(0).is_zero() || result.curve.at_s(1).is_zero()) {
    result.incomplete = "a side r = 0 or r = 1 belongs to the curve";
    return;
  }
  result.arcs = curve_arcs(result.curve, events);
  result.is_true.assign(result.arcs.arcs.size(), false);
  for (const CurveGap& gap : result.arcs.gaps) {
    if (gap.arcs.empty()) continue;
    const LinePoints line = exact_line_points(x, y, {Parameter::u, gap.sample});
    if (line.incomplete || !line.on_patch.empty()) result.incomplete = "a fibre is infinite or not known";
    result.certified_points += line.points.size();
    for (const std::size_t i : roots_of(line.points, real_roots(result.curve.at_r(gap.sample), 0, 1)))
      result.is_true[gap.arcs[i]] = true;
  }
  if (std::any_of(result.arcs.events.begin(), result.arcs.events.end(),
                  [](const CurveEvent& event) { return event.is_crowded; }))
    result.incomplete = "a boundary point and several turning values are within 2^-59 of each other";
  MeetingSplitter(x, y, result).split_all();
  result.components = components(result.arcs, result.is_true);
  result.phantoms = components(result.arcs, opposite(result.is_true));
  if (!result.arcs.vertical.empty() && !result.incomplete)
    result.incomplete =
        "a line u = const belongs to the curve; whether it belongs to the intersection is not decided";
}

}  // namespace

ResultantMethod intersect_by_resultant(const BezierPatch& x, const BezierPatch& y) {
  return in_nearest_rounding([&]() -> ResultantMethod {
    ResultantMethod result{{}, {}, {}, {}, {}, 0, std::nullopt};
    if (auto why = failure_of([&] { solve(x, y, result); })) result.incomplete = std::move(why);
    return result;
  });
}

ResultantCheck check(const ResultantMethod& method, const std::vector<CheckLine>& lines) {
  return in_nearest_rounding([&] {
    ResultantCheck result{0, 0};
    for (const CheckLine& line : lines) {
      const Polynomial in_r = method.curve.at_r(line.u);
      if (in_r.degree() < 1) continue;
      const std::vector<RealAlgebraic> roots = real_roots(in_r, 0, 1);
      std::vector<std::size_t> matched = roots_of(line.points, roots);
      std::sort(matched.begin(), matched.end());
      matched.erase(std::unique(matched.begin(), matched.end()), matched.end());
      result.points += line.points.size();
      result.phantoms += roots.size() - matched.size();
    }
    return result;
  });
}

}  // namespace exsect
