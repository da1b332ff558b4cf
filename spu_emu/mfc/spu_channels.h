/// @file
/// The channels of one SPU: what its read, write and count instructions do, and the other side's view of
/// them.
#ifndef SPU_EMU_MFC_SPU_CHANNELS_H
#define SPU_EMU_MFC_SPU_CHANNELS_H

#include <array>
#include <cstdint>
#include <optional>

#include "mfc/atomic_unit.h"
#include "mfc/command_queue.h"
#include "mfc/decrementer.h"
#include "mfc/events.h"
#include "mfc/mailbox.h"
#include "mfc/signal.h"
#include "mfc/spe_directory.h"
#include "mfc/statistics.h"
#include "mfc/tag_table.h"
#include "mfc/wait_listener.h"
#include "mfc/wait_point.h"

namespace spu_emu {

/// Settings of one SPU's channels. What the pointers and references mean outlives the channels.
struct ChannelSetup {
  /// The SPE's number, for words about it.
  unsigned spe = 0;
  DmaMode mode = DmaMode::eager;
  std::uint64_t seed = 1;
  SignalMode signal1 = SignalMode::overwrite;
  SignalMode signal2 = SignalMode::overwrite;
  ActivityLog* log = nullptr;
  WaitPoint* also_notified = nullptr;
};

/// The SPU side (read, write, count, dma, finish) is for the SPU's own thread. The other side may be called
/// from any thread. A broken rule is thrown as Fault. Reads and writes that block on the hardware block here.
class SpuChannels final : public ProblemState {
 public:
  SpuChannels(LocalStoreView& store, const Timebase& timebase, const ChannelSetup& setup);
  SpuChannels(const SpuChannels&) = delete;
  SpuChannels& operator=(const SpuChannels&) = delete;

  // SPU side.
  std::uint32_t read(std::uint32_t channel, SourceLine where = {});
  void write(std::uint32_t channel, std::uint32_t value, SourceLine where = {});
  std::uint32_t count(std::uint32_t channel, SourceLine where = {});
  /// The same as writing the six channels of a command.
  void dma(const Command& command);
  /// The program stopped: all that is in flight lands.
  void finish() { queue_.land_all(); }
  /// From here on a read or write that has waited until then is a fault.
  void set_deadline(WaitPoint::Time deadline) { deadline_ = deadline; }
  /// Told of waits from here on; outlives the channels. Null for nobody.
  void set_wait_listener(WaitListener* listener) { wait_listener_ = listener; }
  /// The program is gone: what is in flight never lands.
  void abandon() { queue_.clear(); }
  TagTable& tags() { return tags_; }
  /// Another local store from here on; nothing is in flight.
  void use_store(LocalStoreView& store) { queue_.use_store(store); }

  // What a debugger looks at, on the SPU's own thread.
  const CommandQueue& queue() const { return queue_; }
  /// The command whose parameters the program is writing.
  const Command& next_command() const { return next_; }
  std::uint32_t tag_mask() const { return tag_mask_; }
  std::optional<std::uint32_t> tag_update() const { return tag_update_; }
  std::optional<std::uint32_t> tag_status() const { return tag_status_; }
  const Events& events() const { return events_; }
  DmaMode mode() const { return mode_; }

  // The other side.
  /// What the SPU waits for, if it does.
  std::optional<WaitState::Wait> waiting() const { return wait_state_.now(); }
  const SignalRegister& signal_register(unsigned index) const { return signals_[index]; }
  Mailbox& in_mailbox() { return in_; }
  Mailbox& out_mailbox() { return out_; }
  Mailbox& out_interrupt_mailbox() { return out_interrupt_; }
  WaitPoint& changed() { return changed_; }
  /// Messages written, at most `count`; the SPU's event is raised.
  unsigned write_in_mailbox(const std::uint32_t* messages, unsigned count);
  /// Messages read from an out mailbox, at most `count`; the SPU's event is raised.
  unsigned read_out_mailbox(std::uint32_t* messages, unsigned count);
  unsigned read_out_interrupt_mailbox(std::uint32_t* messages, unsigned count);
  /// `index` 0 or 1 for signal register 1 or 2.
  void signal(unsigned index, std::uint32_t value);
  bool write_register(std::uint32_t offset, std::uint32_t value) override;
  bool read_register(std::uint32_t offset, std::uint32_t& value) override;

  const ChannelCounters& counters() const { return counters_; }
  QueueCounters& queue_counters() { return queue_.counters(); }

 private:
  std::uint32_t read_tag_status(SourceLine where);
  std::uint32_t read_stall_status(SourceLine where);
  std::uint32_t read_atomic_status(SourceLine where);
  std::uint32_t read_signal(unsigned index);
  std::uint32_t read_in_mailbox();
  std::uint32_t read_event_status(SourceLine where);
  void write_tag_update(std::uint32_t kind, SourceLine where);
  void write_out(Mailbox& mailbox, std::uint32_t value, const char* what);
  [[noreturn]] void fail_deadline(const char* what) const;
  template <class Ready>
  void wait_until_ready(const char* what, Ready&& ready);
  void wait_for_tags(std::uint32_t kind, SourceLine where);
  std::uint32_t count_tag_status();
  std::uint32_t count_stall_status();
  std::uint32_t count_command();
  void poll_events();
  bool progress_for_events(SourceLine where);
  WaitPoint::Time next_poll() const;
  WaitPoint::Time next_look() const;
  void tell_of_wait(const char* what);
  unsigned read_mailbox(Mailbox& mailbox, std::uint32_t event, std::uint32_t* messages, unsigned count);
  std::uint32_t done_tags() const { return queue_.empty() ? tag_mask_ : tag_mask_ & ~queue_.pending_tags(); }
  void set_tag_status();

  const unsigned spe_;
  const DmaMode mode_;
  ActivityLog* log_;
  WaitPoint changed_;
  WaitPoint::Time deadline_ = WaitPoint::Time::max();
  WaitListener* wait_listener_ = nullptr;
  WaitState wait_state_;
  Events events_;
  ChannelCounters counters_;
  CommandQueue queue_;
  AtomicUnit atomics_;
  Decrementer decrementer_;
  TagTable tags_;
  Random random_;
  Mailbox in_{4};
  Mailbox out_{1};
  Mailbox out_interrupt_{1};
  std::array<SignalRegister, 2> signals_;
  Command next_;
  std::uint32_t tag_mask_ = 0;
  std::optional<std::uint32_t> tag_update_;
  std::optional<std::uint32_t> tag_status_;
  std::uint32_t srr0_ = 0;
};

}  // namespace spu_emu

#endif
