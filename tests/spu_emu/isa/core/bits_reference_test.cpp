// Logic, shifts, shuffles and masks against scalar references.
#include "reference_check.h"

namespace spu_emu::isa {
namespace {

using namespace reference;

TEST(LogicInstructions, WorkOnAllBits) {
  ReferenceCheck spu;
  const auto bit_and = [](u64 a, u64 b) { return a & b; };
  const auto bit_or = [](u64 a, u64 b) { return a | b; };
  const auto bit_xor = [](u64 a, u64 b) { return a ^ b; };
  spu.check("and", of_ab(lanewise<4>(bit_and)));
  spu.check("or", of_ab(lanewise<4>(bit_or)));
  spu.check("xor", of_ab(lanewise<4>(bit_xor)));
  spu.check("andc", of_ab(lanewise<4>([](u64 a, u64 b) { return a & ~b; })));
  spu.check("orc", of_ab(lanewise<4>([](u64 a, u64 b) { return a | ~b; })));
  spu.check("nand", of_ab(lanewise<4>([](u64 a, u64 b) { return ~(a & b); })));
  spu.check("nor", of_ab(lanewise<4>([](u64 a, u64 b) { return ~(a | b); })));
  spu.check("eqv", of_ab(lanewise<4>([](u64 a, u64 b) { return ~(a ^ b); })));
  spu.check("andbi", of_a_and_immediate<1>(lanewise<1>(bit_and)));
  spu.check("andhi", of_a_and_immediate<2>(lanewise<2>(bit_and)));
  spu.check("andi", of_a_and_immediate<4>(lanewise<4>(bit_and)));
  spu.check("orbi", of_a_and_immediate<1>(lanewise<1>(bit_or)));
  spu.check("orhi", of_a_and_immediate<2>(lanewise<2>(bit_or)));
  spu.check("ori", of_a_and_immediate<4>(lanewise<4>(bit_or)));
  spu.check("xorbi", of_a_and_immediate<1>(lanewise<1>(bit_xor)));
  spu.check("xorhi", of_a_and_immediate<2>(lanewise<2>(bit_xor)));
  spu.check("xori", of_a_and_immediate<4>(lanewise<4>(bit_xor)));
  spu.check("selb", of_abt(lanewise<4>([](u64 a, u64 b, u64 t) { return (a & ~t) | (b & t); })));
  spu.check("orx", of_a([](const Register& a) {
              Register r{};
              put<4>(r, 0, lane<4>(a, 0) | lane<4>(a, 1) | lane<4>(a, 2) | lane<4>(a, 3));
              return r;
            }));
}

/// The counts of words and halfwords; those of right shifts are negated.
template <int Width, class F>
auto by_count(unsigned mask, bool negated, F f) {
  return lanewise<Width>([=](u64 a, u64 b) { return f(a, (negated ? 0 - b : b) & mask); });
}

TEST(ShiftInstructions, ShiftAndRotateWordsAndHalfwords) {
  ReferenceCheck spu;
  const auto check_both = [&](const std::string& name, auto half, auto word, const char* suffix = "") {
    spu.check((name + "h" + suffix).c_str(), of_ab(half));
    spu.check((name + suffix).c_str(), of_ab(word));
    spu.check((name + "h" + suffix + "i").c_str(), of_a_and_immediate<2>(half));
    spu.check((name + suffix + "i").c_str(), of_a_and_immediate<4>(word));
  };
  check_both("shl", by_count<2>(31, false, shifted_left<2>), by_count<4>(63, false, shifted_left<4>));
  check_both("rot", by_count<2>(15, false, rotated<2>), by_count<4>(31, false, rotated<4>));
  check_both("rot", by_count<2>(31, true, shifted_right<2>), by_count<4>(63, true, shifted_right<4>), "m");
  const auto half = by_count<2>(31, true, shifted_right_signed<2>);
  const auto word = by_count<4>(63, true, shifted_right_signed<4>);
  spu.check("rotmah", of_ab(half));
  spu.check("rotma", of_ab(word));
  spu.check("rotmahi", of_a_and_immediate<2>(half));
  spu.check("rotmai", of_a_and_immediate<4>(word));
}

/// By the preferred slot of b and by the immediate: f(a, count).
template <class F>
void check_quadword(ReferenceCheck& spu, const std::string& name, F f) {
  spu.check(name.c_str(), of_ab([f](const Register& a, const Register& b) {
              return f(a, static_cast<unsigned>(lane<4>(b, 0)));
            }));
  if (name.ends_with("bybi")) return;
  spu.check((name + "i").c_str(),
            [f](const Operands& o) { return f(o.a, static_cast<unsigned>(o.immediate)); });
}

TEST(ShiftInstructions, ShiftAndRotateQuadwords) {
  ReferenceCheck spu;
  const auto by = [](unsigned count, unsigned mask, unsigned scale) {
    return static_cast<int>((count & mask) * scale);
  };
  check_quadword(spu, "shlqbi", [&](const Register& a, unsigned n) { return moved_left(a, by(n, 7, 1)); });
  check_quadword(spu, "shlqby", [&](const Register& a, unsigned n) { return moved_left(a, by(n, 31, 8)); });
  check_quadword(spu, "shlqbybi",
                 [&](const Register& a, unsigned n) { return moved_left(a, by(n >> 3, 31, 8)); });
  check_quadword(spu, "rotqbi", [&](const Register& a, unsigned n) { return moved_around(a, by(n, 7, 1)); });
  check_quadword(spu, "rotqby", [&](const Register& a, unsigned n) { return moved_around(a, by(n, 15, 8)); });
  check_quadword(spu, "rotqbybi",
                 [&](const Register& a, unsigned n) { return moved_around(a, by(n >> 3, 15, 8)); });
  check_quadword(spu, "rotqmbi",
                 [&](const Register& a, unsigned n) { return moved_left(a, -by(0 - n, 7, 1)); });
  check_quadword(spu, "rotqmby",
                 [&](const Register& a, unsigned n) { return moved_left(a, -by(0 - n, 31, 8)); });
  check_quadword(spu, "rotqmbybi",
                 [&](const Register& a, unsigned n) { return moved_left(a, -by(0 - (n >> 3), 31, 8)); });
}

TEST(ShuffleInstructions, PickGatherAndSpread) {
  ReferenceCheck spu;
  spu.check("shufb", of_abt(shuffled));
  spu.check("gbb", of_a(gathered<1>));
  spu.check("gbh", of_a(gathered<2>));
  spu.check("gb", of_a(gathered<4>));
  spu.check("fsmb", of_a([](const Register& a) { return mask_of<1>(lane<4>(a, 0)); }));
  spu.check("fsmh", of_a([](const Register& a) { return mask_of<2>(lane<4>(a, 0)); }));
  spu.check("fsm", of_a([](const Register& a) { return mask_of<4>(lane<4>(a, 0)); }));
}

/// The identity on shufb's second operand, but for `width` bytes of the first one's preferred slot.
Register insertion(u64 address, unsigned width) {
  Register r{};
  for (unsigned k = 0; k < 16; ++k) r[k] = static_cast<std::uint8_t>(16 + k);
  const auto start = static_cast<unsigned>(address & 15U & ~(width - 1));
  for (unsigned k = 0; k < width; ++k)
    r[start + k] = static_cast<std::uint8_t>((width < 4 ? 4 - width : 0) + k);
  return r;
}

TEST(ShuffleInstructions, MakeMasksForInsertions) {
  ReferenceCheck spu;
  const std::pair<const char*, unsigned> kinds[] = {{"cb", 1}, {"ch", 2}, {"cw", 4}, {"cd", 8}};
  for (const auto& [name, width] : kinds) {
    const unsigned w = width;
    spu.check((std::string(name) + "d").c_str(), [w](const Operands& o) {
      return insertion(lane<4>(o.a, 0) + static_cast<u64>(o.immediate), w);
    });
    spu.check((std::string(name) + "x").c_str(), of_ab([w](const Register& a, const Register& b) {
                return insertion(lane<4>(a, 0) + lane<4>(b, 0), w);
              }));
  }
}

}  // namespace
}  // namespace spu_emu::isa
