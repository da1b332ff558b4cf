// Shifts and rotates: of words, halfwords and bits the intrinsics' functions, of whole bytes by tables.
#include "isa/core/byte_tables.h"
#include "isa/core/handlers.h"
#include "spu_emu/intrinsics/specific_shift.h"

namespace spu_emu::isa {

namespace {

constexpr auto kRotate = make_controls<16>([](unsigned k, unsigned count) { return (k + count) & 15U; });
constexpr auto kLeft = make_controls<32>([](unsigned k, unsigned count) { return k + count; });
/// Byte k comes from k - count; a negative number is one far above 15.
constexpr auto kRight = make_controls<32>([](unsigned k, unsigned count) { return k - count; });

qword moved(qword bytes, const Bytes& control) {
  return static_cast<qword>(
      (vec_uint4)_mm_shuffle_epi8((__m128i) static_cast<vec_uint4>(bytes), (__m128i)control.vector()));
}

qword rotate(qword bytes, std::uint32_t count) {
  return moved(bytes, kRotate[count & 15U]);
}
qword left(qword bytes, std::uint32_t count) {
  return moved(bytes, kLeft[count & 31U]);
}
/// The count is given negated, as the instructions do.
qword right(qword bytes, std::uint32_t count) {
  return moved(bytes, kRight[(0U - count) & 31U]);
}

/// By the preferred slot of b, which counts bytes, or bits in the forms whose names end with "bi".
template <auto F>
const Op* by_register(State& state, const Op* op) {
  state.at(op->t) = F(state.at(op->a), state.preferred(op->b));
  return go_on(state, op);
}
template <auto F>
const Op* by_register_of_bits(State& state, const Op* op) {
  state.at(op->t) = F(state.at(op->a), state.preferred(op->b) >> 3U);
  return go_on(state, op);
}
template <auto F>
const Op* by_immediate(State& state, const Op* op) {
  state.at(op->t) = F(state.at(op->a), static_cast<std::uint32_t>(op->immediate));
  return go_on(state, op);
}

constexpr HandlerRow kRows[] = {
    {"shlh", binary<si_shlh>},
    {"shl", binary<si_shl>},
    {"roth", binary<si_roth>},
    {"rot", binary<si_rot>},
    {"rothm", binary<si_rothm>},
    {"rotm", binary<si_rotm>},
    {"rotmah", binary<si_rotmah>},
    {"rotma", binary<si_rotma>},
    {"shlqbi", binary<si_shlqbi>},
    {"rotqbi", binary<si_rotqbi>},
    {"rotqmbi", binary<si_rotqmbi>},
    {"shlhi", with_immediate<si_shlhi>},
    {"shli", with_immediate<si_shli>},
    {"rothi", with_immediate<si_rothi>},
    {"roti", with_immediate<si_roti>},
    {"rothmi", with_immediate<si_rothmi>},
    {"rotmi", with_immediate<si_rotmi>},
    {"rotmahi", with_immediate<si_rotmahi>},
    {"rotmai", with_immediate<si_rotmai>},
    {"shlqbii", with_immediate<si_shlqbii>},
    {"rotqbii", with_immediate<si_rotqbii>},
    {"rotqmbii", with_immediate<si_rotqmbii>},
    {"shlqby", by_register<left>},
    {"rotqby", by_register<rotate>},
    {"rotqmby", by_register<right>},
    {"shlqbybi", by_register_of_bits<left>},
    {"rotqbybi", by_register_of_bits<rotate>},
    {"rotqmbybi", by_register_of_bits<right>},
    {"shlqbyi", by_immediate<left>},
    {"rotqbyi", by_immediate<rotate>},
    {"rotqmbyi", by_immediate<right>},
};

}  // namespace

std::span<const HandlerRow> shift_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
