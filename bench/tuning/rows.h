/// @file
/// The rows of suite `tuning/`, and what they are measured with.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/threads/crew.h"
#include "cellsweep/world/frame_source.h"
#include "engines/stream/cells/cell_tree.h"

namespace cellsweep::bench {

/// A row's counters: what it measured, and what is in the code.
using Measured = std::vector<std::pair<std::string_view, double>>;

/// Registers `tuning/NAME`.
void register_tuning_row(const std::string& name, const std::function<Measured()>& measure);

double seconds_of(const std::function<void()>& work);

/// Of so many times that the work is done: where two ways are compared, what else the machine does must not
/// decide.
double quickest_seconds_of(int times, const std::function<void()>& work);

/// Scene `uniform`.
std::unique_ptr<FrameSource> uniform(std::size_t bodies, double moving);

/// Cells on one thread, with the best kernels.
struct Cells {
  Cells();

  double build_seconds(std::span<const Aabb> boxes);

  Crew crew{nullptr, 1, Crew::Choice::given};
  stream::CellTree tree;
};

/// What bodies, threads, tests and copies cost, and sorting.
void register_cost_rows();
/// Small worlds: the sweep, and cells in its place.
void register_sweep_rows();
/// Which candidates are tested, and whether cells are asked in their place.
void register_candidate_rows();
/// Fat boxes of bodies that turn back.
void register_fat_box_rows();
/// Grids among long boxes.
void register_grid_rows();

}  // namespace cellsweep::bench
