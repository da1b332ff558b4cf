// Channel instructions, and the interrupts that come from channel 0.
#include "isa/core/channel_access.h"
#include "isa/core/handlers.h"
#include "isa/core/host_float_mode.h"
#include "mfc/spu_channels.h"
#include "spu_emu/channel_numbers.h"

namespace spu_emu::isa {

namespace {

/// Calls the channels for `op`. If they throw, the run is where it was before the instruction.
template <class Call>
auto call_channels(State& state, const Op* op, Call&& call) {
  const HostFloatMode mode(state);
  state.pc = op->pc;
  state.budget -= op->count - 1;
  auto result = call(*state.channels);
  state.budget += op->count - 1;
  return result;
}

std::uint32_t channel_of(const Op* op) {
  return static_cast<std::uint32_t>(op->immediate);
}

const Op* read(State& state, const Op* op) {
  state.set_preferred(op->t, read_channel(state, op, channel_of(op)));
  return go_to(state, op, address_after(op));
}

const Op* count(State& state, const Op* op) {
  state.set_preferred(op->t, count_channel(state, op, channel_of(op)));
  return go_to(state, op, address_after(op));
}

const Op* write(State& state, const Op* op) {
  write_channel(state, op, channel_of(op), state.preferred(op->t));
  return go_to(state, op, address_after(op));
}

constexpr HandlerRow kRows[] = {{"rdch", read}, {"rchcnt", count}, {"wrch", write}};

}  // namespace

// These are apart from the handlers, whose frames have to be gone when they call the next one.

[[gnu::noinline]] std::uint32_t read_channel(State& state, const Op* op, std::uint32_t channel) {
  // The channels know nothing of the SPU's interrupt enable bit.
  if (channel == SPU_RdMachStat) return (state.attention.load() & kInterruptsEnabled) != 0 ? 1 : 0;
  return call_channels(state, op, [&](SpuChannels& channels) { return channels.read(channel); });
}

[[gnu::noinline]] std::uint32_t count_channel(State& state, const Op* op, std::uint32_t channel) {
  return call_channels(state, op, [&](SpuChannels& channels) { return channels.count(channel); });
}

[[gnu::noinline]] void write_channel(State& state, const Op* op, std::uint32_t channel, std::uint32_t value) {
  call_channels(state, op, [&](SpuChannels& channels) {
    channels.write(channel, value);
    return 0;
  });
}

std::uint32_t read_return_address(State& state, const Op* op) {
  return read_channel(state, op, SPU_RdSRR0);
}

bool is_event_waiting(State& state, const Op* op) {
  return count_channel(state, op, SPU_RdEventStat) != 0;
}

void take_interrupt(State& state) {
  const HostFloatMode mode(state);
  if (state.channels->count(SPU_RdEventStat) == 0) return;
  state.channels->write(SPU_WrSRR0, state.pc);
  state.pc = 0;
  state.attention.fetch_and(~std::uint32_t{kInterruptsEnabled});
}

std::span<const HandlerRow> channel_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
