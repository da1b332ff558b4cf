// Time on a Cell: what real SPU code would take there, by a model of the SPU's pipeline and of its MFC.
#ifndef SPU_EMU_CYCLES_H
#define SPU_EMU_CYCLES_H

#include <libspe2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace spu_emu {

/// Every number of the model; cycles are the SPU's. What each means and where it comes from is in
/// cycle_parameters().
struct CycleParameters {
  double hertz = 3.2e9;

  std::uint32_t fixed_latency = 2;
  std::uint32_t shift_latency = 4;
  std::uint32_t byte_latency = 4;
  std::uint32_t float_latency = 6;
  std::uint32_t multiply_latency = 7;
  std::uint32_t double_latency = 13;
  std::uint32_t shuffle_latency = 4;
  std::uint32_t load_latency = 6;
  std::uint32_t branch_latency = 4;
  std::uint32_t channel_latency = 6;

  std::uint32_t double_block = 6;
  std::uint32_t branch_miss = 18;
  std::uint32_t hint_lead = 15;
  std::uint32_t hint_seen = 8;
  std::uint32_t fetch_starved = 8;

  std::uint32_t dma_start = 30;
  std::uint32_t dma_element = 8;
  std::uint32_t memory_latency = 750;
  std::uint32_t local_store_latency = 250;
  std::uint32_t bus_line = 128;
  double memory_bytes_per_cycle = 8.0;
  double port_bytes_per_cycle = 8.0;
  std::uint32_t sharing_spes = 1;
};

/// One number of CycleParameters for people and for command lines.
struct CycleParameter {
  std::string_view name;     ///< as the member
  std::string_view meaning;  ///< one phrase, with the unit
  std::string_view source;   ///< where its default comes from
  double least;              ///< smallest value allowed
};

/// All of them, in the order of CycleParameters. Any thread.
std::span<const CycleParameter> cycle_parameters();

/// The number of that name. Throws std::invalid_argument for a name that is not there.
double cycle_parameter(const CycleParameters& parameters, std::string_view name);

/// Changes one number. Throws std::invalid_argument, and changes nothing, for a name that is not there or a
/// value that cannot be: too small, too large, or a fraction where whole numbers are counted.
void set_cycle_parameter(CycleParameters& parameters, std::string_view name, double value);

/// The same by "NAME=VALUE". Throws std::invalid_argument, with the reason, also for what is no such text.
void set_cycle_parameter(CycleParameters& parameters, const std::string& assignment);

/// Why no instruction was issued in a cycle.
enum class Stall : std::uint8_t {
  fixed,         ///< waits for a result of the fixed-point units
  floating,      ///< of the floating-point units, double precision and integer multiply among them
  shuffle,       ///< of the shuffle unit
  load,          ///< of a load
  channel,       ///< of a channel instruction
  double_block,  ///< after a double-precision instruction
  branch_miss,   ///< a branch went where it was not predicted to
  late_hint,     ///< a hint came too shortly before its branch
  port,          ///< DMA had the local store's port
  fetch,         ///< no instructions: loads and stores had the port for too long
  dma_wait,      ///< a wait for tags or for an atomic command
  dma_queue,     ///< the command queue was full
};
inline constexpr std::size_t kStalls = 12;

/// The cause in a few words, as shown to people and in JSON.
std::string_view stall_name(Stall cause);

/// Cycles of a piece of code. Each cycle issues one or two instructions, or is a stall of one cause:
/// cycles = instructions - dual_issued + all stalls.
struct CycleCounts {
  std::uint64_t cycles = 0;
  std::uint64_t instructions = 0;  ///< all that were executed, no-operations and hints too
  std::uint64_t dual_issued = 0;   ///< pairs that issued together
  std::array<std::uint64_t, kStalls> stalls{};

  CycleCounts& operator+=(const CycleCounts& more);
  /// `earlier` must be an earlier state of the same counts.
  CycleCounts& operator-=(const CycleCounts& earlier);
  /// Cycles per instruction, 0 without instructions.
  double cpi() const;
  /// Share of the instructions that issued in pairs, 0 to 1.
  double dual_issue_share() const;
  std::uint64_t stall(Stall cause) const { return stalls[static_cast<std::size_t>(cause)]; }
  /// Cycles that waited for DMA: for tags, for atomic commands, for room in the command queue.
  std::uint64_t dma_wait() const { return stall(Stall::dma_wait) + stall(Stall::dma_queue); }
};

/// What one function took itself, without those that it called.
struct FunctionCycles {
  std::string name;  ///< demangled; "(no symbol)" for code that the program's symbols do not cover
  CycleCounts counts;
};

/// Cycles of one program since it was loaded.
struct CycleProfile {
  CycleCounts total;
  std::vector<FunctionCycles> functions;  ///< that executed anything, by rising address
  std::uint64_t dma_commands = 0;
  std::uint64_t dma_bytes = 0;
};

/// Of the program in the context, as of its last stop or, before that, its last write to an outbound mailbox:
/// what came before the write is in it, what comes after is not yet. So a host that reads after the message
/// gets the same numbers in every run. Empty when EmulationSettings::cycles was not set and on the host
/// engine. Any thread.
CycleProfile cycle_profile(spe_context_ptr_t spe);

}  // namespace spu_emu
#pragma GCC visibility pop

#endif
