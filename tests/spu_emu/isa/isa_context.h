// A libspe2 context with real SPU code in it, assembled by the test.
#ifndef SPU_EMU_TESTS_ISA_ISA_CONTEXT_H
#define SPU_EMU_TESTS_ISA_ISA_CONTEXT_H

#include <gtest/gtest.h>
#include <libspe2.h>

#include <array>
#include <string>

#include "elf/elf_builder.h"
#include "encoding/assembler.h"
#include "spu_emu/emulation.h"

namespace spu_emu::isa {

using Code = std::vector<std::uint32_t>;

/// Appends the instructions of one DMA command and, unless it is an atomic one, the wait for its tag 0. The
/// EA comes from the doubleword in r4; r10 to r12 are used.
inline Code& append_dma(Code& code, std::uint32_t command, std::int32_t ls, std::int32_t size) {
  const auto write = [&](std::int32_t channel, std::int32_t value) {
    code.push_back(encode("ila", {10, value}));
    code.push_back(encode("wrch", {channel, 10}));
  };
  write(16, ls);
  code.push_back(encode("wrch", {17, 4}));
  code.push_back(encode("rotqbyi", {11, 4, 4}));
  code.push_back(encode("wrch", {18, 11}));
  write(19, size);
  write(20, 0);
  write(21, static_cast<std::int32_t>(command));
  return code;
}

inline Code& append_wait(Code& code) {
  for (const auto& [channel, value] : {std::pair{22, 1}, std::pair{23, 2}}) {
    code.push_back(encode("il", {10, value}));
    code.push_back(encode("wrch", {channel, 10}));
  }
  code.push_back(encode("rdch", {12, 24}));
  return code;
}

inline std::uint32_t stop_with(std::uint32_t code) {
  return encode("stop") | code;
}

/// Memory for DMA: 32 words 0x00010203, 0x04050607 and so on.
struct alignas(128) MainWords {
  MainWords() {
    for (std::uint32_t i = 0; i < words.size(); ++i) words[i] = 0x00010203U + i * 0x04040404U;
  }
  std::array<std::uint32_t, 32> words{};
};

class IsaContext {
 public:
  explicit IsaContext(const Code& code, const EmulationSettings& settings = {},
                      unsigned int flags = SPE_EVENTS_ENABLE)
      : IsaContext(ElfBuilder(0x80, {{0x80, code}}, {{"begin", 0x80}}).build(), settings, flags) {}
  explicit IsaContext(File file, const EmulationSettings& settings = {},
                      unsigned int flags = SPE_EVENTS_ENABLE)
      : file_(std::move(file)) {
    const SettingsScope scope(settings);
    spe = spe_context_create(flags, nullptr);
    EXPECT_NE(spe, nullptr);
    spe_program_handle_t handle{sizeof handle, file_.data(), nullptr};
    load_result = spe_program_load(spe, &handle);
  }
  ~IsaContext() { EXPECT_EQ(spe_context_destroy(spe), 0); }
  IsaContext(const IsaContext&) = delete;
  IsaContext& operator=(const IsaContext&) = delete;

  int run(const void* argp = nullptr, unsigned int flags = 0) {
    entry = SPE_DEFAULT_ENTRY;
    return spe_context_run(spe, &entry, flags, const_cast<void*>(argp), nullptr, &stop);
  }
  int resume(unsigned int flags = 0) { return spe_context_run(spe, &entry, flags, nullptr, nullptr, &stop); }

  std::byte* local_store() { return static_cast<std::byte*>(spe_ls_area_get(spe)); }
  std::uint32_t word(std::uint32_t ls) { return read_word(local_store() + ls); }
  void expect_fault(const char* part) {
    EXPECT_NE(last_fault(spe).find(part), std::string::npos) << part << " is not in: " << last_fault(spe);
  }

  spe_context_ptr_t spe = nullptr;
  int load_result = -1;
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop{};

 private:
  File file_;
};

}  // namespace spu_emu::isa

#endif
