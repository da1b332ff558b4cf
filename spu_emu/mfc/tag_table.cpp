#include "mfc/tag_table.h"

namespace spu_emu {

namespace {
std::uint32_t tag_bits(std::uint32_t tag, std::uint32_t count) {
  return static_cast<std::uint32_t>(((std::uint64_t{1} << count) - 1) << tag);
}
}  // namespace

std::uint32_t TagTable::reserve(std::uint32_t count) {
  if (count == 0 || count > kTagCount) return kInvalid;
  for (std::uint32_t tag = 0; tag + count <= kTagCount; ++tag) {
    const std::uint32_t bits = tag_bits(tag, count);
    if ((reserved_ & bits) == 0) {
      reserved_ |= bits;
      return tag;
    }
  }
  return kInvalid;
}

std::uint32_t TagTable::release(std::uint32_t tag, std::uint32_t count) {
  if (count == 0 || count > kTagCount || tag > kTagCount - count) return kInvalid;
  const std::uint32_t bits = tag_bits(tag, count);
  if ((reserved_ & bits) != bits) return kInvalid;
  reserved_ &= ~bits;
  return kValid;
}

}  // namespace spu_emu
