#include "isa/core/machine.h"

#include <algorithm>

#include "isa/core/block_cache.h"
#include "isa/core/channel_access.h"
#include "isa/core/decoder.h"
#include "isa/core/host_float_mode.h"
#include "isa/core/instruction_observer.h"
#include "isa/core/instruction_traps.h"
#include "isa/core/written_lines.h"
#include "spu_emu/intrinsics/float_mode.h"

namespace spu_emu::isa {

struct Machine::Impl {
  State state;
  BlockCache blocks;
  WrittenLines written;
  std::uint64_t executed = 0;  // before the run in progress
  std::uint64_t allowed = 0;   // in the run in progress

  explicit Impl(std::byte* local_store) : blocks(state, local_store) { state.store = local_store; }

  std::uint64_t instructions() const { return executed + allowed - state.budget; }
  void start(std::uint64_t max_instructions);
  bool look_up();
  void drop_written();
  void attend();
  const Op* next_block();
  MachineStop stopped() const;
  MachineStop run();
};

namespace {

constexpr MachineStop::Kind kind_of(Exit exit) {
  if (exit == Exit::stop) return MachineStop::Kind::stop;
  return exit == Exit::halt ? MachineStop::Kind::halt : MachineStop::Kind::illegal;
}

/// Tells the observer of the end of a run, also where a Fault comes through.
class ObservedRun {
 public:
  explicit ObservedRun(const State& state) : state_(state) {}
  ~ObservedRun() {
    if (state_.observer != nullptr && !ended_) state_.observer->cancel();
  }
  ObservedRun(const ObservedRun&) = delete;
  ObservedRun& operator=(const ObservedRun&) = delete;

  void end(MachineStop::Kind kind) {
    if (state_.observer == nullptr || kind == MachineStop::Kind::illegal) return;
    ended_ = true;
    state_.observer->end(state_.pc, state_);
  }

 private:
  const State& state_;
  bool ended_ = false;
};

}  // namespace

void Machine::Impl::start(std::uint64_t max_instructions) {
  executed = instructions();
  allowed = max_instructions;
  state.budget = max_instructions;
  state.exit = Exit::none;
}

/// Does what was asked for between blocks; false if the run has to end.
bool Machine::Impl::look_up() {
  const std::uint32_t attention = state.attention.load();
  if ((attention & kWritten) != 0) drop_written();
  if ((attention & kTrap) != 0) attend();
  if ((attention & kInterrupted) != 0) {
    state.attention.fetch_and(~std::uint32_t{kInterrupted});
    return false;
  }
  if ((attention & kInterruptsEnabled) != 0 && state.budget != 0) take_interrupt(state);
  return true;
}

void Machine::Impl::drop_written() {
  // First the bit, then the lines: what comes in between is found now or the next time.
  state.attention.fetch_and(~std::uint32_t{kWritten});
  written.take([this](std::uint32_t first) { blocks.drop(first, WrittenLines::kLine); });
}

void Machine::Impl::attend() {
  state.attention.fetch_and(~std::uint32_t{kTrap});
  const HostFloatMode mode(state);
  if (state.traps != nullptr) state.traps->attend();
}

const Op* Machine::Impl::next_block() {
  blocks.free_dropped();
  if (state.budget >= kMaxBlock) return blocks.block(state.pc);
  return blocks.partial_block(state.pc, static_cast<std::uint32_t>(state.budget));
}

MachineStop Machine::Impl::stopped() const {
  const std::uint32_t code = state.exit == Exit::stop      ? state.stop_code
                             : state.exit == Exit::illegal ? fetch(state.store, state.pc)
                                                           : 0;
  return {kind_of(state.exit), code, state.pc};
}

Machine::Machine(std::byte* local_store, SpuChannels& channels) : impl_(std::make_unique<Impl>(local_store)) {
  impl_->state.channels = &channels;
}

Machine::~Machine() = default;

void Machine::reset() {
  State& state = impl_->state;
  std::fill(std::begin(state.registers), std::end(state.registers), vec_uint4{});
  state.fpscr = vec_uint4{};
  state.pc = 0;
  state.attention.fetch_and(~std::uint32_t{kInterruptsEnabled});
  impl_->start(0);
  impl_->executed = 0;
  impl_->blocks.drop_all();
  impl_->blocks.free_dropped();
  if (state.observer != nullptr) state.observer->restart();
}

MachineStop Machine::Impl::run() {
  for (;;) {
    if (state.attention.load() != 0 && !look_up()) return {MachineStop::Kind::interrupted, 0, state.pc};
    if (state.budget == 0) return {MachineStop::Kind::budget, 0, state.pc};
    const Op* op = next_block();
    while (op != nullptr) op = op->run(state, op);
    if (state.exit != Exit::none) return stopped();
  }
}

MachineStop Machine::run(std::uint64_t max_instructions) {
  State& state = impl_->state;
  state.host_float_control = float_control();
  const SpuFloatMode mode;
  impl_->start(max_instructions);
  ObservedRun observed(state);
  const MachineStop stop = impl_->run();
  observed.end(stop.kind);
  return stop;
}

void Machine::set_observer(InstructionObserver& observer) {
  impl_->state.observer = &observer;
  impl_->blocks.drop_all();
}

void Machine::set_traps(InstructionTraps& traps) {
  impl_->state.traps = &traps;
  impl_->blocks.drop_all();
}

void Machine::decode_again() {
  impl_->blocks.drop_all();
}

void Machine::ask_for_attention() {
  impl_->state.attention.fetch_or(kTrap);
}

std::uint32_t Machine::pc() const {
  return impl_->state.pc;
}

void Machine::set_pc(std::uint32_t pc) {
  impl_->state.pc = pc & kCodeMask;
}

std::uint32_t Machine::word(unsigned reg, unsigned slot) const {
  return impl_->state.registers[reg & 127U][slot & 3U];
}

void Machine::set_word(unsigned reg, unsigned slot, std::uint32_t value) {
  impl_->state.registers[reg & 127U][slot & 3U] = value;
}

std::uint32_t Machine::fpscr(unsigned slot) const {
  return impl_->state.fpscr[slot & 3U];
}

std::uint64_t Machine::instructions() const {
  return impl_->instructions();
}

void Machine::local_store_written(std::uint32_t first, std::uint32_t size) {
  impl_->written.add(first, size);
  impl_->state.attention.fetch_or(kWritten);
}

void Machine::interrupt() {
  impl_->state.attention.fetch_or(kInterrupted);
}

}  // namespace spu_emu::isa
