// What the lines of a batch add up to.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace exsect::cli {

/// The form of the lines.
inline constexpr const char* batch_line_form = "batch-line/1";

/// What is counted over the lines of a batch.
struct Tally {
  std::uint64_t lines = 0;
  std::uint64_t selves = 0;  // of these: patches with themselves
  std::uint64_t complete = 0;
  std::uint64_t incomplete = 0;
  std::uint64_t failed = 0;
  std::uint64_t by_boxes = 0;  // of the complete ones
  std::uint64_t by_doubles = 0;
  std::uint64_t by_exact = 0;
  std::uint64_t meeting = 0;  // complete or incomplete, with a curve, a point or an overlap
  std::uint64_t open = 0;
  std::uint64_t closed = 0;
  std::uint64_t branched = 0;
  std::uint64_t isolated = 0;
  std::uint64_t overlaps = 0;
};

Tally& operator+=(Tally& sum, const Tally& more);

/// Adds a line of a batch to the tally and returns its number in the whole batch. Throws
/// std::invalid_argument if it is not a line of a batch.
std::uint64_t count_line(std::string_view line, Tally& tally);
/// The same for a line that is known to be one.
std::uint64_t count_line(const nlohmann::ordered_json& line, Tally& tally);

}  // namespace exsect::cli
