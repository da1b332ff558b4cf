/// @file
/// The flags that choose engines and their settings.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cellsweep/engines.h"
#include "report/run_engine.h"

namespace cellsweep::app {

using Engines = std::vector<std::unique_ptr<Broadphase>>;

/// Adds --engine, --threads and the settings of single engines to a command, and makes what they ask for.
class EngineFlags {
 public:
  /// `only` as the default of --engine; empty: the whole table.
  void add_to(CLI::App& command, std::string only = {});

  const std::vector<std::string>& names() const { return names_; }
  const EngineOptions& options() const { return options_; }

  /// What the engines are to be given.
  report::Shape shape() const { return options_.spu_boxes ? report::Shape::poses : report::Shape::boxes; }

  /// One empty engine a name. Errors: those of make_engine().
  Result<Engines> make() const;

 private:
  void add_cell_flags(CLI::App& command);

  std::vector<std::string> names_;
  EngineOptions options_;
};

}  // namespace cellsweep::app
