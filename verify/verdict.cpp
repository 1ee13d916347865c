#include "verdict.h"

namespace exsect {

const char* name(Agreement agreement) {
  constexpr std::array<const char*, 3> names = {"agrees", "disagrees", "undecided"};
  return names[static_cast<std::size_t>(agreement)];
}

const char* name(DifferenceKind kind) {
  constexpr std::array<const char*, 12> names = {
      "lost-curve",     "gap",        "spurious-curve",  "wrong-connection",
      "split",          "repeated",   "curve-as-points", "false-point",
      "point-on-curve", "lost-point", "repeated-point",  "wrong-contact"};
  return names[static_cast<std::size_t>(kind)];
}

const char* name(Representation representation) {
  constexpr std::array<const char*, 3> names = {"space", "first", "second"};
  return names[static_cast<std::size_t>(representation)];
}

const char* name(Coverage coverage) {
  constexpr std::array<const char*, 4> names = {"covered", "partly", "missed", "undecided"};
  return names[static_cast<std::size_t>(coverage)];
}

}  // namespace exsect
