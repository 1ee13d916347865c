#include "star/symmetric_crossing.h"

#include <algorithm>
#include <cmath>

#include "answer/exact_source.h"
#include "answer/parameter_box.h"
#include "line/line_points_in.h"
#include "star/other_turning.h"

namespace exsect {

namespace {

constexpr int kSymmetricSlabs = 6;

/// The conditions of Lemma 6.4.
class SymmetricCrossingProof {
 public:
  SymmetricCrossingProof(const StarQuery& query, const ExchangingSymmetry& symmetry,
                         const CertifiedPoint& centre)
      : query_(query),
        others_(other_turning(query.pair, query.turning.sweep)),
        symmetry_(symmetry),
        centre_(centre),
        sweep_(index(query.turning.sweep)),
        other_(1 - sweep_) {}

  std::optional<StarNeighbourhood> run() {
    if (!others_.complete) return std::nullopt;
    for (double half = query_.largest_halfwidth; half >= 0x1p-40; half *= 0x1p-6) {
      double slab = half / 4;
      for (int i = 0; i < kSymmetricSlabs; ++i, slab *= 0.25) {
        if (is_stopped(query_.pair.stop())) return std::nullopt;
        set_box(slab, half);
        if (!is_small_enough()) break;
        if (!section_crosses() || !lateral_faces_are_free()) continue;
        StarNeighbourhood star{centre_, query_.turning.sweep, box_, {}, {}};
        return add_ports(star, -1) && add_ports(star, 1) ? std::optional(star) : std::nullopt;
      }
    }
    return std::nullopt;
  }

 private:
  std::size_t partner(std::size_t j) const { return symmetry_.partner[j]; }

  /// `half` around the centre but for the sweep parameter, and symmetric in the other one of its patch.
  void set_box(double slab, double half) {
    for (const std::size_t j : {sweep_, other_}) {
      const Rational middle = from_double(to_double(centre_.box()[j].midpoint()));
      const RationalInterval wide = {middle - from_double(half), middle + from_double(half)};
      box_[partner(j)] = symmetry_.partner_range(j, wide);
      box_[j] = j == sweep_ ? RationalInterval{middle - from_double(slab), middle + from_double(slab)} : wide;
    }
  }

  /// Inside the squares, without points of sides or over samples; one root of each turning eliminant at most,
  /// for the sweep parameter's in the partner's range as well.
  bool is_small_enough() const {
    const auto is_inside = [](const RationalInterval& i) { return i.lower > 0 && i.upper < 1; };
    const auto meets_box = [&](const CertifiedPoint& p) {
      return meet(p.refined_to(power_of_two(-200)).box(), box_);
    };
    const auto has_one = [](const TurningValues& turning, const RationalInterval& range) {
      return std::ranges::count_if(turning.values,
                                   [&](const TurningValue& v) { return is_in(v.value, range); }) <= 1;
    };
    return std::ranges::all_of(box_, is_inside) && std::ranges::none_of(query_.places.boundary, meets_box) &&
           std::ranges::none_of(
               query_.places.samples,
               [&](const Rational& t) { return is_in(t, box_[index(query_.places.sampled)]); }) &&
           has_one(query_.turning, symmetry_.partner_range(sweep_, box_[partner(sweep_)])) &&
           std::ranges::all_of(others_.values, [&](const TurningValues* turning) {
             return has_one(*turning, box_[index(turning->sweep)]);
           });
  }

  Rational section_at(const Rational& on_sweep, const Rational& on_other) const {
    return sweep_ == 0 ? symmetry_.section(on_sweep, on_other) : symmetry_.section(on_other, on_sweep);
  }

  bool section_crosses() const {
    const RationalInterval& over = box_[sweep_];
    const RationalInterval& range = box_[other_];
    return section_at(over.lower, range.lower) * section_at(over.lower, range.upper) < 0;
  }

  bool lateral_faces_are_free() const {
    return std::ranges::all_of(all_parameters, [&](Parameter p) {
      const auto is_free = [&](const Rational& value) {
        const auto points = line_points_in(query_.pair.x(), query_.pair.y(), {p, value}, box_);
        return points && points->empty();
      };
      return index(p) == sweep_ || (is_free(box_[index(p)].lower) && is_free(box_[index(p)].upper));
    });
  }

  /// Two points of the fibre, one of them on the other side of it than its image.
  bool add_ports(StarNeighbourhood& star, int side) const {
    const Rational value = side < 0 ? box_[sweep_].lower : box_[sweep_].upper;
    const auto points = line_points_in(query_.pair.x(), query_.pair.y(), {query_.turning.sweep, value}, box_);
    if (!points || points->size() != 2) return false;
    bool reversed = false;
    for (const CertifiedPoint& point : *points) {
      const RationalInterval image =
          symmetry_.partner_range(sweep_, point.refined_to(power_of_two(-100)).box()[partner(sweep_)]);
      reversed = reversed || (side < 0 ? image.lower > value : image.upper < value);
      star.ports.push_back({point, query_.turning.sweep, side});
    }
    return reversed;
  }

  const StarQuery& query_;
  OtherTurning others_;
  const ExchangingSymmetry& symmetry_;
  const CertifiedPoint& centre_;
  std::size_t sweep_;
  std::size_t other_;
  ParameterBox box_;
};

}  // namespace

std::vector<CertifiedPoint> fixed_points_over(const ExchangingSymmetry& symmetry, Parameter sweep,
                                              const RealAlgebraic& value) {
  const BivariatePolynomial one = BivariatePolynomial::constant(1);
  const std::size_t j = index(sweep);
  const BivariatePolynomial section = j == 0 ? symmetry.section.exchanged() : symmetry.section;
  std::vector<CertifiedPoint> result;
  if (reduced_at(section, value).is_zero()) return result;
  for (const TriangularPoint& at : roots_at(section, value, 0, 1)) {
    ExactParameters exact{at, {}, {one, one, one, one}};
    exact.numerator[j] = BivariatePolynomial::s();
    exact.numerator[1 - j] = BivariatePolynomial::r();
    for (const std::size_t k : {0U, 1U})
      exact.numerator[symmetry.partner[k]] =
          symmetry.reversed[k] ? one - exact.numerator[k] : exact.numerator[k];
    result.push_back(certified(std::move(exact), {}));
  }
  return result;
}

std::optional<StarNeighbourhood> symmetric_crossing_star(const StarQuery& query,
                                                         const ExchangingSymmetry& symmetry,
                                                         const CertifiedPoint& centre) {
  return SymmetricCrossingProof(query, symmetry, centre).run();
}

}  // namespace exsect
