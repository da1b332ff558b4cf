#include "libspe2/mapped_registers.h"

#include <csignal>
#include <cstdio>

#include "libspe2/context.h"

namespace spu_emu {

namespace {
constexpr std::uint32_t kLsa = kMfcCommandArea + 0x4;
constexpr std::uint32_t kEah = kMfcCommandArea + 0x8;
constexpr std::uint32_t kEal = kMfcCommandArea + 0xc;
constexpr std::uint32_t kSizeAndTag = kMfcCommandArea + 0x10;
constexpr std::uint32_t kCommand = kMfcCommandArea + 0x14;
constexpr std::uint32_t kQueueStatus = kMfcCommandArea + 0x104;
constexpr std::uint32_t kQueryType = kMfcCommandArea + 0x204;
constexpr std::uint32_t kQueryMask = kMfcCommandArea + 0x21c;
constexpr std::uint32_t kTagStatus = kMfcCommandArea + 0x22c;
constexpr std::uint32_t kOutMailbox = kControlArea + 0x4;
constexpr std::uint32_t kInMailbox = kControlArea + 0xc;
constexpr std::uint32_t kMailboxStatus = kControlArea + 0x14;
constexpr std::uint32_t kStatus = kControlArea + 0x24;
constexpr std::uint32_t kRunning = 1;
constexpr std::uint32_t kQueueIsEmpty = 0x80000000U;
}  // namespace

/// With the words written before it; what comes of it is 0, done, in the register's other meaning.
void MappedRegisters::issue(std::uint32_t command) {
  const std::lock_guard lock(spe_->spe.proxy_mutex());
  const std::uint64_t ea = std::uint64_t{eah_} << 32U | eal_;
  const std::uint32_t ls = spe_->spe.loaded() ? spe_->spe.program()->ls_address(lsa_) : lsa_;
  try {
    spe_->spe.proxy().issue({command & 0xffU, size_and_tag_ & 0xffffU, size_and_tag_ >> 16U, ls, ea, {}});
  } catch (const Fault& fault) {
    spe_->spe.set_last_fault(fault.text());
    std::fprintf(stderr, "spu_emu: %s\n", fault.text().c_str());
    std::raise(SIGBUS);
  }
}

std::uint32_t MappedRegisters::tag_status() {
  const std::lock_guard lock(spe_->spe.proxy_mutex());
  spe_->spe.proxy().land_one(query_mask_);
  return query_mask_ & ~spe_->spe.proxy().pending_tags();
}

bool MappedRegisters::write(std::uint32_t offset, std::uint32_t value) {
  const std::lock_guard lock(mutex_);
  switch (offset) {
    case kMsSyncArea:
    case kQueryType:
      return true;
    case kLsa:
      lsa_ = value;
      return true;
    case kEah:
      eah_ = value;
      return true;
    case kEal:
      eal_ = value;
      return true;
    case kSizeAndTag:
      size_and_tag_ = value;
      return true;
    case kCommand:
      issue(value);
      return true;
    case kQueryMask:
      query_mask_ = value;
      return true;
    default:
      return spe_->spe.channels().write_register(offset, value);
  }
}

bool MappedRegisters::read(std::uint32_t offset, std::uint32_t& value) {
  const std::lock_guard lock(mutex_);
  value = 0;
  switch (offset) {
    case kMsSyncArea:
    case kCommand:
    case kQueryType:
      return true;
    case kQueryMask:
      value = query_mask_;
      return true;
    case kTagStatus:
      value = tag_status();
      return true;
    case kQueueStatus: {
      const std::lock_guard proxy(spe_->spe.proxy_mutex());
      value = spe_->spe.proxy().free_slots() | (spe_->spe.proxy().empty() ? kQueueIsEmpty : 0);
      return true;
    }
    case kStatus:
      value = spe_->running.load() ? kRunning : static_cast<std::uint32_t>(spe_->status.load());
      return true;
    case kOutMailbox:
      // An empty mailbox has some value on a Cell, too.
      spe_->spe.channels().read_register(offset, value);
      return true;
    default:
      return spe_->spe.channels().read_register(offset, value);
  }
}

RegisterName register_name(std::uint32_t offset) {
  switch (offset) {
    case kOutMailbox:
      return {"SPU_Out_Mbox", "spe_out_mbox_read"};
    case kInMailbox:
      return {"SPU_In_Mbox", "spe_in_mbox_write"};
    case kMailboxStatus:
      return {"SPU_Mbox_Stat", "spe_in_mbox_status, spe_out_mbox_status or spe_out_intr_mbox_status"};
    case kSignal1Area + 0xc:
    case kSignal2Area + 0xc:
      return {"SPU_Sig_Notify", "spe_signal_write"};
    case kMsSyncArea:
      return {"MFC_MSSync", "spe_mssync_start"};
    default:
      if (offset >= kMfcCommandArea && offset < kControlArea) {
        return {"an MFC command register", "spe_mfcio_get, spe_mfcio_put or spe_mfcio_tag_status_read"};
      }
      return {"a register that runs the SPU", "spe_context_run"};
  }
}

}  // namespace spu_emu
