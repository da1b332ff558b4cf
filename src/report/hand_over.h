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

/// Hands the bodies that are in the frame the source stands at to an empty engine. Errors: those of the
/// engine, and bad_input for poses of a source that knows none.
Status insert_all(Broadphase& engine, const FrameSource& source, Shape shape = Shape::boxes);

/// Tells an engine which bodies went, came and moved in the frame the source stands at. Errors: those of the
/// engine; what was told before one stays told.
Status hand_over_changes(Broadphase& engine, const FrameSource& source, Shape shape = Shape::boxes);

}  // namespace cellsweep::report
