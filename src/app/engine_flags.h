/// @file
/// The flags that choose engines and their settings.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cellsweep/engines.h"
#include "report/cell_time.h"
#include "report/run_engine.h"

namespace cellsweep::app {

using Engines = std::vector<std::unique_ptr<Broadphase>>;

/// Adds --engine, --threads and the settings of single engines to a command, and makes what they ask for.
class EngineFlags {
 public:
  /// `only` as the default of --engine; empty: the whole table.
  void add_to(CLI::App& command, std::string only = {});

  /// Adds --cycles and what goes with it, for commands that show frames' times.
  void add_cycle_flags(CLI::App& command);

  const std::vector<std::string>& names() const { return names_; }
  const EngineOptions& options() const { return options_; }

  /// What the engines are to be given.
  report::Shape shape() const { return options_.spu_boxes ? report::Shape::poses : report::Shape::boxes; }

  /// What is not simulated of a Cell is to cost.
  const report::PpuCosts& ppu_costs() const { return ppu_costs_; }

  /// One empty engine a name. Errors: those of make_engine().
  Result<Engines> make() const;

 private:
  void add_cell_flags(CLI::App& command);

  std::vector<std::string> names_;
  EngineOptions options_;
  report::PpuCosts ppu_costs_;
};

}  // namespace cellsweep::app
