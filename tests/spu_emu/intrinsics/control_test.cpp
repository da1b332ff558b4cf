#include <gtest/gtest.h>

#include "register_image.h"
#include "services.h"

namespace {

using namespace reference;

template <typename F>
bool halts(F f) {
  last_request() = {};
  f();
  return last_request().kind == "halt";
}

qword word(unsigned int w) {
  return si_from_uint(w);
}

TEST(Halt, StopsWhenItsConditionHoldsAndNotOtherwise) {
  EXPECT_TRUE(halts([] { spu_hcmpeq(-1, -1); }));
  EXPECT_FALSE(halts([] { spu_hcmpeq(-1, 1); }));
  EXPECT_TRUE(halts([] { spu_hcmpeq(7U, 7U); }));
  EXPECT_FALSE(halts([] { spu_hcmpeq(7U, 8U); }));
  EXPECT_TRUE(halts([] { spu_hcmpgt(1, -1); }));
  EXPECT_FALSE(halts([] { spu_hcmpgt(-1, 1); }));
  EXPECT_TRUE(halts([] { spu_hcmpgt(0x80000000U, 1U); }));
  EXPECT_FALSE(halts([] { spu_hcmpgt(1U, 1U); }));
}

TEST(Halt, ComparesPreferredWordsOfQwords) {
  EXPECT_TRUE(halts([] { si_heq(word(5), word(5)); }));
  EXPECT_FALSE(halts([] { si_heq(word(5), word(6)); }));
  EXPECT_TRUE(halts([] { si_heqi(word(0xffffffff), -1); }));
  EXPECT_FALSE(halts([] { si_heqi(word(1), -1); }));
  EXPECT_TRUE(halts([] { si_hgt(word(1), word(0xffffffff)); }));
  EXPECT_FALSE(halts([] { si_hgt(word(0xffffffff), word(1)); }));
  EXPECT_TRUE(halts([] { si_hgti(word(1), -1); }));
  EXPECT_FALSE(halts([] { si_hgti(word(1), 1); }));
  EXPECT_TRUE(halts([] { si_hlgt(word(0xffffffff), word(1)); }));
  EXPECT_FALSE(halts([] { si_hlgt(word(1), word(0xffffffff)); }));
  EXPECT_TRUE(halts([] { si_hlgti(word(0xffffffff), -2); }));
  EXPECT_FALSE(halts([] { si_hlgti(word(1), -1); }));
}

TEST(Halt, NamesTheLineOfSpuSourceThatHalted) {
  spu_hcmpeq(1, 1);
  const int line = __LINE__ - 1;
  EXPECT_EQ(last_request().line, line);
  EXPECT_NE(last_request().file.find("control_test.cpp"), std::string::npos);
}

TEST(Channels, AreReadAndWrittenThroughThePreferredSlot) {
  channel_answer() = 0x1234;
  EXPECT_EQ(image(si_rdch(SPU_RdInMbox)), image(vec_uint4{0x1234, 0, 0, 0}));
  EXPECT_EQ(last_request().channel, SPU_RdInMbox);
  EXPECT_EQ(image(si_rchcnt(SPU_RdInMbox)), image(vec_uint4{0x1234, 0, 0, 0}));
  EXPECT_EQ(last_request().kind, "count");
  si_wrch(SPU_WrOutMbox, word(77));
  EXPECT_EQ(last_request().kind, "write");
  EXPECT_EQ(last_request().value, 77U);
}

TEST(Control, StopsWithACode) {
  si_stop(0x123);
  EXPECT_EQ(last_request().kind, "stop");
  EXPECT_EQ(last_request().value, 0x123U);
  si_stopd(word(0), word(0), word(0));
  EXPECT_EQ(last_request().value, 0x3fffU);
}

int calls = 0;
void count_call() {
  ++calls;
}

TEST(Control, CallsAHandlerOnlyWhileAnEventWaits) {
  void* handler = reinterpret_cast<void*>(count_call);
  calls = 0;
  channel_answer() = 0;
  spu_bisled(handler, nullptr);
  spu_bisled_d(handler, nullptr);
  spu_bisled_e(handler, nullptr);
  EXPECT_EQ(calls, 0);
  channel_answer() = 1;
  spu_bisled(handler, nullptr);
  spu_bisled_d(handler, nullptr);
  spu_bisled_e(handler, nullptr);
  si_bisled(si_from_ptr(handler), nullptr);
  si_bisledd(si_from_ptr(handler), nullptr);
  si_bislede(si_from_ptr(handler), nullptr);
  EXPECT_EQ(calls, 6);
}

TEST(Control, KeepsTheRoundingModesOfTheFpscr) {
  spu_mtfpscr(vec_uint4{0x00000600, 0, 0, 0});
  EXPECT_EQ(image(spu_mffpscr()), image(vec_uint4{0x00000600, 0, 0, 0}));
  si_fscrwr(word(0));
  EXPECT_EQ(image(si_fscrrd()), image(vec_uint4{}));
}

TEST(Control, ReadsSpecialRegistersAsZeroAndAcceptsWrites) {
  spu_mtspr(1, 5);
  si_mtspr(1, word(5));
  EXPECT_EQ(spu_mfspr(1), 0U);
  EXPECT_EQ(image(si_mfspr(1)), image(vec_uint4{}));
}

TEST(Memory, LoadsAndStoresQuadwordsAtTruncatedAddresses) {
  alignas(16) unsigned int words[12] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  const qword base = si_from_ptr(words);
  EXPECT_EQ(image(si_lqd(base, 16)), image(vec_uint4{5, 6, 7, 8}));
  EXPECT_EQ(image(si_lqd(si_from_ptr(words + 5), 16)), image(vec_uint4{9, 10, 11, 12}));
  EXPECT_EQ(image(si_lqx(base, si_from_uint(20))), image(vec_uint4{5, 6, 7, 8}));
  EXPECT_EQ(image(si_lqx(si_from_uint(20), base)), image(vec_uint4{5, 6, 7, 8}));
  si_stqd((qword)vec_uint4{21, 22, 23, 24}, base, 32);
  EXPECT_EQ(words[8], 21U);
  EXPECT_EQ(words[11], 24U);
  si_stqx((qword)vec_uint4{31, 32, 33, 34}, base, si_from_uint(0));
  EXPECT_EQ(words[0], 31U);
  EXPECT_EQ(words[4], 5U);
}

// si_shufb by an insertion pattern puts the scalar of the preferred slot at the address's offset.
template <int Width, typename D, typename X>
void check_insertion(D d_form, X x_form) {
  const Register scalar = build<1>([](int i) { return 0xa0 + i; });
  const Register quadword = build<1>([](int i) { return i; });
  for (unsigned int address = 0; address < 40; ++address) {
    Register expected = quadword;
    const int preferred = Width < 4 ? 4 / Width - 1 : 0;
    put<Width>(expected, static_cast<int>(address % 16) / Width, lane<Width>(scalar, preferred));
    for (const qword pattern :
         {d_form(word(address - 3), 3), x_form(word(address), word(0)), x_form(word(7), word(address - 7))})
      EXPECT_EQ(image(si_shufb(vector<qword>(scalar), vector<qword>(quadword), pattern)), expected)
          << address;
  }
}

TEST(Memory, MakesInsertionPatternsForEveryWidthAndOffset) {
  check_insertion<1>([](qword a, int d) { return si_cbd(a, d); },
                     [](qword a, qword b) { return si_cbx(a, b); });
  check_insertion<2>([](qword a, int d) { return si_chd(a, d); },
                     [](qword a, qword b) { return si_chx(a, b); });
  check_insertion<4>([](qword a, int d) { return si_cwd(a, d); },
                     [](qword a, qword b) { return si_cwx(a, b); });
  check_insertion<8>([](qword a, int d) { return si_cdd(a, d); },
                     [](qword a, qword b) { return si_cdx(a, b); });
}

TEST(Memory, MakesThePatternThatMovesAQuadwordRight) {
  alignas(16) char bytes[16];
  const vec_char16 pattern = spu_lvsr(bytes + 5);
  EXPECT_EQ(image(pattern), build<1>([](int i) { return 16 - 5 + i; }));
}

TEST(Control, AcceptsHintsAndFencesThatComputeNothing) {
  spu_align_hint(nullptr, 0, 0);
  spu_idisable();
  spu_ienable();
  si_nop();
  si_lnop();
  si_sync();
  si_syncc();
  si_dsync();
}

}  // namespace
