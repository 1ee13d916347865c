#include "eliminant/exact_pair.h"

#include <exsect/solver/parameter.h>

#include "answer/exact_source.h"
#include "line/exact_line_points.h"
#include "line/known_tangent.h"
#include "shape/coincident_parameters.h"

namespace exsect {

const SweepChoice& ExactPair::choice() {
  if (!choice_) {
    choice_ = choose_sweep(x_, y_, stop_);
    for (const Parameter p : all_parameters) {
      const auto& tried = choice_->tried[index(p)];
      auto& known = turning_[index(p)];
      if (tried && !known) known = tried;
    }
  }
  return *choice_;
}

const std::optional<TurningValues>& ExactPair::turning(Parameter p) {
  static const std::optional<TurningValues> kUnknown;
  auto& known = turning_[index(p)];
  if (!known && !is_stopped(stop_)) known = turning_values(x_, y_, p);
  return known ? *known : kUnknown;
}

const LinePoints& ExactPair::fibre(const LineQuery& query) {
  const std::pair key(query.fixed, query.value);
  const auto known = fibres_.find(key);
  return known != fibres_.end() ? known->second
                                : fibres_.emplace(key, exact_line_points(x_, y_, query)).first->second;
}

const std::array<std::size_t, 4>& ExactPair::coincident() {
  if (!coincident_) coincident_ = coincident_parameters(x_, y_);
  return *coincident_;
}

const std::array<std::optional<std::size_t>, 2>& ExactPair::plane() {
  if (!plane_) plane_ = plane_coordinates(x_, y_);
  return *plane_;
}

const std::optional<ExchangingSymmetry>& ExactPair::symmetry() {
  if (!symmetry_) symmetry_ = exchanging_symmetry(x_, y_);
  return *symmetry_;
}

bool ExactPair::surely_takes(const CertifiedPoint& point, Parameter p, const Rational& value) const {
  if (const auto exact = point.exact()) return takes_value(*exact, index(p), value);
  const auto solution = rational_solution(x_, y_, point);
  return solution && (*solution)[index(p)] == value;
}

}  // namespace exsect
