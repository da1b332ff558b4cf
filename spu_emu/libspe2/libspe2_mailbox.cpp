// libspe2: mailboxes and signals.
#include "libspe2/context.h"
#include "mfc/format.h"
#include "spe/host_waits.h"

namespace {

using spu_emu::fail;

/// Moves messages by `move(first, count)`, which moves what it can now, as the behavior says; `ready` tells
/// whether it can move one. Returns the number moved or -1 with errno.
template <class Move, class Ready>
int transfer(const char* name, spe_context_ptr_t spe, unsigned* data, int count, unsigned behavior,
             Move&& move, Ready&& ready) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  if (data == nullptr || count < 1 || behavior < SPE_MBOX_ALL_BLOCKING ||
      behavior > SPE_MBOX_ANY_NONBLOCKING) {
    return fail(EINVAL);
  }
  const auto total = static_cast<unsigned>(count);
  unsigned done = move(spe->spe.channels(), data, total);
  if (behavior == SPE_MBOX_ANY_NONBLOCKING) return static_cast<int>(done);
  const unsigned wanted = behavior == SPE_MBOX_ALL_BLOCKING ? total : 1U;
  if (done >= wanted) return static_cast<int>(done);
  const spu_emu::HostWait wait(spu_emu::format("%s of SPE %u", name, spe->spe.number()));
  while (done < wanted) {
    spe->spe.channels().changed().wait([&] { return ready(spe->spe.channels()); });
    done += move(spe->spe.channels(), data + done, total - done);
  }
  return static_cast<int>(done);
}

}  // namespace

int spe_out_mbox_read(spe_context_ptr_t spe, unsigned int* mbox_data, int count) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  if (mbox_data == nullptr || count < 1) return fail(EINVAL);
  return static_cast<int>(spe->spe.channels().read_out_mailbox(mbox_data, static_cast<unsigned>(count)));
}

int spe_out_mbox_status(spe_context_ptr_t spe) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  return static_cast<int>(spe->spe.channels().out_mailbox().count());
}

int spe_in_mbox_write(spe_context_ptr_t spe, unsigned int* mbox_data, int count, unsigned int behavior) {
  return transfer(
      __func__, spe, mbox_data, count, behavior,
      [](spu_emu::SpuChannels& channels, unsigned* first, unsigned n) {
        return channels.write_in_mailbox(first, n);
      },
      [](spu_emu::SpuChannels& channels) { return channels.in_mailbox().space() != 0; });
}

int spe_in_mbox_status(spe_context_ptr_t spe) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  return static_cast<int>(spe->spe.channels().in_mailbox().space());
}

int spe_out_intr_mbox_read(spe_context_ptr_t spe, unsigned int* mbox_data, int count, unsigned int behavior) {
  return transfer(
      __func__, spe, mbox_data, count, behavior,
      [](spu_emu::SpuChannels& channels, unsigned* first, unsigned n) {
        return channels.read_out_interrupt_mailbox(first, n);
      },
      [](spu_emu::SpuChannels& channels) { return channels.out_interrupt_mailbox().count() != 0; });
}

int spe_out_intr_mbox_status(spe_context_ptr_t spe) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  return static_cast<int>(spe->spe.channels().out_interrupt_mailbox().count());
}

int spe_signal_write(spe_context_ptr_t spe, unsigned int signal_reg, unsigned int data) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  if (signal_reg != SPE_SIG_NOTIFY_REG_1 && signal_reg != SPE_SIG_NOTIFY_REG_2) return fail(EINVAL);
  spe->spe.channels().signal(signal_reg == SPE_SIG_NOTIFY_REG_1 ? 0 : 1, data);
  return 0;
}
