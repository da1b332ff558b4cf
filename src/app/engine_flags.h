/// @file
/// The flags that choose engines and their settings.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "app/setting_flags.h"
#include "cellsweep/engines.h"
#include "report/cell_time.h"
#include "report/verify.h"

namespace cellsweep::app {

/// Adds --engine, and a flag for every setting that an engine of the table has, to a command, and makes what
/// they ask for. A setting goes to the chosen engines that have it; one that none of them has is refused.
class EngineFlags {
 public:
  /// What a command is for. One that shows no frames' times has no use for those of a Cell; one that compares
  /// all with the oracle none for another oracle.
  enum class Purpose { times, verdicts, a_look };

  /// `only` as the default of --engine; empty: the whole table.
  void add_to(CLI::App& command, Purpose purpose, std::string only = {});

  /// The engines chosen; without --engine, and no other default, all of the table that the purpose needs.
  std::vector<std::string> names() const;

  /// Every setting that was given, whichever engines have it.
  const SettingValues& values() const { return values_; }

  /// Whether the chosen engines are there, and each setting is one that one of them has. Errors: bad_option.
  Status check() const;

  /// What is not simulated of a Cell is to cost.
  const report::PpuCosts& ppu_costs() const { return ppu_costs_; }

  /// One empty engine a name. When the whole table is meant, those that do not hold so many bodies are left
  /// out, and the oracle where it would take long; standard error says which. Errors: those of check() and
  /// make_broadphase().
  Result<std::vector<report::FedEngine>> make(std::size_t bodies) const;

 private:
  void add_setting(CLI::App& command, const SharedSetting& setting);
  void add_ppu_flags(CLI::App& command);

  Purpose purpose_ = Purpose::times;
  std::vector<std::string> names_;
  SettingValues values_;
  report::PpuCosts ppu_costs_;
};

}  // namespace cellsweep::app
