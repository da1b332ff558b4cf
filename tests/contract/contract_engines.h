/// @file
/// The engines that the contract suite runs on: the whole engine table, and option sets worth a run of their
/// own.
#pragma once

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "cellsweep/engines.h"

namespace cellsweep::contract {

/// An engine and the options to make it with. The label is its name in test names: letters, digits and `_`.
struct ContractEngine {
  std::string name;
  EngineOptions options;
  std::string label;
};

/// Every engine of the table with default options, then the extra option sets. A new engine is here by being
/// in the table; options that give up exactness (`literal`) are never here.
const std::vector<ContractEngine>& contract_engines();

/// Options that make the engine's capacity small enough to fill in a test, but not below the 16 bodies that
/// the fixed scenes of the suite need; nothing when no option does.
std::optional<EngineOptions> small_capacity_options(const ContractEngine& engine);

/// A new engine; throws std::runtime_error with the status' message when the table refuses.
std::unique_ptr<Broadphase> make(const ContractEngine& engine);

std::ostream& operator<<(std::ostream& out, const ContractEngine& engine);

}  // namespace cellsweep::contract
