/// @file
/// What a result must be read with: machine, compiler, flags, commit.
#pragma once

namespace cellsweep::bench {

/// Adds CPU, compiler, flags and commit to the context that Google Benchmark writes with its results.
void add_context();

}  // namespace cellsweep::bench
