// Round trip of a mailbox message to a running SPE and back, and the start of a program for comparison.
#include <benchmark/benchmark.h>
#include <libspe2.h>

#include <thread>

extern "C" spe_program_handle_t bench_mailbox_program;

namespace {

spe_context_ptr_t load() {
  spe_context_ptr_t spe = spe_context_create(0, nullptr);
  spe_program_load(spe, &bench_mailbox_program);
  return spe;
}

void run(spe_context_ptr_t spe) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_run(spe, &entry, 0, nullptr, nullptr, nullptr);
}

void mailbox_round_trip(benchmark::State& state) {
  spe_context_ptr_t spe = load();
  std::thread thread([spe] { run(spe); });
  unsigned int message = 1;
  for (auto _ : state) {
    spe_in_mbox_write(spe, &message, 1, SPE_MBOX_ALL_BLOCKING);
    spe_out_intr_mbox_read(spe, &message, 1, SPE_MBOX_ALL_BLOCKING);
  }
  message = 0;
  spe_in_mbox_write(spe, &message, 1, SPE_MBOX_ALL_BLOCKING);
  thread.join();
  spe_context_destroy(spe);
}

void run_a_loaded_program(benchmark::State& state) {
  spe_context_ptr_t spe = load();
  unsigned int end = 0;
  for (auto _ : state) {
    spe_in_mbox_write(spe, &end, 1, SPE_MBOX_ALL_BLOCKING);
    run(spe);
  }
  spe_context_destroy(spe);
}

void load_a_program(benchmark::State& state) {
  for (auto _ : state) spe_context_destroy(load());
}

}  // namespace

BENCHMARK(mailbox_round_trip)->UseRealTime();
BENCHMARK(run_a_loaded_program);
BENCHMARK(load_a_program);
