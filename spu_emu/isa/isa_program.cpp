#include "isa/isa_program.h"

#include <algorithm>
#include <cerrno>
#include <stdexcept>

#include "isa/elf/effective_addresses.h"
#include "isa/encoding/disassembler.h"
#include "isa/timing/code_ranges.h"
#include "mfc/format.h"
#include "spe/debugger_choice.h"

namespace spu_emu::isa {

namespace {
constexpr unsigned kRegisters = 128;

constexpr bool is_exit(std::uint32_t code) {
  return (code & 0xff00U) == 0x2000U;
}
constexpr bool is_library_call(std::uint32_t code) {
  return (code & 0xff00U) == 0x2100U;
}
}  // namespace

IsaProgram::IsaProgram(Spe& spe)
    : spe_(spe),
      store_(spe.arena(), spe.settings(), *this),
      machine_(store_.bytes(), spe.channels()),
      calls_(StoreBytes({store_.bytes(), store_.limit()}, this), spe.settings().library_calls) {
  if (!spe.settings().cycles) return;
  cycles_ = std::make_unique<CycleModel>(*spe.settings().cycles, store_.bytes());
  machine_.set_observer(*cycles_);
}

LoadResult IsaProgram::load(Spe& spe, const ProgramImage& image) {
  const std::span<const std::byte> file = image.bytes;
  ElfResult elf = read_elf(file);
  if (!elf.program) return {nullptr, EINVAL, elf.error};
  auto program = std::make_unique<IsaProgram>(spe);
  std::string too_large = program->store_.place(*elf.program);
  if (!too_large.empty()) return {nullptr, ENOMEM, std::move(too_large)};
  std::string unreadable = place_effective_addresses(elf.program->toe, image.toe, program->store_.bytes());
  if (!unreadable.empty()) return {nullptr, EINVAL, std::move(unreadable)};
  program->overlays_.provide(file, *elf.program, program->store_.bytes());
  program->entry_ = elf.program->entry;
  program->symbols_ = std::move(elf.program->symbols);
  if (program->cycles_) program->cycles_->set_code(code_ranges(program->symbols_, elf.program->end));
  program->high_water_ = elf.program->end;  // the rest of the local store has been cleared
  try {
    program->attach_debugger(file);
  } catch (const std::runtime_error& error) {
    return {nullptr, ENOENT, error.what()};
  } catch (const std::invalid_argument& error) {
    return {nullptr, EINVAL, error.what()};
  }
  return {std::move(program), 0, {}};
}

void IsaProgram::attach_debugger(std::span<const std::byte> file) {
  const auto chosen = debugger_of(spe_.settings(), spe_.number());
  if (!chosen) return;
  debugger_ = std::make_unique<Debugger>(spe_, machine_, store_.bytes(), chosen->commands, symbols_, file);
}

void IsaProgram::store_written(std::uint32_t ls, std::uint32_t size) noexcept {
  machine_.local_store_written(ls, size);
  if (debugger_) debugger_->store_written();
}

void IsaProgram::set_doubleword(unsigned reg, std::uint64_t value) {
  machine_.set_word(reg, 0, static_cast<std::uint32_t>(value >> 32U));
  machine_.set_word(reg, 1, static_cast<std::uint32_t>(value));
}

/// As libspe2 leaves them: arguments in r3 to r5, the local store's effective address in r6. r1 is for
/// programs without start-up code, which find a stack there.
void IsaProgram::set_registers(const Arguments& arguments) {
  machine_.reset();
  machine_.set_word(1, 0, store_.stack_top());
  machine_.set_word(1, 1, store_.stack_top() - store_.image_end());
  set_doubleword(6, reinterpret_cast<std::uintptr_t>(spe_.arena().base()));
  if (arguments.user_registers == nullptr) {
    set_doubleword(3, arguments.speid);
    set_doubleword(4, arguments.argp);
    set_doubleword(5, arguments.envp);
    return;
  }
  for (unsigned i = 0; i < 12; ++i) machine_.set_word(3 + i / 4, i % 4, arguments.user_registers[i]);
}

Stop IsaProgram::start(const Arguments& arguments) {
  set_registers(arguments);
  machine_.set_pc(entry_);
  if (debugger_) debugger_->started();
  is_over_ = false;
  store_known_ = true;
  return run();
}

bool IsaProgram::can_resume(unsigned int entry) const {
  return !is_over_ && entry % 4 == 0 && entry < kHardwareSize;
}

Stop IsaProgram::resume(unsigned int entry) {
  machine_.set_pc(entry);
  if (debugger_) debugger_->resumed();
  return run();
}

Stop IsaProgram::run() {
  if (!store_known_) store_written(0, kHardwareSize);
  store_known_ = false;
  try {
    const MachineStop stop = execute();
    spe_.channels().finish();
    return translate(stop);
  } catch (const Fault& fault) {
    return end_by(fault);
  }
}

MachineStop IsaProgram::execute() {
  const std::uint64_t limit = spe_.settings().instruction_limit;
  const std::uint64_t done = machine_.instructions();
  const std::uint64_t allowed = limit == 0 ? UINT64_MAX - done : limit - std::min(limit, done);
  return spe_.deadline() == WaitPoint::Time::max() ? machine_.run(allowed)
                                                   : run_until_deadline(done + allowed);
}

/// Looks at the clock every few milliseconds. `most` counts from the program's start.
MachineStop IsaProgram::run_until_deadline(std::uint64_t most) {
  constexpr std::uint64_t kBetweenLooks = 1U << 18U;
  for (;;) {
    const std::uint64_t left = most - machine_.instructions();
    const MachineStop stop = machine_.run(std::min(left, kBetweenLooks));
    if (stop.kind != MachineStop::Kind::budget || left <= kBetweenLooks) return stop;
    if (std::chrono::steady_clock::now() < spe_.deadline()) continue;
    throw Fault(Rule::time_limit,
                format("SPE %u's program has run for %lld ms and has not ended", spe_.number(),
                       static_cast<long long>(spe_.settings().time_limit.count())));
  }
}

Stop IsaProgram::translate(const MachineStop& stop) {
  if (stop.kind != MachineStop::Kind::stop || !is_library_call(stop.code)) note_progress();
  if (const auto touched = store_.limit() < kHardwareSize ? store_.touched_beyond_limit() : std::nullopt) {
    throw Fault(Rule::local_store_full, format("the program wrote to LS 0x%05x, beyond the limit of %u bytes",
                                               *touched, store_.limit()));
  }
  switch (stop.kind) {
    case MachineStop::Kind::stop:
      return at_stop_instruction(stop);
    case MachineStop::Kind::halt:
      throw Fault(Rule::halt, "a halt instruction's condition held");
    case MachineStop::Kind::illegal:
      throw Fault(Rule::illegal_instruction, format("0x%08x encodes no instruction", stop.code));
    default:
      throw Fault(Rule::instruction_limit,
                  format("%llu instructions are executed",
                         static_cast<unsigned long long>(spe_.settings().instruction_limit)));
  }
}

/// A library call has its argument word behind the stop.
Stop IsaProgram::at_stop_instruction(const MachineStop& stop) {
  stopped_at_ = (stop.pc - 4) % kHardwareSize;
  if (is_exit(stop.code) && debugger_) debugger_->ended(stop.code & 0xffU);
  if (is_exit(stop.code)) return {Stop::Kind::exit, stop.code, 0, {}};
  if (is_library_call(stop.code)) return {Stop::Kind::library_call, stop.code, stop.pc, {}};
  return {Stop::Kind::signal, stop.code, 0, {}};
}

int IsaProgram::serve_library_call(const Stop& call) {
  store_known_ = true;
  return calls_.serve(call.code, call.argument) ? 0 : -1;
}

/// The program is over: what is in flight never lands.
Stop IsaProgram::end_by(const Fault& fault) {
  if (debugger_) debugger_->failed(fault.text());
  spe_.channels().abandon();
  is_over_ = true;
  stopped_at_ = machine_.pc();
  note_progress();
  spe_.set_last_fault(fault.text() + "\n" + where());
  return {Stop::Kind::fault, 0, 0, stop_report(fault.rule())};
}

std::string IsaProgram::place_of(std::uint32_t pc) const {
  const std::string symbol = nearest_symbol(symbols_, pc);
  std::string text = disassemble(read_word(store_.bytes() + pc), pc);
  std::replace(text.begin(), text.end(), '\t', ' ');
  return format("  at pc 0x%05x%s%s: %s", pc, symbol.empty() ? "" : " in ", symbol.c_str(), text.c_str());
}

std::string IsaProgram::registers() const {
  std::string text;
  for (unsigned reg = 0; reg < kRegisters; ++reg) {
    text += format("  r%-3u", reg);
    for (unsigned slot = 0; slot < 4; ++slot) text += format(" %08x", machine_.word(reg, slot));
    text += reg % 2 == 0 ? "  " : "\n";
  }
  return text;
}

void IsaProgram::note_progress() {
  high_water_.store(std::max(high_water(), store_.bytes_in_use()), std::memory_order_relaxed);
  instructions_.store(machine_.instructions(), std::memory_order_relaxed);
}

}  // namespace spu_emu::isa
