/// @file
/// The whole world on one engine, beside that of the ranks.
#pragma once

#include <optional>
#include <string>

#include "cellsweep/broadphase.h"
#include "cellsweep/ranks.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep::app {

/// On the first rank; on the others a partner of its sums, which all ranks make together.
class OneEngine {
 public:
  explicit OneEngine(bool is_here) {
    if (is_here) engine_.emplace();
  }

  /// Follows the source to this frame, and says in words what the ranks have in another way; empty where
  /// nothing is, and on the other ranks. `said` is what the ranks' update said.
  std::string compare(const FrameSource& source, bool is_first, const DistributedBroadphase& world,
                      const RankChanges& said);

  /// The same with the world that a checkpoint had, in the place of the first frame.
  std::string compare_restored(const FrameSource& source, const DistributedBroadphase& world);

 private:
  std::optional<Broadphase> engine_;
};

}  // namespace cellsweep::app
