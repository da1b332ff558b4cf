/// @file
/// The suite of sort kernels: the document's vectorised insertion sort against others, on one axis.
#pragma once

namespace cellsweep::bench {

/// Registers rows `sort/KERNEL/N/INPUT`: N endpoint values with their IDs. Kernels: scalar_insertion (4.1.3
/// on two arrays), simd_insertion (C5-C8), simd_insertion_no_early_out, std_sort. Inputs: random, sorted, and
/// nearly, in which every tenth value moved by a few places. Rows whose result is not sorted are skipped with
/// an error.
void register_sort_suite();

}  // namespace cellsweep::bench
