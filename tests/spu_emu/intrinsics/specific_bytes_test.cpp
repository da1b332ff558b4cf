#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

// Immediates are sign-extended to the lane.
template <int Width, typename F>
auto immediate_lanewise(F f) {
  return with_splat<Width>(lanewise<Width>(f));
}

TEST(SpecificLogic, CombinesBits) {
  check<qword, qword>(
      "si_and", [](qword a, qword b) { return si_and(a, b); },
      lanewise<8>([](u64 a, u64 b) { return a & b; }));
  check<qword, qword>(
      "si_andc", [](qword a, qword b) { return si_andc(a, b); },
      lanewise<8>([](u64 a, u64 b) { return a & ~b; }));
  check<qword, qword>(
      "si_eqv", [](qword a, qword b) { return si_eqv(a, b); },
      lanewise<8>([](u64 a, u64 b) { return ~(a ^ b); }));
  check<qword, qword>(
      "si_nand", [](qword a, qword b) { return si_nand(a, b); },
      lanewise<8>([](u64 a, u64 b) { return ~(a & b); }));
  check<qword, qword>(
      "si_nor", [](qword a, qword b) { return si_nor(a, b); },
      lanewise<8>([](u64 a, u64 b) { return ~(a | b); }));
  check<qword, qword>(
      "si_or", [](qword a, qword b) { return si_or(a, b); }, lanewise<8>([](u64 a, u64 b) { return a | b; }));
  check<qword, qword>(
      "si_orc", [](qword a, qword b) { return si_orc(a, b); },
      lanewise<8>([](u64 a, u64 b) { return a | ~b; }));
  check<qword, qword>(
      "si_xor", [](qword a, qword b) { return si_xor(a, b); },
      lanewise<8>([](u64 a, u64 b) { return a ^ b; }));
  check<qword, qword, qword>(
      "si_selb", [](qword a, qword b, qword c) { return si_selb(a, b, c); },
      lanewise<8>([](u64 a, u64 b, u64 c) { return (a & ~c) | (b & c); }));
  check<qword, qword, qword>(
      "si_shufb", [](qword a, qword b, qword c) { return si_shufb(a, b, c); }, shuffled);
}

TEST(SpecificLogic, CombinesLanesWithImmediates) {
  check<qword, int>(
      "si_andbi", [](qword a, int n) { return si_andbi(a, n); },
      immediate_lanewise<1>([](u64 a, u64 b) { return a & b; }));
  check<qword, int>(
      "si_andhi", [](qword a, int n) { return si_andhi(a, n); },
      immediate_lanewise<2>([](u64 a, u64 b) { return a & b; }));
  check<qword, int>(
      "si_andi", [](qword a, int n) { return si_andi(a, n); },
      immediate_lanewise<4>([](u64 a, u64 b) { return a & b; }));
  check<qword, int>(
      "si_orbi", [](qword a, int n) { return si_orbi(a, n); },
      immediate_lanewise<1>([](u64 a, u64 b) { return a | b; }));
  check<qword, int>(
      "si_orhi", [](qword a, int n) { return si_orhi(a, n); },
      immediate_lanewise<2>([](u64 a, u64 b) { return a | b; }));
  check<qword, int>(
      "si_ori", [](qword a, int n) { return si_ori(a, n); },
      immediate_lanewise<4>([](u64 a, u64 b) { return a | b; }));
  check<qword, int>(
      "si_xorbi", [](qword a, int n) { return si_xorbi(a, n); },
      immediate_lanewise<1>([](u64 a, u64 b) { return a ^ b; }));
  check<qword, int>(
      "si_xorhi", [](qword a, int n) { return si_xorhi(a, n); },
      immediate_lanewise<2>([](u64 a, u64 b) { return a ^ b; }));
  check<qword, int>(
      "si_xori", [](qword a, int n) { return si_xori(a, n); },
      immediate_lanewise<4>([](u64 a, u64 b) { return a ^ b; }));
}

TEST(SpecificBytes, CountsSumsExtendsAndMasks) {
  check<qword>(
      "si_clz", [](qword a) { return si_clz(a); }, lanewise<4>(leading_zeros32));
  check<qword>(
      "si_cntb", [](qword a) { return si_cntb(a); }, lanewise<1>([](u64 a) { return ones_in(a); }));
  check<qword, qword>(
      "si_avgb", [](qword a, qword b) { return si_avgb(a, b); },
      lanewise<1>([](u64 a, u64 b) { return (a + b + 1) / 2; }));
  check<qword, qword>(
      "si_absdb", [](qword a, qword b) { return si_absdb(a, b); },
      lanewise<1>([](u64 a, u64 b) { return a > b ? a - b : b - a; }));
  check<qword, qword>(
      "si_sumb", [](qword a, qword b) { return si_sumb(a, b); },
      [](const Register& a, const Register& b) {
        return build<2>([&](int i) {
          u64 sum = 0;
          for (int k = 0; k < 4; ++k) sum += lane<1>(i % 2 == 0 ? b : a, i / 2 * 4 + k);
          return sum;
        });
      });
  check<qword>(
      "si_xsbh", [](qword a) { return si_xsbh(a); },
      [](const Register& a) { return build<2>([&](int i) { return signed_lane<1>(a, 2 * i + 1); }); });
  check<qword>(
      "si_xshw", [](qword a) { return si_xshw(a); },
      [](const Register& a) { return build<4>([&](int i) { return signed_lane<2>(a, 2 * i + 1); }); });
  check<qword>(
      "si_xswd", [](qword a) { return si_xswd(a); },
      [](const Register& a) { return build<8>([&](int i) { return signed_lane<4>(a, 2 * i + 1); }); });
  check<qword>(
      "si_gb", [](qword a) { return si_gb(a); }, gathered<4>);
  check<qword>(
      "si_gbh", [](qword a) { return si_gbh(a); }, gathered<2>);
  check<qword>(
      "si_gbb", [](qword a) { return si_gbb(a); }, gathered<1>);
  check<qword>(
      "si_fsm", [](qword a) { return si_fsm(a); },
      [](const Register& a) { return mask_of<4>(lane<4>(a, 0)); });
  check<qword>(
      "si_fsmh", [](qword a) { return si_fsmh(a); },
      [](const Register& a) { return mask_of<2>(lane<4>(a, 0)); });
  check<qword>(
      "si_fsmb", [](qword a) { return si_fsmb(a); },
      [](const Register& a) { return mask_of<1>(lane<4>(a, 0)); });
  check<int>(
      "si_fsmbi", [](int n) { return si_fsmbi(n); }, [](int n) { return mask_of<1>(static_cast<u64>(n)); });
  check<qword>(
      "si_orx", [](qword a) { return si_orx(a); },
      [](const Register& a) {
        Register r{};
        put<4>(r, 0, lane<4>(a, 0) | lane<4>(a, 1) | lane<4>(a, 2) | lane<4>(a, 3));
        return r;
      });
}

TEST(SpecificCompare, ComparesLanesAndImmediates) {
  check<qword, qword>(
      "si_ceqb", [](qword a, qword b) { return si_ceqb(a, b); },
      lanewise<1>([](u64 a, u64 b) { return all_ones(a == b); }));
  check<qword, int>(
      "si_ceqbi", [](qword a, int n) { return si_ceqbi(a, n); },
      with_splat<1>(lanewise<1>([](u64 a, u64 b) { return all_ones(a == b); })));
  check<qword, qword>(
      "si_cgtb", [](qword a, qword b) { return si_cgtb(a, b); },
      signed_lanewise<1>([](s64 a, s64 b) { return all_ones(a > b); }));
  check<qword, int>(
      "si_cgtbi", [](qword a, int n) { return si_cgtbi(a, n); },
      with_splat<1>(signed_lanewise<1>([](s64 a, s64 b) { return all_ones(a > b); })));
  check<qword, qword>(
      "si_clgtb", [](qword a, qword b) { return si_clgtb(a, b); },
      lanewise<1>([](u64 a, u64 b) { return all_ones(a > b); }));
  check<qword, int>(
      "si_clgtbi", [](qword a, int n) { return si_clgtbi(a, n); },
      with_splat<1>(lanewise<1>([](u64 a, u64 b) { return all_ones(a > b); })));
  check<qword, qword>(
      "si_ceqh", [](qword a, qword b) { return si_ceqh(a, b); },
      lanewise<2>([](u64 a, u64 b) { return all_ones(a == b); }));
  check<qword, int>(
      "si_ceqhi", [](qword a, int n) { return si_ceqhi(a, n); },
      with_splat<2>(lanewise<2>([](u64 a, u64 b) { return all_ones(a == b); })));
  check<qword, qword>(
      "si_cgth", [](qword a, qword b) { return si_cgth(a, b); },
      signed_lanewise<2>([](s64 a, s64 b) { return all_ones(a > b); }));
  check<qword, int>(
      "si_cgthi", [](qword a, int n) { return si_cgthi(a, n); },
      with_splat<2>(signed_lanewise<2>([](s64 a, s64 b) { return all_ones(a > b); })));
  check<qword, qword>(
      "si_clgth", [](qword a, qword b) { return si_clgth(a, b); },
      lanewise<2>([](u64 a, u64 b) { return all_ones(a > b); }));
  check<qword, int>(
      "si_clgthi", [](qword a, int n) { return si_clgthi(a, n); },
      with_splat<2>(lanewise<2>([](u64 a, u64 b) { return all_ones(a > b); })));
  check<qword, qword>(
      "si_ceq", [](qword a, qword b) { return si_ceq(a, b); },
      lanewise<4>([](u64 a, u64 b) { return all_ones(a == b); }));
  check<qword, int>(
      "si_ceqi", [](qword a, int n) { return si_ceqi(a, n); },
      with_splat<4>(lanewise<4>([](u64 a, u64 b) { return all_ones(a == b); })));
  check<qword, qword>(
      "si_cgt", [](qword a, qword b) { return si_cgt(a, b); },
      signed_lanewise<4>([](s64 a, s64 b) { return all_ones(a > b); }));
  check<qword, int>(
      "si_cgti", [](qword a, int n) { return si_cgti(a, n); },
      with_splat<4>(signed_lanewise<4>([](s64 a, s64 b) { return all_ones(a > b); })));
  check<qword, qword>(
      "si_clgt", [](qword a, qword b) { return si_clgt(a, b); },
      lanewise<4>([](u64 a, u64 b) { return all_ones(a > b); }));
  check<qword, int>(
      "si_clgti", [](qword a, int n) { return si_clgti(a, n); },
      with_splat<4>(lanewise<4>([](u64 a, u64 b) { return all_ones(a > b); })));
}

}  // namespace
