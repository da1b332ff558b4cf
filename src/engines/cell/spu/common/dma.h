/// @file
/// Transfers of any length for SPU programs: split into commands of what the MFC takes (C4). SPU side only.
#pragma once

#include <spu_mfcio.h>

#include "engines/cell/wire.h"

namespace cellsweep::cell {

inline unsigned long long ea_of(const WireAddress& address) {
  return mfc_hl2ea(address.high, address.low);
}

/// Waits until all commands of the tags in `mask` are done (Listing 4.7).
inline void wait_for_tags(unsigned int mask) {
  mfc_write_tag_mask(mask);
  mfc_read_tag_status_all();
}

inline void wait_for_tag(unsigned int tag) {
  wait_for_tags(1U << tag);
}

/// Moves `bytes`, a multiple of 16, by as many commands as that takes; done when the tag is.
inline void transfer(void* ls, unsigned long long ea, unsigned int bytes, unsigned int tag,
                     unsigned int command) {
  char* next = static_cast<char*>(ls);
  while (bytes != 0) {
    const unsigned int now = bytes < kMaxTransfer ? bytes : kMaxTransfer;
    spu_mfcdma64(next, mfc_ea2h(ea), mfc_ea2l(ea), now, tag, command);
    next += now;
    ea += now;
    bytes -= now;
  }
}

inline void get_all(void* ls, unsigned long long ea, unsigned int bytes, unsigned int tag) {
  transfer(ls, ea, bytes, tag, MFC_GET_CMD);
}

inline void put_all(void* ls, unsigned long long ea, unsigned int bytes, unsigned int tag) {
  transfer(ls, ea, bytes, tag, MFC_PUT_CMD);
}

}  // namespace cellsweep::cell
