#include "support/exact_tensor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace exsect::exact_oracle {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// As a double between 2^-1 and 2^0 times 2^(-bits of `largest`).
double relative(const Integer& value, long bits) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, value.backend().data());
  return std::ldexp(mantissa, static_cast<int>(std::max(exponent - bits, -2000L)));
}

long bits_of(const std::vector<Integer>& values) {
  long most = 0;
  for (const Integer& value : values)
    if (value != 0) most = std::max(most, static_cast<long>(msb(abs(value))) + 1);
  return most;
}

/// The mean of all coefficients stands for the value at the centre: this is no proof, nor has to be one.
double mean(const Tensor& tensor, long bits) {
  double sum = 0;
  for (const Integer& c : tensor.coefficients) sum += relative(c, bits);
  return sum / static_cast<double>(tensor.coefficients.size());
}

/// The adjugate.
Matrix adjugate(const Matrix& m) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      result[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
  }
  return result;
}

Integer largest_of(const std::vector<Integer>& values) {
  Integer result = 0;
  for (const Integer& value : values) result = std::max<Integer>(result, abs(value));
  return result;
}

}  // namespace

std::size_t Tensor::stride(std::size_t axis) const {
  std::size_t result = 1;
  for (std::size_t k = axis + 1; k < 3; ++k) result *= degrees[k] + 1;
  return result;
}

Tensor Tensor::cut(std::size_t axis, long p, long q, int end) const {
  Tensor result = *this;
  const std::size_t n = degrees[axis], step = stride(axis);
  for (std::size_t start = 0; start < coefficients.size(); ++start) {
    if (start / step % (n + 1) != 0) continue;
    const auto at = [&](std::size_t k) -> Integer& { return result.coefficients[start + k * step]; };
    // After level l, those which are ready are multiplied by q too: all have the same factor in the end.
    for (std::size_t level = 1; level <= n; ++level) {
      for (std::size_t k = 0; k <= n; ++k) {
        const std::size_t i = end == 0 ? n - k : k;
        const bool ready = end == 0 ? i < level : i > n - level;
        if (ready) {
          at(i) *= q;
        } else {
          at(i) =
              end == 0 ? Integer((q - p) * at(i - 1) + p * at(i)) : Integer((q - p) * at(i) + p * at(i + 1));
        }
      }
    }
  }
  return result;
}

Tensor Tensor::widened(std::size_t axis) const { return cut(axis, -1, 2, 1).cut(axis, 4, 3, 0); }

Tensor Tensor::derivative(std::size_t axis) const {
  Tensor result = {degrees, {}};
  --result.degrees[axis];
  const std::size_t n = degrees[axis], step = stride(axis);
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    if (i / step % (n + 1) < n) result.coefficients.push_back(n * (coefficients[i + step] - coefficients[i]));
  return result;
}

std::vector<Integer> Tensor::face(std::size_t axis, int end) const {
  std::vector<Integer> result;
  const std::size_t n = degrees[axis], step = stride(axis);
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    if (i / step % (n + 1) == (end == 0 ? 0 : n)) result.push_back(coefficients[i]);
  return result;
}

int common_sign(const std::vector<Integer>& values) {
  const int first = values.front().sign();
  return std::all_of(values.begin(), values.end(), [&](const Integer& v) { return v.sign() == first; })
             ? first
             : 0;
}

std::array<std::array<Integer, 3>, 3> preconditioner(const System& system) {
  Matrix jacobian{};
  std::array<long, 3> bits{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<Tensor, 3> slopes = {system[k].derivative(0), system[k].derivative(1),
                                    system[k].derivative(2)};
    for (const Tensor& slope : slopes) bits[k] = std::max(bits[k], bits_of(slope.coefficients));
    for (std::size_t i = 0; i < 3; ++i) jacobian[k][i] = mean(slopes[i], bits[k]);
  }
  const Matrix inverse = adjugate(jacobian);
  double largest = 0;
  for (const auto& row : inverse)
    for (const double entry : row) largest = std::max(largest, std::abs(entry));
  std::array<std::array<Integer, 3>, 3> result;
  const long most = *std::max_element(bits.begin(), bits.end());
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double entry = largest > 0 ? inverse[i][k] / largest : (i == k ? 1.0 : 0.0);
      result[i][k] = Integer(std::llround(std::ldexp(entry, 40))) << static_cast<unsigned>(most - bits[k]);
    }
  }
  return result;
}

System combined(const std::array<std::array<Integer, 3>, 3>& matrix, const System& system) {
  System result = system;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < result[i].coefficients.size(); ++c)
      result[i].coefficients[c] = matrix[i][0] * system[0].coefficients[c] +
                                  matrix[i][1] * system[1].coefficients[c] +
                                  matrix[i][2] * system[2].coefficients[c];
  return result;
}

bool has_no_zero(const System& system) {
  return std::any_of(system.begin(), system.end(),
                     [](const Tensor& tensor) { return common_sign(tensor.coefficients) != 0; });
}

bool has_one_zero(const System& system) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (common_sign(system[i].face(i, 0)) * common_sign(system[i].face(i, 1)) != -1) return false;
    const std::vector<Integer> own = system[i].derivative(i).coefficients;
    if (common_sign(own) == 0) return false;
    Integer least = abs(own.front());
    for (const Integer& value : own) least = std::min<Integer>(least, abs(value));
    Integer others = 0;
    for (std::size_t j = 0; j < 3; ++j)
      if (j != i) others += largest_of(system[i].derivative(j).coefficients);
    if (least <= others) return false;
  }
  return true;
}

}  // namespace exsect::exact_oracle
