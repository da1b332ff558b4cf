// One emulated SPE: local store, channels, loaded program, and the thread of control in it.
#ifndef SPU_EMU_HOST_SPE_H
#define SPU_EMU_HOST_SPE_H

#include <libspe2-types.h>

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "host/fiber.h"
#include "host/host_local_store.h"
#include "host/module.h"
#include "host/trace.h"
#include "mfc/fault.h"
#include "mfc/spu_channels.h"
#include "spu_emu/emulation.h"
#include "spu_emu/services.h"

namespace spu_emu {

/// Why control came back from the program.
struct Stop {
  enum class Kind { exit, signal, library_call, fault };
  Kind kind = Kind::exit;
  /// The 14-bit code, for a library call with the LS address of its argument word.
  unsigned int code = 0;
  std::uint32_t argument = 0;
  StopReport report{};
};

/// What a program is started with.
struct Arguments {
  unsigned long long speid = 0;
  unsigned long long argp = 0;
  unsigned long long envp = 0;
};

/// load, start, resume and what comes of them belong to one thread at a time; channels() as SpuChannels says.
class Spe {
 public:
  Spe(const EmulationSettings& settings, unsigned int flags, WaitPoint* event_point);
  ~Spe();
  Spe(const Spe&) = delete;
  Spe& operator=(const Spe&) = delete;

  /// 0, or an errno value with the reason in last_fault().
  int load(const spe_program_handle_t& program);
  bool loaded() const { return module_ != nullptr; }

  /// Starts the loaded program, or goes on after a stop, and runs until it stops.
  Stop start(const Arguments& arguments);
  Stop resume();
  /// True when the program stopped in the middle and can go on.
  bool suspended() const { return suspended_; }

  SpuChannels& channels() { return channels_; }
  HostLocalStore& store() { return store_; }
  SpeTrace* trace() { return settings_.trace ? &trace_ : nullptr; }

  /// The proxy queue, to be used under its mutex.
  CommandQueue& proxy() { return proxy_; }
  std::mutex& proxy_mutex() { return proxy_mutex_; }

  /// Any thread.
  void set_last_fault(std::string text);
  std::string last_fault();
  SpeStatistics statistics();

  // The program's side, called on its stack.
  void stop_here(const Stop& stop);
  [[noreturn]] void stop_for_good(const Stop& stop);
  /// Remembers a fault as the reason of the stop to come; whatever is in flight never lands.
  void note_fault(const Fault& fault);
  /// Ends the program for the fault noted.
  [[noreturn]] void stop_for_fault();
  /// The LS address of a program's pointer. Throws Fault if it is none.
  std::uint32_t ls_of(const volatile void* pointer, const Command& command) {
    if (store_.in_arena(pointer)) return store_.ls_of_arena(pointer);
    return ls_outside_arena(pointer, command);
  }
  /// The three allocation functions throw Fault when the local store is full or a block unknown.
  void* allocate(std::size_t size, std::size_t alignment);
  void* reallocate(void* block, std::size_t size);
  void release(void* block);
  /// Writes the argument word of a library call into the local store; its LS address.
  std::uint32_t make_call_word(unsigned int opcode, void* data);
  void free_call_word(std::uint32_t ls);

 private:
  static void enter(void* self);
  std::uint32_t ls_outside_arena(const volatile void* pointer, const Command& command);
  Stop run_fiber();
  void note_high_water();

  const EmulationSettings settings_;
  const unsigned number_;
  SpeTrace trace_;
  HostLocalStore store_;
  SteadyTimebase timebase_;
  SpuChannels channels_;
  std::mutex proxy_mutex_;
  CommandQueue proxy_;
  HostServices services_;
  std::unique_ptr<Module> module_;
  std::optional<Fiber> fiber_;
  Arguments arguments_;
  Stop stop_;
  bool suspended_ = false;
  std::mutex fault_mutex_;
  std::string last_fault_;
  StopReport fault_report_{};
  std::atomic<std::uint32_t> high_water_{0};
};

/// The table of functions by which a program reaches `spe`.
HostServices make_services(Spe& spe);

}  // namespace spu_emu

#endif
