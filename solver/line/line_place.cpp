#include "line/line_place.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace exsect {
namespace {

void require_unit_interval(const LineQuery& query) {
  if (query.value < 0 || query.value > 1)
    throw std::invalid_argument(std::string("parameter line: the value of ") + name(query.fixed) +
                                " must lie in [0,1]");
}

LineRoles line_roles(Parameter fixed) {
  using enum Parameter;
  switch (fixed) {
    case u:
      return {u, v, r, s};
    case v:
      return {v, u, r, s};
    case r:
      return {r, s, u, v};
    case s:
      break;
  }
  return {s, r, u, v};
}

}  // namespace

LinePlace line_place(const LineQuery& query) {
  require_unit_interval(query);
  return {line_roles(query.fixed), query.value};
}

LineAndPatch line_and_patch(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  require_unit_interval(query);
  switch (query.fixed) {
    case Parameter::u:
      return {line_at_first(x, query.value), y};
    case Parameter::v:
      return {line_at_second(x, query.value), y};
    case Parameter::r:
      return {line_at_first(y, query.value), x};
    case Parameter::s:
      break;
  }
  return {line_at_second(y, query.value), x};
}

IntegerLineAndPatch integer_line_and_patch(const BezierPatch& x, const BezierPatch& y,
                                           const LineQuery& query) {
  require_unit_interval(query);
  const bool of_x = query.fixed == Parameter::u || query.fixed == Parameter::v;
  const bool along_first = query.fixed == Parameter::u || query.fixed == Parameter::r;
  IntegerPair pair = integer_pair(x, y);
  if (!of_x) std::swap(pair.x, pair.y);
  const IntegerLine line = line_at_first(along_first ? pair.x : exchanged(pair.x), query.value);
  return {line, std::move(pair.y)};
}

}  // namespace exsect
