// Sums an array on one SPE that streams it through two small buffers.
#include "streaming_sum.h"

#include <numeric>
#include <vector>

#include "run_spe.h"

extern "C" spe_program_handle_t streaming_sum_spu;

namespace {
/// 128-byte units, so that the array is aligned for DMA.
struct alignas(128) Block {
  std::uint32_t words[kBlockWords];
};
}  // namespace

int main(int argc, char** argv) {
  set_mode_from_arguments(argc, argv);
  constexpr std::uint32_t kBlocks = 37;
  std::vector<Block> blocks(kBlocks);
  std::uint32_t value = 1;
  std::uint32_t expected = 0;
  for (Block& block : blocks) {
    for (std::uint32_t& word : block.words) {
      word = value;
      value = value * 1664525U + 1013904223U;
    }
    expected = std::accumulate(std::begin(block.words), std::end(block.words), expected);
  }
  const auto address = reinterpret_cast<std::uintptr_t>(blocks.data());
  StreamingSum job{static_cast<std::uint32_t>(address >> 32U), static_cast<std::uint32_t>(address), kBlocks,
                   0};

  spe_context_ptr_t spe = load_spe(streaming_sum_spu);
  const bool ran = run_spe(spe, &job);
  spe_context_destroy(spe);
  std::printf("sum %08x, expected %08x\n", job.sum, expected);
  return ran && job.sum == expected ? EXIT_SUCCESS : EXIT_FAILURE;
}
