#include "isa/debug/debugger.h"

#include <unistd.h>

#include <utility>

#include "isa/debug/commands.h"
#include "isa/debug/line_reader.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {

/// What `quit` ends the process with, as spu-run ends when a program broke a rule.
constexpr int kQuitCode = 125;

/// Of all debuggers of the process one asks at a time.
std::mutex& prompt_mutex() {
  static std::mutex mutex;
  return mutex;
}

Session make_session(Spe& spe, Machine& machine, std::byte* store, std::vector<ElfSymbol> symbols,
                     std::span<const std::byte> elf_file) {
  DwarfLines dwarf = read_lines(elf_file);
  return {spe,
          machine,
          store,
          CodeMap(std::move(symbols), std::move(dwarf.lines)),
          std::move(dwarf.missing),
          std::move(dwarf.variables)};
}

}  // namespace

Debugger::Debugger(Spe& spe, Machine& machine, std::byte* store, const std::string& commands,
                   std::vector<ElfSymbol> symbols, std::span<const std::byte> elf_file)
    : session_(make_session(spe, machine, store, std::move(symbols), elf_file)),
      console_(commands),
      timer_(machine),
      prompt_(format("(spu %u) ", spe.number())) {
  ctrl_c_.emplace(machine);
  machine.set_traps(*this);
  spe.channels().set_wait_listener(this);
}

Debugger::~Debugger() {
  session_.spe.channels().set_wait_listener(nullptr);
}

void Debugger::started() {
  spu_thread_.store(std::this_thread::get_id());
  starts_ = !detached_;
  session_.is_over = false;
  standing_at_.reset();
  done_at_.reset();
  session_.machine.decode_again();
}

void Debugger::resumed() {
  spu_thread_.store(std::this_thread::get_id());
}

void Debugger::store_written() {
  const bool here = std::this_thread::get_id() == spu_thread_.load();
  (here ? written_here_ : written_elsewhere_).store(true);
  session_.machine.ask_for_attention();
}

bool Debugger::wants(std::uint32_t pc, std::uint32_t word) const {
  if (detached_) return false;
  return starts_ || session_.plan.wants(pc) || session_.breakpoints.wants(pc, word);
}

/// Everything that says that the program is to stop before this instruction.
bool Debugger::come(std::uint32_t pc) {
  if (detached_ || std::exchange(done_at_, std::nullopt) == pc) return true;
  const bool stands = std::exchange(standing_at_, std::nullopt) == pc;
  std::vector<std::string> reasons;
  if (!stands) reasons = session_.breakpoints.meet(pc, session_.word(pc), session_.machine);
  const bool was_out = session_.plan.goes_out();
  bool stops =
      session_.plan.arrive(pc, session_.machine.word(1, 0), session_.map.lines()) || !reasons.empty();
  if (stops && was_out && reasons.empty()) reasons.push_back(returned_text());
  if (std::exchange(starts_, false)) {
    reasons.insert(reasons.begin(), format("SPE %u's program begins", session_.spe.number()));
    stops = true;
    session_.stops_have_changed = true;
  }
  if (stops) stop(reasons);
  // Nobody has looked at what this store does to bytes that are watched.
  if (stands || stops) session_.breakpoints.expect(pc, session_.word(pc), session_.machine);
  return leave(pc);
}

/// r3 has what a function returns.
std::string Debugger::returned_text() const {
  std::string text = "the function has returned, r3";
  for (unsigned slot = 0; slot < 4; ++slot) text += format(" %08x", session_.machine.word(3, slot));
  return text;
}

/// Also notes what the instruction at `pc`, which is next, means for the plan.
bool Debugger::leave(std::uint32_t pc) {
  if (!detached_) session_.plan.leave(pc, session_.word(pc), session_.machine.word(1, 0));
  if (!take_changes()) return true;
  done_at_ = pc;
  return false;
}

/// True if other instructions are wanted now.
bool Debugger::take_changes() {
  const bool plan = session_.plan.changed();
  const bool stops = std::exchange(session_.stops_have_changed, false);
  if (plan || stops) session_.machine.decode_again();
  return plan || stops;
}

std::vector<std::string> Debugger::reasons_from_outside() {
  std::vector<std::string> reasons;
  if (ctrl_c_ && ctrl_c_->take()) reasons.emplace_back("interrupted");
  if (timer_.take()) reasons.emplace_back("the time is up");
  const bool here = written_here_.exchange(false);
  const bool elsewhere = written_elsewhere_.exchange(false);
  if (!here && !elsewhere) return reasons;
  const char* who = here ? "this SPE's MFC or library call" : "the host or another SPE";
  for (std::string& each : session_.breakpoints.changed_by(who)) reasons.push_back(std::move(each));
  return reasons;
}

void Debugger::attend() {
  if (detached_ || starts_) return;
  const auto reasons = reasons_from_outside();
  if (reasons.empty()) return;
  stop(reasons);
  standing_at_ = session_.machine.pc();
  take_changes();
}

/// The instruction that waits is being executed: the next one to come is another.
void Debugger::still_waiting(const char* what) {
  if (detached_) return;
  auto reasons = reasons_from_outside();
  if (reasons.empty()) return;
  reasons.push_back(format("SPE %u waits: %s", session_.spe.number(), what));
  stop(reasons);
  leave(session_.machine.pc());
  done_at_.reset();
}

void Debugger::failed(const std::string& text) {
  if (detached_) return;
  session_.is_over = true;
  stop({text});
  session_.plan = RunPlan();
}

void Debugger::ended(std::uint32_t exit_code) {
  if (detached_) return;
  timer_.cancel();
  std::string text =
      format("SPE %u's program has ended with exit code %u after %llu instructions\n", session_.spe.number(),
             exit_code, static_cast<unsigned long long>(session_.machine.instructions()));
  if (const unsigned rest = console_.count_rest(); rest != 0)
    text += format("%u commands were not used\n", rest);
  console_.write(text);
}

void Debugger::stop(const std::vector<std::string>& reasons) {
  const std::lock_guard lock(prompt_mutex());
  const auto begin = std::chrono::steady_clock::now();
  timer_.cancel();
  std::string text;
  for (const std::string& each : reasons) text += each + "\n";
  console_.write(text + session_.standing());
  ask();
  session_.spe.add_time(std::chrono::steady_clock::now() - begin);
  if (session_.time && !detached_) timer_.start(*session_.time);
}

void Debugger::ask() {
  session_.goes_on = false;
  while (!session_.goes_on) {
    const auto line = console_.read(prompt_);
    if (!line) return detach();
    do_command(*line);
  }
}

/// An empty line is the last one again, where somebody types.
void Debugger::do_command(const std::string& line) {
  if (!line.empty()) last_line_ = line;
  console_.write(execute(session_, last_line_));
  session_.stops_have_changed = session_.stops_have_changed || session_.goes_on;
  if (!session_.quits) return;
  std::fflush(nullptr);
  _exit(kQuitCode);
}

/// From here on the program runs as if it had never been debugged.
void Debugger::detach() {
  detached_ = true;
  session_.breakpoints.remove_all();
  session_.plan = RunPlan();
  session_.stops_have_changed = true;
  session_.time.reset();
  ctrl_c_.reset();
  session_.spe.channels().set_wait_listener(nullptr);
}

}  // namespace spu_emu::isa
