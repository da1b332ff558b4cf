// A machine with a local store and channels of its own, and programs made of instruction words.
#ifndef SPU_EMU_TESTS_ISA_CORE_TEST_MACHINE_H
#define SPU_EMU_TESTS_ISA_CORE_TEST_MACHINE_H

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <initializer_list>

#include "../../mfc/test_spu.h"
#include "../encoding/assembler.h"
#include "isa/core/machine.h"
#include "mfc/byte_order.h"

namespace spu_emu::isa {

using Words = std::array<std::uint32_t, 4>;

class TestMachine : public TestSpu {
 public:
  explicit TestMachine(DmaMode mode = DmaMode::eager)
      : TestSpu(mode, 1, kSpuWordOrder), machine(local->bytes.data(), channels) {}

  /// Writes a word as the SPU sees it; the machine is told.
  void put(std::uint32_t address, std::uint32_t word) {
    const std::uint32_t bytes = big_endian(word);
    std::memcpy(local->bytes.data() + address, &bytes, sizeof bytes);
    machine.local_store_written(address, sizeof bytes);
  }
  std::uint32_t get(std::uint32_t address) const {
    std::uint32_t bytes = 0;
    std::memcpy(&bytes, local->bytes.data() + address, sizeof bytes);
    return big_endian(bytes);
  }
  void program(std::initializer_list<std::uint32_t> words, std::uint32_t address = 0) {
    machine.set_pc(address);
    for (const std::uint32_t word : words) {
      put(address, word);
      address += 4;
    }
  }
  void set(unsigned reg, const Words& words) {
    for (unsigned slot = 0; slot < 4; ++slot) machine.set_word(reg, slot, words[slot]);
  }
  Words reg(unsigned number) const {
    Words words{};
    for (unsigned slot = 0; slot < 4; ++slot) words[slot] = machine.word(number, slot);
    return words;
  }
  /// Runs to a stop, which must come soon.
  MachineStop run_to_stop() {
    const MachineStop stop = machine.run(1'000'000);
    EXPECT_EQ(stop.kind, MachineStop::Kind::stop) << "at pc " << stop.pc << " code " << stop.code;
    return stop;
  }

  Machine machine;
};

inline constexpr std::uint32_t kStop = 0;

}  // namespace spu_emu::isa

#endif
