// Claims that do not hold.
#pragma once

#include <stdexcept>
#include <vector>

namespace exsect::checker {

/// What was claimed does not hold; whoever knows the place of the claim adds it.
class Failed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline void require(bool holds, const char* reason) {
  if (!holds) throw Failed(reason);
}
/// list[i]; fails if there is none.
template <class T>
const T& element(const std::vector<T>& list, std::size_t i, const char* reason) {
  require(i < list.size(), reason);
  return list[i];
}

}  // namespace exsect::checker
