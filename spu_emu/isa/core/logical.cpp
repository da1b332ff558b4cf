// Bitwise logic: the functions are the intrinsics'.
#include "isa/core/handlers.h"
#include "spu_emu/intrinsics/specific_bytes.h"

namespace spu_emu::isa {

namespace {
constexpr HandlerRow kRows[] = {
    {"and", binary<si_and>},
    {"andc", binary<si_andc>},
    {"or", binary<si_or>},
    {"orc", binary<si_orc>},
    {"xor", binary<si_xor>},
    {"nand", binary<si_nand>},
    {"nor", binary<si_nor>},
    {"eqv", binary<si_eqv>},
    {"andbi", with_immediate<si_andbi>},
    {"andhi", with_immediate<si_andhi>},
    {"andi", with_immediate<si_andi>},
    {"orbi", with_immediate<si_orbi>},
    {"orhi", with_immediate<si_orhi>},
    {"ori", with_immediate<si_ori>},
    {"xorbi", with_immediate<si_xorbi>},
    {"xorhi", with_immediate<si_xorhi>},
    {"xori", with_immediate<si_xori>},
    {"orx", unary<si_orx>},
    {"selb", ternary<si_selb>},
};
}  // namespace

std::span<const HandlerRow> logical_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
