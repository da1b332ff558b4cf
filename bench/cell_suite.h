/// @file
/// The suite of the Cell engines' settings: DMA mode, local store, overlap method, results by list, the
/// document's literal logic, SPU count, boxes made on the SPUs, a timeline.
#pragma once

namespace cellsweep::bench {

/// Registers rows `cell/ENGINE/SETTING/N/MODE` of scene `paper`, each with one setting that is not the
/// default, and `cell/ENGINE/default/N/MODE` to compare with; `cell/stream/on_spes` is engine `cell-stream`,
/// and `cell/stream/on_spes_isa` the same as real SPU code.
void register_cell_suite();

}  // namespace cellsweep::bench
