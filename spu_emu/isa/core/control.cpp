// Stops, halts, special registers, and what is no instruction.
#include "isa/core/handlers.h"
#include "isa/core/host_float_mode.h"
#include "isa/core/instruction_observer.h"
#include "isa/core/instruction_traps.h"

namespace spu_emu::isa {

namespace {

/// stopd has no field for a code; the hardware reports this one.
constexpr std::uint32_t kStopdCode = 0x3fff;

const Op* end_run(State& state, const Op* op, Exit exit, std::uint32_t pc) {
  state.exit = exit;
  return leave(state, op, pc);
}

const Op* stop(State& state, const Op* op) {
  state.stop_code = static_cast<std::uint32_t>(op->immediate);
  return end_run(state, op, Exit::stop, address_after(op));
}

const Op* stop_with_dependencies(State& state, const Op* op) {
  state.stop_code = kStopdCode;
  return end_run(state, op, Exit::stop, address_after(op));
}

bool is_equal(std::uint32_t a, std::uint32_t b) {
  return a == b;
}
bool is_greater(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::int32_t>(a) > static_cast<std::int32_t>(b);
}
bool is_greater_unsigned(std::uint32_t a, std::uint32_t b) {
  return a > b;
}

template <auto Condition>
const Op* halt_if(State& state, const Op* op) {
  if (Condition(state.preferred(op->a), state.preferred(op->b)))
    return end_run(state, op, Exit::halt, op->pc);
  return go_on(state, op);
}

template <auto Condition>
const Op* halt_if_immediate(State& state, const Op* op) {
  if (Condition(state.preferred(op->a), static_cast<std::uint32_t>(op->immediate)))
    return end_run(state, op, Exit::halt, op->pc);
  return go_on(state, op);
}

/// The SPU of a Cell has no special-purpose register that a program could use; all read as zero.
const Op* move_from_special(State& state, const Op* op) {
  state.set_preferred(op->t, 0);
  return go_on(state, op);
}

/// Apart from its handler, whose frame has to be gone when it calls the next one. Meanwhile the run is where
/// it is before the instruction.
[[gnu::noinline]] bool come_to_trap(State& state, const Op* op) {
  const HostFloatMode mode(state);
  state.pc = op->pc;
  state.budget -= op->count - 1;
  if (!state.traps->come(op->pc)) return false;
  state.budget += op->count - 1;
  return true;
}

constexpr HandlerRow kRows[] = {
    {"stop", stop},
    {"stopd", stop_with_dependencies},
    {"heq", halt_if<is_equal>},
    {"hgt", halt_if<is_greater>},
    {"hlgt", halt_if<is_greater_unsigned>},
    {"heqi", halt_if_immediate<is_equal>},
    {"hgti", halt_if_immediate<is_greater>},
    {"hlgti", halt_if_immediate<is_greater_unsigned>},
    {"mfspr", move_from_special},
};

}  // namespace

const Op* execute_illegal(State& state, const Op* op) {
  // It is not executed, so it does not count.
  ++state.budget;
  return end_run(state, op, Exit::illegal, op->pc);
}

const Op* execute_end_of_block(State& state, const Op* op) {
  return go_to(state, op, op->pc);
}

const Op* execute_observation(State& state, const Op* op) {
  state.observer->begin(op->pc, state);
  return go_on(state, op);
}

const Op* execute_trap(State& state, const Op* op) {
  return come_to_trap(state, op) ? go_on(state, op) : nullptr;
}

std::span<const HandlerRow> control_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
