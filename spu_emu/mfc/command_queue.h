/// @file
/// An MFC command queue: checks commands, keeps their order rules, and decides when their bytes move.
#ifndef SPU_EMU_MFC_COMMAND_QUEUE_H
#define SPU_EMU_MFC_COMMAND_QUEUE_H

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "mfc/activity.h"
#include "mfc/command.h"
#include "mfc/events.h"
#include "mfc/list.h"
#include "mfc/random.h"
#include "mfc/rules.h"
#include "mfc/transfers.h"
#include "spu_emu/dma_mode.h"

namespace spu_emu {

inline constexpr std::uint32_t kSpuQueueDepth = 16;
inline constexpr std::uint32_t kProxyQueueDepth = 8;

/// How a queue works; `events` and `log` may be null, and outlive the queue.
struct QueueSetup {
  Issuer issuer = Issuer::spu;
  DmaMode mode = DmaMode::eager;
  std::uint64_t seed = 1;
  Events* events = nullptr;
  ActivityLog* log = nullptr;
};

/// A command in a queue, for who looks at it.
struct QueuedCommand {
  Command command;
  /// Of a list: elements that have moved or are about to, of `elements`. It stands still until its stall is
  /// acknowledged when it is `stalled`.
  std::uint32_t next_element = 0;
  std::uint32_t elements = 0;
  bool stalled = false;
};

/// Used by one thread at a time. Functions that land commands throw Fault when a command broke a rule; the
/// command is gone then. In eager and unchecked mode only commands that wait for a stalled list stay in the
/// queue.
class CommandQueue {
 public:
  CommandQueue(LocalStoreView& store, const QueueSetup& setup);
  ~CommandQueue() { clear(); }
  CommandQueue(const CommandQueue&) = delete;
  CommandQueue& operator=(const CommandQueue&) = delete;

  /// Takes a command; when the queue is full, one of it lands first. Throws Fault, then nothing was queued.
  void issue(const Command& command);

  std::uint32_t free_slots() const { return depth_ - static_cast<std::uint32_t>(queue_.size()); }
  bool empty() const { return queue_.empty(); }
  /// All of them, the first that was issued first.
  std::vector<QueuedCommand> commands() const;
  /// Bit n is set while a command with tag n is in the queue.
  std::uint32_t pending_tags() const;
  /// Lands every command of these tags that can land, and what must go before them.
  void land_tags(std::uint32_t tags);
  /// Lands all puts that can, and what must go before them.
  void land_stores();
  /// Lands all that can.
  void land_all();
  /// Lands one command of these tags (or one that must go before them), if any can; true if one did.
  bool land_one(std::uint32_t tags);
  /// Lands lists up to their next stall.
  void land_stalling_lists();

  /// Bit n is set when a list of tag n has stalled; reading clears all.
  std::uint32_t stall_status() const { return stall_status_; }
  std::uint32_t take_stall_status();
  /// Lets the stalled lists of a tag go on. Throws Fault when none is stalled.
  void acknowledge_stall(std::uint32_t tag, SourceLine where);

  /// Forgets every command: nothing of them moves any more.
  void clear();

  /// Another local store from here on; the queue is empty.
  void use_store(LocalStoreView& store) {
    store_ = &store;
    transfers_.use_store(store);
  }

  QueueCounters& counters() { return counters_; }
  Transfers& transfers() { return transfers_; }

 private:
  struct Pending {
    Command command;
    TraceTime issued{};
    std::vector<Piece> pieces;
    std::vector<std::byte> source;
    std::vector<ListElement> elements;
    std::uint32_t next_element = 0;
    std::uint32_t next_ls = 0;
    std::uint64_t id = 0;
    bool stalled = false;
    bool watched = false;
  };
  using Wanted = std::function<bool(const Pending&)>;

  bool late() const { return mode_ == DmaMode::late; }
  void issue_unchecked(const Command& command);
  void perform_now(const Command& command, std::byte* host);
  void move_other(const Command& command);
  void make_room(const Command& command);
  Pending prepare(const Command& command);
  Piece make_piece(const Command& command, std::uint32_t ls, std::uint64_t ea, std::uint32_t size);
  void collect_segment(Pending& pending);
  void collect_element(Pending& pending, const ListElement& element);
  void settle_overlaps(const Pending& pending);
  const Pending* find_overlap(const Pending& pending) const;
  void watch(Pending& pending);
  void end_watch(Pending& pending);

  bool can_land(std::size_t index) const;
  std::optional<std::size_t> choose(const Wanted& wanted);
  bool land_first(const Wanted& wanted);
  void land_wanted(const Wanted& wanted);
  void land(std::size_t index);
  void move(const Pending& pending);
  void move_piece(const Command& command, const Piece& piece);
  void stall(Pending pending, std::size_t index);
  void resume(std::uint64_t id);
  std::size_t index_of(std::uint64_t id) const;
  void count(const Command& command);
  static std::uint64_t bytes_of(const Pending& pending);
  void report(const Command& command, std::uint64_t bytes, TraceTime issued, TraceTime begin);
  TraceTime trace_time() const;
  void drain();

  const Issuer issuer_;
  const DmaMode mode_;
  const std::uint32_t depth_;
  Events* events_;
  ActivityLog* log_;
  QueueCounters counters_;
  Transfers transfers_;
  LocalStoreView* store_;
  Random random_;
  std::vector<Pending> queue_;
  std::uint64_t next_id_ = 0;
  std::uint32_t stall_status_ = 0;
};

}  // namespace spu_emu

#endif
