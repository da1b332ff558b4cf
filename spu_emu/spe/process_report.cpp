#include "spe/process_report.h"

#include "mfc/format.h"
#include "spe/host_waits.h"
#include "spe/spe.h"
#include "spe/spe_list.h"

namespace spu_emu {

namespace {
double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string state_of(Spe& spe) {
  if (const auto wait = spe.channels().waiting()) {
    const std::string where = spe.where_waiting();
    return format("waits for %.1f s: %s%s%s", seconds_since(wait->since), wait->what,
                  where.empty() ? "" : ",\n     ", where.c_str());
  }
  return spe.runs() ? "runs" : "stands still: the host does not run it";
}

std::string mailboxes_of(SpuChannels& channels) {
  const auto text = [](const char* name, const Mailbox& mailbox) {
    return format("%s %u of %u", name, mailbox.count(), mailbox.capacity());
  };
  std::string all = "messages: " + text("in mailbox", channels.in_mailbox()) + ", " +
                    text("out mailbox", channels.out_mailbox()) + ", " +
                    text("out interrupt mailbox", channels.out_interrupt_mailbox());
  for (unsigned index = 0; index < 2; ++index) {
    if (channels.signal_register(index).pending()) all += format(", signal %u", index + 1);
  }
  return all;
}
}  // namespace

std::string process_report() {
  std::string text;
  SpeList::instance().for_each([&](Spe& spe) {
    text += format("SPE %u %s\n      %s\n", spe.number(), state_of(spe).c_str(),
                   mailboxes_of(spe.channels()).c_str());
  });
  HostWaits::instance().for_each([&](const HostWaits::Wait& wait) {
    text += format("the host waits for %.1f s in %s\n", seconds_since(wait.since), wait.what.c_str());
  });
  return text;
}

}  // namespace spu_emu
