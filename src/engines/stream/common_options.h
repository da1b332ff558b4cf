/// @file
/// What the options of engine `stream` and of one-shot searches have in common. In line: each has one caller
/// in a program that has only the one.
#pragma once

#include <cstdint>

#include "base/text.h"
#include "cellsweep/status.h"
#include "cellsweep/vector_isa.h"

namespace cellsweep::stream {

// Of internal linkage: what has one caller in a source is put in line there, and a program has no more of it
// than it calls.
namespace {

/// More than any machine has; more are a slip of the pen.
inline constexpr unsigned kMostThreads = 1024;

/// The refusal of more than kMostThreads.
inline Status too_many_threads(unsigned threads) {
  return Status::bad_option("threads",
                            text("threads is ", threads, "; at most ", kMostThreads, " are taken."), threads,
                            kMostThreads);
}

/// That of an instruction set for which find_kernels() finds none.
inline Status no_such_isa(VectorIsa isa) {
  return Status::bad_option(
      "isa",
      "This machine or build does not have the instruction set that isa names; leave the "
      "choice to the library.",
      static_cast<std::uint64_t>(isa));
}

/// The refusal of more pairs than max_pairs allows.
inline Status too_many_pairs(std::uint64_t most) {
  return Status::over_capacity(
      text("There are more than ", most, " pairs, the most that max_pairs allows; raise it, or set it to 0."),
      most + 1, most, "max_pairs");
}

}  // namespace
}  // namespace cellsweep::stream
