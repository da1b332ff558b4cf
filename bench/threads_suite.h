/// @file
/// The suite that tells what threads are worth to engine `stream` on this machine.
#pragma once

namespace cellsweep::bench {

/// Registers rows `threads/BODIES/MODE/THREADS` of scene `uniform` for 1 to 16 threads and for as many as the
/// engine finds to pay, `auto`; checked and timed as all engine rows.
void register_threads_suite();

}  // namespace cellsweep::bench
