#include "app/output.h"

#include <cstdio>

namespace cellsweep::app {

void print_text(const std::string& text) {
  std::fputs(text.c_str(), stdout);
}

void print_json(const nlohmann::ordered_json& json) {
  print_text(json.dump(2) + "\n");
}

ExitCode complain(const Status& status) {
  std::fprintf(stderr, "cellsweep: %s\n", status.message.c_str());
  return exit_code_of(status);
}

}  // namespace cellsweep::app
