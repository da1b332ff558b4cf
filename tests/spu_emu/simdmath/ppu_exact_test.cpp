// The functions whose results are exact: the PPU's are those of the SPU, for numbers that both have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "simdmath/ppu_evaluator.h"
#include "simdmath/references.h"

namespace {

using namespace simdmath_test;

const char* const commands[] = {SIMDMATH_PPU64, SIMDMATH_PPU32};

/// All but those with an error, those of the SPU alone, and those that round as each side's unit does.
std::vector<std::string> exact_functions() {
  std::vector<std::string> result;
  for (const std::string& name : function_names()) {
    const std::string base = name.substr(0, name.size() - 2);
    const auto& all = references();
    const bool has_error =
        std::any_of(all.begin(), all.end(), [&](const Reference& r) { return r.name == base; });
    const bool rounds = base == "rint" || base == "nearbyint" || base == "irint" || base == "llrint";
    if (!has_error && name.find("_fast") == std::string::npos && !(rounds && name.back() == '4'))
      result.push_back(name);
  }
  return result;
}

/// A word that is an ordinary number as a float and as the high half of a double.
std::uint32_t ordinary_word(std::mt19937& random) {
  const std::uint32_t word = random();
  switch (random() % 4) {
    case 0:
      return (word & 0x80000000U) | (0x3f000000U + (word & 0x01ffffffU));
    case 1:
      return (word & 0x80000000U) | (0x41000000U + (word & 0x01ffffffU));
    default:
      return (word & 0x80000000U) | (0x30000000U + (word & 0x1fffffffU));
  }
}
/// A small integer, for exponents, of 32 and of 64 bits.
std::vector<Words> small_integers(std::mt19937& random) {
  Words ints{};
  for (std::uint32_t& word : ints) word = random() % 61U - 30U;
  Words longs{};
  for (std::size_t i = 0; i < 4; i += 2) {
    longs[i + 1] = random() % 1201U - 600U;
    longs[i] = (longs[i + 1] >> 31U) != 0 ? ~0U : 0U;
  }
  return {ints, longs};
}

std::vector<Call> calls_of(const std::string& name) {
  std::mt19937 random(20);
  std::vector<Call> calls(400);
  for (Call& call : calls) {
    for (Words& argument : call) {
      for (std::uint32_t& word : argument) word = ordinary_word(random);
    }
    const std::vector<Words> integers = small_integers(random);
    if (random() % 4 == 0) call[1] = call[0];
    if (name == "ldexpf4" || name == "scalbnf4") call[1] = integers[0];
    if (name == "ldexpd2" || name == "scalbllnd2") call[1] = integers[1];
    // The neighbour of zero is a denormal number, which the SPU does not have.
    if (random() % 8 == 0 && name != "nextafterd2") call[0] = {};
  }
  return calls;
}

class ExactOnPpu : public testing::TestWithParam<std::string> {};

TEST_P(ExactOnPpu, GivesWhatTheSpuGives) {
  const unsigned function = number_of(GetParam());
  std::vector<Call> calls = calls_of(GetParam());
  // The largest number of the SPU stands for what has no value; on the PPU that is an infinity.
  if (GetParam() == "logbf4") {
    for (Call& call : calls) call[0] = call[2];
  }
  const std::vector<Result> of_spu = evaluate_precisely_on_host(function, calls);
  for (const char* command : commands) {
    const std::vector<Result> of_ppu = evaluate_on_ppu(command, function, calls);
    for (std::size_t i = 0; i < calls.size(); ++i) {
      ASSERT_EQ(of_ppu[i], of_spu[i])
          << command << ", call " << i << std::hex << ": " << calls[i][0][0] << " " << calls[i][0][1] << ", "
          << calls[i][1][0] << " " << calls[i][1][1];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Functions, ExactOnPpu, testing::ValuesIn(exact_functions()),
                         [](const auto& test) { return test.param; });

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Words doubles(double a, double b) {
  std::uint64_t bits[2];
  std::memcpy(bits, &a, 8);
  std::memcpy(bits + 1, &b, 8);
  return {static_cast<std::uint32_t>(bits[0] >> 32U), static_cast<std::uint32_t>(bits[0]),
          static_cast<std::uint32_t>(bits[1] >> 32U), static_cast<std::uint32_t>(bits[1])};
}
Words longs(std::int64_t a, std::int64_t b) {
  return {static_cast<std::uint32_t>(static_cast<std::uint64_t>(a) >> 32U), static_cast<std::uint32_t>(a),
          static_cast<std::uint32_t>(static_cast<std::uint64_t>(b) >> 32U), static_cast<std::uint32_t>(b)};
}
Words floats(float a, float b, float c, float d) {
  Words words;
  const float all[] = {a, b, c, d};
  std::memcpy(words.data(), all, sizeof all);
  return words;
}

/// What both widths of the PPU give.
Result on_ppu(const std::string& name, Words x, Words y = {}) {
  const std::vector<Call> calls = {Call{x, y, {}}};
  const Result result = evaluate_on_ppu(commands[0], number_of(name), calls)[0];
  EXPECT_EQ(evaluate_on_ppu(commands[1], number_of(name), calls)[0], result) << name;
  return result;
}

TEST(SimdMathOnPpu, DenormalDoublesAreNumbers) {
  constexpr double kDenormal = 0x1p-1070;
  EXPECT_EQ(on_ppu("isequald2", doubles(kDenormal, 0), doubles(0, -0.0))[0], longs(0, -1));
  EXPECT_EQ(on_ppu("is0denormd2", doubles(kDenormal, 0x1p-1022))[0], longs(-1, 0));
  EXPECT_EQ(on_ppu("isnormald2", doubles(kDenormal, 0x1p-1022))[0], longs(0, -1));
  EXPECT_EQ(on_ppu("logbd2", doubles(kDenormal, -kDenormal))[0], doubles(-1070, -1070));
  EXPECT_EQ(on_ppu("ilogbd2", doubles(kDenormal, 0))[0], longs(-1070, std::numeric_limits<int>::min()));
  EXPECT_EQ(on_ppu("nextafterd2", doubles(0, 0x1p-1022), doubles(1, 0))[0],
            doubles(0x1p-1074, 0x0.fffffffffffffp-1022));
  EXPECT_EQ(on_ppu("ldexpd2", doubles(kDenormal, 3), longs(1070, -1075))[0], doubles(1, 0x1p-1073));
  EXPECT_EQ(on_ppu("frexpd2", doubles(kDenormal, 0)), (Result{doubles(0.5, 0), longs(-1069, 0)}));
}

TEST(SimdMathOnPpu, WhatIsTooLargeForALongIsLimited) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  for (const char* name : {"llrintd2", "llroundd2"}) {
    EXPECT_EQ(on_ppu(name, doubles(0x1p63, -0x1p63))[0], longs(kMost, kLeast)) << name;
    EXPECT_EQ(on_ppu(name, doubles(kNan, -kInfinite))[0], longs(kMost, kLeast)) << name;
  }
  const Result of_floats = on_ppu("llroundf4", floats(2.5F, -2.5F, 0x1p70F, -0x1p70F));
  EXPECT_EQ(of_floats, (Result{longs(3, -3), longs(kMost, kLeast)}));
  EXPECT_EQ(on_ppu("llrintf4", floats(2.5F, -2.5F, 3.5F, 0.4F)), (Result{longs(2, -2), longs(4, 0)}));
}

TEST(SimdMathOnPpu, KindsOfSpecialDoublesAreSeen) {
  EXPECT_EQ(on_ppu("isnand2", doubles(kNan, kInfinite))[0], longs(-1, 0));
  EXPECT_EQ(on_ppu("isinfd2", doubles(kNan, -kInfinite))[0], longs(0, -1));
  EXPECT_EQ(on_ppu("isfinited2", doubles(kNan, 1))[0], longs(0, -1));
  EXPECT_EQ(on_ppu("isunorderedd2", doubles(kNan, 1), doubles(1, 2))[0], longs(-1, 0));
  EXPECT_EQ(on_ppu("isequald2", doubles(kNan, kInfinite), doubles(kNan, kInfinite))[0], longs(0, -1));
  EXPECT_EQ(on_ppu("islessequald2", doubles(kNan, 1), doubles(1, 1))[0], longs(0, -1));
  EXPECT_EQ(on_ppu("ilogbd2", doubles(kNan, kInfinite))[0],
            longs(std::numeric_limits<int>::max(), std::numeric_limits<int>::max()));
  EXPECT_EQ(on_ppu("frexpd2", doubles(kInfinite, -kInfinite)),
            (Result{doubles(kInfinite, -kInfinite), longs(0, 0)}));
  EXPECT_EQ(on_ppu("logbd2", doubles(0, -kInfinite))[0], doubles(-kInfinite, kInfinite));
}

}  // namespace
