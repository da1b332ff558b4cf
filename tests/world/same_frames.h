/// @file
/// Two sources beside each other.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "cellsweep/world/frame_source.h"

namespace cellsweep {

/// Expects that both tell the same in every frame, and where a body is there, that it has the same.
inline void expect_same_frames(FrameSource& one, FrameSource& other, std::size_t frames) {
  for (std::size_t frame = 0; frame < frames; ++frame) {
    ASSERT_TRUE(std::ranges::equal(one.bodies(), other.bodies())) << "frame " << frame;
    ASSERT_TRUE(std::ranges::equal(one.inserted(), other.inserted())) << "frame " << frame;
    ASSERT_TRUE(std::ranges::equal(one.removed(), other.removed())) << "frame " << frame;
    ASSERT_TRUE(std::ranges::equal(one.moved(), other.moved())) << "frame " << frame;
    ASSERT_EQ(one.filters().empty(), other.filters().empty());
    for (const BodyId body : one.bodies()) {
      ASSERT_EQ(one.boxes()[body], other.boxes()[body]) << "frame " << frame << ", body " << body;
      if (!one.filters().empty()) {
        ASSERT_EQ(one.filters()[body], other.filters()[body]) << "frame " << frame << ", body " << body;
      }
    }
    ASSERT_EQ(one.advance(), other.advance() || frame + 1 == frames);
  }
}

}  // namespace cellsweep
