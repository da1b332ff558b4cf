/// @file
/// What a file of boxes says before them.
#pragma once

#include <cstddef>
#include <string>

#include "cellsweep/aabb.h"
#include "cellsweep/world/recording.h"

namespace cellsweep {

struct RecordingHead {
  std::string name;
  std::string type;
  Aabb world;
  std::size_t bodies = 0;
  std::size_t frames = 0;  ///< at least one
};

inline RecordingHead head_of(const Recording& recording) {
  return {recording.name, recording.type, recording.world, recording.bodies, recording.frames()};
}

}  // namespace cellsweep
