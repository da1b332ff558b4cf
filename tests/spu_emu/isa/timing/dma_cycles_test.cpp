// DMA by the clock: single commands counted by hand, and a streaming program against 25.6 GB/s.
#include <vector>

#include "timed_machine.h"

namespace spu_emu::isa {
namespace {

constexpr std::uint32_t kGet = 0x40;
constexpr std::uint32_t kGetWithFence = 0x42;

/// Registers 10 to 15 hold what a command is made of, 16 and 17 mask and kind of a wait.
class DmaMachine : public TimedMachine {
 public:
  explicit DmaMachine(const CycleParameters& parameters = {}) : TimedMachine(parameters) {
    const std::uint32_t words[] = {
        0x10000, static_cast<std::uint32_t>(ea() >> 32U), static_cast<std::uint32_t>(ea()), 128, 0, kGet, 1,
        2};
    for (unsigned i = 0; i < 8; ++i) set(10 + i, {words[i], 0, 0, 0});
  }
  void set_size(std::uint32_t bytes) { set(13, {bytes, 0, 0, 0}); }

  static void append_command(std::vector<std::uint32_t>& code) {
    for (std::int32_t i = 0; i < 6; ++i)
      code.push_back(encode("wrch", {static_cast<std::int32_t>(MFC_LSA) + i, 10 + i}));
  }
  static void append_wait(std::vector<std::uint32_t>& code) {
    code.push_back(encode("wrch", {MFC_WrTagMask, 16}));
    code.push_back(encode("wrch", {MFC_WrTagUpdate, 17}));
    code.push_back(encode("rdch", {18, MFC_RdTagStat}));
  }
  CycleCounts run(const std::vector<std::uint32_t>& code) {
    for (std::uint32_t i = 0; i < code.size(); ++i) put(4 * i, code[i]);
    machine.set_pc(0);
    run_to_stop();
    return model.profile().total;
  }
};

std::vector<std::uint32_t> get_and_wait() {
  std::vector<std::uint32_t> code;
  DmaMachine::append_command(code);
  DmaMachine::append_wait(code);
  code.push_back(kStop);
  return code;
}

TEST(DmaCycles, ACommandTakesItsStartItsBytesAndTheLatency) {
  DmaMachine spu;
  spu.set_size(16384);
  // The command is written @5; 30 cycles to start, 2,048 for the bytes, 750 of latency: done @2833. Waiting
  // begins @8; the stop is @2834.
  const CycleCounts counts = spu.run(get_and_wait());
  EXPECT_EQ(counts.cycles, 2835U);
  EXPECT_EQ(counts.stall(Stall::dma_wait), 2825U);
  EXPECT_EQ(spu.model.profile().dma_bytes, 16384U);
  EXPECT_EQ(spu.model.profile().dma_commands, 1U);
}

TEST(DmaCycles, SpesThatShareMemoryGetAPartOfItsBandwidth) {
  CycleParameters shared;
  shared.sharing_spes = 4;
  DmaMachine spu(shared);
  spu.set_size(16384);
  // Four times 2,048 cycles for the bytes.
  EXPECT_EQ(spu.run(get_and_wait()).cycles, 2835U + 3 * 2048);
}

TEST(DmaCycles, FewBytesTakeALineOfTheBus) {
  DmaMachine spu;
  spu.set_size(4);
  // As above with 16 cycles for a line.
  EXPECT_EQ(spu.run(get_and_wait()).cycles, 2835U - 2048 + 16);
}

TEST(DmaCycles, LatenciesOverlapAndBandwidthDoesNot) {
  std::vector<std::uint32_t> code;
  DmaMachine::append_command(code);
  for (int i = 0; i < 3; ++i) code.push_back(encode("wrch", {MFC_Cmd, 15}));
  DmaMachine::append_wait(code);
  code.push_back(kStop);
  DmaMachine spu;
  spu.set_size(1024);
  // The first begins @35, each takes the bus for 128 cycles, the last is done @35 + 512 + 750; the stop
  // after.
  EXPECT_EQ(spu.run(code).cycles, 35U + 512 + 750 + 2);
}

TEST(DmaCycles, AFenceWaitsForTheTagsEarlierCommands) {
  std::vector<std::uint32_t> code;
  DmaMachine::append_command(code);
  code.push_back(encode("wrch", {MFC_Cmd, 20}));
  DmaMachine::append_wait(code);
  code.push_back(kStop);
  DmaMachine spu;
  spu.set(20, {kGetWithFence, 0, 0, 0});
  // The first is done @35 + 16 + 750, the second begins then.
  EXPECT_EQ(spu.run(code).cycles, 35U + 2 * (16 + 750) + 2);
}

TEST(DmaCycles, TheSeventeenthCommandWaitsForARoomInTheQueue) {
  std::vector<std::uint32_t> code;
  DmaMachine::append_command(code);
  for (int i = 0; i < 16; ++i) code.push_back(encode("wrch", {MFC_Cmd, 15}));
  code.push_back(kStop);
  DmaMachine spu;
  // The first is done @35 + 16 + 750 = @801, the seventeenth would issue @21.
  const CycleCounts counts = spu.run(code);
  EXPECT_EQ(counts.stall(Stall::dma_queue), 780U);
  EXPECT_EQ(counts.cycles, 803U);
}

TEST(DmaCycles, AListTakesALineAndAStepForEachElement) {
  DmaMachine spu;
  for (std::uint32_t i = 0; i < 4; ++i) {
    spu.put(0x8000 + 8 * i, 16);
    spu.put(0x8004 + 8 * i, static_cast<std::uint32_t>(spu.ea(256 * i)));
  }
  spu.set(12, {0x8000, 0, 0, 0});
  spu.set(13, {32, 0, 0, 0});
  spu.set(15, {kGet | 4, 0, 0, 0});
  // Begins @35; four lines of 16 cycles, three more elements of 8, the latency.
  EXPECT_EQ(spu.run(get_and_wait()).cycles, 35U + 4 * 16 + 3 * 8 + 750 + 2);
  EXPECT_EQ(spu.model.profile().dma_bytes, 64U);
}

TEST(DmaCycles, ALookAtTheTagsWaitsForWhatItReports) {
  DmaMachine spu;
  spu.set(17, {MFC_TAG_UPDATE_IMMEDIATE, 0, 0, 0});
  // The emulated bytes have moved at once; a program that polls would do so until cycle 801.
  EXPECT_EQ(spu.run(get_and_wait()).cycles, 35U + 16 + 750 + 2);
}

TEST(DmaCycles, DmaTakesThePortFromLoads) {
  // While 16 KB come in from @785 on, a line of 128 bytes takes the port every 16 cycles. 4,000 loads and
  // branches after the command meet some of them.
  std::vector<std::uint32_t> code;
  DmaMachine::append_command(code);
  code.push_back(encode("lqd", {21, 0, 100}));
  code.push_back(encode("lqd", {22, 0, 100}));
  code.push_back(encode("ai", {23, 23, -1}));
  code.push_back(encode("brnz", {23, -12}));
  code.push_back(kStop);
  const auto port_stalls = [&](std::uint32_t bytes) {
    DmaMachine spu;
    spu.set(23, {200, 0, 0, 0});
    spu.set_size(bytes);
    return spu.run(code).stall(Stall::port);
  };
  EXPECT_EQ(port_stalls(0), 0U);
  EXPECT_GT(port_stalls(16384), 5U);
  EXPECT_LT(port_stalls(16384), 128U) << "no line delays more than once";
}

TEST(DmaCycles, AtomicCommandsAreWaitedForByTheirStatus) {
  std::vector<std::uint32_t> code;
  DmaMachine::append_command(code);
  code.push_back(encode("rdch", {18, MFC_RdAtomicStat}));
  code.push_back(kStop);
  DmaMachine spu;
  spu.set(15, {0xd0, 0, 0, 0});
  // A line from @35: the read returns @801, the stop, second of no pair, follows.
  EXPECT_EQ(spu.run(code).cycles, 803U);
}

/// Streams blocks of 16 KB through two buffers and adds up their words. With `ahead` the next block is
/// fetched before the current one is waited for.
std::vector<std::uint32_t> streaming_program(bool ahead) {
  std::vector<std::uint32_t> code;
  const auto append_get = [&] {
    DmaMachine::append_command(code);
    code.insert(code.end(), {encode("xor", {10, 10, 30}), encode("xor", {14, 14, 31})});
  };
  if (ahead) append_get();
  const auto block = static_cast<std::int32_t>(4 * code.size());
  append_get();
  DmaMachine::append_wait(code);
  code.insert(code.end(), {encode("xor", {16, 16, 32}), encode("il", {41, 128})});
  // Eight quadwords a turn in nine pairs, 128 turns. The hint before them holds for all but the last.
  if (code.size() % 2 == 0) code.push_back(encode("lnop"));
  code.push_back(encode("hbrr", {4 * 18, 4}));
  code.insert(code.end(), {encode("ai", {41, 41, -1}), encode("lnop")});
  for (std::int32_t i = 0; i < 8; ++i) {
    code.push_back(encode("a", {50 + i, 50 + i, 60 + i}));
    code.push_back(i < 7 ? encode("lqd", {60 + i, 16 * i, 10}) : encode("brnz", {41, -4 * 17}));
  }
  code.push_back(encode("ai", {40, 40, -1}));
  code.push_back(encode("brnz", {40, block - static_cast<std::int32_t>(4 * code.size())}));
  code.push_back(kStop);
  return code;
}

double gigabytes_per_second(bool ahead, const CycleParameters& parameters) {
  constexpr std::uint32_t kBlocks = 40;
  DmaMachine spu(parameters);
  spu.set_size(16384);
  spu.set(30, {0x4000, 0, 0, 0});
  spu.set(31, {1, 0, 0, 0});
  spu.set(32, {3, 0, 0, 0});
  spu.set(40, {kBlocks, 0, 0, 0});
  const CycleCounts counts = spu.run(streaming_program(ahead));
  return kBlocks * 16384.0 * parameters.hertz / 1e9 / static_cast<double>(counts.cycles);
}

TEST(DmaCycles, ADoubleBufferedStreamComesNearTheBandwidthOfMemory) {
  const double speed = gigabytes_per_second(true, {});
  EXPECT_LT(speed, 25.6);
  EXPECT_GT(speed, 0.95 * 25.6);
}

TEST(DmaCycles, AStreamOnOneBufferAtATimeDoesNot) {
  // 2,048 cycles for the bytes, 780 of start and latency, and 1,152 of work in turns: below 14 GB/s.
  EXPECT_LT(gigabytes_per_second(false, {}), 14.0);
  EXPECT_GT(gigabytes_per_second(false, {}), 10.0);
}

TEST(DmaCycles, SeveralStreamsGetTheirShareOfTheBandwidth) {
  for (const std::uint32_t spes : {2U, 4U, 8U}) {
    CycleParameters shared;
    shared.sharing_spes = spes;
    EXPECT_LT(gigabytes_per_second(true, shared), 25.6 / spes);
    EXPECT_GT(gigabytes_per_second(true, shared), 0.95 * 25.6 / spes);
  }
}

}  // namespace
}  // namespace spu_emu::isa
