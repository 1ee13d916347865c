#include "side/boundary_lines.h"

#include <algorithm>
#include <optional>
#include <string>

#include "answer/left_open.h"
#include "answer/parameter_box.h"
#include "line/exact_line_points.h"

namespace exsect {

namespace {

constexpr const char* kPointsWorkCap = "the work cap was reached while boundary points were computed";
constexpr const char* kTwoPoles =
    "two adjacent sides of a patch and a side of the other one are the same point";
constexpr const char* kLostEnd = "an end of a boundary arc was not found on the other side";

class BoundarySearch {
 public:
  BoundarySearch(const BezierPatch& x, const BezierPatch& y, const ModelScale& scale, double tolerance,
                 const StopRequest& stop)
      : x_(x), y_(y), scale_(scale), tolerance_(tolerance), stop_(stop) {}

  BoundaryLines run() {
    result_.poles = common_poles(x_, y_);
    for (const Parameter p : all_parameters)
      for (const int value : {0, 1}) {
        if (stop_ && stop_()) {
          result_.incomplete.push_back(out_of_time(whole_domain(), kPointsWorkCap));
          return std::move(result_);
        }
        find_on_line({p, value});
      }
    for (const LineResult& line : lines_) add_points(line);
    for (const LineResult& line : lines_) add_lone_ends(line);
    for (const LineResult& line : lines_) add_ends(line);
    for (const CommonPole& pole : result_.poles)
      for (const int i : {0, 1})
        for (const int k : {0, 1}) add_corner(pair_on(pole, i, k));
    for (LineResult& line : lines_) add_arcs(line);
    return std::move(result_);
  }

 private:
  struct LineResult {
    Side side;
    std::vector<CertifiedPoint> points;
    LineArcs arcs;
  };

  void incomplete(const ParameterBox& where, const std::string& why) {
    result_.incomplete.push_back({where, why, is_stopped(stop_) ? Reason::time : Reason::not_decided});
  }

  /// Keeps the arcs whose first side this is; an arc may lie on two.
  void find_on_line(const Side& side) {
    const LineQuery query = {side.parameter, side.value};
    LinePoints points = exact_line_points(x_, y_, query);
    ParameterBox where = whole_domain();
    where[index(side.parameter)] = {side.value, side.value};
    const std::string label = std::string(name(side.parameter)) + " = " + std::to_string(side.value);
    const std::string line_name = "the boundary line " + label + ": ";
    if (points.incomplete) incomplete(where, line_name + *points.incomplete);
    LineResult line{side, std::move(points.points), {}};
    if (!points.on_patch.empty()) {
      line.arcs = line_arcs(x_, y_, query, scale_, tolerance_, stop_, result_.incomplete.empty());
      if (line.arcs.incomplete) incomplete(where, line_name + *line.arcs.incomplete);
      // A side of the other patch that is one point is found as a line of its own.
      if (std::any_of(line.arcs.collapsed.begin(), line.arcs.collapsed.end(), [](const CollapsedLine& other) {
            return other.value.compare(0) != 0 && other.value.compare(1) != 0;
          }))
        incomplete(where, line_name + "a parameter line of the other patch is one point of it");
      std::erase_if(line.arcs.arcs, [&](const LineArc& arc) {
        return !arc.collapsed && !(arc.inside.sides().front() == side);
      });
    }
    lines_.push_back(std::move(line));
  }

  /// A point is kept from the line of its first side.
  void add_points(const LineResult& line) {
    const auto add = [&](const CertifiedPoint& point) {
      if (point.sides().front() == line.side) result_.points.push_back(point);
    };
    std::for_each(line.points.begin(), line.points.end(), add);
    const std::vector<bool> used = ends_of_arcs(line);
    for (std::size_t i = 0; i < used.size(); ++i)
      if (used[i]) add(line.arcs.ends[i]);
  }

  static std::vector<bool> ends_of_arcs(const LineResult& line) {
    std::vector<bool> used(line.arcs.ends.size(), false);
    for (const LineArc& arc : line.arcs.arcs) used[arc.from] = used[arc.to] = true;
    return used;
  }

  /// Points of the curve on the other patch in which no arc ends: a line that turns back has its other end
  /// there, for instance.
  void add_lone_ends(const LineResult& line) {
    const std::vector<bool> used = ends_of_arcs(line);
    for (std::size_t i = 0; i < used.size(); ++i)
      if (!used[i] && line.arcs.ends[i].sides().front() == line.side) add_if_new(line.arcs.ends[i]);
  }

  /// The ends of a side that is one point, and those in common poles: on the other sides these may not be
  /// isolated.
  void add_ends(const LineResult& line) {
    for (const LineArc& arc : line.arcs.arcs)
      for (const std::size_t i : {arc.from, arc.to}) {
        const CertifiedPoint& end = line.arcs.ends[i];
        const auto has_end = [&](const CommonPole& pole) { return is_on(end, pole); };
        if (arc.collapsed || std::ranges::any_of(result_.poles, has_end)) add_if_new(end);
      }
  }

  /// Of a pole, and of one only: two adjacent sides at one point are no square of solutions.
  void add_corner(const CertifiedPoint& corner) {
    const auto has_corner = [&](const CommonPole& pole) { return is_on(corner, pole); };
    if (std::ranges::count_if(result_.poles, has_corner) > 1) incomplete(corner.box(), kTwoPoles);
    add_if_new(corner);
  }

  void add_if_new(const CertifiedPoint& point) {
    if (!find(point)) result_.points.push_back(point);
  }

  void add_arcs(LineResult& line) {
    for (LineArc& arc : line.arcs.arcs) {
      const auto from = find(line.arcs.ends[arc.from]);
      const auto to = find(line.arcs.ends[arc.to]);
      if (!from || !to) {
        incomplete(line.arcs.ends[from ? arc.to : arc.from].box(), kLostEnd);
        continue;
      }
      result_.arcs.push_back({line.side, *from, *to, arc.inside, std::move(arc.polyline), arc.error_bound,
                              std::move(arc.hulls), arc.collapsed});
    }
  }

  /// The kept point that is this one: it is among those with the same sides, and all others can be told from
  /// it by refinement.
  std::optional<std::size_t> find(const CertifiedPoint& point) const {
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < result_.points.size(); ++i)
      if (result_.points[i].sides() == point.sides()) candidates.push_back(i);
    Rational width = power_of_two(-50);
    for (int step = 0; step < 8; ++step, width *= width) {
      const ParameterBox box = point.refined_to(width).box();
      std::erase_if(candidates,
                    [&](std::size_t i) { return !meet(box, result_.points[i].refined_to(width).box()); });
      if (candidates.size() <= 1) break;
    }
    if (candidates.size() != 1) return std::nullopt;
    return candidates.front();
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  const ModelScale& scale_;
  double tolerance_;
  const StopRequest& stop_;
  std::vector<LineResult> lines_;
  BoundaryLines result_;
};

}  // namespace

BoundaryLines boundary_lines(const BezierPatch& x, const BezierPatch& y, const ModelScale& scale,
                             double tolerance, const StopRequest& stop) {
  return BoundarySearch(x, y, scale, tolerance, stop).run();
}

}  // namespace exsect
