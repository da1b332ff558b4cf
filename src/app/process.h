/// @file
/// What the command asks of its process before anything else, and how it ends when memory runs out.
#pragma once

#include <exception>

namespace cellsweep::app {

/// Makes sure that what the command opens never takes the place of standard output or standard error, and
/// that a closed pipe or a file above the system's limit is an error and no end without words. Once, first
/// thing in main().
void prepare_process();

/// Says that memory ran out and ends the command with kNoMemory, at once and without asking for any. Files
/// that are not whole yet have no name, and go. An allocation that fails, on any thread, before or in main(),
/// comes here.
[[noreturn]] void end_without_memory();

/// Whether this was thrown for want of memory or threads.
bool is_want_of_memory(const std::exception& error);

}  // namespace cellsweep::app
