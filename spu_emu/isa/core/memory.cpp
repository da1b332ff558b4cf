// Loads and stores of quadwords. Addresses wrap and are cut down to a multiple of 16.
#include "isa/core/block_cache.h"
#include "isa/core/handlers.h"

namespace spu_emu::isa {

namespace {

/// Between the SPU's bytes and words of the host; its own inverse.
vec_uint4 swapped(vec_uint4 words) {
  return (vec_uint4)spu_emu::detail::reverse_lanes<4>((__m128i)words);
}

// Whole quadwords are read and written back where a program means a part of one, so bytes of them may be
// forbidden to AddressSanitizer: those of a transfer in flight.
__attribute__((no_sanitize("address"))) vec_uint4 quadword(const std::byte* address) {
  return *reinterpret_cast<const vec_uint4*>(address);
}

__attribute__((no_sanitize("address"))) void set_quadword(std::byte* address, vec_uint4 words) {
  *reinterpret_cast<vec_uint4*>(address) = words;
}

std::uint32_t displaced(State& state, const Op* op) {
  return (state.preferred(op->a) + static_cast<std::uint32_t>(op->immediate)) & kQuadwordMask;
}

std::uint32_t indexed(State& state, const Op* op) {
  return (state.preferred(op->a) + state.preferred(op->b)) & kQuadwordMask;
}

/// A PC-relative address is one already, too.
std::uint32_t absolute(State&, const Op* op) {
  return static_cast<std::uint32_t>(op->immediate) & kQuadwordMask;
}

template <auto Address>
const Op* load(State& state, const Op* op) {
  const std::uint32_t address = Address(state, op);
  state.at(op->t) = static_cast<qword>(swapped(quadword(state.store + address)));
  return go_on(state, op);
}

/// Instructions were written: what was decoded of them is dropped, with it perhaps the rest of this block.
[[gnu::noinline, gnu::cold]] const Op* leave_after_writing_code(State& state, const Op* op,
                                                                std::uint32_t address) {
  state.blocks->drop(address, 16);
  return leave(state, op, address_after(op));
}

template <auto Address>
const Op* store(State& state, const Op* op) {
  const std::uint32_t address = Address(state, op);
  set_quadword(state.store + address, swapped(static_cast<vec_uint4>(state.at(op->t))));
  if ((*state.code)[address / 16] != 0) [[unlikely]]
    return leave_after_writing_code(state, op, address);
  return go_on(state, op);
}

constexpr HandlerRow kRows[] = {
    {"lqd", load<displaced>},  {"lqx", load<indexed>},     {"lqa", load<absolute>},
    {"lqr", load<absolute>},   {"stqd", store<displaced>}, {"stqx", store<indexed>},
    {"stqa", store<absolute>}, {"stqr", store<absolute>},
};

}  // namespace

std::span<const HandlerRow> memory_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
