/// @file
/// What a Broadphase is made of, for the engines of this library.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/threads/crew.h"
#include "cellsweep/engine/engine.h"

namespace cellsweep {

struct HandleParts {
  std::string_view name;  ///< of the engine; a literal
  EngineMaker maker;
  std::shared_ptr<Crew> crew{};  ///< null: the calling thread alone
  std::string trace{};           ///< the timeline's file, or empty
  std::string row_name{};        ///< of the timeline's row
};

}  // namespace cellsweep
