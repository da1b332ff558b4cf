#include "contract/contract_engines.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace cellsweep::contract {
namespace {

/// Few kilobytes of pair map: a capacity that a random sequence runs into all the time.
constexpr std::uint64_t kSmallPairMap = 16 << 10;

std::string label_of(std::string_view name) {
  std::string label(name);
  std::replace_if(
      label.begin(), label.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return label;
}

std::vector<ContractEngine> list_engines() {
  std::vector<ContractEngine> engines;
  for (const EngineInfo& info : engine_table()) {
    engines.push_back({std::string(info.name), {}, label_of(info.name)});
  }
  engines.push_back({"control", {.pair_map_bytes = kSmallPairMap}, "control_with_a_small_pair_map"});
  return engines;
}

}  // namespace

const std::vector<ContractEngine>& contract_engines() {
  static const std::vector<ContractEngine> engines = list_engines();
  return engines;
}

std::optional<EngineOptions> small_capacity_options(const ContractEngine& engine) {
  if (engine.name != "control") return std::nullopt;
  EngineOptions options = engine.options;
  options.pair_map_bytes = kSmallPairMap;
  return options;
}

std::unique_ptr<Broadphase> make(const ContractEngine& engine) {
  auto made = make_engine(engine.name, engine.options);
  if (!made) throw std::runtime_error(engine.label + ": " + made.status().message);
  return std::move(*made);
}

std::ostream& operator<<(std::ostream& out, const ContractEngine& engine) {
  return out << engine.label;
}

}  // namespace cellsweep::contract
