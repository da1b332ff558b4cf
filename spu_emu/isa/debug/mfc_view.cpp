#include "isa/debug/mfc_view.h"

#include "mfc/format.h"
#include "spe/spe_list.h"

namespace spu_emu::isa {

namespace {

const char* mode_name(DmaMode mode) {
  if (mode == DmaMode::late) return "late";
  return mode == DmaMode::eager ? "eager" : "unchecked";
}

std::string command_line(const QueuedCommand& queued) {
  const Command& command = queued.command;
  std::string text =
      format("  %-8s tag %2u  LS 0x%05x  EA 0x%llx  size %u", command_name(command.opcode), command.tag,
             command.ls, static_cast<unsigned long long>(command.ea), command.size);
  if (queued.elements != 0) text += format("  element %u of %u", queued.next_element, queued.elements);
  return text + (queued.stalled ? "  stalled\n" : "\n");
}

std::string queue_lines(const char* name, const CommandQueue& queue, std::uint32_t depth) {
  const auto commands = queue.commands();
  std::string text = format("%-14s %zu of %u commands\n", name, commands.size(), depth);
  for (const QueuedCommand& each : commands) text += command_line(each);
  return text;
}

/// "3, 5" for the bits 3 and 5.
std::string bits_text(std::uint32_t bits) {
  std::string text;
  for (unsigned bit = 0; bit < 32; ++bit) {
    if ((bits >> bit & 1U) != 0) text += (text.empty() ? "" : ", ") + std::to_string(bit);
  }
  return text.empty() ? "none" : text;
}

std::string tag_lines(SpuChannels& channels) {
  constexpr const char* kUpdates[] = {"immediate", "any", "all"};
  std::string text =
      format("%-14s %s\n", "tags in flight", bits_text(channels.queue().pending_tags()).c_str());
  text += format("%-14s %s\n", "tag mask", bits_text(channels.tag_mask()).c_str());
  if (const auto update = channels.tag_update())
    text += format("%-14s %s\n", "tag update", kUpdates[*update]);
  if (const auto status = channels.tag_status())
    text += format("%-14s %s\n", "tag status", bits_text(*status).c_str());
  text += format("%-14s %s\n", "stalled tags", bits_text(channels.queue().stall_status()).c_str());
  return text + format("%-14s %s\n", "reserved tags", bits_text(channels.tags().reserved()).c_str());
}

std::string mailbox_line(const char* name, Mailbox& mailbox) {
  const auto messages = mailbox.messages();
  std::string text =
      format("%-22s %zu of %u%s", name, messages.size(), mailbox.capacity(), messages.empty() ? "" : ":");
  for (const std::uint32_t each : messages) text += format(" 0x%08x", each);
  return text + "\n";
}

std::string signal_line(unsigned index, const SignalRegister& signal) {
  return format("signal %u  0x%08x  %s  (%s)\n", index + 1, signal.value(),
                signal.pending() ? "waits to be read" : "nothing to read",
                signal.mode() == SignalMode::logical_or ? "later ones are ORed" : "later ones overwrite");
}

struct EventName {
  std::uint32_t bit;
  const char* name;
};
constexpr EventName kEvents[] = {
    {MFC_MULTI_SRC_SYNC_EVENT, "multi-source sync"},
    {MFC_PRIV_ATTN_EVENT, "privileged attention"},
    {MFC_LLR_LOST_EVENT, "reservation lost"},
    {MFC_SIGNAL_NOTIFY_1_EVENT, "signal 1"},
    {MFC_SIGNAL_NOTIFY_2_EVENT, "signal 2"},
    {MFC_OUT_MBOX_AVAILABLE_EVENT, "out mailbox available"},
    {MFC_OUT_INTR_MBOX_AVAILABLE_EVENT, "out interrupt mailbox available"},
    {MFC_DECREMENTER_EVENT, "decrementer"},
    {MFC_IN_MBOX_AVAILABLE_EVENT, "in mailbox available"},
    {MFC_COMMAND_QUEUE_AVAILABLE_EVENT, "queue available"},
    {MFC_LIST_STALL_NOTIFY_EVENT, "list stalled"},
    {MFC_TAG_STATUS_UPDATE_EVENT, "tag status updated"},
};

std::string event_names(std::uint32_t bits) {
  std::string text;
  for (const EventName& each : kEvents) {
    if ((bits & each.bit) != 0) text += (text.empty() ? "" : ", ") + std::string(each.name);
  }
  return text.empty() ? "none" : text;
}

std::string state_text(Spe& spe, const Spe& here) {
  const auto wait = spe.channels().waiting();
  if (&spe == &here && !wait) return "stands here, in the debugger";
  if (wait) {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - wait->since;
    return format("waits for %.1f s: %s", time.count(), wait->what);
  }
  return spe.runs() ? "runs" : "stands still: the host does not run it";
}

std::string pending_text(SpuChannels& channels) {
  std::string text =
      format("in mailbox %u of %u, out mailbox %u of %u, out interrupt mailbox %u of %u",
             channels.in_mailbox().count(), channels.in_mailbox().capacity(), channels.out_mailbox().count(),
             channels.out_mailbox().capacity(), channels.out_interrupt_mailbox().count(),
             channels.out_interrupt_mailbox().capacity());
  for (unsigned index = 0; index < 2; ++index) {
    if (channels.signal_register(index).pending()) text += format(", signal %u", index + 1);
  }
  return text;
}

}  // namespace

std::string queue_text(Spe& spe) {
  SpuChannels& channels = spe.channels();
  std::string text = queue_lines("queue", channels.queue(), kSpuQueueDepth);
  {
    const std::lock_guard lock(spe.proxy_mutex());
    text += queue_lines("proxy queue", spe.proxy(), kProxyQueueDepth);
  }
  text += tag_lines(channels);
  const Command& next = channels.next_command();
  text += format("%-14s LS 0x%05x  EA 0x%llx  size %u  tag %u\n", "written so far", next.ls,
                 static_cast<unsigned long long>(next.ea), next.size, next.tag);
  text +=
      format("%-14s %s%s\n", "DMA mode", mode_name(channels.mode()),
             channels.mode() == DmaMode::late ? "" : ": a transfer is done when it is issued; late keeps it");
  return text;
}

std::string mailboxes_text(Spe& spe) {
  SpuChannels& channels = spe.channels();
  return mailbox_line("in mailbox", channels.in_mailbox()) +
         mailbox_line("out mailbox", channels.out_mailbox()) +
         mailbox_line("out interrupt mailbox", channels.out_interrupt_mailbox());
}

std::string signals_text(Spe& spe) {
  return signal_line(0, spe.channels().signal_register(0)) +
         signal_line(1, spe.channels().signal_register(1));
}

std::string events_text(Spe& spe) {
  const Events& events = spe.channels().events();
  return "pending  " + event_names(events.pending()) + "\nmask     " + event_names(events.mask()) + "\n";
}

std::string spes_text(Spe& here) {
  std::string text;
  SpeList::instance().for_each([&](Spe& spe) {
    text += format("SPE %-3u %s\n        %s\n", spe.number(), state_text(spe, here).c_str(),
                   pending_text(spe.channels()).c_str());
  });
  return text;
}

}  // namespace spu_emu::isa
