// The si_ float functions against the typed ones, which have references of their own: operand order and
// meaning.
#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

// Which of two NaN patterns comes out of an addition is the compiler's choice of operand order, and nothing
// that the default build promises: lanes with such an operand may differ.
template <int Arguments>
bool same_where_ordinary(const Value& result, const Value& expected, const Value* arguments) {
  for (int i = 0; i < 4; ++i) {
    bool ordinary = true;
    for (int k = 0; k < Arguments; ++k)
      ordinary = ordinary && (lane<4>(arguments[k].image, i) >> 23 & 255) != 255;
    if (ordinary && lane<4>(result.image, i) != lane<4>(expected.image, i)) return false;
  }
  return true;
}

// The qword function gives the image that the typed one gives.
#define SAME_2(type, specific, generic, agree)                                                               \
  check<qword, qword>(                                                                                       \
      #specific, [](qword a, qword b) { return specific(a, b); },                                            \
      [](const Register& a, const Register& b) { return image(generic(vector<type>(a), vector<type>(b))); }, \
      agree)
#define SAME_3(type, specific, generic, agree)                                    \
  check<qword, qword, qword>(                                                     \
      #specific, [](qword a, qword b, qword c) { return specific(a, b, c); },     \
      [](const Register& a, const Register& b, const Register& c) {               \
        return image(generic(vector<type>(a), vector<type>(b), vector<type>(c))); \
      },                                                                          \
      agree)
#define SAME_1(type, specific, generic)               \
  check<qword>(                                       \
      #specific, [](qword a) { return specific(a); }, \
      [](const Register& a) { return image(generic(vector<type>(a))); })
#define SAME_SCALED(type, specific, generic)                          \
  check<qword, int>(                                                  \
      #specific, [](qword a, int n) { return specific(a, n & 127); }, \
      [](const Register& a, int n) { return image(generic(vector<type>(a), n & 127)); })

TEST(SpecificFloat, IsTheTypedArithmetic) {
  const spu_emu::SpuFloatMode mode;
  SAME_2(vec_float4, si_fa, spu_add, same_where_ordinary<2>);
  SAME_2(vec_float4, si_fs, spu_sub, same_where_ordinary<2>);
  SAME_2(vec_float4, si_fm, spu_mul, same_where_ordinary<2>);
  SAME_3(vec_float4, si_fma, spu_madd, same_where_ordinary<3>);
  SAME_3(vec_float4, si_fms, spu_msub, same_where_ordinary<3>);
  SAME_3(vec_float4, si_fnms, spu_nmsub, same_where_ordinary<3>);
  SAME_1(vec_float4, si_frest, spu_frest);
  SAME_1(vec_float4, si_frsqest, spu_frsqest);
}

TEST(SpecificFloat, IsTheTypedDoubleArithmetic) {
  SAME_2(vec_double2, si_dfa, spu_add, same_bits);
  SAME_2(vec_double2, si_dfs, spu_sub, same_bits);
  SAME_2(vec_double2, si_dfm, spu_mul, same_bits);
  SAME_3(vec_double2, si_dfma, spu_madd, same_bits);
  SAME_3(vec_double2, si_dfms, spu_msub, same_bits);
  SAME_3(vec_double2, si_dfnma, spu_nmadd, same_bits);
  SAME_3(vec_double2, si_dfnms, spu_nmsub, same_bits);
}

TEST(SpecificFloat, IsTheTypedCompare) {
  const spu_emu::SpuFloatMode mode;
  SAME_2(vec_float4, si_fceq, spu_cmpeq, same_bits);
  SAME_2(vec_float4, si_fcmeq, spu_cmpabseq, same_bits);
  SAME_2(vec_float4, si_fcgt, spu_cmpgt, same_bits);
  SAME_2(vec_float4, si_fcmgt, spu_cmpabsgt, same_bits);
  SAME_2(vec_double2, si_dfceq, spu_cmpeq, same_bits);
  SAME_2(vec_double2, si_dfcmeq, spu_cmpabseq, same_bits);
  SAME_2(vec_double2, si_dfcgt, spu_cmpgt, same_bits);
  SAME_2(vec_double2, si_dfcmgt, spu_cmpabsgt, same_bits);
  SAME_SCALED(vec_double2, si_dftsv, spu_testsv);
}

TEST(SpecificFloat, IsTheTypedConversion) {
  const spu_emu::SpuFloatMode mode;
  SAME_SCALED(vec_int4, si_csflt, spu_convtf);
  SAME_SCALED(vec_uint4, si_cuflt, spu_convtf);
  SAME_SCALED(vec_float4, si_cflts, spu_convts);
  SAME_SCALED(vec_float4, si_cfltu, spu_convtu);
  SAME_1(vec_double2, si_frds, spu_roundtf);
  SAME_1(vec_float4, si_fesd, spu_extend);
}

}  // namespace
