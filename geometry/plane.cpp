#include "plane.h"

namespace exsect {

AffineForm form_through(const Point& a0, const Point& normal) { return {normal, -dot(normal, a0)}; }

}  // namespace exsect
