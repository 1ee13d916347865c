#include "star/other_turning.h"

namespace exsect {

OtherTurning other_turning(ExactPair& pair, Parameter sweep) {
  OtherTurning others;
  for (const Parameter p : all_parameters) {
    const std::size_t twin = pair.coincident()[index(p)];
    if (p == sweep || twin == index(sweep)) continue;
    const auto& turning = pair.turning(p);
    if (turning) others.values.push_back(&*turning);
    others.complete = others.complete && (turning || pair.turning(all_parameters[twin]));
  }
  return others;
}

}  // namespace exsect
