// Integer compares: the functions are the intrinsics'.
#include "isa/core/handlers.h"
#include "spu_emu/intrinsics/specific_compare.h"

namespace spu_emu::isa {

namespace {
constexpr HandlerRow kRows[] = {
    {"ceqb", binary<si_ceqb>},
    {"ceqh", binary<si_ceqh>},
    {"ceq", binary<si_ceq>},
    {"cgtb", binary<si_cgtb>},
    {"cgth", binary<si_cgth>},
    {"cgt", binary<si_cgt>},
    {"clgtb", binary<si_clgtb>},
    {"clgth", binary<si_clgth>},
    {"clgt", binary<si_clgt>},
    {"ceqbi", with_immediate<si_ceqbi>},
    {"ceqhi", with_immediate<si_ceqhi>},
    {"ceqi", with_immediate<si_ceqi>},
    {"cgtbi", with_immediate<si_cgtbi>},
    {"cgthi", with_immediate<si_cgthi>},
    {"cgti", with_immediate<si_cgti>},
    {"clgtbi", with_immediate<si_clgtbi>},
    {"clgthi", with_immediate<si_clgthi>},
    {"clgti", with_immediate<si_clgti>},
};
}  // namespace

std::span<const HandlerRow> compare_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
