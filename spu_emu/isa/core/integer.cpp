// Integer arithmetic and constants: the functions are the intrinsics'.
#include "isa/core/handlers.h"
#include "spu_emu/intrinsics/specific_bytes.h"
#include "spu_emu/intrinsics/specific_integer.h"

namespace spu_emu::isa {

namespace {
constexpr HandlerRow kRows[] = {
    {"ilh", constant<si_ilh>},
    {"ilhu", constant<si_ilhu>},
    {"il", constant<si_il>},
    {"ila", constant<si_ila>},
    {"iohl", into_target<si_iohl>},
    {"ah", binary<si_ah>},
    {"a", binary<si_a>},
    {"sfh", binary<si_sfh>},
    {"sf", binary<si_sf>},
    {"cg", binary<si_cg>},
    {"bg", binary<si_bg>},
    {"mpy", binary<si_mpy>},
    {"mpyu", binary<si_mpyu>},
    {"mpyh", binary<si_mpyh>},
    {"mpys", binary<si_mpys>},
    {"mpyhh", binary<si_mpyhh>},
    {"mpyhhu", binary<si_mpyhhu>},
    {"avgb", binary<si_avgb>},
    {"absdb", binary<si_absdb>},
    {"sumb", binary<si_sumb>},
    {"addx", accumulating<si_addx>},
    {"cgx", accumulating<si_cgx>},
    {"sfx", accumulating<si_sfx>},
    {"bgx", accumulating<si_bgx>},
    {"mpyhha", accumulating<si_mpyhha>},
    {"mpyhhau", accumulating<si_mpyhhau>},
    {"ahi", with_immediate<si_ahi>},
    {"ai", with_immediate<si_ai>},
    {"sfhi", with_immediate<si_sfhi>},
    {"sfi", with_immediate<si_sfi>},
    {"mpyi", with_immediate<si_mpyi>},
    {"mpyui", with_immediate<si_mpyui>},
    {"mpya", ternary<si_mpya>},
    {"clz", unary<si_clz>},
    {"xsbh", unary<si_xsbh>},
    {"xshw", unary<si_xshw>},
    {"xswd", unary<si_xswd>},
    {"cntb", unary<si_cntb>},
};
}  // namespace

std::span<const HandlerRow> integer_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
