// Counts in JSON that others may have written.
#pragma once

#include <cstdint>
#include <stdexcept>

namespace exsect::cli {

/// The integer >= 0 that a JSON value (of either kind of nlohmann's) is. Throws std::invalid_argument for
/// anything else: a fraction or a number beyond 64 bits would be cut off silently.
template <class Object>
std::uint64_t natural(const Object& value) {
  if (!value.is_number_unsigned() && !(value.is_number_integer() && value.template get<std::int64_t>() >= 0))
    throw std::invalid_argument("holds something else where a count is needed");
  return value.template get<std::uint64_t>();
}

}  // namespace exsect::cli
