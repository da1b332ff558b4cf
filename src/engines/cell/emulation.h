/// @file
/// What the SDK has no name for: how SPEs are emulated and what they did. Those who make engines inject it,
/// so that the host side knows libspe2 only.
#pragma once

#include <libspe2.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cellsweep/cell.h"

namespace cellsweep::cell {

/// What one SPE did since its context was made.
struct SpeCounts {
  std::uint64_t gets = 0;
  std::uint64_t puts = 0;
  std::uint64_t bytes_in = 0;
  std::uint64_t bytes_out = 0;
  std::uint64_t list_elements = 0;
  std::uint64_t local_store_high_water = 0;  ///< bytes in use at most

  SpeCounts& operator+=(const SpeCounts& more);
};

/// Cycles of one function of an SPU program, without those of functions that it called.
struct FunctionCycles {
  std::string name;            ///< demangled, with its parameters
  std::uint64_t cycles = 0;    ///< all
  std::uint64_t dma_wait = 0;  ///< of them
};

/// What an SPE would have done on a Cell since its program was loaded.
struct SpeCycles {
  double hertz = 0;  ///< 0: it is not counted
  std::vector<FunctionCycles> functions;
};

/// How the bytes of a local store (C14) are given out before a program asks for any.
struct LocalStoreBudget {
  std::uint64_t limit = 0;  ///< 0: no limit
  std::uint64_t code = 0;   ///< what code and constants are taken to occupy
  std::uint64_t data = 0;   ///< what variables of the program and of its C library are taken to occupy
  std::uint64_t stack = 0;  ///< what the stack is taken to occupy
};

/// One engine's way to its SPEs. Used by the thread that uses the engine; fault() of a context only while it
/// does not run. counts() of one that runs are of about now.
class Emulation {
 public:
  virtual ~Emulation() = default;

  virtual LocalStoreBudget local_store() const = 0;

  /// What to load for a program: the same handle, or that of the same program compiled for a real SPU.
  virtual spe_program_handle_t& image(spe_program_handle_t& program) const = 0;

  /// spe_context_create() with this engine's settings, for one of `spes` that work at the same time; null
  /// with errno as there.
  virtual spe_context_ptr_t create_context(unsigned flags, unsigned spes) = 0;

  virtual SpeCounts counts(spe_context_ptr_t spe) const = 0;

  /// As of the program's last end or message; empty unless SpeOptions::cycles.
  virtual SpeCycles cycles(spe_context_ptr_t spe) const = 0;

  /// The rule that the context's last failing call broke, in words; empty when there was none.
  virtual std::string fault(spe_context_ptr_t spe) const = 0;
};

/// SPEs as the options say: those of spu_emu, or a Cell's own in a build for these. Their transfers and waits
/// go to the timeline of the file `trace`; empty: to none. Errors: bad_option for a local store that is no
/// multiple of 128 or too small for code and stack, for a trace file that cannot be written, for
/// SpeEngine::isa without SPU programs or with more than 256 KB, for cycles without SpeEngine::isa or with
/// numbers that cannot be, and for what a Cell's own SPEs cannot do.
Result<std::shared_ptr<Emulation>> make_emulation(const SpeOptions& options, const std::string& trace = {});

}  // namespace cellsweep::cell
