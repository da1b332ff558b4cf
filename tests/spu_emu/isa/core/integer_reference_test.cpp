// Integer instructions against scalar references.
#include "reference_check.h"

namespace spu_emu::isa {
namespace {

using namespace reference;

constexpr u64 kWord = 0xffffffff;

TEST(IntegerInstructions, AddAndSubtractWithCarries) {
  ReferenceCheck spu;
  spu.check("ah", of_ab(lanewise<2>([](u64 a, u64 b) { return a + b; })));
  spu.check("a", of_ab(lanewise<4>([](u64 a, u64 b) { return a + b; })));
  spu.check("sfh", of_ab(lanewise<2>([](u64 a, u64 b) { return b - a; })));
  spu.check("sf", of_ab(lanewise<4>([](u64 a, u64 b) { return b - a; })));
  spu.check("ahi", of_a_and_immediate<2>(lanewise<2>([](u64 a, u64 b) { return a + b; })));
  spu.check("ai", of_a_and_immediate<4>(lanewise<4>([](u64 a, u64 b) { return a + b; })));
  spu.check("sfhi", of_a_and_immediate<2>(lanewise<2>([](u64 a, u64 b) { return b - a; })));
  spu.check("sfi", of_a_and_immediate<4>(lanewise<4>([](u64 a, u64 b) { return b - a; })));
  spu.check("addx", of_abt(lanewise<4>([](u64 a, u64 b, u64 t) { return a + b + (t & 1); })));
  spu.check("sfx", of_abt(lanewise<4>([](u64 a, u64 b, u64 t) { return b + (~a & kWord) + (t & 1); })));
  spu.check("cg", of_ab(lanewise<4>([](u64 a, u64 b) { return (a + b) >> 32; })));
  spu.check("bg", of_ab(lanewise<4>([](u64 a, u64 b) { return b >= a ? 1 : 0; })));
  spu.check("cgx", of_abt(lanewise<4>([](u64 a, u64 b, u64 t) { return (a + b + (t & 1)) >> 32; })));
  spu.check("bgx",
            of_abt(lanewise<4>([](u64 a, u64 b, u64 t) { return (b + (~a & kWord) + (t & 1)) >> 32; })));
}

TEST(IntegerInstructions, MultiplyHalfwords) {
  ReferenceCheck spu;
  const auto product = [](s64 p) { return p; };
  const auto unsigned_product = [](u64 p) { return p; };
  const auto sum = [](auto p, auto t) { return static_cast<u64>(p) + static_cast<u64>(t); };
  spu.check("mpy", of_ab(halfword_products(1, 1, product)));
  spu.check("mpyu", of_ab(unsigned_halfword_products(1, 1, unsigned_product)));
  spu.check("mpyh", of_ab(halfword_products(0, 1, [](s64 p) { return static_cast<u64>(p) << 16; })));
  spu.check("mpys", of_ab(halfword_products(1, 1, [](s64 p) { return p >> 16; })));
  spu.check("mpyhh", of_ab(halfword_products(0, 0, product)));
  spu.check("mpyhhu", of_ab(unsigned_halfword_products(0, 0, unsigned_product)));
  spu.check("mpyhha", of_abt(halfword_products(0, 0, sum)));
  spu.check("mpyhhau", of_abt(unsigned_halfword_products(0, 0, sum)));
  spu.check("mpya", of_abt(halfword_products(1, 1, sum)));
  spu.check("mpyi", of_a_and_immediate<2>(halfword_products(1, 1, product)));
  spu.check("mpyui", of_a_and_immediate<2>(unsigned_halfword_products(1, 1, unsigned_product)));
}

TEST(IntegerInstructions, CountExtendAndSumBytes) {
  ReferenceCheck spu;
  spu.check("clz", of_a(lanewise<4>(leading_zeros32)));
  spu.check("cntb", of_a(lanewise<1>(ones_in)));
  spu.check("xsbh", of_a([](const Register& a) {
              return build<2>([&](int i) { return signed_lane<1>(a, 2 * i + 1); });
            }));
  spu.check("xshw", of_a([](const Register& a) {
              return build<4>([&](int i) { return signed_lane<2>(a, 2 * i + 1); });
            }));
  spu.check("xswd", of_a([](const Register& a) {
              return build<8>([&](int i) { return signed_lane<4>(a, 2 * i + 1); });
            }));
  spu.check("avgb", of_ab(lanewise<1>([](u64 a, u64 b) { return (a + b + 1) >> 1; })));
  spu.check("absdb", of_ab(lanewise<1>([](u64 a, u64 b) { return a > b ? a - b : b - a; })));
  const auto bytes_of = [](const Register& r, int word) {
    return lane<1>(r, 4 * word) + lane<1>(r, 4 * word + 1) + lane<1>(r, 4 * word + 2) +
           lane<1>(r, 4 * word + 3);
  };
  spu.check("sumb", of_ab([&](const Register& a, const Register& b) {
              return build<2>([&](int i) { return bytes_of(i % 2 == 0 ? b : a, i / 2); });
            }));
}

TEST(IntegerInstructions, LoadConstants) {
  ReferenceCheck spu;
  const auto constant = [](auto f) {
    return [f](const Operands& o) { return build<4>([&](int) { return f(static_cast<u64>(o.immediate)); }); };
  };
  spu.check("ilh", constant([](u64 i) { return (i & 0xffff) << 16 | (i & 0xffff); }));
  spu.check("ilhu", constant([](u64 i) { return i << 16; }));
  spu.check("il", constant([](u64 i) { return i; }));
  spu.check("ila", constant([](u64 i) { return i; }));
  spu.check("iohl", [](const Operands& o) {
    return lanewise<4>([&](u64 t) { return t | (static_cast<u64>(o.immediate) & 0xffff); })(o.t);
  });
  spu.check("fsmbi", [](const Operands& o) { return mask_of<1>(static_cast<u64>(o.immediate)); });
}

TEST(IntegerInstructions, Compare) {
  ReferenceCheck spu;
  const auto equal = [](auto a, auto b) { return all_ones(a == b); };
  const auto greater = [](auto a, auto b) { return all_ones(a > b); };
  spu.check("ceqb", of_ab(lanewise<1>(equal)));
  spu.check("ceqh", of_ab(lanewise<2>(equal)));
  spu.check("ceq", of_ab(lanewise<4>(equal)));
  spu.check("cgtb", of_ab(signed_lanewise<1>(greater)));
  spu.check("cgth", of_ab(signed_lanewise<2>(greater)));
  spu.check("cgt", of_ab(signed_lanewise<4>(greater)));
  spu.check("clgtb", of_ab(lanewise<1>(greater)));
  spu.check("clgth", of_ab(lanewise<2>(greater)));
  spu.check("clgt", of_ab(lanewise<4>(greater)));
  spu.check("ceqbi", of_a_and_immediate<1>(lanewise<1>(equal)));
  spu.check("ceqhi", of_a_and_immediate<2>(lanewise<2>(equal)));
  spu.check("ceqi", of_a_and_immediate<4>(lanewise<4>(equal)));
  spu.check("cgtbi", of_a_and_immediate<1>(signed_lanewise<1>(greater)));
  spu.check("cgthi", of_a_and_immediate<2>(signed_lanewise<2>(greater)));
  spu.check("cgti", of_a_and_immediate<4>(signed_lanewise<4>(greater)));
  spu.check("clgtbi", of_a_and_immediate<1>(lanewise<1>(greater)));
  spu.check("clgthi", of_a_and_immediate<2>(lanewise<2>(greater)));
  spu.check("clgti", of_a_and_immediate<4>(lanewise<4>(greater)));
}

}  // namespace
}  // namespace spu_emu::isa
