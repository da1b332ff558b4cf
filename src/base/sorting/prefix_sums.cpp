#include "base/sorting/prefix_sums.h"

#include <cstddef>
#include <cstring>
#include <utility>

namespace cellsweep {

// Four at a time: the sum before them is waited for once, not four times.
void make_prefix_sums(std::span<std::uint32_t> counts) {
  using Four [[gnu::vector_size(16)]] = std::uint32_t;
  constexpr std::size_t kFour = 4;
  const Four none{};
  Four before{};
  for (; counts.size() >= kFour; counts = counts.subspan(kFour)) {
    Four here;
    std::memcpy(&here, counts.data(), sizeof here);
    Four sums = here + __builtin_shufflevector(none, here, 0, 4, 5, 6);
    sums += __builtin_shufflevector(none, sums, 0, 1, 4, 5);
    const Four begins = before + sums - here;
    std::memcpy(counts.data(), &begins, sizeof begins);
    before += __builtin_shufflevector(sums, sums, 3, 3, 3, 3);
  }
  std::uint32_t sum = before[0];
  for (std::uint32_t& count : counts) sum += std::exchange(count, sum);
}

}  // namespace cellsweep
