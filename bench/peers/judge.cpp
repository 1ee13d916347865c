#include "judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace peers {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double near_truth = 1e-3;    // of the size of the pair
constexpr double common_point = 1e-4;  // residual, of the size of the pair

/// Where a point is nearest to a polyline: distance, and the length of the polyline up to there.
struct Foot {
  double distance = infinite;
  double along = 0;
};

/// The nearest point of the segment [a,b], as a fraction of it.
template <std::size_t n>
double foot_on_segment(const std::array<double, n>& p, const std::array<double, n>& a,
                       const std::array<double, n>& b, double& distance) {
  double dot = 0;
  double square = 0;
  for (std::size_t k = 0; k < n; ++k) {
    dot += (p[k] - a[k]) * (b[k] - a[k]);
    square += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double t = square > 0 ? std::clamp(dot / square, 0.0, 1.0) : 0;
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double difference = p[k] - a[k] - t * (b[k] - a[k]);
    sum += difference * difference;
  }
  distance = std::sqrt(sum);
  return t;
}

/// Parameters and the point in units of the size: curves that meet in space alone stay apart.
std::array<double, 7> together(const Vertex& v, double size) {
  return {v.parameters[0],   v.parameters[1],   v.parameters[2],  v.parameters[3],
          v.point[0] / size, v.point[1] / size, v.point[2] / size};
}

/// A true curve with what is asked about it.
class TrueCurve {
 public:
  TrueCurve(const Component& component, double size) : shape_(component.shape), size_(size) {
    for (const Curve& curve : component.curves) {
      for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        segments_.push_back({&curve[i], &curve[i + 1], length_});
        length_ += peers::distance(curve[i].point, curve[i + 1].point);
        joint_.push_back({together(curve[i], size), together(curve[i + 1], size)});
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      double lowest = infinite;
      double highest = -infinite;
      for (const Curve& curve : component.curves) {
        for (const Vertex& v : curve) {
          lowest = std::min(lowest, v.point[k]);
          highest = std::max(highest, v.point[k]);
        }
      }
      extent_ = std::max(extent_, highest - lowest);
    }
  }

  double length() const { return length_; }
  double extent() const { return extent_; }
  /// How near a chord has to be to cover.
  double reach() const { return std::min(near_truth * size_, extent_ / 8); }
  bool has_one_passage() const { return shape_ != "branched"; }

  Foot in_space(const Point& p) const {
    Foot best;
    for (const Segment& s : segments_) {
      double distance = 0;
      const double t = foot_on_segment(p, s.from->point, s.to->point, distance);
      if (distance < best.distance) {
        best = {distance, s.before + t * peers::distance(s.from->point, s.to->point)};
      }
    }
    return best;
  }

  /// Distance in all coordinates together.
  Foot jointly(const Vertex& v) const {
    const auto p = together(v, size_);
    Foot best;
    for (std::size_t i = 0; i < joint_.size(); ++i) {
      double distance = 0;
      const double t = foot_on_segment(p, joint_[i].first, joint_[i].second, distance);
      if (distance < best.distance) {
        const Segment& s = segments_[i];
        best = {distance, s.before + t * peers::distance(s.from->point, s.to->point)};
      }
    }
    return best;
  }

  /// The way along the curve between two places, the shorter one of a closed curve.
  double way(double a, double b) const {
    const double direct = std::abs(a - b);
    return shape_ == "closed" ? std::min(direct, length_ - direct) : direct;
  }

  /// The fraction of the length within reach of the chords.
  double covered_by(const std::vector<std::pair<Vertex, Vertex>>& chords) const {
    double sum = 0;
    for (const Segment& s : segments_) {
      Point middle{};
      for (std::size_t k = 0; k < 3; ++k) middle[k] = (s.from->point[k] + s.to->point[k]) / 2;
      const bool covered = std::any_of(chords.begin(), chords.end(), [&](const auto& chord) {
        double distance = 0;
        foot_on_segment(middle, chord.first.point, chord.second.point, distance);
        return distance <= reach();
      });
      if (covered) sum += peers::distance(s.from->point, s.to->point);
    }
    return length_ > 0 ? sum / length_ : 1;
  }

 private:
  struct Segment {
    const Vertex* from;
    const Vertex* to;
    double before;  // length of the curve up to `from`
  };

  std::string shape_;
  double size_;
  double length_ = 0;
  double extent_ = 0;
  std::vector<Segment> segments_;
  std::vector<std::pair<std::array<double, 7>, std::array<double, 7>>> joint_;
};

/// What a vertex of an answer is.
struct Place {
  double distance = infinite;  // from the truth
  std::vector<std::size_t> may_be_on;
  double along = 0;  // where it is on one curve alone
};

class Judge {
 public:
  Judge(const PatchPair& pair, const Reference& reference)
      : pair_(pair), reference_(reference), size_(pair.size()) {
    for (const Component& component : reference.components) curves_.emplace_back(component, size_);
  }

  Verdict operator()(const Answer& answer) {
    verdict_.components = static_cast<int>(curves_.size());
    verdict_.isolated = static_cast<int>(reference_.isolated.size());
    chords_.resize(curves_.size());
    for (const Curve& curve : answer.curves) judge_curve(curve);
    for (const Vertex& point : answer.points) judge_point(point);
    for (std::size_t i = 0; i < curves_.size(); ++i) judge_component(i, answer.points);
    for (const Vertex& point : reference_.isolated) judge_isolated(point, answer);
    return verdict_;
  }

 private:
  Place place(const Vertex& v) const {
    Place result;
    Vertex on_truth = v;
    if (const auto foot = nearest_point(pair_, v.point, v.parameters)) {
      result.distance = distance(foot->point, v.point);
      if (result.distance < near_truth * size_) on_truth = *foot;
    }
    for (const TrueCurve& curve : curves_)
      result.distance = std::min(result.distance, curve.in_space(v.point).distance);
    for (const Vertex& point : reference_.isolated) {
      result.distance = std::min(result.distance, distance(point.point, v.point));
    }
    if (!reference_.rims.empty() && residual(pair_, v.parameters) < common_point * size_) result.distance = 0;
    find_curves(on_truth, result);
    return result;
  }

  /// The nearest true curve, and all that are too near it to tell: polylines are within 1e-5 of their curves.
  void find_curves(const Vertex& v, Place& place) const {
    constexpr double blur = 4e-5;
    std::vector<Foot> feet;
    double nearest = infinite;
    for (const TrueCurve& curve : curves_) {
      feet.push_back(curve.jointly(v));
      nearest = std::min(nearest, feet.back().distance);
    }
    for (std::size_t i = 0; i < feet.size(); ++i) {
      if (feet[i].distance > 3 * nearest + blur) continue;
      place.may_be_on.push_back(i);
      place.along = feet[i].along;
    }
  }

  void judge_curve(const Curve& curve) {
    std::vector<Place> places;
    std::size_t far = 0;
    for (const Vertex& v : curve) {
      places.push_back(place(v));
      if (places.back().distance > near_truth * size_) ++far;
    }
    if (2 * far >= curve.size()) {
      ++verdict_.invented_curves;
      return;
    }
    for (std::size_t i = 0; i < curve.size(); ++i) {
      verdict_.residual = std::max(verdict_.residual, residual(pair_, curve[i].parameters));
      verdict_.distance = std::max(verdict_.distance, places[i].distance);
      if (i == 0) continue;
      for (const std::size_t c : places[i].may_be_on) {
        if (std::count(places[i - 1].may_be_on.begin(), places[i - 1].may_be_on.end(), c) != 0) {
          chords_[c].push_back({curve[i - 1], curve[i]});
        }
      }
    }
    if (jumps(curve, places)) ++verdict_.wrong_connections;
  }

  /// From one curve to another, or along one by much more than the chord.
  bool jumps(const Curve& curve, const std::vector<Place>& places) const {
    constexpr double longer = 5;
    constexpr double slack = 0.02;
    std::size_t last = curve.size();  // the last vertex on one curve alone
    for (std::size_t i = 0; i < curve.size(); ++i) {
      if (places[i].may_be_on.size() != 1 || places[i].distance > near_truth * size_) continue;
      if (last < curve.size()) {
        const std::size_t c = places[i].may_be_on.front();
        if (places[last].may_be_on.front() != c) return true;
        const double chord = distance(curve[last].point, curve[i].point);
        const double way = curves_[c].way(places[last].along, places[i].along);
        const double allowed = longer * chord + std::min(slack * size_, curves_[c].length() / 4);
        if (last + 1 == i && curves_[c].has_one_passage() && way > allowed) return true;
      }
      last = i;
    }
    return false;
  }

  void judge_point(const Vertex& point) {
    const Place found = place(point);
    const double r = residual(pair_, point.parameters);
    if (found.distance > near_truth * size_ || r > common_point * size_) {
      ++verdict_.invented_points;
      return;
    }
    verdict_.residual = std::max(verdict_.residual, r);
    verdict_.distance = std::max(verdict_.distance, found.distance);
  }

  void judge_component(std::size_t i, const std::vector<Vertex>& points) {
    const TrueCurve& curve = curves_[i];
    const double covered = curve.covered_by(chords_[i]);
    if (covered >= 0.99) {
      ++verdict_.found;
      return;
    }
    ++(covered >= 0.05 ? verdict_.partly : verdict_.lost);
    const double reach = std::min(near_truth * size_, curve.extent());
    if (std::any_of(points.begin(), points.end(),
                    [&](const Vertex& p) { return curve.in_space(p.point).distance <= reach; })) {
      ++verdict_.as_points;
    }
  }

  void judge_isolated(const Vertex& point, const Answer& answer) {
    const auto near = [&](const Vertex& v) { return distance(v.point, point.point) <= near_truth * size_; };
    bool found = std::any_of(answer.points.begin(), answer.points.end(), near);
    for (const Curve& curve : answer.curves) found = found || std::any_of(curve.begin(), curve.end(), near);
    if (found) ++verdict_.isolated_found;
  }

  const PatchPair& pair_;
  const Reference& reference_;
  double size_;
  std::vector<TrueCurve> curves_;
  std::vector<std::vector<std::pair<Vertex, Vertex>>> chords_;  // of the answer, on each true curve
  Verdict verdict_;
};

}  // namespace

bool Verdict::right() const {
  return found == components && isolated_found == isolated && invented_curves == 0 && invented_points == 0 &&
         wrong_connections == 0;
}

Verdict& Verdict::operator+=(const Verdict& other) {
  components += other.components;
  found += other.found;
  partly += other.partly;
  lost += other.lost;
  as_points += other.as_points;
  isolated += other.isolated;
  isolated_found += other.isolated_found;
  invented_curves += other.invented_curves;
  invented_points += other.invented_points;
  wrong_connections += other.wrong_connections;
  residual = std::max(residual, other.residual);
  distance = std::max(distance, other.distance);
  return *this;
}

Verdict judge(const PatchPair& pair, const Reference& reference, const Answer& answer) {
  return Judge(pair, reference)(answer);
}

LineVerdict judge_lines(const std::vector<std::vector<Point>>& reference,
                        const std::vector<std::vector<Point>>& answer) {
  constexpr double same = 1e-4;
  LineVerdict verdict;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    std::vector<Point> left = answer.at(i);
    for (const Point& p : reference[i]) {
      ++verdict.points;
      const auto match = std::find_if(left.begin(), left.end(), [&](const Point& q) {
        return std::abs(p[0] - q[0]) < same && std::abs(p[1] - q[1]) < same && std::abs(p[2] - q[2]) < same;
      });
      if (match == left.end()) {
        ++verdict.lost;
      } else {
        left.erase(match);
      }
    }
    verdict.invented += static_cast<int>(left.size());
  }
  return verdict;
}

}  // namespace peers
