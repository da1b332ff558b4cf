#include "broadphase/bodies/distinct_ids.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/key_sort.h"
#include "base/memory/list.h"
#include "base/memory/memory.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

/// For each value of a hash a bit: whether an id has it, and whether a second one has.
class HashBits {
 public:
  explicit HashBits(std::size_t ids)
      : bits_(static_cast<unsigned>(std::bit_width(std::max(ids * tuning::kBitsOfId, std::size_t{64}) - 1))),
        words_((std::size_t{1} << bits_) / 64) {}

  void add(BodyId id) {
    const std::uint64_t hash = hash_of(id);
    Words& words = words_[hash / 64];
    const std::uint64_t bit = std::uint64_t{1} << hash % 64;
    words.twice |= words.once & bit;
    words.once |= bit;
  }

  bool is_shared(BodyId id) const {
    const std::uint64_t hash = hash_of(id);
    return (words_[hash / 64].twice >> hash % 64 & 1) != 0;
  }

 private:
  struct Words {
    std::uint64_t once = 0;
    std::uint64_t twice = 0;
  };

  // The golden ratio, for it scatters runs.
  std::uint64_t hash_of(BodyId id) const { return id * 0x9e3779b97f4a7c15U >> (64 - bits_); }

  unsigned bits_;
  Vector<Words> words_;
};

/// Those whose hashes another one has; nearly none where ids are few and all differ.
List<std::uint64_t> list_shared(const HashBits& hashes, std::span<const BodyId> ids) {
  constexpr std::size_t kBlock = 512;
  List<std::uint64_t> shared;
  for (std::size_t first = 0; first < ids.size(); first += kBlock) {
    const auto block = ids.subspan(first, std::min(kBlock, ids.size() - first));
    shared.reserve(shared.size() + block.size());
    std::uint64_t* end = shared.data() + shared.size();
    for (const BodyId id : block) {
      *end = id;
      end += hashes.is_shared(id) ? 1 : 0;
    }
    shared.set_size(static_cast<std::size_t>(end - shared.data()));
  }
  return shared;
}

}  // namespace

bool are_distinct(std::span<const BodyId> ids) {
  HashBits hashes(ids.size());
  for (const BodyId id : ids) hashes.add(id);
  List<std::uint64_t> shared = list_shared(hashes, ids);
  sort_keys(shared.view());
  return std::ranges::adjacent_find(shared.view()) == shared.view().end();
}

}  // namespace cellsweep
