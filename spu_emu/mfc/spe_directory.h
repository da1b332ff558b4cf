/// @file
/// Which effective addresses are local stores and problem state areas of emulated SPEs.
#ifndef SPU_EMU_MFC_SPE_DIRECTORY_H
#define SPU_EMU_MFC_SPE_DIRECTORY_H

#include <atomic>
#include <cstdint>
#include <shared_mutex>
#include <unordered_map>

#include "mfc/local_store.h"

namespace spu_emu {

/// Registers of a problem state area that DMA can reach, by their offset in the area of one SPE.
class ProblemState {
 public:
  virtual ~ProblemState() = default;
  /// False when no such register can be written / read. May be called from any thread.
  virtual bool write_register(std::uint32_t offset, std::uint32_t value) = 0;
  virtual bool read_register(std::uint32_t offset, std::uint32_t& value) = 0;
};

/// Offsets of the areas within one SPE's problem state, as the hardware lays them out.
inline constexpr std::uint32_t kMsSyncArea = 0x0000;
inline constexpr std::uint32_t kMfcCommandArea = 0x3000;
inline constexpr std::uint32_t kControlArea = 0x4000;
inline constexpr std::uint32_t kSignal1Area = 0x14000;
inline constexpr std::uint32_t kSignal2Area = 0x1c000;
inline constexpr std::uint32_t kProblemStateSize = 0x20000;
/// An SPE has a window of effective addresses for itself, 4 GB from a multiple of 4 GB, and 1 MB where a
/// process has only 4 GB in all. The local store is at its start, the problem state at kProblemStateOffset.
inline constexpr bool kWideAddresses = sizeof(void*) == 8;
inline constexpr unsigned kWindowBits = kWideAddresses ? 32 : 20;
inline constexpr std::uint64_t kWindowSize = std::uint64_t{1} << kWindowBits;
inline constexpr std::uint32_t kProblemStateOffset = kWideAddresses ? 0xf0000000U : 0x80000U;

/// Where an effective address lies in its window.
constexpr std::uint32_t window_offset(std::uint64_t ea) {
  return static_cast<std::uint32_t>(ea & (kWindowSize - 1));
}

/// An SPE's window of effective addresses; `base` is a multiple of kWindowSize.
struct SpeWindow {
  std::uint64_t base = 0;
  std::uint32_t local_store_size = 0;
  LocalStoreView* store = nullptr;
  ProblemState* registers = nullptr;
};

/// All windows of the process. Any thread may use it; a window is removed before what it points to ends.
class SpeDirectory {
 public:
  static SpeDirectory& instance();

  void add(const SpeWindow& window);
  void remove(std::uint64_t base);

  /// Quick test: false means surely main memory.
  static bool may_be_window(std::uint64_t ea) {
    const std::uint32_t low = window_offset(ea);
    return low < largest_local_store_.load(std::memory_order_relaxed) ||
           (low >= kProblemStateOffset && low < kProblemStateOffset + kProblemStateSize);
  }

  /// Calls `use(const SpeWindow*)`, with null when `ea` lies in no window; the window stays valid meanwhile.
  template <class Use>
  void with_window(std::uint64_t ea, Use&& use) {
    const std::shared_lock lock(mutex_);
    const auto found = windows_.find(ea >> kWindowBits);
    use(found == windows_.end() ? nullptr : &found->second);
  }

 private:
  std::shared_mutex mutex_;
  std::unordered_map<std::uint64_t, SpeWindow> windows_;
  inline static std::atomic<std::uint32_t> largest_local_store_{0};
};

}  // namespace spu_emu

#endif
