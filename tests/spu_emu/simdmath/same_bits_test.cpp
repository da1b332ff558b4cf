// The same functions on the host engine and as real SPU code: equal bits.
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "simdmath/spe_evaluator.h"

extern "C" spe_program_handle_t simdmath_program;
extern "C" spe_program_handle_t simdmath_program_elf;

namespace {

using namespace simdmath_test;

/// A word as a float of any exponent, a small integer, or any bits.
std::uint32_t any_word(std::mt19937& random) {
  const std::uint32_t word = random();
  switch (random() % 6) {
    case 0: return word & 0xfffU;
    case 1: return (word & 0x807fffffU) | (120U + random() % 16U) << 23U;
    case 2: return word & 0xff800000U;
    default: return word;
  }
}

std::vector<Call> any_calls(std::size_t count) {
  std::mt19937 random(20);
  std::vector<Call> calls(count);
  for (Call& call : calls) {
    for (Words& argument : call) {
      for (std::uint32_t& word : argument) word = any_word(random);
    }
  }
  // Every exponent, with both signs, as float and as the high half of a double.
  for (std::uint32_t i = 0; i < 4096; ++i) {
    Words& argument = calls[i % count][0];
    argument[i % 4] = i << 20U | (random() & 0xfffffU);
  }
  return calls;
}

std::string text(const Words& words) {
  char line[40];
  std::snprintf(line, sizeof line, "%08x %08x %08x %08x", words[0], words[1], words[2], words[3]);
  return line;
}

bool has_exponent(std::uint32_t word, std::uint32_t least, std::uint32_t most) {
  const std::uint32_t exponent = word >> 23U & 255U;
  return exponent >= least && exponent <= most;
}

/// What the host engine's fast build leaves open, for functions that are single instructions or say that they are not for
/// all numbers: exponent 255, the sign of zero, and arguments far from 1.
bool is_left_open(const std::string& function, const Call& call, const Result& real, std::size_t lane) {
  if (function == "fmaf4" || function == "fdimf4") {
    return has_exponent(real[0][lane], 255, 255) || has_exponent(real[0][lane], 0, 0) || has_exponent(call[0][lane], 255, 255) ||
           has_exponent(call[1][lane], 255, 255) || has_exponent(call[2][lane], 255, 255);
  }
  if (function.find("_fast") == std::string::npos) return false;
  return !has_exponent(call[0][lane], 64, 190) || !has_exponent(call[1][lane], 64, 190);
}

class SameBits : public testing::TestWithParam<std::string> {};

TEST_P(SameBits, TheHostEngineHasTheBitsOfRealSpuCode) {
  const unsigned function = number_of(GetParam());
  const std::vector<Call> calls = any_calls(1088);
  const std::vector<Result> real = evaluate_on_spe(simdmath_program_elf, function, calls);
  const std::vector<Result> precise = evaluate_precisely_on_host(function, calls);
  const std::vector<Result> engine = evaluate_on_spe(simdmath_program, function, calls);
  for (std::size_t i = 0; i < calls.size(); ++i) {
    ASSERT_EQ(precise[i], real[i]) << "precise host build: " << text(precise[i][0]) << " and " << text(precise[i][1])
                                   << "\nreal SPU code: " << text(real[i][0]) << " and " << text(real[i][1]) << "\nof "
                                   << text(calls[i][0]) << "\n   " << text(calls[i][1]) << "\n   " << text(calls[i][2]);
  }
  for (std::size_t i = 0; i < calls.size() * 4; ++i) {
    const Result& host = engine[i / 4];
    const Result& spu = real[i / 4];
    if (is_left_open(GetParam(), calls[i / 4], spu, i % 4)) continue;
    ASSERT_TRUE(host[0][i % 4] == spu[0][i % 4] && host[1][i % 4] == spu[1][i % 4])
        << "host engine: " << text(host[0]) << " and " << text(host[1]) << "\nreal SPU code: " << text(spu[0]) << " and "
        << text(spu[1]) << "\nof " << text(calls[i / 4][0]) << "\n   " << text(calls[i / 4][1]) << "\n   "
        << text(calls[i / 4][2]);
  }
}

INSTANTIATE_TEST_SUITE_P(Functions, SameBits, testing::ValuesIn(function_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
