// What a batch is about: the pairs of a model or of a list of files, and which of them a shard does.
#pragma once

#include <exsect/geometry/rational_patch_file.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "output/text/json_forms.h"

namespace exsect::cli {

/// A batch has no more parts than this.
inline constexpr int most_shards = 1000000;

/// Part `index` of `count`, 1 <= index <= count. Lines are dealt out in blocks of 64.
struct Shard {
  std::uint64_t index = 1;
  std::uint64_t count = 1;

  /// How many of `all` lines are in this shard.
  std::uint64_t size(std::uint64_t all) const;
  /// The number in the whole batch of line `local` of this shard.
  std::uint64_t global(std::uint64_t local) const;
  /// Whether line `global` of the whole batch is in this shard, as which line of it.
  bool contains(std::uint64_t global) const;
  std::uint64_t local(std::uint64_t global) const;
};

/// A pair of patches, or twice the same patch for its self-intersection.
struct Subject {
  NamedRationalPatch x;
  NamedRationalPatch y;
  bool self;
};

/// Lines are numbered from 0 over the whole batch; a shard has the lines local 0, 1, ... of its own.
class BatchInput {
 public:
  virtual ~BatchInput() = default;

  /// Lines of this shard.
  virtual std::uint64_t size() const = 0;
  /// "model" or "list" with its counts and checksum, and "lines", the number of lines of the whole batch.
  virtual Json header() const = 0;
  /// What is known of a line without its patches: "file" in a list, names of patches in a model.
  virtual Json names(std::uint64_t local) const = 0;
  virtual bool self(std::uint64_t local) const = 0;
  /// Whether the boxes of all pairs are known to meet.
  virtual bool pairs_meet() const = 0;
  /// Reads the patches. Throws InputError.
  virtual Subject load(std::uint64_t local) const = 0;
  /// Pairs that are no lines since their boxes do not meet.
  virtual std::uint64_t apart() const = 0;
};

/// The pairs i < j of the patches of one file whose exact bounding boxes meet, in lexicographic order, with
/// `self` also each patch, before its pairs. Throws InputError.
std::unique_ptr<BatchInput> read_model(const std::string& path, bool self, const Shard& shard);

/// One pair in each of the files, in this order; with `self` also the two patches, before and after it.
std::unique_ptr<BatchInput> list_of_pairs(std::vector<std::string> files, bool self, const Shard& shard);

/// The paths in a list: one on each line, those that are not absolute relative to the directory of the list;
/// empty lines are skipped. Throws InputError if there is none, or for a line with a NUL.
std::vector<std::string> read_list(const std::string& path);

/// Whether it is a BPT file, or its first character that is not blank is "{": patches, not a list. Throws
/// InputError if it cannot be read.
bool holds_patches(const std::string& path);

}  // namespace exsect::cli
