/// @file
/// Bullet's own tree beside `stream` in Bullet's worlds, in Markdown.
#pragma once

#include <string>

#include "bench/measured/measured_rows.h"

namespace cellsweep::bench {

/// A row for each world and number of bodies: microseconds of a step, the mean and the 99th percentile, of
/// Bullet's tree and of `stream` on one thread, exact and with a margin, how many times as long the tree
/// took, and milliseconds of the whole step with each. Below it how far the turns of a row lay apart.
std::string bullet_frames(const MeasuredRows& measured);

/// A row for each question: microseconds, and how many bodies are met.
std::string bullet_questions(const MeasuredRows& measured);

}  // namespace cellsweep::bench
