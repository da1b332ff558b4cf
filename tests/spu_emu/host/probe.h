// What the probe program can be asked to do: its argp is one of these numbers, its envp a parameter.
#ifndef SPU_EMU_TESTS_PROBE_H
#define SPU_EMU_TESTS_PROBE_H

enum class Probe : unsigned long long {
  return_parameter,
  exit_with_parameter,
  stop_twice,
  stop_inside_a_handler,
  halt,
  misaligned_get,
  bad_channel,
  count_runs,
  sum_into_global,
  sum_into_stack,
  sum_into_heap,
  put_constant,
  get_to_foreign_pointer,
  get_to_deep_stack,
  allocate_until_full,
  use_the_heap,
  free_twice,
  library_call,
  plain_library_stop,
  check_rounding,
  echo_mailbox,
  answer_to_signal,
  read_without_waiting,
  write_without_waiting,
  list_on_stack,
  reserve_tags,
  put_without_waiting,
  many_gets,
  own_arguments,
  send_global_and_wait
};

#endif
