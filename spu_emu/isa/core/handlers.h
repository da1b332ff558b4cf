/// @file
/// Makes handlers of functions on registers, and lists the handlers of every class of instructions.
#ifndef SPU_EMU_ISA_CORE_HANDLERS_H
#define SPU_EMU_ISA_CORE_HANDLERS_H

#include <span>

#include "isa/core/state.h"

namespace spu_emu::isa {

/// Which handler executes the instruction of a name.
struct HandlerRow {
  const char* mnemonic;
  Handler handler;
};

std::span<const HandlerRow> integer_handlers();
std::span<const HandlerRow> logical_handlers();
std::span<const HandlerRow> shift_handlers();
std::span<const HandlerRow> compare_handlers();
std::span<const HandlerRow> shuffle_handlers();
std::span<const HandlerRow> memory_handlers();
std::span<const HandlerRow> float_single_handlers();
std::span<const HandlerRow> float_double_handlers();
std::span<const HandlerRow> branch_handlers();
std::span<const HandlerRow> channel_handlers();
std::span<const HandlerRow> control_handlers();

/// For words that encode no instruction, and for the end of a block that runs on into the next.
const Op* execute_illegal(State& state, const Op* op);
const Op* execute_end_of_block(State& state, const Op* op);

/// Tells State::observer of the instruction whose Op follows, if it has one.
const Op* execute_observation(State& state, const Op* op);

/// Asks State::traps before the instruction whose Op follows.
const Op* execute_trap(State& state, const Op* op);

/// t = F(a)
template <auto F>
const Op* unary(State& state, const Op* op) {
  state.at(op->t) = F(state.at(op->a));
  return go_on(state, op);
}

/// t = F(a, b)
template <auto F>
const Op* binary(State& state, const Op* op) {
  state.at(op->t) = F(state.at(op->a), state.at(op->b));
  return go_on(state, op);
}

/// t = F(a, b, t)
template <auto F>
const Op* accumulating(State& state, const Op* op) {
  state.at(op->t) = F(state.at(op->a), state.at(op->b), state.at(op->t));
  return go_on(state, op);
}

/// c = F(a, b, t), the form with four registers
template <auto F>
const Op* ternary(State& state, const Op* op) {
  state.at(op->c) = F(state.at(op->a), state.at(op->b), state.at(op->t));
  return go_on(state, op);
}

/// t = F(immediate)
template <auto F>
const Op* constant(State& state, const Op* op) {
  state.at(op->t) = F(op->immediate);
  return go_on(state, op);
}

/// t = F(a, immediate)
template <auto F>
const Op* with_immediate(State& state, const Op* op) {
  state.at(op->t) = F(state.at(op->a), op->immediate);
  return go_on(state, op);
}

/// t = F(t, immediate)
template <auto F>
const Op* into_target(State& state, const Op* op) {
  state.at(op->t) = F(state.at(op->t), op->immediate);
  return go_on(state, op);
}

}  // namespace spu_emu::isa

#endif
