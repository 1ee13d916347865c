#include <exsect/algebra/real_algebraic.h>

#include <iostream>

int main() {
  const exsect::Polynomial cubic = {1, -3, 0, 1};  // 1 - 3t + t^3
  const exsect::RealAlgebraic root = exsect::real_roots(cubic, 0, 1).at(0);
  // root^2 - 2 is another root, exactly: the cubic of it vanishes at this one.
  const exsect::Polynomial other = {-2, 0, 1};
  std::cout << root.to_double() << ' ' << exsect::sign_at(1 - 3 * other + other * other * other, root)
            << '\n';
}
