// How the rogue program goes wrong: its argp is one of these numbers.
#ifndef SPU_EMU_TESTS_ROGUE_H
#define SPU_EMU_TESTS_ROGUE_H

enum class Rogue : unsigned long long {
  nothing,  // returns its envp
  write_to_null,
  write_beyond_the_store,
  overrun_the_heap,
  overrun_a_block,
  overrun_a_freed_block,
  overrun_a_block_by_dma,
  jump_to_null,
  run_into_no_instruction,
  recurse,
  recurse_with_dma,
  divide_by_zero,
  divide_lowest_by_minus_one,
  abort,
  fail_assertion,
  throw_exception,
  throw_number,
  throw_out_of_noexcept,
  fault_inside_a_handler,
  copy_to_null,
  loop,
  loop_over_the_c_library,
  wait_for_a_mailbox,
  wait_for_an_event
};

#endif
