#include "mfc/spu_channels.h"

#include <algorithm>

#include "mfc/fault.h"
#include "mfc/format.h"
#include "spu_emu/channel_numbers.h"

namespace spu_emu {

namespace {
constexpr std::uint32_t kTagMaskAll = 0xffffffffU;

[[noreturn]] void fail_channel(const char* what, std::uint32_t channel, SourceLine where) {
  std::string detail = format("channel %u cannot be %s", channel, what);
  if (where.file != nullptr) detail += format(" (at %s:%d)", where.file, where.line);
  throw Fault(Rule::channel, detail);
}

[[noreturn]] void fail_wait(const char* why, SourceLine where) {
  std::string detail = why;
  if (where.file != nullptr) detail += format(" (at %s:%d)", where.file, where.line);
  throw Fault(Rule::deadlock, detail);
}
}  // namespace

SpuChannels::SpuChannels(LocalStoreView& store, const Timebase& timebase, const ChannelSetup& setup)
    : spe_(setup.spe),
      mode_(setup.mode),
      log_(setup.log),
      changed_(setup.also_notified),
      events_(changed_),
      queue_(store, {Issuer::spu, setup.mode, setup.seed, &events_, setup.log}),
      atomics_(queue_.transfers(), events_, counters_),
      decrementer_(timebase),
      random_(setup.seed + 1),
      signals_{SignalRegister(setup.signal1), SignalRegister(setup.signal2)} {}

std::uint32_t SpuChannels::read(std::uint32_t channel, SourceLine where) {
  switch (channel) {
    case SPU_RdEventStat:
      return read_event_status(where);
    case SPU_RdSigNotify1:
      return read_signal(0);
    case SPU_RdSigNotify2:
      return read_signal(1);
    case SPU_RdDec:
      return decrementer_.read();
    case SPU_RdEventMask:
      return events_.mask();
    case MFC_RdTagMask:
      return tag_mask_;
    case SPU_RdMachStat:
      return 0;
    case SPU_RdSRR0:
      return srr0_;
    case MFC_RdTagStat:
      return read_tag_status(where);
    case MFC_RdListStallStat:
      return read_stall_status(where);
    case MFC_RdAtomicStat:
      return read_atomic_status(where);
    case SPU_RdInMbox:
      return read_in_mailbox();
    default:
      fail_channel("read", channel, where);
  }
}

void SpuChannels::write(std::uint32_t channel, std::uint32_t value, SourceLine where) {
  switch (channel) {
    case SPU_WrEventMask:
      return events_.set_mask(value);
    case SPU_WrEventAck:
      return events_.acknowledge(value);
    case SPU_WrDec:
      return decrementer_.write(value);
    case MFC_WrMSSyncReq:
      return events_.raise_own(MFC_MULTI_SRC_SYNC_EVENT);
    case SPU_WrSRR0:
      srr0_ = value;
      return;
    case MFC_LSA:
      next_.ls = value;
      return;
    case MFC_EAH:
      next_.ea = (next_.ea & kTagMaskAll) | (std::uint64_t{value} << 32U);
      return;
    case MFC_EAL:
      next_.ea = (next_.ea & ~std::uint64_t{kTagMaskAll}) | value;
      return;
    case MFC_Size:
      next_.size = value;
      return;
    case MFC_TagID:
      next_.tag = value;
      return;
    case MFC_Cmd: {
      Command command = next_;
      command.opcode = value & 0xffU;
      command.where = where;
      return dma(command);
    }
    case MFC_WrTagMask:
      tag_mask_ = value;
      return;
    case MFC_WrTagUpdate:
      return write_tag_update(value, where);
    case MFC_WrListStallAck:
      return queue_.acknowledge_stall(value, where);
    case SPU_WrOutMbox:
      return write_out(out_, value, "write out mailbox");
    case SPU_WrOutIntrMbox:
      return write_out(out_interrupt_, value, "write out interrupt mailbox");
    default:
      fail_channel("written", channel, where);
  }
}

std::uint32_t SpuChannels::count(std::uint32_t channel, SourceLine where) {
  switch (channel) {
    case SPU_RdEventStat:
      progress_for_events(where);
      return events_.status() != 0 ? 1 : 0;
    case SPU_RdSigNotify1:
      return signals_[0].pending() ? 1 : 0;
    case SPU_RdSigNotify2:
      return signals_[1].pending() ? 1 : 0;
    case MFC_Cmd:
      return count_command();
    case MFC_RdTagStat:
      return count_tag_status();
    case MFC_RdListStallStat:
      return count_stall_status();
    case MFC_RdAtomicStat:
      return atomics_.has_status() ? 1 : 0;
    case SPU_WrOutMbox:
      return out_.space();
    case SPU_RdInMbox:
      return in_.count();
    case SPU_WrOutIntrMbox:
      return out_interrupt_.space();
    default:
      return 1;
  }
}

void SpuChannels::dma(const Command& command) {
  if (!AtomicUnit::handles(command.opcode)) return queue_.issue(command);
  if (mode_ != DmaMode::unchecked) {
    Command untagged = command;
    untagged.tag = 0;  // The atomic commands have no tag; programs leave anything in the channel.
    check_command(untagged, Issuer::spu, queue_.transfers().store());
  }
  atomics_.execute(command);
}

// Tag status
// -------------------------------------------------------------------------------------------------------

void SpuChannels::write_tag_update(std::uint32_t kind, SourceLine where) {
  if (kind > MFC_TAG_UPDATE_ALL) {
    std::string detail = format("%u is not 0 (immediate), 1 (any) or 2 (all)", kind);
    if (where.file != nullptr) detail += format(" (at %s:%d)", where.file, where.line);
    throw Fault(Rule::tag_update, detail);
  }
  tag_status_.reset();
  tag_update_ = kind;
  if (mode_ != DmaMode::late && (kind == MFC_TAG_UPDATE_IMMEDIATE || done_tags() == tag_mask_)) {
    events_.raise_own(MFC_TAG_STATUS_UPDATE_EVENT);
  }
}

/// Lands what the update that was asked for covers, and sets the tag status.
void SpuChannels::wait_for_tags(std::uint32_t kind, SourceLine where) {
  const WaitSpan span(log_, "wait for tags");
  counters_.tag_waits.add(1);
  if (queue_.empty()) return set_tag_status();  // The usual case of eager mode.
  if (kind == MFC_TAG_UPDATE_ALL) {
    queue_.land_tags(tag_mask_);
    if (done_tags() != tag_mask_)
      fail_wait("a tag of the mask has a stalled list: acknowledge the stall", where);
  } else if (kind == MFC_TAG_UPDATE_IMMEDIATE) {
    if (random_.below(2) == 0) queue_.land_one(tag_mask_);
  } else {
    if (done_tags() == 0 || random_.below(2) == 0) queue_.land_one(tag_mask_);
    while (done_tags() == 0 && tag_mask_ != 0) {
      if (!queue_.land_one(tag_mask_)) fail_wait("every tag of the mask has a stalled list", where);
    }
  }
  queue_.land_stores();
  set_tag_status();
}

void SpuChannels::set_tag_status() {
  tag_status_ = done_tags();
  tag_update_.reset();
  events_.raise_own(MFC_TAG_STATUS_UPDATE_EVENT);
}

std::uint32_t SpuChannels::read_tag_status(SourceLine where) {
  if (!tag_status_) {
    if (!tag_update_) fail_wait("the tag status is read but no tag update was written", where);
    wait_for_tags(*tag_update_, where);
  }
  // Not std::exchange: it would copy value and flag as one word just after they were written as two.
  const std::uint32_t status = *tag_status_;
  tag_status_.reset();
  return status;
}

/// Whether a read would not block; in late mode every look lets one more command land.
std::uint32_t SpuChannels::count_tag_status() {
  if (tag_status_) return 1;
  if (!tag_update_) return 0;
  if (mode_ == DmaMode::late) queue_.land_one(tag_mask_);
  if (*tag_update_ == MFC_TAG_UPDATE_ALL) return done_tags() == tag_mask_ ? 1 : 0;
  return *tag_update_ == MFC_TAG_UPDATE_IMMEDIATE || tag_mask_ == 0 || done_tags() != 0 ? 1 : 0;
}

// Lists, atomics, queue
// --------------------------------------------------------------------------------------------

std::uint32_t SpuChannels::read_stall_status(SourceLine where) {
  queue_.land_stores();
  if (queue_.stall_status() == 0) queue_.land_stalling_lists();
  if (queue_.stall_status() == 0) fail_wait("no list in the queue can stall", where);
  return queue_.take_stall_status();
}

std::uint32_t SpuChannels::count_stall_status() {
  if (queue_.stall_status() == 0) queue_.land_stalling_lists();
  return queue_.stall_status() != 0 ? 1 : 0;
}

std::uint32_t SpuChannels::read_atomic_status(SourceLine where) {
  queue_.land_stores();
  const auto status = atomics_.take_status();
  if (!status) fail_wait("the atomic status is read but no atomic command was issued", where);
  return *status;
}

std::uint32_t SpuChannels::count_command() {
  if (queue_.free_slots() == 0) queue_.land_one(kTagMaskAll);
  return queue_.free_slots();
}

// Events
// -----------------------------------------------------------------------------------------------------------

void SpuChannels::poll_events() {
  if (decrementer_.take_event()) events_.raise(MFC_DECREMENTER_EVENT);
  if ((events_.mask() & MFC_LLR_LOST_EVENT) != 0) atomics_.poll_reservation();
}

/// Lets everything happen that an enabled event can be waiting for. True if one is there now.
bool SpuChannels::progress_for_events(SourceLine where) {
  poll_events();
  if (events_.status() != 0) return true;
  if ((events_.mask() & MFC_LIST_STALL_NOTIFY_EVENT) != 0) queue_.land_stalling_lists();
  if ((events_.mask() & MFC_COMMAND_QUEUE_AVAILABLE_EVENT) != 0) count_command();
  if ((events_.mask() & MFC_TAG_STATUS_UPDATE_EVENT) != 0 && tag_update_ && queue_.stall_status() == 0) {
    wait_for_tags(*tag_update_, where);
  }
  return events_.status() != 0;
}

/// When a sleeping SPU must look again for what no thread tells it: the decrementer and a changed reserved
/// line.
WaitPoint::Time SpuChannels::next_poll() const {
  const auto now = std::chrono::steady_clock::now();
  auto next = WaitPoint::Time::max();
  if ((events_.mask() & MFC_DECREMENTER_EVENT) != 0 && decrementer_.armed()) {
    next = now + decrementer_.until_event();
  }
  if ((events_.mask() & MFC_LLR_LOST_EVENT) != 0) {
    next = std::min<WaitPoint::Time>(next, now + std::chrono::microseconds(50));
  }
  return next;
}

std::uint32_t SpuChannels::read_event_status(SourceLine where) {
  queue_.land_stores();
  if (!progress_for_events(where)) {
    const WaitSpan span(log_, "wait for events");
    const Waiting waiting(wait_state_, "wait for events");
    counters_.event_waits.add(1);
    while (!changed_.wait_until([&] { return events_.status() != 0; }, std::min(next_poll(), next_look()))) {
      tell_of_wait("wait for events");
      poll_events();
    }
  }
  return events_.status();
}

}  // namespace spu_emu
