/// @file
/// One emulated SPE: address space, channels, proxy queue, and the program loaded into it.
#ifndef SPU_EMU_SPE_SPE_H
#define SPU_EMU_SPE_SPE_H

#include <libspe2-types.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "mfc/spu_channels.h"
#include "spe/arena.h"
#include "spe/program.h"
#include "spe/program_loader.h"
#include "spe/trace.h"
#include "spu_emu/emulation.h"

namespace spu_emu {

/// load, start, resume and what comes of them belong to one thread at a time; channels() as SpuChannels says.
class Spe {
 public:
  Spe(const EmulationSettings& settings, unsigned int flags, WaitPoint* event_point);
  ~Spe();
  Spe(const Spe&) = delete;
  Spe& operator=(const Spe&) = delete;

  /// Loads an image in the place of the program before, if there was one. 0, or an errno value with the
  /// reason in last_fault(); then nothing is loaded.
  int load(const ProgramImage& image, ProgramLoader load_program);
  bool loaded() const { return program_ != nullptr; }
  /// Null while nothing is loaded.
  Program* program() { return program_.get(); }

  /// Starts the loaded program, or goes on at `entry` after a stop, and runs until it stops.
  Stop start(const Arguments& arguments);
  Stop resume(unsigned int entry);

  /// Counts the SPEs of the process, as the timeline does.
  unsigned number() const { return number_; }
  /// When the program that runs has used up its time.
  WaitPoint::Time deadline() const { return deadline_; }
  /// The program that runs has so much more time: somebody kept it standing. By its own thread.
  void add_time(std::chrono::steady_clock::duration time);
  /// Whether a thread is in start or resume. Any thread.
  bool runs() const { return runs_.load(std::memory_order_relaxed); }
  const EmulationSettings& settings() const { return settings_; }
  Arena& arena() { return arena_; }
  SpuChannels& channels() { return channels_; }
  /// Bytes of local store; of the loaded program, else of the settings.
  std::uint32_t store_size() const;
  std::string store_map() const;

  /// The proxy queue, to be used under its mutex.
  CommandQueue& proxy() { return proxy_; }
  std::mutex& proxy_mutex() { return proxy_mutex_; }

  /// Any thread.
  void set_last_fault(std::string text);
  std::string last_fault();
  /// Of real SPU code that waits in a channel: the instruction, as Program::where_waiting says it.
  std::string where_waiting();
  SpeStatistics statistics();
  CycleProfile cycle_profile();

 private:
  void unload();
  void use_store(LocalStoreView& store);
  template <class Run>
  Stop traced(Run&& run);
  void set_deadline(WaitPoint::Time begin);

  const EmulationSettings settings_;
  const unsigned number_;
  SpeTrace trace_;
  Arena arena_;
  FlatLocalStore empty_store_;
  SteadyTimebase timebase_;
  SpuChannels channels_;
  std::mutex proxy_mutex_;
  CommandQueue proxy_;
  std::mutex program_mutex_;
  std::unique_ptr<Program> program_;
  WaitPoint::Time deadline_ = WaitPoint::Time::max();
  std::chrono::steady_clock::duration time_used_{};
  std::atomic<bool> runs_{false};
  std::mutex fault_mutex_;
  std::string last_fault_;
};

}  // namespace spu_emu

#endif
