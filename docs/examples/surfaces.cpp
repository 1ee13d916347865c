#include <exsect/solver/intersect_surface.h>
#include <exsect/solver/patch_ray.h>

#include <iostream>

int main() {
  using exsect::ImplicitSurface;
  // z = x y / 16 over a square, and a torus about the z axis.
  const exsect::RationalPatch saddle({{{-4, -4, 1}, {-4, 4, -1}}, {{4, -4, -1}, {4, 4, 1}}});
  const auto torus = ImplicitSurface::torus({0, 0, 0}, {0, 0, 1}, 3, 1);
  const auto result = exsect::intersect(torus, saddle);
  if (result.status != exsect::Status::complete) return 3;
  std::cout << result.graph.count(exsect::ComponentShape::closed) << " closed\n";

  // A cylinder of radius 1 about the axis (1,1,1): it has no rational point.
  const auto oblique = ImplicitSurface::cylinder({0, 0, 0}, {1, 1, 1}, 1);
  for (const auto& hit : exsect::intersect_ray({-5, 0, 0}, {1, 0, 0}, oblique).hits)
    std::cout << "t = " << hit.t.to_double() << ", " << name(hit.contact) << '\n';
}
