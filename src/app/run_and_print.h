/// @file
/// What `simulate` and `replay` share: run engines over frames and print what came of it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "app/engine_flags.h"
#include "app/frame_flags.h"
#include "app/output.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep::app {

/// Makes a source at frame 0; called once an engine, so that each sees the same frames.
using SourceMaker = std::function<Result<std::unique_ptr<FrameSource>>()>;

/// Runs each engine over a source of its own, with so many bodies, and prints tables, or JSON if asked for.
/// What was run when somebody presses Ctrl-C is printed, too.
ExitCode run_and_print(const EngineFlags& engine_flags, const FrameFlags& frame_flags, std::size_t bodies,
                       const SourceMaker& make_source);

}  // namespace cellsweep::app
