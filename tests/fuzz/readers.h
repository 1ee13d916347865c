// Everything that reads text from outside, as functions of the text, and what has to hold for each of them.
#pragma once

#include <span>
#include <string_view>

namespace exsect::fuzz {

/// `read` returns if the text was refused by the error that is documented for it, or was read and what was
/// read can be written and read again without a change. Otherwise it throws: std::logic_error with the
/// property that does not hold, or whatever left the reader.
struct Reader {
  std::string_view name;
  void (*read)(std::string_view text);
};

/// number, patches, bpt, model, curve, candidate-json, candidate-csv, candidate-obj, candidate-g2,
/// certificate, batch-line and journal.
std::span<const Reader> readers();

}  // namespace exsect::fuzz
