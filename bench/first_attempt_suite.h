/// @file
/// The suite of the document's first attempt (F5), to show why it was dropped.
#pragma once

namespace cellsweep::bench {

/// Registers rows `first_attempt/paper/N/MODE` for 64 to 1024 boxes of scene `paper`. The time is that of
/// copying the values into endpoints and of the SPUs' runs; no pair manager is kept, so compare with the
/// phases `refill values` and `spus` of cell-paper. Rows whose pairs are not as many as the oracle's are
/// skipped with an error.
void register_first_attempt_suite();

}  // namespace cellsweep::bench
