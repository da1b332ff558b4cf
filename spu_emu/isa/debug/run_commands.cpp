// Commands that let the program run, a little or to its end.
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "isa/debug/commands.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {

using Calls = RunPlan::Calls;

std::uint64_t count_in(const Words& words, const char* usage) {
  check_count(words, 1, usage);
  const std::uint32_t count = words.empty() ? 1 : number_in(words.front());
  if (count == 0) throw CommandError("0 is no number of steps: 1 is the smallest.");
  return count;
}

std::string go(Session& session, const RunPlan& plan) {
  session.goes_on = true;
  session.plan = plan;
  session.time.reset();
  return session.is_over ? "The program broke a rule and cannot go on: it ends.\n" : "";
}

std::string step_instructions(Session& session, const Words& words, Calls calls, const char* usage) {
  return go(session, RunPlan::instructions(count_in(words, usage), calls));
}

/// By instruction where no lines are known.
std::string step_lines(Session& session, const Words& words, Calls calls, const char* usage) {
  const std::uint64_t count = count_in(words, usage);
  const auto row = session.map.lines().at(session.machine.pc());
  if (row) return go(session, RunPlan::statements(count, *row, calls));
  const std::string why =
      session.no_lines.empty() ? "No source line is known for this instruction." : session.no_lines;
  return go(session, RunPlan::instructions(count, calls)) + why + " One step is one instruction here.\n";
}

std::string step(Session& session, const Words& words) {
  return step_lines(session, words, Calls::into, "step [N]");
}
std::string next(Session& session, const Words& words) {
  return step_lines(session, words, Calls::over, "next [N]");
}
std::string stepi(Session& session, const Words& words) {
  return step_instructions(session, words, Calls::into, "stepi [N]");
}
std::string nexti(Session& session, const Words& words) {
  return step_instructions(session, words, Calls::over, "nexti [N]");
}

std::string finish(Session& session, const Words& words) {
  check_count(words, 0, "finish");
  const Frame frame = session.frames().front();
  if (frame.return_address == 0) throw CommandError("No caller is known that this function could return to.");
  return go(session, RunPlan::out_to({frame.return_address, frame.caller_sp}));
}

std::chrono::milliseconds seconds_in(const std::string& text) {
  char* end = nullptr;
  const double seconds = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0' || !(seconds >= 0.001 && seconds <= 1e6)) {
    throw CommandError("\"" + text + "\" is no number of seconds: 0.001 to 1000000.");
  }
  return std::chrono::milliseconds(std::llround(seconds * 1000));
}

std::string go_on(Session& session, const Words& words) {
  check_count(words, 2, "continue [for SECONDS]");
  if (words.empty()) return go(session, RunPlan());
  if (words.size() != 2 || words.front() != "for") throw CommandError("It is: continue [for SECONDS]");
  const auto time = seconds_in(words[1]);
  std::string text = go(session, RunPlan());
  session.time = time;
  return text;
}

std::string quit(Session& session, const Words& words) {
  check_count(words, 0, "quit");
  session.quits = true;
  return {};
}

constexpr DebuggerCommand kRunCommands[] = {
    {"continue", "c", "[for SECONDS]", "Run on, to the next stop or for some time",
     "Examples:\n"
     "  continue           to the next breakpoint, a broken rule or the end\n"
     "  continue for 2.5   and then stop, also in the middle of a wait\n",
     go_on},
    {"step", "s", "[N]", "Run to another source line, also in functions that are called",
     "Functions without lines (the C library's) are run through. Without source lines it is stepi.\n"
     "Examples:\n"
     "  step      one line\n"
     "  step 5    five lines\n",
     step},
    {"next", "n", "[N]", "The same, but calls count as a part of their line",
     "Breakpoints in functions that are called still stop.\nExample:\n  next 3\n", next},
    {"stepi", "si", "[N]", "Run one instruction",
     "A library call (printf) is done by the host and counts as one instruction.\nExample:\n  stepi 16\n",
     stepi},
    {"nexti", "ni", "[N]", "The same, but a call counts as one instruction", "Example:\n  nexti\n", nexti},
    {"finish", "fin", "", "Run until the function returns to its caller",
     "r3 is shown then, which has what it returns.\n", finish},
    {"quit", "q", "", "End the process, with exit code 125", "", quit},
};

}  // namespace

std::span<const DebuggerCommand> run_commands() {
  return kRunCommands;
}

}  // namespace spu_emu::isa
