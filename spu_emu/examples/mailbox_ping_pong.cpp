// Sends numbers to an SPE through its mailbox and reads the answers.
#include <thread>

#include "run_spe.h"

extern "C" spe_program_handle_t mailbox_ping_pong_spu;

int main(int argc, char** argv) {
  set_mode_from_arguments(argc, argv);
  spe_context_ptr_t spe = load_spe(mailbox_ping_pong_spu);
  bool ran = false;
  std::thread thread([&] { ran = run_spe(spe, nullptr); });
  bool right = true;
  for (unsigned int message = 1; message <= 1000; ++message) {
    unsigned int answer = 0;
    spe_in_mbox_write(spe, &message, 1, SPE_MBOX_ALL_BLOCKING);
    spe_out_intr_mbox_read(spe, &answer, 1, SPE_MBOX_ALL_BLOCKING);
    right = right && answer == message + 1;
  }
  unsigned int end = 0;
  spe_in_mbox_write(spe, &end, 1, SPE_MBOX_ALL_BLOCKING);
  thread.join();
  spe_context_destroy(spe);
  std::printf("1000 answers: %s\n", right ? "right" : "wrong");
  return ran && right ? EXIT_SUCCESS : EXIT_FAILURE;
}
