#include <fstream>

#include "base/text.h"
#include "failing_calls.h"

namespace cellsweep::app {

// A sanitizer has its own malloc and open; the preloaded library would be of another machine's kind.
bool can_fail_calls() {
#if defined(CELLSWEEP_SANITIZED_TESTS) || defined(CELLSWEEP_EMULATED_TESTS)
  return false;
#else
  return true;
#endif
}

CommandResult run_failing(const std::string& arguments, const CallPlan& plan) {
  return run_command(arguments, text("LD_PRELOAD=", CELLSWEEP_FAILING_CALLS, " CELLSWEEP_FAIL='", plan.kind,
                                     " ", plan.number, plan.and_later ? "+" : "", " ", plan.what, "'"));
}

long calls_of(const std::string& kind, const std::string& arguments) {
  const ScratchFolder scratch;
  run_command(arguments,
              text("LD_PRELOAD=", CELLSWEEP_FAILING_CALLS, " CELLSWEEP_CALLS=", scratch.path("calls")));
  std::ifstream calls(scratch.path("calls"));
  std::string name;
  long number = 0;
  while (calls >> name >> number) {
    if (name == kind) return number;
  }
  return 0;
}

}  // namespace cellsweep::app
