// libspe2: DMA through the proxy queue.
#include <utility>

#include "libspe2/context.h"

namespace {

using spu_emu::CommandQueue;
using spu_emu::fail;
using spu_emu::Fault;

constexpr unsigned kProxyTags = 16;
constexpr unsigned kLargestId = 0xff;

/// Calls `use(queue)` under the proxy's lock; a broken rule becomes errno EIO.
template <class Use>
int with_proxy(spe_context_ptr_t spe, Use&& use) {
  const std::lock_guard lock(spe->spe.proxy_mutex());
  try {
    return use(spe->spe.proxy());
  } catch (const Fault& fault) {
    spe->spe.set_last_fault(fault.text());
    return fail(EIO);
  }
}

int issue(spe_context_ptr_t spe, unsigned opcode, unsigned ls, void* ea, unsigned size, unsigned tag,
          unsigned tid, unsigned rid) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  if (tag >= kProxyTags || tid > kLargestId || rid > kLargestId) return fail(EINVAL);
  return with_proxy(spe, [&](CommandQueue& queue) {
    const std::uint32_t address = spe->spe.loaded() ? spe->spe.program()->ls_address(ls) : ls;
    queue.issue({opcode, tag, size, address, reinterpret_cast<std::uintptr_t>(ea), {}});
    spe->used_tags |= 1U << tag;
    return 0;
  });
}

void land(CommandQueue& queue, unsigned mask, unsigned behavior) {
  if (behavior == SPE_TAG_ALL) {
    queue.land_tags(mask);
  } else if (behavior == SPE_TAG_IMMEDIATE || (mask & ~queue.pending_tags()) == 0) {
    queue.land_one(mask);
    while (behavior == SPE_TAG_ANY && (mask & ~queue.pending_tags()) == 0 && queue.land_one(mask)) {
    }
  }
}

}  // namespace

int spe_mfcio_put(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                  unsigned int tid, unsigned int rid) {
  return issue(spe, MFC_PUT_CMD, ls, ea, size, tag, tid, rid);
}

int spe_mfcio_putb(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                   unsigned int tid, unsigned int rid) {
  return issue(spe, MFC_PUTB_CMD, ls, ea, size, tag, tid, rid);
}

int spe_mfcio_putf(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                   unsigned int tid, unsigned int rid) {
  return issue(spe, MFC_PUTF_CMD, ls, ea, size, tag, tid, rid);
}

int spe_mfcio_get(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                  unsigned int tid, unsigned int rid) {
  return issue(spe, MFC_GET_CMD, ls, ea, size, tag, tid, rid);
}

int spe_mfcio_getb(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                   unsigned int tid, unsigned int rid) {
  return issue(spe, MFC_GETB_CMD, ls, ea, size, tag, tid, rid);
}

int spe_mfcio_getf(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                   unsigned int tid, unsigned int rid) {
  return issue(spe, MFC_GETF_CMD, ls, ea, size, tag, tid, rid);
}

int spe_mfcio_tag_status_read(spe_context_ptr_t spe, unsigned int mask, unsigned int behavior,
                              unsigned int* tag_status) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  if (tag_status == nullptr || behavior < SPE_TAG_ALL || behavior > SPE_TAG_IMMEDIATE) return fail(EINVAL);
  return with_proxy(spe, [&](CommandQueue& queue) {
    const unsigned asked = mask != 0 ? mask : spe->used_tags;
    land(queue, asked, behavior);
    *tag_status = asked & ~queue.pending_tags();
    spe->used_tags &= ~*tag_status;
    return 0;
  });
}
