/// @file
/// Hands the bodies of a frame to an engine.
#pragma once

#include "cellsweep/broadphase.h"
#include "cellsweep/engines.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep::report {

/// What an engine is handed: boxes, or poses of which it makes the boxes itself (F3).
enum class Shape { boxes, poses };

/// What an engine with these settings wants.
Shape shape_of(const SettingValues& settings);

/// Hands all bodies of a source to an empty engine, as 0 … n − 1. Errors: those of the engine, and bad_input
/// for poses of a source that knows none.
Status insert_all(Broadphase& engine, const FrameSource& source, Shape shape = Shape::boxes);

/// Hands an engine the bodies that changed in the frame the source stands at.
Status move_changed(Broadphase& engine, const FrameSource& source, Shape shape = Shape::boxes);

}  // namespace cellsweep::report
