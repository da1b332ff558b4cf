// spu-run: runs one SPU program alone, as if it were a program of this machine.
#include <libspe2.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "isa/debug/dwarf_lines.h"
#include "isa/debug/line_table_text.h"
#include "isa/elf/elf_loader.h"
#include "spu_emu/emulation.h"
#include "tools/cycle_table.h"
#include "tools/spu_arguments.h"

namespace {

/// Exit codes that do not come from the program.
enum ExitCode { kUsage = 124, kFault = 125, kNoProgram = 126, kNoFile = 127 };

/// A year.
constexpr double kMostSeconds = 365.0 * 24 * 3600;

constexpr const char* kFooter =
    "Exit codes: the program's own; 124 bad usage; 125 the program broke a rule,\n"
    "halted or stopped with a code that nobody here serves; 126 the file is no SPU\n"
    "program or does not fit; 127 the file cannot be read.\n\n"
    "main(argc, argv) of programs linked with -mstdmain gets the arguments.\n"
    "main(speid, argp, envp) of others gets in argp the address of the arguments\n"
    "(the program's name first), each ended by a NUL, to be fetched by DMA, and in\n"
    "envp their size, a multiple of 16. They lie at the begin of 1 MB of zeroes that\n"
    "the program may read and write.\n\n"
    "Examples:\n"
    "  spu-run hello.elf\n"
    "  spu-run --stats --dma late --seed 7 kernel.elf input.txt 100\n"
    "  spu-run --no-files --timeout 10 stranger.elf\n"
    "  spu-run --trace run.json kernel.elf        (opens in Perfetto)\n"
    "  spu-run --cycles --cycle-parameter sharing_spes=6 kernel.elf\n"
    "  spu-run --debug kernel.elf                 (then: help)\n"
    "  spu-run --debug-commands stops.txt kernel.elf\n";

struct Options {
  spu_emu::EmulationSettings settings;
  bool statistics = false;
  bool list_lines = false;
  bool cycles = false;
  std::vector<std::string> cycle_parameters;
  std::string trace;
  std::vector<std::string> command;
};

struct Failure : std::runtime_error {
  Failure(int code_, const std::string& text) : std::runtime_error(text), code(code_) {}
  int code;
};

void add_options(CLI::App& app, Options& options) {
  using spu_emu::DmaMode;
  static const std::map<std::string, DmaMode> modes{
      {"eager", DmaMode::eager}, {"late", DmaMode::late}, {"unchecked", DmaMode::unchecked}};
  app.prefix_command();
  app.footer(kFooter);
  app.add_flag("--stats", options.statistics,
               "Print instructions, speed and DMA counts on stderr\nat the end");
  app.add_option("--trace", options.trace, "Write a timeline in Chrome's JSON format")->type_name("FILE");
  app.add_flag_callback(
      "--no-files", [&options] { options.settings.library_calls = spu_emu::LibraryCallAccess::console; },
      "Refuse to open files of this machine; printf and\nthe standard streams still work");
  app.add_option("--max-instructions", options.settings.instruction_limit, "Stop after so many instructions");
  app.add_option_function<double>(
         "--timeout",
         [&options](double seconds) {
           options.settings.time_limit = std::chrono::milliseconds(std::llround(std::ceil(seconds * 1000)));
         },
         "Stop after so many seconds, waits included")
      ->check(CLI::Range(0.001, kMostSeconds).description(""))
      ->type_name("SECONDS");
  app.add_option("--dma", options.settings.dma_mode,
                 "When bytes of a transfer move: eager, late or\nunchecked")
      ->transform(CLI::CheckedTransformer(modes, CLI::ignore_case).description(""))
      ->type_name("MODE")
      ->default_str("eager");
  app.add_option("--seed", options.settings.seed, "Order of landing of late transfers");
  app.add_option("--local-store", options.settings.local_store_limit,
                 "Local store of this size, 256K at most")
      ->transform(CLI::AsSizeValue(false).description(""))
      ->type_name("SIZE");
}

void add_debugger_options(CLI::App& app, Options& options) {
  app.add_flag_callback(
      "--debug",
      [&options] {
        if (!options.settings.debugger) options.settings.debugger.emplace();
      },
      "Stop at the first instruction and ask for\ncommands; help teaches them");
  app.add_option_function<std::string>(
         "--debug-commands", [&options](const std::string& file) { options.settings.debugger = {file}; },
         "Take the debugger's commands from a file, one a\nline, and then run on")
      ->type_name("FILE");
  app.add_flag("--list-lines", options.list_lines,
               "Print which line of source each instruction comes\nfrom (needs -g), and end");
}

void add_cycle_options(CLI::App& app, Options& options) {
  app.add_flag("--cycles", options.cycles,
               "Print on stderr what the program would take on a\nCell, in all and by function");
  app.add_option("--cycle-parameter", options.cycle_parameters,
                 "Change a number of the cycle model; may be\nrepeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  app.add_flag_callback(
      "--list-cycle-parameters",
      [] {
        std::fputs(spu_emu::cycle_parameter_table({}).c_str(), stdout);
        throw CLI::Success();
      },
      "Print the numbers of the cycle model, what they\nmean and where they come from, and end");
}

/// A change of a number asks for the count, too.
void set_cycles(Options& options) {
  if (!options.cycles && options.cycle_parameters.empty()) return;
  options.settings.cycles.emplace();
  for (const std::string& each : options.cycle_parameters) {
    spu_emu::set_cycle_parameter(*options.settings.cycles, each);
  }
}

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Reads no further than a program can be long: a name may be that of a device without an end.
std::vector<char> read_program(const std::string& name) {
  constexpr std::size_t kStep = 65536;
  constexpr std::size_t kMostBytes = std::size_t{256} << 20U;
  const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(name.c_str(), "rb"));
  std::vector<char> bytes;
  std::size_t got = file ? kStep : 0;
  while (got == kStep) {
    if (bytes.size() >= kMostBytes) {
      throw Failure(kNoProgram, name + ": an SPU program has at most " + std::to_string(kMostBytes) +
                                    " bytes, and the file has more");
    }
    bytes.resize(bytes.size() + kStep);
    got = std::fread(bytes.data() + bytes.size() - kStep, 1, kStep, file.get());
    bytes.resize(bytes.size() - kStep + got);
  }
  if (!file || std::ferror(file.get()) != 0) throw Failure(kNoFile, name + ": " + std::strerror(errno));
  return bytes;
}

/// The library says it, too, when it loads the program: as of a program that cannot be loaded.
void check_commands(const std::string& name) {
  if (name.empty()) return;
  const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(name.c_str(), "r"));
  if (!file || (std::fgetc(file.get()) == EOF && std::ferror(file.get()) != 0)) {
    throw Failure(kNoFile, name + ": " + std::strerror(errno));
  }
}

/// Ends the context with itself.
struct ContextDeleter {
  void operator()(spe_context_ptr_t spe) const { spe_context_destroy(spe); }
};
using Context = std::unique_ptr<spe_context, ContextDeleter>;

Context load(std::vector<char>& file, const std::string& name) {
  const auto elf = spu_emu::isa::read_elf(std::as_bytes(std::span(file)));
  if (!elf.program) throw Failure(kNoProgram, name + ": " + elf.error);
  Context context(spe_context_create(SPE_EVENTS_ENABLE, nullptr));
  if (!context) throw Failure(kNoProgram, std::string("no SPE: ") + std::strerror(errno));
  if (spu_emu::program_load(context.get(), file.data(), file.size()) != 0) {
    throw Failure(kNoProgram, name + ": " + spu_emu::last_fault(context.get()));
  }
  return context;
}

/// Runs to the end; the exit code for the shell.
int run(spe_context_ptr_t spe, spu_emu::SpuArguments& arguments) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop{};
  const int result =
      spe_context_run(spe, &entry, SPE_RUN_USER_REGS, arguments.registers().data(), nullptr, &stop);
  std::fflush(stdout);
  if (result == 0 && stop.stop_reason == SPE_EXIT) return stop.result.spe_exit_code;
  std::string what = spu_emu::last_fault(spe);
  if (stop.stop_reason == SPE_STOP_AND_SIGNAL) {
    what = "the program stopped with code " + std::to_string(stop.result.spe_signal_code) +
           ", and no host program is there to go on with it\n" + spu_emu::where(spe);
  }
  if (stop.stop_reason == SPE_CALLBACK_ERROR)
    what = "the program made a library call that cannot be served here\n" + spu_emu::where(spe);
  std::fprintf(stderr, "spu-run: %s\n%s", what.c_str(), spu_emu::registers(spe).c_str());
  return kFault;
}

void print_statistics(spe_context_ptr_t spe, double seconds) {
  const spu_emu::SpeStatistics s = spu_emu::statistics(spe);
  const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
  std::fprintf(stderr, "instructions     %llu\n", number(s.instructions));
  std::fprintf(stderr, "seconds          %.3f (%.1f million instructions a second)\n", seconds,
               static_cast<double>(s.instructions) / seconds / 1e6);
  std::fprintf(stderr, "gets             %llu (%llu bytes)\n", number(s.gets), number(s.bytes_in));
  std::fprintf(stderr, "puts             %llu (%llu bytes)\n", number(s.puts), number(s.bytes_out));
  std::fprintf(stderr, "list elements    %llu\n", number(s.list_elements));
  std::fprintf(stderr, "waits for tags   %llu\n", number(s.tag_waits));
  std::fprintf(stderr, "atomics          %llu (%llu failed)\n", number(s.atomics), number(s.failed_atomics));
  std::fprintf(stderr, "local store      %u bytes in use at most\n", s.local_store_high_water);
}

void write_trace(const std::string& name) {
  std::ofstream file(name);
  spu_emu::write_trace(file);
  file.close();
  if (!file) throw Failure(kUsage, name + ": the timeline cannot be written");
}

int list_lines(const std::string& name) {
  const std::vector<char> file = read_program(name);
  const spu_emu::isa::DwarfLines dwarf = spu_emu::isa::read_dwarf_lines(std::as_bytes(std::span(file)));
  if (!dwarf.missing.empty()) throw Failure(kNoProgram, name + ": " + dwarf.missing);
  std::fputs(spu_emu::isa::line_table_text(dwarf.lines).c_str(), stdout);
  std::fputs(spu_emu::isa::variable_table_text(dwarf.variables).c_str(), stdout);
  return 0;
}

int run_command(Options& options) {
  if (options.list_lines) return list_lines(options.command.front());
  options.settings.trace = !options.trace.empty();
  if (const auto& debugger = options.settings.debugger) check_commands(debugger->commands);
  set_cycles(options);
  options.settings.code_reserve = 0;  // The file says what its code takes.
  const spu_emu::SettingsScope scope(options.settings);
  std::vector<char> file = read_program(options.command.front());
  const Context context = load(file, options.command.front());
  spu_emu::SpuArguments arguments(spu_emu::main_kind(std::as_bytes(std::span(file))), options.command,
                                  static_cast<std::uint32_t>(spe_ls_size_get(context.get())));
  const auto begin = std::chrono::steady_clock::now();
  const int code = run(context.get(), arguments);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  if (options.statistics) print_statistics(context.get(), time.count());
  if (const auto& cycles = options.settings.cycles) {
    std::fputs(spu_emu::cycle_table(spu_emu::cycle_profile(context.get()), cycles->hertz).c_str(), stderr);
  }
  if (!options.trace.empty()) write_trace(options.trace);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Runs an SPU ELF program by itself, instruction by instruction.\n"
      "usage: spu-run [OPTIONS] PROGRAM.elf [ARGUMENTS...]");
  add_options(app, options);
  add_debugger_options(app, options);
  add_cycle_options(app, options);
  try {
    app.parse(argc, argv);
    options.command = app.remaining();
    if (options.command.empty()) throw CLI::RequiredError("PROGRAM.elf");
    if (options.command.front().starts_with('-')) throw CLI::ExtrasError({options.command.front()});
    return run_command(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUsage;
  } catch (const Failure& failure) {
    std::fprintf(stderr, "spu-run: %s\n", failure.what());
    return failure.code;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "spu-run: %s\n", error.what());
    return kUsage;
  }
}
