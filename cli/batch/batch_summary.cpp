#include "cli/batch/batch_summary.h"

#include <fmt/format.h>

#include "output/text/terminal_text.h"

namespace exsect::cli {

std::string batch_summary(const Tally& tally, std::uint64_t apart, const BatchEffort& effort) {
  std::vector<std::vector<std::string>> rows;
  const auto row = [&](const char* what, std::uint64_t number, const std::string& note = "") {
    rows.push_back({what, std::to_string(number), note});
  };
  if (apart > 0) row("apart", apart, "pairs whose boxes do not meet, not solved");
  row("pairs", tally.lines - tally.selves);
  if (tally.selves > 0) row("patches", tally.selves, "with themselves");
  row("complete", tally.complete,
      fmt::format("by boxes {}, in doubles {}, exactly {}", tally.by_boxes, tally.by_doubles,
                  tally.by_exact));
  row("incomplete", tally.incomplete);
  row("failed", tally.failed);
  row("meeting", tally.meeting,
      fmt::format("{} open, {} closed, {} branched, {} isolated, {} overlaps", tally.open, tally.closed,
                  tally.branched, tally.isolated, tally.overlaps));
  std::string text = table({"", "number", ""}, rows);
  if (effort.lines > 0) {
    text += fmt::format("  {} solved in {:.1f} s by {}, {:.0f} a second; largest worker {:.0f} MB\n",
                        effort.lines, effort.seconds, counted(effort.workers, "worker"),
                        static_cast<double>(effort.lines) / std::max(effort.seconds, 1e-3),
                        static_cast<double>(effort.peak_kib) / 1024);
  }
  return text;
}

}  // namespace exsect::cli
