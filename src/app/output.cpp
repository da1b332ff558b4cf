#include "app/output.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "app/setting_flags.h"
#include "base/text.h"
#include "cellsweep/engine/timeline.h"
#include "report/interrupt.h"

namespace cellsweep::app {
namespace {

// Why standard output was lost; 0: it was not. Later errors are often of another kind.
int lost_output = 0;

void note_output(bool worked) {
  if (!worked && lost_output == 0) lost_output = errno != 0 ? errno : EIO;
}

}  // namespace

void print_text(const std::string& text) {
  note_output(std::fputs(text.c_str(), stdout) >= 0);
}

void print_json(const nlohmann::ordered_json& json) {
  print_text(json.dump(2) + "\n");
}

void say(const std::string& sentence) {
  std::fprintf(stderr, "cellsweep: %s\n", sentence.c_str());
}

ExitCode complain(const Status& status) {
  say(message_with_flags(status));
  return exit_code_of(status);
}

ExitCode end_with(ExitCode code, const std::string& when_interrupted) {
  if (!report::is_interrupted()) return code;
  say(text("Stopped by ", report::interrupt_name(), ". ", when_interrupted));
  return report::interrupt_signal() == SIGTERM ? kTerminated : kInterrupted;
}

int end_of_program(int code) {
  // Help is written through std::cout, which has stdio's buffer.
  note_output(std::fflush(stdout) == 0 && std::ferror(stdout) == 0);
  if (lost_output != 0) {
    say(text("Standard output cannot be written: ", std::generic_category().message(lost_output), "."));
    if (code == kGood) code = kOutputLost;
  }
  if (const Status status = Timeline::take_failure(); !status.ok()) {
    const ExitCode failed = complain(status);
    if (code == kGood) code = failed;
  }
  return code;
}

}  // namespace cellsweep::app
