#include "app/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/output.h"
#include "app/process.h"
#include "app/suggestion.h"
#include "app/wrap.h"
#include "base/text.h"
#include "report/build_context.h"

namespace cellsweep::app {
namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  cellsweep simulate --scene paper --bodies 1024 --frames 1000\n"
    "  cellsweep replay bench/scenes/bullet-pile-1024.aabbs --json\n"
    "  cellsweep verify --scene varied --bodies 500 --moving 1\n"
    "  cellsweep query --scene paper --frame 100 --box 0,0,0,2,2,2\n"
    "  cellsweep experiment --out results\n"
    "  cellsweep render --scene paper --frame 100 --out scene.png\n"
    "  cellsweep view --scene paper --engine cell-resident\n"
    "Exit codes: 0 good, 1 results differ from the oracle, 2 bad usage or input,\n"
    "3 over an engine's capacity, 4 an SPE failed, 5 no display for view,\n"
    "6 output was lost, 7 no more memory; 130 stopped by Ctrl-C and 143 by SIGTERM,\n"
    "with what there was by then.";

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

/// The command line, its subcommands, and what became of the one that was chosen.
class Program {
 public:
  Program() {
    program_.formatter(std::make_shared<HelpFormat>());
    program_.set_version_flag("--version", report::version_text(), "Print the version and exit");
    for (const auto add : {add_simulate, add_replay, add_record, add_verify, add_query, add_engines,
                           add_local_store, add_experiment, add_render, add_view, add_demo}) {
      add(program_, exit_code_);
    }
    program_.require_subcommand(1);
    program_.footer(kFooter);
  }

  int run(int argc, char** argv) {
    if (const std::string fault = fault_of_command(argc, argv); !fault.empty()) return complain_of(fault);
    try {
      program_.parse(argc, argv);
    } catch (const CLI::ExtrasError&) {
      return complain_of(fault_of_rest());
    } catch (const CLI::ParseError& error) {
      return error.get_exit_code() == 0 ? program_.exit(error) : complain_of(error.what());
    }
    return exit_code_;
  }

 private:
  static ExitCode complain_of(const std::string& fault) {
    say(fault);
    return kBadUsage;
  }

  std::vector<std::string> command_names() const {
    std::vector<std::string> names;
    for (const CLI::App* command : program_.get_subcommands({})) names.push_back(command->get_name());
    return names;
  }

  // What is wrong with the first word that is no flag; empty when it is a command, or help is asked for.
  std::string fault_of_command(int argc, char** argv) const {
    const std::vector<std::string> names = command_names();
    const std::string list = wrapped("There are: " + joined(names) + ".");
    if (argc < 2) return "A command is wanted.\n" + list + "\ncellsweep --help says what they do.";
    const std::string word = argv[1];
    if (word.starts_with("-") || std::find(names.begin(), names.end(), word) != names.end()) return {};
    const auto meant = nearest(word, names);
    return text("There is no command \"", word, "\"",
                meant ? "; did you mean " + *meant + "?" : std::string("."), "\n", list);
  }

  // What is wrong with the first argument that the chosen command could not use.
  std::string fault_of_rest() const {
    const std::vector<std::string> rest = program_.remaining(true);
    const std::vector<CLI::App*> chosen = program_.get_subcommands();
    const CLI::App& command = chosen.empty() ? program_ : *chosen.front();
    const std::string argument = rest.empty() ? "" : rest.front();
    const std::string flag = argument.substr(0, argument.find('='));
    const auto meant = nearest(flag, flags_of(command));
    return text(command.get_name(), flag.starts_with("-") ? " has no flag \"" : " has no use for \"", flag,
                "\"", meant ? "; did you mean " + *meant + "?" : std::string("."), "\ncellsweep ",
                chosen.empty() ? "" : command.get_name() + " ", "--help says what there is.");
  }

  static std::vector<std::string> flags_of(const CLI::App& command) {
    std::vector<std::string> flags;
    for (const CLI::Option* option : command.get_options()) {
      for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
    }
    return flags;
  }

  ExitCode exit_code_ = kGood;
  CLI::App program_{"Exact broadphase collision detection: run, compare and record scenes of boxes.",
                    "cellsweep"};
};

}  // namespace

int run_program(int argc, char** argv) {
  try {
    const int code = Program().run(argc, argv);
    return end_of_program(code);
  } catch (const std::exception& error) {
    if (is_want_of_memory(error)) end_without_memory();
    say(error.what());
    return kBadUsage;
  }
}

}  // namespace cellsweep::app
