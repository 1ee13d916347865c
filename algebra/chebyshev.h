// Chebyshev expansions: polynomials on an interval by their values at Chebyshev nodes.
#pragma once

#include <exsect/algebra/wide_ball.h>

#include <vector>

namespace exsect {

/// The n zeros t_k = cos((2k + 1) pi / 2n) of the Chebyshev polynomial T_n, and the values T_j(t_k) there.
class ChebyshevNodes {
 public:
  explicit ChebyshevNodes(std::size_t n);

  std::size_t size() const { return size_; }
  /// T_j(t_k).
  const WideBall& value(std::size_t j, std::size_t k) const {
    const std::size_t angle = j * (2 * k + 1) % (4 * size_);  // in units of pi / 2n
    return cosines_[angle];
  }
  const WideBall& node(std::size_t k) const { return value(1, k); }
  /// c with f = sum c_j T_j, for the polynomial f of degree below n with these n values at the nodes (4.16a).
  std::vector<WideBall> coefficients(const std::vector<WideBall>& values) const;

 private:
  std::size_t size_;
  std::vector<WideBall> cosines_;  // of all multiples of pi / 2n in a circle
};

}  // namespace exsect
