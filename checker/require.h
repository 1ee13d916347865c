// Claims that do not hold.
#pragma once

#include <optional>
#include <stdexcept>
#include <vector>

namespace exsect::checker {

/// Why a certificate is rejected.
enum class Violation {
  form,         // it is not written as docs/certificate.md says, or beyond the limits there
  seal,         // a seal does not fit its claim
  claim,        // a factor, a star, a tube, a node, a point, an arc or an overlap is not proved
  error_bound,  // a curve is not proved to be so near to its polyline
  cover,        // the subdivision: a cell is not proved to hold no more solutions than are claimed
  graph,        // nodes, arcs and components do not fit together
  summary,      // the numbers are not those of the claims
};
/// As `exsect check --json` writes it.
const char* name(Violation kind);

/// What was claimed does not hold; whoever knows the place of the claim adds it.
class Failed : public std::runtime_error {
 public:
  explicit Failed(const char* reason, Violation violation = Violation::claim)
      : std::runtime_error(reason), kind(violation) {}

  Violation kind;
  std::optional<double> needed;  // of error_bound: one that would be accepted
};

inline void require(bool holds, const char* reason, Violation kind = Violation::claim) {
  if (!holds) throw Failed(reason, kind);
}
/// list[i]; fails if there is none.
template <class T>
const T& element(const std::vector<T>& list, std::size_t i, const char* reason) {
  require(i < list.size(), reason);
  return list[i];
}

}  // namespace exsect::checker
