/// @file
/// Frames of a scene or a recording, played to a broadphase.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/world/frame_source.h"
#include "cellsweep/world/recording.h"
#include "project_file.h"

namespace cellsweep {

/// Inserts the bodies of the frame that a source stands at.
inline Status insert_all(Broadphase& broadphase, const FrameSource& source) {
  std::vector<Aabb> boxes;
  for (const BodyId body : source.bodies()) boxes.push_back(source.boxes()[body]);
  return broadphase.insert(source.bodies(), boxes);
}

/// Moves the bodies that changed in the frame that the source stands at; none of it come or go.
inline Status move_changed(Broadphase& broadphase, const FrameSource& source) {
  EXPECT_FALSE(source.bodies_come_and_go());
  std::vector<Aabb> boxes;
  for (const BodyId body : source.moved()) boxes.push_back(source.boxes()[body]);
  return broadphase.move(source.moved(), boxes);
}

/// The pairs of a frame, as all against all found them.
struct KnownFrame {
  std::size_t frame = 0;
  std::size_t pairs = 0;
  std::uint64_t hash = 0;
};

/// Plays one of the recorded scenes of bench/scenes/ to an empty broadphase, and compares the frames known.
inline void expect_recorded_frames(Broadphase& broadphase, const std::string& name,
                                   const std::vector<KnownFrame>& known) {
  auto recording = read_recording(project_file("bench/scenes/bullet-" + name + "-1024.aabbs"));
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  const auto source = make_recording_frames(std::move(*recording));
  ASSERT_TRUE(insert_all(broadphase, *source).ok());
  std::size_t frame = 0;
  for (const KnownFrame& expected : known) {
    for (; frame < expected.frame; ++frame) {
      ASSERT_TRUE(broadphase.update().ok());
      ASSERT_TRUE(source->advance());
      ASSERT_TRUE(move_changed(broadphase, *source).ok());
    }
    ASSERT_TRUE(broadphase.update().ok());
    EXPECT_EQ(broadphase.pairs().size(), expected.pairs) << "frame " << frame;
    EXPECT_EQ(pair_set_hash(broadphase.pairs()), expected.hash) << "frame " << frame;
  }
}

}  // namespace cellsweep
