/// @file
/// The engines that the contract suite runs on: the whole engine table, and settings worth a run of their
/// own.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/engines.h"

namespace cellsweep::contract {

/// An engine with settings. The label is its name in test names: letters, digits and `_`.
struct ContractEngine {
  using Maker = std::function<Result<Broadphase>()>;

  std::string name;
  Maker make;
  std::string label;
  /// Finds settings with which its capacity is small enough to fill in a test, but not below the 16 bodies
  /// that the fixed scenes of the suite need; null where no setting does that.
  std::function<Maker()> shrink{};
  bool takes_poses = false;
};

/// Whether an engine of the table is tested: every one is, but with the thread sanitizer those that never
/// have a second thread.
bool takes_part(std::string_view name);

/// Every engine of the table that takes part with default settings, then the extra settings. A new engine is
/// here by being in the table; settings that give up exactness (`literal`) are never here.
const std::vector<ContractEngine>& contract_engines();

/// An engine of the table by name, with settings as texts.
ContractEngine engine_with_settings(const std::string& name, const SettingValues& settings,
                                    std::string label);

/// Whether its SPU programs run instruction by instruction, which takes long.
bool is_interpreted(const ContractEngine& engine);

/// The name of an engine in letters, digits and `_`.
std::string label_of(std::string_view name);

/// Whether an engine of the table has a setting of that name.
bool has_setting(const EngineInfo& info, std::string_view setting);

/// A new broadphase; throws std::runtime_error with the status' message when there is none.
Broadphase make(const ContractEngine& engine);

std::ostream& operator<<(std::ostream& out, const ContractEngine& engine);

}  // namespace cellsweep::contract
