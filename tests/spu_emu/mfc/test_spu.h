// An SPU's channels on a local store of its own, and main memory beside it, for tests of the MFC.
#ifndef SPU_EMU_TESTS_TEST_SPU_H
#define SPU_EMU_TESTS_TEST_SPU_H

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>

#include "mfc/fault.h"
#include "mfc/spu_channels.h"
#include "spu_emu/channel_numbers.h"

#if defined(__SANITIZE_ADDRESS__)
#define SPU_EMU_TEST_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SPU_EMU_TEST_ASAN 1
#endif
#endif

namespace spu_emu {

/// Time that only the test moves.
class ManualTimebase : public Timebase {
 public:
  std::uint64_t ticks() const override { return now; }
  std::chrono::nanoseconds duration(std::uint64_t ticks) const override {
    return std::chrono::nanoseconds(static_cast<std::int64_t>(ticks));
  }
  std::uint64_t now = 1000;
};

struct alignas(128) LocalBytes {
  std::array<std::byte, kLocalStoreSize> bytes{};
};

struct alignas(128) MainBytes {
  std::array<std::byte, 65536> bytes{};
};

class TestSpu {
 public:
  explicit TestSpu(DmaMode mode = DmaMode::eager, std::uint64_t seed = 1, WordOrder order = WordOrder::same,
                   SignalMode signals = SignalMode::overwrite)
      : store(local->bytes.data(), kLocalStoreSize, order),
        channels(store, timebase, setup(mode, seed, signals)) {
    for (std::size_t i = 0; i < main->bytes.size(); ++i) main->bytes[i] = pattern(i);
  }

  static std::byte pattern(std::size_t i) { return static_cast<std::byte>((i * 7 + i / 256) & 0x7f); }

  std::uint64_t ea(std::size_t offset = 0) const {
    return reinterpret_cast<std::uintptr_t>(main->bytes.data()) + offset;
  }
  void dma(std::uint32_t opcode, std::uint32_t ls, std::uint64_t address, std::uint32_t size,
           std::uint32_t tag) {
    channels.dma({opcode, tag, size, ls, address, {"program.cpp", 42}});
  }
  std::uint32_t wait(std::uint32_t mask, std::uint32_t kind = MFC_TAG_UPDATE_ALL) {
    channels.write(MFC_WrTagMask, mask);
    channels.write(MFC_WrTagUpdate, kind);
    return channels.read(MFC_RdTagStat);
  }
  /// Reads and writes that AddressSanitizer does not see, as those of code built without it.
  __attribute__((no_sanitize("address"))) std::byte peek(std::uint32_t ls) const {
    return local->bytes.data()[ls];
  }
  __attribute__((no_sanitize("address"))) void poke(std::uint32_t ls, std::byte value) {
    local->bytes.data()[ls] = value;
  }
  bool same(std::uint32_t ls, std::size_t offset, std::size_t size) const {
    return std::memcmp(local->bytes.data() + ls, main->bytes.data() + offset, size) == 0;
  }
  void write_element(std::uint32_t list, std::uint32_t index, std::uint32_t first_word,
                     std::uint32_t ea_low) {
    const std::array<std::uint32_t, 2> words{first_word, ea_low};
    std::memcpy(local->bytes.data() + list + index * 8, words.data(), 8);
  }
  std::uint32_t ea_low(std::size_t offset) const { return static_cast<std::uint32_t>(ea(offset)); }

  std::unique_ptr<LocalBytes> local = std::make_unique<LocalBytes>();
  std::unique_ptr<MainBytes> main = std::make_unique<MainBytes>();
  FlatLocalStore store;
  ManualTimebase timebase;
  SpuChannels channels;

 private:
  static ChannelSetup setup(DmaMode mode, std::uint64_t seed, SignalMode signals) {
    ChannelSetup result;
    result.mode = mode;
    result.seed = seed;
    result.signal1 = result.signal2 = signals;
    return result;
  }
};

/// Names a parametrised test by its mode.
inline std::string mode_name(const testing::TestParamInfo<DmaMode>& mode) {
  switch (mode.param) {
    case DmaMode::eager:
      return "eager";
    case DmaMode::late:
      return "late";
    default:
      return "unchecked";
  }
}

/// Expects that `action` breaks `rule`; returns the fault's text.
template <class Action>
std::string expect_fault(Rule rule, Action&& action) {
  try {
    action();
  } catch (const Fault& fault) {
    EXPECT_EQ(rule_name(fault.rule()), std::string(rule_name(rule))) << fault.text();
    return fault.text();
  }
  ADD_FAILURE() << "no fault, expected: " << rule_name(rule);
  return "";
}

}  // namespace spu_emu

#endif
