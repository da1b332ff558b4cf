#include "app/output.h"

#include <cstdio>

#include "app/setting_flags.h"
#include "report/interrupt.h"

namespace cellsweep::app {

void print_text(const std::string& text) {
  std::fputs(text.c_str(), stdout);
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
  say("Stopped by Ctrl-C. " + when_interrupted);
  return kInterrupted;
}

}  // namespace cellsweep::app
