#include "certificate_star.h"

#include <algorithm>
#include <cmath>

#include "certificate_algebraic.h"
#include "certificate_claims.h"
#include "certificate_singular.h"

namespace exsect::cli {
namespace {

using checker::Ball;
using checker::others;
using checker::Star;

/// The line whose half branch in the chart begins at z; -1 if there is none.
int line_at(const Star& star, std::size_t direction, const Parameters& z,
            const std::vector<checker::Line>& lines) {
  const std::size_t k = direction / 2;
  for (std::size_t n = 0; n < lines.size(); ++n) {
    Parameters e{};
    bool through = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& [a, b, c] = lines[n].at[i];
      through = through && c == 0 &&
                checker::Algebraic(a) + checker::Algebraic(b) * star.at[lines[n].axis] == star.at[i];
      for (std::size_t j = 0; j < 4; ++j)
        e[j] += checker::number<double>(star.coordinates[j][i]) * to_double(b);
    }
    if (!through || e[k] == 0) continue;
    bool same = true;
    for (const std::size_t j : others(k))
      same = same && std::abs((direction % 2 == 0 ? e[j] : -e[j]) / e[k] - z[j]) < 1e-9;
    if (same) return static_cast<int>(n);
  }
  return -1;
}

/// One chart: its tubes and its subdivision. Throws NotAlone if it does not end.
class ChartSearch {
 public:
  ChartSearch(const Star& star, const Map& map, const ClaimNumbers& first, std::size_t direction,
              const std::vector<checker::Line>& lines)
      : star_(star), map_(map), first_(first), direction_(direction), lines_(lines) {}

  /// The half branch along a line on which the patches touch; `equation`: F.
  void add_seam(const checker::Map<Rational>& equation, std::size_t line) {
    const checker::MapName chart = {Chart::star, first_.star, direction_};
    checker::OnAxis<Rational> on;
    try {
      on = checker::ray(star_, chart, lines_[line]);
    } catch (const checker::Failed&) {
      return;
    }
    for (const std::size_t j : others(direction_ / 2))
      if (abs(on[j][0]) >= 1) return;
    const auto map = checker::in_direction<Rational>(checker::centred(equation, star_), star_, direction_,
                                                     star_.rows, star_.orders);
    seams_.push_back(seam_along(map, chart, on, direction_ / 2, 0, 1, first_.seam + seams_.size(),
                                static_cast<int>(line)));
    tubes_.push_back(seams_.back().tube);
  }

  void run() {
    Parameters middle{};
    Parameters half = {1, 1, 1, 1};
    middle[direction_ / 2] = half[direction_ / 2] = 0.5;
    add(middle, half, 0);
  }

  std::string entries_;
  std::vector<Tube> tubes_;
  std::vector<FoundSeam> seams_;

 private:
  void add(const Parameters& middle, const Parameters& half, int depth) {
    if (++count_ > max_entries || depth > 60) throw NotAlone();
    std::string place = leaf(middle, half);
    if (place.empty() && depth > 8 && half_branch(middle, half)) place = leaf(middle, half);
    std::size_t parameter = 0;
    for (std::size_t j = 1; j < 4; ++j)
      if (weight(half, j) > weight(half, parameter)) parameter = j;
    entries_ += (entries_.empty() ? "" : " ") + (place.empty() ? std::string(1, "uvrs"[parameter]) : place);
    if (!place.empty()) return;
    Parameters less = half;
    less[parameter] /= 2;
    for (const int side : {-1, 1}) {
      Parameters moved = middle;
      moved[parameter] += side * less[parameter];
      add(moved, less, depth + 1);
    }
  }

  /// t is halved late: little depends on it.
  double weight(const Parameters& half, std::size_t j) const {
    return j == direction_ / 2 ? 0.1 * half[j] : half[j];
  }

  std::string leaf(const Parameters& middle, const Parameters& half) const {
    checker::Box<double> box;
    for (std::size_t j = 0; j < 4; ++j) box[j] = {middle[j], half[j]};
    for (std::size_t i = 0; i < tubes_.size(); ++i) {
      Tube tube = tubes_[i];
      tube.width *= 1 - 1e-9;
      if (tube.contains(box)) return "t" + std::to_string(first_.tube + i);
    }
    return one_sign(map_, middle, half, direction_ / 2);
  }

  /// A tube whose half branch begins in the cell, if Newton's method finds one.
  bool half_branch(Parameters z, const Parameters& half) {
    const std::size_t k = direction_ / 2;
    const Parameters middle = z;
    z[k] = 0;
    try {
      z = on_curve(map_, z, k);
    } catch (const NoCertificate&) {
      return false;
    }
    for (const std::size_t j : others(k))
      if (!(std::abs(z[j] - middle[j]) <= 4 * half[j] && std::abs(z[j]) < 0.97)) return false;
    for (const Tube& tube : tubes_) {
      double away = 0;
      for (const std::size_t j : others(k)) away = std::max(away, std::abs(z[j] - tube.centre[j]));
      if (away < tube.width) return false;
    }
    return find_tube(z);
  }

  bool find_tube(const Parameters& z) {
    const std::size_t k = direction_ / 2;
    const Map here = map_.at(z);
    auto c = inverse(here, k);
    if (!c) return false;
    for (auto& row : *c)
      for (double& a : row) a = std::ldexp(std::nearbyint(std::ldexp(a, 20)), -20);
    const auto slope = checker::curve_bounds(here.times(*c), k, {}).first;
    const int line = line_at(star_, direction_, z, lines_);
    for (int e = 2; e < 30; ++e) {
      Tube tube = {
          {Chart::star, first_.star, direction_}, z, k, {}, 1 + 0x1p-20, std::ldexp(1.0, -e), *c, line};
      for (std::size_t j = 0; j < 4; ++j) {
        tube.centre[j] = std::ldexp(std::nearbyint(std::ldexp(z[j], e + 20)), -e - 20);
        tube.slope[j] = j == k      ? 1
                        : line >= 0 ? 0
                                    : std::ldexp(std::nearbyint(std::ldexp(slope[j].middle, 12)), -12);
      }
      if (!holds(tube)) continue;
      tubes_.push_back(tube);
      return true;
    }
    return false;
  }

  bool holds(const Tube& tube) const {
    const Map local = map_.at(tube.centre).times(tube.inverse);
    for (const double slack : checker::contraction(tube, local))
      if (!(slack > 0.05 * tube.width)) return false;
    for (const std::size_t j : others(tube.axis))
      if (!(std::abs(tube.centre[j]) + tube.width < 1 - 1e-9)) return false;
    for (const Tube& other : tubes_) {
      double away = 0;
      for (const std::size_t j : others(tube.axis))
        away = std::max(away, std::abs(tube.centre[j] - other.centre[j]));
      if (!(away > 1.001 * (tube.width + other.width))) return false;
    }
    const auto signs =
        checker::half_branch_signs(star_, tube, checker::curve_bounds(local, tube.axis, tube.extent()));
    for (std::size_t i = 0; i < 4; ++i) {
      const bool constant = tube.line >= 0 && lines_[static_cast<std::size_t>(tube.line)].at[i][1] == 0;
      if (!constant && signs[i] == 0) return false;
    }
    return true;
  }

  static constexpr std::size_t max_entries = 3000;
  const Star& star_;
  const Map& map_;
  ClaimNumbers first_;
  std::size_t direction_;
  const std::vector<checker::Line>& lines_;
  std::size_t count_ = 0;
};

/// The star, if what is around its point is in tubes; otherwise throws NotAlone.
FoundStar alone(const Star& star, const checker::Map<Rational>& equation, const ClaimNumbers& first,
                const std::vector<checker::Line>& lines, const std::vector<bool>& touching) {
  FoundStar result = {star, {}, {}, {}, {}};
  result.maps = scaled_maps(result.claim, equation);
  for (std::size_t direction = 0; direction < 8; ++direction) {
    const ClaimNumbers next = {first.star, first.tube + result.tubes.size(),
                               first.seam + result.seams.size()};
    ChartSearch chart(result.claim, result.maps[direction], next, direction, lines);
    for (std::size_t n = 0; n < lines.size(); ++n)
      if (touching[n]) chart.add_seam(equation, n);
    chart.run();
    result.subdivisions[direction] = chart.entries_;
    result.tubes.insert(result.tubes.end(), chart.tubes_.begin(), chart.tubes_.end());
    result.seams.insert(result.seams.end(), chart.seams_.begin(), chart.seams_.end());
  }
  return result;
}

/// The greatest way of a parameter in the star.
double extent(const Star& star) {
  double most = 0;
  for (const auto& row : star.axes) {
    double sum = 0;
    for (const checker::Algebraic& q : row) sum += std::abs(checker::number<double>(q));
    most = std::max(most, sum);
  }
  return most;
}

}  // namespace

FoundStar star_at(const Patches& patches, const Node& node, const ClaimNumbers& first, double size,
                  const std::vector<checker::Line>& lines, const std::vector<bool>& touching) {
  const auto equation = checker::pair_map(patches[0].power_basis(), patches[1].power_basis());
  for (const Star& star : singular_points(patches, node)) {
    if (!star.is_rational() && std::count(touching.begin(), touching.end(), true) > 0)
      throw NoCertificate("an irrational special point beside an arc along which the patches touch");
    const bool plain = star.weights == std::array<std::size_t, 4>{1, 1, 1, 1};
    int tried = 0;
    for (int e = 2; e < 46 && tried < (plain ? 22 : 6); plain ? e += 2 : ++e) {
      const Star scaled = at_scale(star, e);
      if (extent(scaled) > size) continue;
      ++tried;
      try {
        return alone(scaled, equation, first, lines, touching);
      } catch (const NotAlone&) {
      }
    }
  }
  throw NoCertificate("a special point with degenerate quadratic terms");
}

namespace {

template <class Numbers>
Json list(const Numbers& numbers) {
  Json result = Json::array();
  for (const checker::Algebraic& q : numbers) result.push_back(algebraic_claim(q));
  return result;
}
template <class Rows>
Json matrix(const Rows& m) {
  Json rows = Json::array();
  for (const auto& row : m) rows.push_back(list(row));
  return rows;
}

/// The claim, without its seal, after what is said before.
Json frame_claim(Json claim, const Star& star, const std::array<std::string, 8>& subdivisions) {
  claim.update({{"at", list(star.at)},
                {"axes", matrix(star.axes)},
                {"coordinates", matrix(star.coordinates)},
                {"weights", star.weights},
                {"rows", matrix(star.rows)},
                {"orders", star.orders},
                {"charts", subdivisions}});
  return claim;
}

}  // namespace

Json star_claims(const std::vector<FoundStar>& stars) {
  Json result = Json::array();
  for (const FoundStar& star : stars) {
    const checker::Root& root = *star.claim.root;
    const Json field = {{"modulus", rationals(root.modulus)}, {"between", rationals(root.between)}};
    result.push_back(
        sealed(in_list("stars", result.size()), frame_claim(field, star.claim, star.subdivisions)));
  }
  return result;
}

Json seam_claims(const std::vector<FoundSeam>& seams) {
  Json result = Json::array();
  for (const FoundSeam& seam : seams) {
    const Json of = {{"of", map_text(seam.claim.of)}};
    result.push_back(sealed(in_list("seams", result.size()), frame_claim(of, seam.claim, seam.subdivisions)));
  }
  return result;
}

Parameters on_half_branch(const FoundStar& star, const Tube& tube, double t) {
  Parameters z = tube.centre;
  for (std::size_t j = 0; j < 4; ++j) z[j] += t * tube.slope[j];
  if (tube.seam >= 0) return z;
  return on_curve(star.maps[tube.direction], z, tube.axis);
}

Parameters parameters_of(const FoundStar& star, const Tube& tube, const Parameters& z) {
  checker::Box<double> box;
  for (std::size_t j = 0; j < 4; ++j) box[j] = {z[j], 0};
  const auto w = checker::from_star(star.claim, tube.direction, box);
  return {w[0].middle, w[1].middle, w[2].middle, w[3].middle};
}

double distance_from_point(const checker::Star& star, const Parameters& w) {
  double t = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    double e = 0;
    for (std::size_t i = 0; i < 4; ++i)
      e += checker::number<double>(star.coordinates[j][i]) * (w[i] - checker::number<double>(star.at[i]));
    t = std::max(t, std::pow(std::abs(e), 1.0 / static_cast<double>(star.weights[j])));
  }
  return t;
}

}  // namespace exsect::cli
