#include "self/star.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <list>
#include <utility>

#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "self/chart.h"
#include "self/glued_fold.h"
#include "self/star_proof.h"
#include "star/star_arc.h"
#include "trace/bounded_vertex.h"

namespace exsect {
namespace {

constexpr double kMostLayers = 1024;
constexpr double kLayersPerTolerance = 8;

class SelfStarSearch {
 public:
  explicit SelfStarSearch(const SelfStarProblem& problem)
      : problem_(problem),
        scale_(model_scale(problem.x, problem.x)),
        system_(problem.x, problem.x, scale_.origin, scale_.frame.exponent) {}

  std::vector<SelfStar> run() {
    for (const GluedFold& fold : glued_folds(problem_.x)) add(fold);
    const double first = std::clamp(problem_.tolerance, 0x1p-36, 0x1p-5);
    for (const double halfwidth : {first, 0x1p-4 * first, 0x1p-9 * first, 0x1p-14 * first, 0x1p-20 * first})
      for (const SelfCentre& centre : problem_.centres)
        if (!is_known(centre)) add(centre, halfwidth);
    return std::move(stars_);
  }

 private:
  bool is_known(const SelfCentre& centre) const {
    return std::ranges::any_of(stars_, [&](const SelfStar& star) {
      return meet(star.star.box, centre.point.box()) ||
             meet(star.star.box, exchanged_pair(centre.point.box()));
    });
  }

  /// As large as its straight arcs may be without layers.
  void add(const GluedFold& fold) {
    for (Rational halfwidth = power_of_two(-5); halfwidth >= power_of_two(-60); halfwidth /= 2) {
      auto star = glued_fold_star(problem_, fold, halfwidth);
      if (!star || !is_disjoint(*star) || !arcs_keep_tolerance(star->star)) continue;
      stars_.push_back(*std::move(star));
      return;
    }
  }

  /// The sweep with the widest slab first, whatever the parameters are called: the searches around the star
  /// have an easy task if its box is not flat.
  void add(const SelfCentre& centre, double halfwidth) {
    std::list<SelfStarProof> proofs;
    std::vector<std::pair<SelfStarProof*, SelfStar>> stars;
    for (const std::size_t sweep : centre.sweeps) {
      proofs.emplace_back(problem_, centre, sweep);
      auto star = proofs.back().run(halfwidth);
      if (star && is_disjoint(*star)) stars.emplace_back(&proofs.back(), *std::move(star));
    }
    std::ranges::stable_sort(stars, std::greater<>(), [](const auto& star) { return slab(star.second); });
    for (auto& [proof, star] : stars) {
      if (!divide_into_layers(*proof, star)) continue;
      star.surroundings = proof->surroundings(star.star.box);
      stars_.push_back(std::move(star));
      return;
    }
  }

  /// As many as the tolerance asks for: tried with more if the hulls between them are wide.
  bool divide_into_layers(const SelfStarProof& proof, SelfStar& star) const {
    double layers = std::clamp(kLayersPerTolerance * slab(star) / problem_.tolerance, 1.0, kMostLayers);
    for (int attempt = 0; attempt < 2; ++attempt, layers = std::min(4 * layers, kMostLayers)) {
      star.star.layers = {};
      if (!proof.add_layers(star, static_cast<int>(layers))) return false;
      if (arcs_keep_tolerance(star.star)) return true;
    }
    return false;
  }

  static double slab(const SelfStar& star) {
    return to_double(star.star.box[index(star.star.sweep)].width());
  }

  bool is_disjoint(const SelfStar& star) const {
    return std::ranges::none_of(stars_, [&](const SelfStar& other) {
      return meet(star.star.box, other.star.box) || meet(star.star.box, exchanged_pair(other.star.box));
    });
  }

  /// In either order of the pairs: the curve's order is that in which it is traced.
  bool arcs_keep_tolerance(const StarNeighbourhood& star) const {
    const ModelFrame unit = {{0, 0, 0}, 0};
    const auto keeps = [&](const ParameterBox& hull) {
      return chord_bound(system_, unit, hull) <= 0.9 * problem_.tolerance;
    };
    return std::ranges::all_of(star.ports, [&](const Port& port) {
      const StarArc arc = star_arc(star, port);
      return std::ranges::all_of(
          arc.hulls, [&](const ParameterBox& hull) { return keeps(hull) && keeps(exchanged_pair(hull)); });
    });
  }

  const SelfStarProblem& problem_;
  ModelScale scale_;
  PairSystem<DoubleBall> system_;
  std::vector<SelfStar> stars_;
};

}  // namespace

std::vector<SelfStar> self_stars(const SelfStarProblem& problem) { return SelfStarSearch(problem).run(); }

}  // namespace exsect
