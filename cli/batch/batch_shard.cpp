#include "cli/batch/batch_input.h"

namespace exsect::cli {
namespace {

constexpr std::uint64_t block = 64;

}  // namespace

std::uint64_t Shard::size(std::uint64_t all) const {
  const std::uint64_t round = block * count;
  const std::uint64_t rest = all % round;
  const std::uint64_t before = (index - 1) * block;
  return all / round * block + (rest > before ? std::min(rest - before, block) : 0);
}

std::uint64_t Shard::global(std::uint64_t local) const {
  return (local / block * count + index - 1) * block + local % block;
}

bool Shard::contains(std::uint64_t global) const { return global / block % count == index - 1; }

std::uint64_t Shard::local(std::uint64_t global) const {
  return global / block / count * block + global % block;
}

}  // namespace exsect::cli
