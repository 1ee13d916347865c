#include <exsect/geometry/broad_phase.h>
#include <exsect/geometry/model_file.h>

#include <utility>

#include "cli/batch/batch_input.h"
#include "cli/batch/checksum.h"

namespace exsect::cli {
namespace {

/// The patches that were read last: a patch is in several pairs that follow each other.
class RecentPatches {
 public:
  explicit RecentPatches(const ModelFile& file) : file_(file), places_(size) {}

  const NamedRationalPatch& patch(std::uint32_t i) {
    auto& place = places_[i % size];
    if (!place || place->first != i) place.emplace(i, file_.patch(i));
    return place->second;
  }

 private:
  static constexpr std::size_t size = 4096;

  const ModelFile& file_;
  std::vector<std::optional<std::pair<std::uint32_t, NamedRationalPatch>>> places_;
};

class Model : public BatchInput {
 public:
  Model(const std::string& path, bool self, const Shard& shard)
      : checksum_(file_checksum(path)),
        file_(path,
              [this](const NamedRationalPatch& patch) {
                names_.push_back(patch.name);
                boxes_.push_back(rounded_outwards(bounding_box(patch.patch)));
              }),
        recent_(file_) {
    find_pairs(self, shard);
    std::vector<RoundedBox>().swap(boxes_);
  }

  std::uint64_t size() const override { return pairs_.size(); }
  Json header() const override {
    return {{"model", {{"patches", names_.size()}, {"checksum", checksum_}, {"apart", apart()}}},
            {"lines", lines_}};
  }
  Json names(std::uint64_t local) const override {
    const auto [i, j] = pairs_.at(local);
    if (i == j) return {{"patch", names_[i]}};
    return {{"first", names_[i]}, {"second", names_[j]}};
  }
  bool self(std::uint64_t local) const override { return pairs_.at(local).first == pairs_[local].second; }
  bool pairs_meet() const override { return true; }
  Subject load(std::uint64_t local) const override {
    const auto [i, j] = pairs_.at(local);
    return {recent_.patch(i), recent_.patch(j), i == j};
  }
  std::uint64_t apart() const override {
    return static_cast<std::uint64_t>(names_.size()) * (names_.size() - 1) / 2 - meeting_;
  }

 private:
  void find_pairs(bool self, const Shard& shard) {
    const auto add = [&](std::uint32_t i, std::uint32_t j) {
      if (shard.contains(lines_++)) pairs_.emplace_back(i, j);
    };
    std::uint32_t selves = 0;
    const auto add_selves_up_to = [&](std::uint32_t i) {
      for (; self && selves <= i; ++selves) add(selves, selves);
    };
    visit_meeting_boxes(boxes_, [&](std::uint32_t i, const std::vector<std::uint32_t>& later) {
      add_selves_up_to(i);
      for (const std::uint32_t j : later) {
        if (!meet(i, j)) continue;
        ++meeting_;
        add(i, j);
      }
    });
    add_selves_up_to(static_cast<std::uint32_t>(boxes_.size() - 1));
  }

  bool meet(std::uint32_t i, std::uint32_t j) const {
    return certainly_meet(boxes_[i], boxes_[j]) ||
           intersects(bounding_box(recent_.patch(i).patch), bounding_box(recent_.patch(j).patch));
  }

  std::string checksum_;
  std::vector<std::string> names_;
  std::vector<RoundedBox> boxes_;
  ModelFile file_;
  mutable RecentPatches recent_;
  std::uint64_t lines_ = 0;
  std::uint64_t meeting_ = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
};

}  // namespace

std::unique_ptr<BatchInput> read_model(const std::string& path, bool self, const Shard& shard) {
  return std::make_unique<Model>(path, self, shard);
}

}  // namespace exsect::cli
