// Shuffles, masks and gathered bits: the functions are the intrinsics' but for the masks of insertions.
#include "isa/core/byte_tables.h"
#include "isa/core/handlers.h"
#include "spu_emu/intrinsics/specific_bytes.h"

namespace spu_emu::isa {

namespace {

template <unsigned Width>
constexpr std::array<Bytes, 16> kInsertions = make_insertions(Width);

template <unsigned Width>
const Op* insert_displaced(State& state, const Op* op) {
  const std::uint32_t address = state.preferred(op->a) + static_cast<std::uint32_t>(op->immediate);
  state.at(op->t) = kInsertions<Width>[address & 15U].words();
  return go_on(state, op);
}

template <unsigned Width>
const Op* insert_indexed(State& state, const Op* op) {
  const std::uint32_t address = state.preferred(op->a) + state.preferred(op->b);
  state.at(op->t) = kInsertions<Width>[address & 15U].words();
  return go_on(state, op);
}

constexpr HandlerRow kRows[] = {
    {"shufb", ternary<si_shufb>}, {"fsmb", unary<si_fsmb>},      {"fsmh", unary<si_fsmh>},
    {"fsm", unary<si_fsm>},       {"gbb", unary<si_gbb>},        {"gbh", unary<si_gbh>},
    {"gb", unary<si_gb>},         {"fsmbi", constant<si_fsmbi>}, {"cbd", insert_displaced<1>},
    {"chd", insert_displaced<2>}, {"cwd", insert_displaced<4>},  {"cdd", insert_displaced<8>},
    {"cbx", insert_indexed<1>},   {"chx", insert_indexed<2>},    {"cwx", insert_indexed<4>},
    {"cdx", insert_indexed<8>},
};

}  // namespace

std::span<const HandlerRow> shuffle_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
