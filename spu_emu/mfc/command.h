/// @file
/// One MFC command as it is issued, and what its opcode says about it.
#ifndef SPU_EMU_MFC_COMMAND_H
#define SPU_EMU_MFC_COMMAND_H

#include <cstdint>

#include "spu_emu/mfc_opcodes.h"
#include "spu_emu/source_line.h"

namespace spu_emu {

/// `ls` is an LS address in bytes, `ea` a whole 64-bit effective address; a list command carries its list's
/// LS address in the low half of `ea` and the list's bytes in `size`.
struct Command {
  std::uint32_t opcode = 0;
  std::uint32_t tag = 0;
  std::uint32_t size = 0;
  std::uint32_t ls = 0;
  std::uint64_t ea = 0;
  SourceLine where;
};

inline constexpr std::uint32_t kLocalStoreSize = 0x40000;
inline constexpr std::uint32_t kLargestTransfer = 16384;
inline constexpr std::uint32_t kLineSize = 128;
inline constexpr std::uint32_t kMostListElements = 2048;

constexpr bool is_put(std::uint32_t opcode) {
  return (opcode & 0xf8U) == MFC_PUT_CMD;
}
constexpr bool is_get(std::uint32_t opcode) {
  return (opcode & 0xf8U) == MFC_GET_CMD;
}
constexpr bool is_send_signal(std::uint32_t opcode) {
  return (opcode & 0xfcU) == MFC_SNDSIG_CMD;
}
/// Moves bytes out of the local store to an address: put, putl and sndsig.
constexpr bool is_store(std::uint32_t opcode) {
  return is_put(opcode) || is_send_signal(opcode);
}
constexpr bool is_list(std::uint32_t opcode) {
  return (is_put(opcode) || is_get(opcode)) && (opcode & 4U) != 0;
}
/// Moves one run of bytes between local store and an address.
constexpr bool is_simple_transfer(std::uint32_t opcode) {
  return (is_store(opcode) || is_get(opcode)) && !is_list(opcode);
}
/// Stores a line whatever is reserved, in the queue and with a tag.
constexpr bool is_line_store(std::uint32_t opcode) {
  return opcode == MFC_PUTQLLUC_CMD;
}
/// Has a variant field whose bits 1 and 2 mean barrier and fence.
constexpr bool has_variant(std::uint32_t opcode) {
  return is_store(opcode) || is_get(opcode);
}
constexpr bool is_tag_barrier(std::uint32_t opcode) {
  return (has_variant(opcode) && (opcode & 1U) != 0) || opcode == MFC_EIEIO_CMD || opcode == MFC_SYNC_CMD;
}
constexpr bool is_tag_fence(std::uint32_t opcode) {
  return has_variant(opcode) && (opcode & 2U) != 0;
}
constexpr bool is_queue_barrier(std::uint32_t opcode) {
  return opcode == MFC_BARRIER_CMD;
}

/// True if `earlier`, issued before `later` in the same queue, must be done before `later` may start.
constexpr bool must_precede(const Command& earlier, const Command& later) {
  if (is_queue_barrier(earlier.opcode) || is_queue_barrier(later.opcode)) return true;
  if (earlier.tag != later.tag) return false;
  return is_tag_barrier(earlier.opcode) || is_tag_barrier(later.opcode) || is_tag_fence(later.opcode);
}

/// The command's SDK name in lower case without prefix, for example "getf"; "unknown" for a reserved code.
const char* command_name(std::uint32_t opcode);

}  // namespace spu_emu

#endif
