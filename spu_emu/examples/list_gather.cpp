// Gathers scattered records of a table with one DMA list.
#include "list_gather.h"

#include <memory>
#include <new>

#include "run_spe.h"

extern "C" spe_program_handle_t list_gather_spu;

namespace {

/// The table and the result in one block within one 4 GB window, as a DMA list wants its elements.
struct alignas(128) Memory {
  unsigned char table[1024 * kRecordBytes];
  unsigned char result[kRecords * kRecordBytes];
};
}  // namespace

int main(int argc, char** argv) {
  set_mode_from_arguments(argc, argv);
  auto memory = std::make_unique<Memory>();
  for (std::size_t i = 0; i < sizeof memory->table; ++i) {
    memory->table[i] = static_cast<unsigned char>(i * 31 + i / 32);
  }
  const auto table = reinterpret_cast<std::uintptr_t>(memory->table);
  const auto result = reinterpret_cast<std::uintptr_t>(memory->result);
  ListGather job{static_cast<std::uint32_t>(table >> 32U),
                 static_cast<std::uint32_t>(table),
                 static_cast<std::uint32_t>(result >> 32U),
                 static_cast<std::uint32_t>(result),
                 {}};
  for (std::uint32_t i = 0; i < kRecords; ++i) job.picks[i] = (i * 389 + 7) % 1024;

  spe_context_ptr_t spe = load_spe(list_gather_spu);
  bool right = run_spe(spe, &job);
  spe_context_destroy(spe);
  for (std::uint32_t i = 0; i < kRecords; ++i) {
    right = right && std::memcmp(memory->result + i * kRecordBytes,
                                 memory->table + job.picks[i] * kRecordBytes, kRecordBytes) == 0;
  }
  std::printf("gathered %u records: %s\n", kRecords, right ? "right" : "wrong");
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
