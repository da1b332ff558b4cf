#include "machine_properties.h"

#include <algorithm>
#include <cstring>
#include <random>

#include "../timing/timed_machine.h"
#include "isa/encoding/disassembler.h"
#include "isa/encoding/opcodes.h"

namespace spu_emu::isa {

namespace {

constexpr std::uint64_t kMostSteps = 3000;
constexpr unsigned kRegisters = 128;

/// Half of the registers are addresses near the program, so that it is read and written.
void fill(TestMachine& spu, std::span<const std::byte> program, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::memset(spu.local->bytes.data(), 0, spu.local->bytes.size());
  std::copy_n(program.begin(), std::min(program.size(), spu.local->bytes.size()), spu.local->bytes.begin());
  spu.machine.reset();
  for (unsigned reg = 0; reg < kRegisters; ++reg) {
    const bool address = random() % 2 != 0;
    for (unsigned slot = 0; slot < 4; ++slot)
      spu.machine.set_word(reg, slot, static_cast<std::uint32_t>(address ? random() % 0x200 : random()));
  }
}

bool is_channel_instruction(std::uint32_t word) {
  const int number = find_instruction(word);
  return number >= 0 &&
         std::strchr(instructions()[static_cast<std::size_t>(number)].operands, 'h') != nullptr;
}

/// The stop that ended it, or the last budget.
MachineStop step(TestMachine& spu) {
  MachineStop stop{MachineStop::Kind::budget, 0, spu.machine.pc()};
  while (spu.machine.instructions() < kMostSteps && stop.kind == MachineStop::Kind::budget &&
         !is_channel_instruction(spu.get(spu.machine.pc()))) {
    stop = spu.machine.run(1);
  }
  return stop;
}

std::string difference(const TestMachine& one, const TestMachine& other) {
  if (one.machine.pc() != other.machine.pc()) return "pc";
  if (one.machine.instructions() != other.machine.instructions()) return "count of instructions";
  for (unsigned reg = 0; reg < kRegisters; ++reg)
    if (one.reg(reg) != other.reg(reg)) return "register " + std::to_string(reg);
  for (unsigned slot = 0; slot < 4; ++slot)
    if (one.machine.fpscr(slot) != other.machine.fpscr(slot)) return "FPSCR";
  const bool same = std::memcmp(one.local->bytes.data(), other.local->bytes.data(), kLocalStoreSize) == 0;
  return same ? "" : "local store";
}

/// Told of every instruction, a cycle model changes nothing, and each of its cycles is accounted for.
std::string difference_when_timed(const TestMachine& wanted, std::span<const std::byte> program,
                                  std::uint32_t seed, std::uint64_t budget) {
  static TimedMachine timed;
  fill(timed, program, seed);
  timed.model.set_code({});
  timed.machine.run(budget);
  const CycleCounts counts = timed.model.profile().total;
  std::uint64_t stalled = 0;
  for (const std::uint64_t stall : counts.stalls) stalled += stall;
  if (counts.instructions != timed.machine.instructions()) return "count of timed instructions";
  if (counts.cycles != counts.instructions - counts.dual_issued + stalled) return "sum of cycles";
  const std::string what = difference(wanted, timed);
  return what.empty() ? what : what + " when timed";
}

}  // namespace

std::string check_program(std::span<const std::byte> program, std::uint32_t seed) {
  static TestMachine stepped;
  static TestMachine at_once;
  fill(stepped, program, seed);
  fill(at_once, program, seed);
  const MachineStop wanted = step(stepped);
  // An illegal instruction is not executed, but needs a budget to be met.
  const bool illegal = wanted.kind == MachineStop::Kind::illegal;
  const std::uint64_t budget = stepped.machine.instructions() + (illegal ? 1 : 0);
  const MachineStop stop = at_once.machine.run(budget);
  if (stop.kind != wanted.kind || stop.code != wanted.code || stop.pc != wanted.pc) return "the stop differs";
  if (stop.pc % 4 != 0 || stop.pc >= kLocalStoreSize) return "pc is no address of an instruction";
  for (std::uint32_t pc = 0; pc < program.size() && pc < 0x100; pc += 4)
    if (disassemble(stepped.get(pc), pc).empty()) return "nothing to read of an instruction";
  const std::string what = difference(stepped, at_once);
  return what.empty() ? difference_when_timed(stepped, program, seed, budget) : what;
}

}  // namespace spu_emu::isa
