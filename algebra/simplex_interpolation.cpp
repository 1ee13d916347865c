#include "simplex_interpolation.h"

#include <stdexcept>

namespace exsect {
namespace {

/// Calls f(line) for each line of the table along an axis; line(m) is its m-th element, 0 <= m <= line.last.
template <class Function>
void for_each_line(SimplexTable& table, int axis, Function f) {
  struct Line {
    SimplexTable& table;
    int axis, a, b;
    int last;
    Residue& operator()(int m) const {
      return axis == 0 ? table(m, a, b) : axis == 1 ? table(a, m, b) : table(a, b, m);
    }
  };
  for (int a = 0; a <= table.degree(); ++a)
    for (int b = 0; a + b <= table.degree(); ++b) f(Line{table, axis, a, b, table.degree() - a - b});
}

}  // namespace

SimplexTable::SimplexTable(int degree)
    : degree_(degree), rows_(static_cast<std::size_t>((degree + 1) * (degree + 1))) {
  int count = 0;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) {
      rows_[static_cast<std::size_t>(i * (degree + 1) + j)] = count;
      count += degree - i - j + 1;
    }
  elements_.resize(static_cast<std::size_t>(count));
}

SimplexTable interpolate(const PrimeField& field, SimplexTable values) {
  if (field.prime() <= static_cast<std::uint64_t>(values.degree()))
    throw std::invalid_argument("interpolate: the prime must be greater than the degree");
  std::vector<Residue> inverse = {field.zero()};
  for (int m = 1; m <= values.degree(); ++m) inverse.push_back(field.inverse(field.residue(m)));
  // Divided differences at 0, 1, ... along each axis: coefficients in the products of Newton's bases, those
  // beyond the total degree being zero.
  for (int axis = 0; axis < 3; ++axis)
    for_each_line(values, axis, [&](const auto& line) {
      for (int order = 1; order <= line.last; ++order)
        for (int m = line.last; m >= order; --m)
          line(m) =
              field.multiply(field.subtract(line(m), line(m - 1)), inverse[static_cast<std::size_t>(order)]);
    });
  // From Newton's basis to powers by Horner's scheme.
  for (int axis = 0; axis < 3; ++axis)
    for_each_line(values, axis, [&](const auto& line) {
      for (int node = line.last - 1; node >= 0; --node)
        for (int m = node; m < line.last; ++m)
          line(m) = field.subtract(line(m), field.multiply(field.residue(node), line(m + 1)));
    });
  return values;
}

}  // namespace exsect
