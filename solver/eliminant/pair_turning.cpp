#include "eliminant/pair_turning.h"

#include <exsect/solver/parameter.h>

namespace exsect {

const SweepChoice& PairTurning::choice(const StopRequest& stop) {
  if (!choice_) {
    choice_ = choose_sweep(x_, y_, stop);
    for (const Parameter p : all_parameters) {
      auto& tried = choice_->tried[index(p)];
      auto& known = values_[index(p)];
      if (tried && !known) {
        known = tried;
      }
    }
  }
  return *choice_;
}

const std::optional<TurningValues>* PairTurning::values(Parameter p, bool may_compute) {
  auto& known = values_[index(p)];
  if (!known && may_compute) {
    known = turning_values(x_, y_, p);
  }
  return known ? &*known : nullptr;
}

}  // namespace exsect
