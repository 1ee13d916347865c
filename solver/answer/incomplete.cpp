#include "answer/incomplete.h"

#include <array>

namespace exsect {

const char* name(Reason reason) {
  constexpr std::array<const char*, 6> names = {"not decided", "tangency", "crossing",
                                                "corner",      "time",     "failed proof"};
  return names[static_cast<std::size_t>(reason)];
}

}  // namespace exsect
