/// @file
/// A ray-traced picture of a world of boxes: daylight, shadows, colliding bodies green (W5, Figure 5.1).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/pose.h"
#include "cellsweep/status.h"
#include "cellsweep/world/frame_file.h"
#include "cellsweep/world/frame_source.h"
#include "report/picture/image.h"

namespace cellsweep::report {

/// What is in the picture: bodies, and the bounds of their world as a frame on a floor.
struct Tableau {
  Aabb world;
  std::vector<BodyPose> bodies;
  std::vector<bool> colliding;  ///< one a body
  std::vector<std::uint32_t>
      groups{};                ///< one a body, each drawn in a colour of its own; none: by collisions
  std::vector<Aabb> frames{};  ///< drawn beside the world's
};

struct PictureSettings {
  unsigned width = 960;   ///< pixels, 1 to 16,384
  unsigned height = 640;  ///< pixels, 1 to 16,384
  unsigned samples = 16;  ///< rays a pixel, 1 to 4,096: more is smoother and takes longer
  unsigned threads = 0;   ///< 0: one for each core; 1,024 at most
  /// Called by the calling thread with the number of each row that it has traced.
  std::function<void(unsigned)> row_done = [](unsigned) {};
};

/// The bodies of a picture, ascending: those as long as the world on two axes are taken for its floor and
/// walls and left out, for they hide the rest.
std::vector<BodyId> shown_bodies(const FrameSource& source, const Aabb& world);

/// Turned as the source's poses say, or the body's box if it knows none.
BodyPose shown_pose(const FrameSource& source, BodyId body);

/// The shown bodies of the frame a source stands at. A body is colliding when the box of it overlaps another
/// body's.
Tableau tableau_of(const FrameSource& source, const Aabb& world);

/// The world of a recording for its pictures: its own, or, if it has walls, the bounds of all other boxes of
/// all frames.
Aabb stage_of(const FrameFile& file);

/// Traces a tableau. The same tableau gives the same pixels for any number of threads, and on every machine:
/// only + − × ÷ √ on floats decide them. Errors: bad_option for settings out of range, or in a build without
/// pictures.
Result<Image> trace_picture(const Tableau& tableau, const PictureSettings& settings);

}  // namespace cellsweep::report
