/// @file
/// The `cellsweep` command.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "app/commands.h"

namespace {

// CLI11 has exit codes of its own; ours are documented as 0 for help and 2 for bad usage.
int exit_with_usage(const CLI::App& program, const CLI::ParseError& error) {
  return program.exit(error) == 0 ? cellsweep::app::kGood : cellsweep::app::kBadUsage;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace cellsweep::app;
  ExitCode exit_code = kGood;
  CLI::App program("Exact broadphase collision detection: run, compare and record scenes of boxes.",
                   "cellsweep");
  program.require_subcommand(1);
  add_simulate(program, exit_code);
  add_replay(program, exit_code);
  add_record(program, exit_code);
  add_verify(program, exit_code);
  add_engines(program, exit_code);
  add_local_store(program, exit_code);
  add_experiment(program, exit_code);
  add_render(program, exit_code);
  add_view(program, exit_code);
  add_demo(program, exit_code);
  program.footer(
      "Examples:\n"
      "  cellsweep simulate --scene paper --bodies 1024 --frames 1000\n"
      "  cellsweep replay bench/scenes/bullet-pile-1024.aabbs --json\n"
      "  cellsweep verify --scene varied --bodies 500 --moving 1\n"
      "  cellsweep experiment --out results\n"
      "  cellsweep render --scene paper --frame 100 --out scene.png\n"
      "  cellsweep view --scene paper --engine cell-resident\n"
      "Exit codes: 0 good, 1 results differ from the oracle, 2 bad usage or input, 3 over an engine's "
      "capacity, 4 an SPE failed, 5 no display for view.");
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return exit_with_usage(program, error);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cellsweep: %s\n", error.what());
    return kBadUsage;
  }
  return exit_code;
}
