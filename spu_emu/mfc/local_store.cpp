#include "mfc/local_store.h"

#include "mfc/format.h"

namespace spu_emu {

std::string FlatLocalStore::why_not(std::uint32_t ls, std::uint32_t size) const {
  return format("%u bytes at LS 0x%x do not lie within the local store of %u bytes", size, ls, size_);
}

}  // namespace spu_emu
