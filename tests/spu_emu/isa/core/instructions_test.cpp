// What executes each instruction: there for all of them, and none needs more stack the longer it runs.
#include <pthread.h>

#include <functional>

#include "isa/core/decoder.h"
#include "isa/core/handlers.h"
#include "isa/encoding/opcodes.h"
#include "mfc/byte_order.h"
#include "test_machine.h"

namespace spu_emu::isa {
namespace {

TEST(Instructions, AreExecutedUnlessTheyHaveNoEffect) {
  for (const Instruction& instruction : instructions()) {
    if (instruction.flow == Flow::none) continue;
    alignas(128) std::array<std::byte, 16> code{};
    const std::uint32_t word = big_endian(std::uint32_t{instruction.opcode} << 21U);
    std::memcpy(code.data(), &word, sizeof word);
    std::uint32_t words = 0;
    const Op op = decode_block(code.data(), 0, 1, words).front();
    EXPECT_NE(op.run, nullptr) << instruction.mnemonic;
    EXPECT_NE(op.run, &execute_illegal) << instruction.mnemonic;
  }
}

/// The instruction with operands by which it neither branches nor halts nor writes into the program: $5 holds
/// ones, $7 twos, $8 zeros.
std::uint32_t harmless(const Instruction& instruction) {
  const std::string name = instruction.mnemonic;
  std::uint32_t word = std::uint32_t{instruction.opcode} << 21U;
  if (instruction.format == Format::rr) word |= 7U << 14U;
  if (instruction.format != Format::ri16 && instruction.format != Format::ri18) word |= 5U << 7U;
  if (instruction.format == Format::ri10 && name.starts_with("h")) word |= 100U << 14U;
  if (name.starts_with("b")) word |= name.ends_with("nz") ? 8U : 5U;
  if (instruction.format == Format::ri16) word |= 0x4000U << 7U;
  return word;
}

/// Runs `work` on a thread with a small stack.
void run_on_small_stack(std::function<void()> work) {
  constexpr std::size_t kBytes = 256 * 1024;
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kBytes);
  pthread_t thread{};
  const auto call = [](void* argument) -> void* {
    (*static_cast<std::function<void()>*>(argument))();
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, call, &work), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

/// Handlers call each other: if one of them did not end with a jump, a loop would overflow the stack.
TEST(Instructions, DoNotNeedMoreStackTheLongerTheyRun) {
  constexpr std::int32_t kTurns = 30'000;
  for (const Instruction& instruction : instructions()) {
    if (instruction.flow != Flow::next && instruction.flow != Flow::may_leave) continue;
    TestMachine spu;
    spu.set(5, {1, 1, 1, 1});
    spu.set(7, {2, 2, 2, 2});
    spu.program({encode("ila", {6, kTurns}), harmless(instruction), encode("ai", {6, 6, -1}),
                 encode("brnz", {6, -8}), kStop},
                0x400);
    run_on_small_stack([&] { spu.run_to_stop(); });
    EXPECT_EQ(spu.machine.instructions(), 3U * kTurns + 2) << instruction.mnemonic;
  }
}

TEST(Instructions, DoNotNeedMoreStackForChannelsAndBranchesEither) {
  constexpr std::int32_t kTurns = 30'000;
  TestMachine spu;
  spu.set(5, {0x410, 0, 0, 0});
  spu.program({encode("ila", {6, kTurns}), encode("rchcnt", {7, MFC_Cmd}), encode("wrch", {MFC_Size, 7}),
               encode("bisl", {8, 5}), encode("rdch", {9, MFC_RdTagMask}), encode("bisled", {8, 5}),
               encode("ai", {6, 6, -1}), encode("brnz", {6, -24}), kStop},
              0x400);
  run_on_small_stack([&] { spu.run_to_stop(); });
  EXPECT_EQ(spu.machine.instructions(), 7U * kTurns + 2);
}

}  // namespace
}  // namespace spu_emu::isa
