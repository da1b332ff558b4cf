// Programs as they were written for the SPU, compiled for this machine by the translator.
#include <gtest/gtest.h>
#include <libspe2.h>

#include "spu_emu/emulation.h"

#define SPU_EMU_PROGRAMS(use)                                                                                \
  use(compiled_old_style) use(compiled_keyword) use(compiled_casts) use(compiled_main_without_parameters)    \
      use(compiled_main_of_two) use(compiled_main_of_union) use(compiled_main_void) use(compiled_huge_value) \
          use(compiled_huge_value_c) use(compiled_local_scalars)

#define SPU_EMU_DECLARE(name) extern "C" spe_program_handle_t name;
SPU_EMU_PROGRAMS(SPU_EMU_DECLARE)

#ifdef SPU_EMU_HAS_ELF
#define SPU_EMU_DECLARE_ELF(name) extern "C" spe_program_handle_t name##_elf;
SPU_EMU_PROGRAMS(SPU_EMU_DECLARE_ELF)
#endif

namespace spu_emu {
namespace {

struct Outcome {
  int exit_code = -1;
  unsigned int message = 0;
};

Outcome run(spe_program_handle_t& program, const void* argument = nullptr) {
  spe_context_ptr_t spe = spe_context_create(SPE_EVENTS_ENABLE, nullptr);
  EXPECT_EQ(spe_program_load(spe, &program), 0) << last_fault(spe);
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop{};
  EXPECT_EQ(spe_context_run(spe, &entry, 0, const_cast<void*>(argument), nullptr, &stop), 0)
      << last_fault(spe);
  Outcome outcome;
  EXPECT_EQ(stop.stop_reason, unsigned{SPE_EXIT});
  outcome.exit_code = stop.result.spe_exit_code;
  if (spe_out_mbox_status(spe) != 0) spe_out_mbox_read(spe, &outcome.message, 1);
  spe_context_destroy(spe);
  return outcome;
}

const void* number(unsigned long long value) {
  return reinterpret_cast<const void*>(value);
}

TEST(Compile, c_of_before_1989_with_intrinsics_and_dma_to_a_scalar) {
  alignas(16) const unsigned int word = 0x1234;
  const Outcome outcome = run(compiled_old_style, &word);
  EXPECT_EQ(outcome.exit_code, 42);
  EXPECT_EQ(outcome.message, 0x1234U);
}

TEST(Compile, scalars_of_functions_are_buffers_of_transfers) {
  alignas(16) const unsigned int word = 0x1234;
  EXPECT_EQ(run(compiled_local_scalars, &word).exit_code, 42);
}

TEST(Compile, vector_is_a_keyword_before_built_in_types_and_a_name_elsewhere) {
  EXPECT_EQ(run(compiled_keyword).exit_code, 5);
}

TEST(Compile, casts_between_element_widths_give_the_bytes_of_an_spu) {
  EXPECT_EQ(run(compiled_casts).exit_code, 42);
}

TEST(Compile, main_may_have_no_parameters_and_no_return) {
  const Outcome outcome = run(compiled_main_without_parameters);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.message, 40U);
}

TEST(Compile, main_may_have_parameters_of_any_type_of_64_bits) {
  EXPECT_EQ(run(compiled_main_of_two, number(41)).exit_code, 41);
  EXPECT_EQ(run(compiled_main_of_union, number(43)).exit_code, 43);
}

TEST(Compile, main_may_return_nothing_which_is_0) {
  const Outcome outcome = run(compiled_main_void, number(4));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.message, 7U);
}

TEST(Compile, the_huge_value_is_what_arithmetic_saturates_to) {
  EXPECT_EQ(run(compiled_huge_value).exit_code, 42);
  EXPECT_EQ(run(compiled_huge_value_c).exit_code, 42);
}

#ifdef SPU_EMU_HAS_ELF
TEST(Compile, the_same_sources_give_the_same_as_real_spu_code) {
  EXPECT_EQ(run(compiled_casts_elf).exit_code, 42);
  EXPECT_EQ(run(compiled_keyword_elf).exit_code, 5);
  alignas(16) const unsigned int word = 0x1234;
  EXPECT_EQ(run(compiled_old_style_elf, &word).exit_code, 42);
  EXPECT_EQ(run(compiled_local_scalars_elf, &word).exit_code, 42);
  EXPECT_EQ(run(compiled_main_without_parameters_elf).message, 40U);
  EXPECT_EQ(run(compiled_huge_value_elf).exit_code, 42);
  EXPECT_EQ(run(compiled_huge_value_c_elf).exit_code, 42);
}
#endif

}  // namespace
}  // namespace spu_emu
