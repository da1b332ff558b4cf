/// @file
/// How the contract tests run on every engine: parameters, and names for them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include "contract/box_kinds.h"
#include "contract/contract_engines.h"

namespace cellsweep::contract {

/// A test that runs once per engine.
using PerEngine = testing::TestWithParam<ContractEngine>;

/// A test that runs once per engine and kind of boxes.
using PerEngineAndKind = testing::TestWithParam<std::tuple<ContractEngine, BoxKind>>;

inline std::string engine_label(const testing::TestParamInfo<ContractEngine>& info) {
  return info.param.label;
}

inline std::string engine_and_kind_label(
    const testing::TestParamInfo<std::tuple<ContractEngine, BoxKind>>& info) {
  return std::get<0>(info.param).label + "_" + std::string(std::get<1>(info.param).name);
}

/// The number of a kind, by which the kinds take turns with what they do not all do.
inline std::size_t turn_of(const BoxKind& kind) {
  const auto is_it = [&](const BoxKind& other) { return other.name == kind.name; };
  return static_cast<std::size_t>(std::ranges::find_if(box_kinds(), is_it) - box_kinds().begin());
}

/// The unit cube whose lower corner is at (x, 0, 0).
inline Aabb cube_at(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

inline auto all_engines() {
  return testing::ValuesIn(contract_engines());
}

/// Those that come with the handle, whose memory is base/memory/'s.
inline auto engines_of_the_core() {
  std::vector<ContractEngine> engines;
  for (const ContractEngine& engine : contract_engines()) {
    if (engine.name == "stream" || engine.name == "control" || engine.name == "oracle")
      engines.push_back(engine);
  }
  return testing::ValuesIn(engines);
}

inline auto all_kinds() {
  const auto kinds = box_kinds();
  return testing::ValuesIn(kinds.begin(), kinds.end());
}

inline auto all_engines_and_kinds() {
  return testing::Combine(all_engines(), all_kinds());
}

}  // namespace cellsweep::contract
