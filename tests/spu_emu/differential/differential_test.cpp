// Every intrinsic on the host engine against the same source compiled by the real SPU compiler: equal bits.
#include <gtest/gtest.h>
#include <libspe2.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "differential/cases.h"
#include "differential/job.h"
#include "differential/programs.h"

namespace {

using differential::Program;

constexpr std::size_t kBlocks = 64;  // of kCases cases each
constexpr std::size_t kWordsPerCase = kInputsPerCase * 4;

using Quadword = const std::uint32_t*;

struct Free {
  void operator()(void* block) const { std::free(block); }
};
using Words = std::unique_ptr<std::uint32_t[], Free>;

Words aligned_words(std::size_t count) {
  return Words(static_cast<std::uint32_t*>(std::aligned_alloc(128, (count * 4 + 127) / 128 * 128)));
}

std::uint32_t high(const void* pointer) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer) >> 32U);
}
std::uint32_t low(const void* pointer) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer));
}

/// Results of all rows on one block of inputs, row after row, a quadword for each case.
Words run(spe_program_handle_t& program, const std::uint32_t* input, std::size_t rows) {
  Words output = aligned_words(rows * kCases * 4);
  alignas(128) DifferentialJob job{
      high(input), low(input), high(output.get()), low(output.get()), 0, static_cast<unsigned>(rows), {}};
  spe_context_ptr_t spe = spe_context_create(0, nullptr);
  spe_stop_info_t stop{};
  unsigned entry = SPE_DEFAULT_ENTRY;
  const bool ran = spe != nullptr && spe_program_load(spe, &program) == 0 &&
                   spe_context_run(spe, &entry, 0, &job, nullptr, &stop) == 0;
  EXPECT_TRUE(ran && stop.stop_reason == SPE_EXIT && stop.result.spe_exit_code == 0)
      << "the program has other rows or broke a rule";
  if (spe != nullptr) spe_context_destroy(spe);
  return output;
}

using Agree = std::function<bool(const Program&, std::size_t row, Quadword input, Quadword a, Quadword b)>;

std::string text(Quadword words) {
  char line[40];
  std::snprintf(line, sizeof line, "%08x %08x %08x %08x", words[0], words[1], words[2], words[3]);
  return line;
}

/// Reports the first case of each row on which the two programs disagree.
void compare(const Program& program, spe_program_handle_t& host, spe_program_handle_t& real,
             const Agree& agree) {
  std::vector<bool> reported(program.rows);
  for (std::size_t block = 0; block < kBlocks; ++block) {
    const auto words = differential::make_words(kCases * kInputsPerCase, block + 1);
    Words input = aligned_words(words.size());
    std::memcpy(input.get(), words.data(), words.size() * 4);
    const Words expected = run(real, input.get(), program.rows);
    const Words result = run(host, input.get(), program.rows);
    if (testing::Test::HasNonfatalFailure() && block == 0) return;
    for (std::size_t i = 0; i < program.rows * kCases; ++i) {
      const std::size_t row = i / kCases;
      Quadword in = input.get() + i % kCases * kWordsPerCase;
      if (reported[row] || agree(program, row, in, &result[i * 4], &expected[i * 4])) continue;
      reported[row] = true;
      ADD_FAILURE() << program.calls[row] << " of\n  " << text(in) << "\n  " << text(in + 4) << "\n  "
                    << text(in + 8) << "\n  " << text(in + 12) << "\nhost " << text(&result[i * 4])
                    << "\nSPU  " << text(&expected[i * 4]);
    }
  }
}

bool same_bits(const Program&, std::size_t, Quadword, Quadword a, Quadword b) {
  return std::memcmp(a, b, 16) == 0;
}

bool has_exponent_255(std::uint32_t word) {
  return (word & 0x7f800000U) == 0x7f800000U;
}

/// The fast build does not handle exponent 255 and the sign of zero of single precision (spu_emu/README.md).
bool same_but_for_the_limits_of_the_fast_build(const Program& program, std::size_t row, Quadword in,
                                               Quadword a, Quadword b) {
  if (same_bits(program, row, in, a, b)) return true;
  if (!program.is_single_precision(row)) return false;
  for (std::size_t i = 0; i < kWordsPerCase; ++i) {
    if (has_exponent_255(in[i])) return true;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const bool zeros = ((a[i] | b[i]) & 0x7fffffffU) == 0;
    if (a[i] != b[i] && !zeros && !has_exponent_255(a[i]) && !has_exponent_255(b[i])) return false;
  }
  return true;
}

class Differential : public testing::TestWithParam<Program> {};

TEST_P(Differential, ThePreciseHostBuildHasTheBitsOfTheRealSpuProgram) {
  compare(GetParam(), *GetParam().precise, *GetParam().real, same_bits);
}

TEST_P(Differential, TheFastHostBuildDiffersOnlyWhereItSaysSo) {
  compare(GetParam(), *GetParam().fast, *GetParam().real, same_but_for_the_limits_of_the_fast_build);
}

INSTANTIATE_TEST_SUITE_P(Intrinsics, Differential, testing::ValuesIn(differential::programs()),
                         [](const auto& program) { return program.param.name; });

}  // namespace
