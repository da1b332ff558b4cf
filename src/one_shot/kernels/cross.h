/// @file
/// The inner loop of a search between two sets: a cell's boxes of the one against those of the other.
#pragma once

#include <cstdint>

#include "cellsweep/engine/cell_boxes.h"
#include "cellsweep/vector_isa.h"

namespace cellsweep::one_shot {

/// Appends every overlapping pair that the cell owns of one of its first `rows` boxes with one of the others.
/// A table of its own, so that programs without a one-shot search do not have it.
using CrossKernel = void (*)(const stream::CellBoxes& cell, std::uint32_t rows, stream::KeyBuffer& found);

/// That of an instruction set that this processor has: Kernels::isa, not `best`.
CrossKernel find_cross_kernel(VectorIsa isa);

// Each from a source file of its own; constinit, as the tables of engine `stream` are.
extern const CrossKernel kPortableCross;
#ifdef CELLSWEEP_X86_KERNELS
extern const CrossKernel kSse41Cross;
extern const CrossKernel kAvx2Cross;
extern const CrossKernel kAvx512Cross;
#endif

}  // namespace cellsweep::one_shot
