#include "output/text/comparison_json.h"

#include <optional>

namespace exsect::cli {
namespace {

Json optional_number(const std::optional<std::size_t>& n) { return n ? Json(*n) : Json(); }

Json row_json(const MethodRow& row) {
  return {{"method", row.method},
          {"detail", row.detail},
          {"answer", row.answer},
          {"found",
           {{"number", row.components},
            {"open", optional_number(row.open)},
            {"closed", optional_number(row.closed)}}},
          {"phantoms", {{"met", optional_number(row.phantom_branches)}, {"removed", row.phantoms_removed}}},
          {"points",
           {{"exact", row.points},
            {"certified", row.certified},
            {"missed", row.missed},
            {"phantoms", row.phantom_points},
            {"phantoms_removed", row.phantom_points_removed}}},
          {"milliseconds", row.milliseconds},
          {"peak_kib", row.peak_kib ? Json(*row.peak_kib) : Json()}};
}

}  // namespace

Json comparison_json(const Comparison& comparison, const PatchNames& names) {
  Json json = {{"exsect", "comparison/1"},
               {"status", comparison.is_complete() ? "complete" : "incomplete"},
               {"first", names.first},
               {"second", names.second},
               {"check_lines", comparison.lines},
               {"methods", Json::array()}};
  for (const MethodRow& row : comparison.rows) json["methods"].push_back(row_json(row));
  return json;
}

}  // namespace exsect::cli
