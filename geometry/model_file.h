// Model files (docs/formats.md): many patches, one on each line, read without holding them all.
#pragma once

#include <exsect/geometry/rational_patch_file.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace exsect {

/// Lines of a model longer than this, in bytes, are refused.
inline constexpr std::size_t max_model_line_bytes = std::size_t{1} << 20;

/// A file of the form model/1,
///
///     {"exsect": "model/1", "title": "...", "source": "...", "numbers": "decimal" | "binary64"}
///     {"name": "x", "degree": [2,2], "points": [[["1/7","0","3/5"], ...3 points], ...3 rows]}
///     ...
///
/// with one JSON value on each line, or of the form patches/1. Of a model/1 only the place of each line is
/// kept, and patch() reads it again from the file, which stays open; of a patches/1 the patches are kept.
/// Names are not empty and distinct.
class ModelFile {
 public:
  /// Reads the whole file once and gives each patch to `each`, in order. Throws InputError (file and line,
  /// JSON path, reason) for whatever parse_patches refuses in a patch, a line that is too long, no patch at
  /// all, or a file that cannot be read.
  ModelFile(const std::string& path, const std::function<void(const NamedRationalPatch&)>& each);
  ~ModelFile();
  ModelFile(ModelFile&&) noexcept;
  ModelFile& operator=(ModelFile&&) noexcept;

  std::size_t size() const;
  const std::string& title() const;
  /// Safe to call from several threads, and from a process that was forked after the file was read. Throws
  /// InputError if the line cannot be read again.
  NamedRationalPatch patch(std::size_t i) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace exsect
