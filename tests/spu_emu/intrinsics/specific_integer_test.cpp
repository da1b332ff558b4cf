#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

// Immediates are sign-extended to the lane.
template <int Width, typename F>
auto immediate_lanewise(F f) {
  return with_splat<Width>(lanewise<Width>(f));
}

TEST(SpecificInteger, AddsAndSubtractsFromTheSecondOperand) {
  check<qword, qword>(
      "si_ah", [](qword a, qword b) { return si_ah(a, b); }, lanewise<2>([](u64 a, u64 b) { return a + b; }));
  check<qword, int>(
      "si_ahi", [](qword a, int n) { return si_ahi(a, n); },
      immediate_lanewise<2>([](u64 a, u64 b) { return a + b; }));
  check<qword, qword>(
      "si_sfh", [](qword a, qword b) { return si_sfh(a, b); },
      lanewise<2>([](u64 a, u64 b) { return b - a; }));
  check<qword, int>(
      "si_sfhi", [](qword a, int n) { return si_sfhi(a, n); },
      immediate_lanewise<2>([](u64 a, u64 b) { return b - a; }));
  check<qword, qword>(
      "si_a", [](qword a, qword b) { return si_a(a, b); }, lanewise<4>([](u64 a, u64 b) { return a + b; }));
  check<qword, int>(
      "si_ai", [](qword a, int n) { return si_ai(a, n); },
      immediate_lanewise<4>([](u64 a, u64 b) { return a + b; }));
  check<qword, qword>(
      "si_sf", [](qword a, qword b) { return si_sf(a, b); }, lanewise<4>([](u64 a, u64 b) { return b - a; }));
  check<qword, int>(
      "si_sfi", [](qword a, int n) { return si_sfi(a, n); },
      immediate_lanewise<4>([](u64 a, u64 b) { return b - a; }));
}

TEST(SpecificInteger, CarriesAndBorrows) {
  check<qword, qword, qword>(
      "si_addx", [](qword a, qword b, qword c) { return si_addx(a, b, c); },
      lanewise<4>([](u64 a, u64 b, u64 c) { return a + b + (c & 1); }));
  check<qword, qword>(
      "si_cg", [](qword a, qword b) { return si_cg(a, b); },
      lanewise<4>([](u64 a, u64 b) { return (a + b) >> 32; }));
  check<qword, qword, qword>(
      "si_cgx", [](qword a, qword b, qword c) { return si_cgx(a, b, c); },
      lanewise<4>([](u64 a, u64 b, u64 c) { return (a + b + (c & 1)) >> 32; }));
  check<qword, qword, qword>(
      "si_sfx", [](qword a, qword b, qword c) { return si_sfx(a, b, c); },
      lanewise<4>([](u64 a, u64 b, u64 c) { return b - a - 1 + (c & 1); }));
  check<qword, qword>(
      "si_bg", [](qword a, qword b) { return si_bg(a, b); },
      lanewise<4>([](u64 a, u64 b) { return b >= a ? 1 : 0; }));
  check<qword, qword, qword>(
      "si_bgx", [](qword a, qword b, qword c) { return si_bgx(a, b, c); },
      lanewise<4>([](u64 a, u64 b, u64 c) { return (b + (0xffffffff - a) + (c & 1)) >> 32; }));
}

TEST(SpecificInteger, MultipliesHalfwords) {
  const auto product = [](auto p) { return p; };
  const auto plus = [](auto p, auto c) { return p + c; };
  check<qword, qword>(
      "si_mpy", [](qword a, qword b) { return si_mpy(a, b); }, halfword_products(1, 1, product));
  check<qword, qword>(
      "si_mpyu", [](qword a, qword b) { return si_mpyu(a, b); }, unsigned_halfword_products(1, 1, product));
  check<qword, int>(
      "si_mpyi", [](qword a, int n) { return si_mpyi(a, n); },
      with_splat<4>(halfword_products(1, 1, product)));
  check<qword, int>(
      "si_mpyui", [](qword a, int n) { return si_mpyui(a, n); },
      with_splat<4>(unsigned_halfword_products(1, 1, product)));
  check<qword, qword, qword>(
      "si_mpya", [](qword a, qword b, qword c) { return si_mpya(a, b, c); }, halfword_products(1, 1, plus));
  check<qword, qword>(
      "si_mpyh", [](qword a, qword b) { return si_mpyh(a, b); },
      halfword_products(0, 1, [](s64 p) { return static_cast<u64>(p) << 16; }));
  check<qword, qword>(
      "si_mpys", [](qword a, qword b) { return si_mpys(a, b); },
      halfword_products(1, 1, [](s64 p) { return p >> 16; }));
  check<qword, qword>(
      "si_mpyhh", [](qword a, qword b) { return si_mpyhh(a, b); }, halfword_products(0, 0, product));
  check<qword, qword>(
      "si_mpyhhu", [](qword a, qword b) { return si_mpyhhu(a, b); },
      unsigned_halfword_products(0, 0, product));
  check<qword, qword, qword>(
      "si_mpyhha", [](qword a, qword b, qword c) { return si_mpyhha(a, b, c); },
      halfword_products(0, 0, plus));
  check<qword, qword, qword>(
      "si_mpyhhau", [](qword a, qword b, qword c) { return si_mpyhhau(a, b, c); },
      unsigned_halfword_products(0, 0, plus));
}

TEST(SpecificInteger, LoadsImmediates) {
  check<int>(
      "si_ilh", [](int n) { return si_ilh(n); },
      [](int i) {
        const s64 n = i;
        return build<2>([&](int) { return n; });
      });
  check<int>(
      "si_ilhu", [](int n) { return si_ilhu(n); },
      [](int i) {
        const s64 n = i;
        return build<4>([&](int) { return static_cast<u64>(n) << 16; });
      });
  check<int>(
      "si_il", [](int n) { return si_il(n); },
      [](int i) {
        const s64 n = i;
        return build<4>([&](int) { return static_cast<std::int16_t>(n); });
      });
  check<int>(
      "si_ila", [](int n) { return si_ila(n); },
      [](int i) {
        const s64 n = i;
        return build<4>([&](int) { return n & 0x3ffff; });
      });
  check<qword, int>(
      "si_iohl", [](qword a, int n) { return si_iohl(a, n); },
      [](const Register& a, int n) {
        return build<4>([&](int i) { return lane<4>(a, i) | (static_cast<u64>(n) & 0xffff); });
      });
}

}  // namespace
