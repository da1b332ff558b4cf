// Branches: relative, absolute, to a register's address, on a condition, from interrupts and on events.
#include "isa/core/channel_access.h"
#include "isa/core/handlers.h"

namespace spu_emu::isa {

namespace {

/// What a branch to a register's address does with interrupts, by the bits of the instruction.
constexpr std::int32_t kEnable = 1;
constexpr std::int32_t kDisable = 2;

std::uint32_t address_in(State& state, std::uint16_t reg) {
  return state.preferred(reg) & kCodeMask;
}

std::uint32_t immediate_address(const Op* op) {
  return static_cast<std::uint32_t>(op->immediate);
}

/// Neither bit, and both, leave interrupts as they are.
void switch_interrupts(State& state, std::int32_t bits) {
  if (bits == kEnable) state.attention.fetch_or(kInterruptsEnabled);
  if (bits == kDisable) state.attention.fetch_and(~std::uint32_t{kInterruptsEnabled});
}

const Op* go_to_register(State& state, const Op* op, std::uint32_t target) {
  if (op->immediate != 0) [[unlikely]]
    switch_interrupts(state, op->immediate);
  return go_to(state, op, target);
}

const Op* branch(State& state, const Op* op) {
  return go_to(state, op, immediate_address(op));
}

const Op* branch_and_link(State& state, const Op* op) {
  state.set_preferred(op->t, address_after(op));
  return go_to(state, op, immediate_address(op));
}

bool is_zero(std::uint32_t value) {
  return value == 0;
}
bool is_not_zero(std::uint32_t value) {
  return value != 0;
}
bool is_half_zero(std::uint32_t value) {
  return (value & 0xffffU) == 0;
}
bool is_half_not_zero(std::uint32_t value) {
  return (value & 0xffffU) != 0;
}

template <auto Condition>
const Op* branch_if(State& state, const Op* op) {
  if (Condition(state.preferred(op->t))) return go_to(state, op, immediate_address(op));
  return go_on(state, op);
}

template <auto Condition>
const Op* branch_to_register_if(State& state, const Op* op) {
  if (Condition(state.preferred(op->t))) return go_to_register(state, op, address_in(state, op->a));
  return go_on(state, op);
}

const Op* branch_to_register(State& state, const Op* op) {
  return go_to_register(state, op, address_in(state, op->a));
}

const Op* branch_to_register_and_link(State& state, const Op* op) {
  const std::uint32_t target = address_in(state, op->a);
  state.set_preferred(op->t, address_after(op));
  return go_to_register(state, op, target);
}

const Op* return_from_interrupt(State& state, const Op* op) {
  const std::uint32_t target = read_return_address(state, op) & kCodeMask;
  return go_to_register(state, op, target);
}

/// Links always, but goes to the register's address only when an event is waiting.
const Op* branch_on_event(State& state, const Op* op) {
  const bool taken = is_event_waiting(state, op);
  const std::uint32_t target = address_in(state, op->a);
  state.set_preferred(op->t, address_after(op));
  return taken ? go_to_register(state, op, target) : go_to(state, op, address_after(op));
}

constexpr HandlerRow kRows[] = {
    {"br", branch},
    {"bra", branch},
    {"brsl", branch_and_link},
    {"brasl", branch_and_link},
    {"brz", branch_if<is_zero>},
    {"brnz", branch_if<is_not_zero>},
    {"brhz", branch_if<is_half_zero>},
    {"brhnz", branch_if<is_half_not_zero>},
    {"bi", branch_to_register},
    {"bisl", branch_to_register_and_link},
    {"iret", return_from_interrupt},
    {"bisled", branch_on_event},
    {"biz", branch_to_register_if<is_zero>},
    {"binz", branch_to_register_if<is_not_zero>},
    {"bihz", branch_to_register_if<is_half_zero>},
    {"bihnz", branch_to_register_if<is_half_not_zero>},
};

}  // namespace

std::span<const HandlerRow> branch_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
