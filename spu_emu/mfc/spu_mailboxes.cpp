// The mailboxes and signal registers of SpuChannels, from the SPU's side and from the other one.
#include <algorithm>

#include "mfc/fault.h"
#include "mfc/format.h"
#include "mfc/spu_channels.h"
#include "spu_emu/channel_numbers.h"

namespace spu_emu {

void SpuChannels::fail_deadline(const char* what) const {
  throw Fault(Rule::time_limit, format("SPE %u's program still waits when its time is over: %s", spe_, what));
}

/// When a sleeping SPU must look again whatever happens: at its deadline, and often where somebody listens.
WaitPoint::Time SpuChannels::next_look() const {
  constexpr std::chrono::milliseconds kBetweenLooks(20);
  if (wait_listener_ == nullptr) return deadline_;
  return std::min<WaitPoint::Time>(deadline_, std::chrono::steady_clock::now() + kBetweenLooks);
}

/// Fails when the program's time is over.
void SpuChannels::tell_of_wait(const char* what) {
  if (std::chrono::steady_clock::now() >= deadline_) fail_deadline(what);
  if (wait_listener_ != nullptr) wait_listener_->still_waiting(what);
}

/// Sleeps until the other side acts, or the program's time is over.
template <class Ready>
void SpuChannels::wait_until_ready(const char* what, Ready&& ready) {
  const WaitSpan span(log_, what);
  const Waiting waiting(wait_state_, what);
  while (!changed_.wait_until(ready, next_look())) tell_of_wait(what);
}

std::uint32_t SpuChannels::read_in_mailbox() {
  queue_.land_stores();
  std::uint32_t message = 0;
  if (!in_.try_read(message)) {
    counters_.mailbox_waits.add(1);
    wait_until_ready("read in mailbox", [&] { return in_.try_read(message); });
  }
  changed_.notify();
  return message;
}

void SpuChannels::write_out(Mailbox& mailbox, std::uint32_t value, const char* what) {
  queue_.land_stores();
  if (!mailbox.try_write(value)) {
    counters_.mailbox_waits.add(1);
    wait_until_ready(what, [&] { return mailbox.try_write(value); });
  }
  changed_.notify();
}

std::uint32_t SpuChannels::read_signal(unsigned index) {
  queue_.land_stores();
  std::uint32_t value = 0;
  if (!signals_[index].try_read(value)) {
    counters_.signal_waits.add(1);
    wait_until_ready(index == 0 ? "read signal 1" : "read signal 2",
                     [&] { return signals_[index].try_read(value); });
  }
  return value;
}

unsigned SpuChannels::write_in_mailbox(const std::uint32_t* messages, unsigned count) {
  unsigned written = 0;
  while (written < count && in_.try_write(messages[written])) ++written;
  if (written != 0) events_.raise(MFC_IN_MBOX_AVAILABLE_EVENT);
  return written;
}

unsigned SpuChannels::read_mailbox(Mailbox& mailbox, std::uint32_t event, std::uint32_t* messages,
                                   unsigned count) {
  unsigned done = 0;
  while (done < count && mailbox.try_read(messages[done])) ++done;
  if (done != 0) events_.raise(event);
  return done;
}

unsigned SpuChannels::read_out_mailbox(std::uint32_t* messages, unsigned count) {
  return read_mailbox(out_, MFC_OUT_MBOX_AVAILABLE_EVENT, messages, count);
}

unsigned SpuChannels::read_out_interrupt_mailbox(std::uint32_t* messages, unsigned count) {
  return read_mailbox(out_interrupt_, MFC_OUT_INTR_MBOX_AVAILABLE_EVENT, messages, count);
}

void SpuChannels::signal(unsigned index, std::uint32_t value) {
  signals_[index].write(value);
  events_.raise(index == 0 ? MFC_SIGNAL_NOTIFY_1_EVENT : MFC_SIGNAL_NOTIFY_2_EVENT);
}

bool SpuChannels::write_register(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case kSignal1Area + 0xc:
      signal(0, value);
      return true;
    case kSignal2Area + 0xc:
      signal(1, value);
      return true;
    case kControlArea + 0xc:
      in_.write_over(value);
      events_.raise(MFC_IN_MBOX_AVAILABLE_EVENT);
      return true;
    default:
      return false;
  }
}

bool SpuChannels::read_register(std::uint32_t offset, std::uint32_t& value) {
  switch (offset) {
    case kControlArea + 0x4:
      return read_out_mailbox(&value, 1) == 1;
    case kControlArea + 0x14:
      value = (out_interrupt_.count() << 16U) | (in_.space() << 8U) | out_.count();
      return true;
    default:
      return false;
  }
}

}  // namespace spu_emu
