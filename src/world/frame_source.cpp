#include "cellsweep/world/frame_source.h"

#include <numeric>

namespace cellsweep {

std::span<const BodyId> FrameSource::bodies() const {
  if (all_.size() != boxes().size()) {
    all_.resize(boxes().size());
    std::iota(all_.begin(), all_.end(), BodyId{0});
  }
  return all_;
}

}  // namespace cellsweep
