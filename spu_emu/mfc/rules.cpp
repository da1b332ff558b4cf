#include "mfc/rules.h"

#include "mfc/fault.h"
#include "mfc/format.h"
#include "mfc/mapped.h"
#include "mfc/spe_directory.h"
#include "mfc/tag_table.h"

namespace spu_emu {

namespace {
constexpr std::uint32_t kProxyTagCount = 16;

bool is_small_size(std::uint32_t size) {
  return size == 1 || size == 2 || size == 4 || size == 8;
}

[[noreturn]] void fail(Rule rule, const std::string& detail, const Command& command) {
  throw Fault(rule, detail, command);
}

void check_size(const Command& command, std::uint32_t size) {
  if (size > kLargestTransfer) {
    fail(Rule::transfer_size, format("%u bytes are more than the 16384 of one transfer", size), command);
  }
  if (!is_small_size(size) && size % 16 != 0) {
    fail(Rule::transfer_size, format("%u bytes are not 1, 2, 4, 8 or a multiple of 16", size), command);
  }
}

void check_alignment(const Command& command, std::uint32_t ls, std::uint64_t ea, std::uint32_t size) {
  if (is_small_size(size)) {
    if (ls % size != 0 || ea % size != 0) {
      fail(Rule::natural_alignment, format("both addresses must be multiples of %u", size), command);
    }
    if (((ls ^ ea) & 15U) != 0) {
      fail(Rule::quadword_offset, "below 16 bytes the low 4 bits of LS address and EA must be equal",
           command);
    }
  } else if (size != 0 && ((ls | ea) & 15U) != 0) {
    fail(Rule::quadword_alignment, "from 16 bytes on both addresses must be multiples of 16", command);
  }
}

void check_list(const Command& command, LocalStoreView& store) {
  const auto list = static_cast<std::uint32_t>(command.ea);
  if (command.size % 8 != 0 || command.size / 8 > kMostListElements) {
    fail(Rule::list_size,
         format("a list of %u bytes is not 8 bytes for each of at most 2048 elements", command.size),
         command);
  }
  if (list % 8 != 0) fail(Rule::list_address, format("the list at LS 0x%x is not 8-aligned", list), command);
  if (store.at(list, command.size) == nullptr) {
    fail(Rule::local_store_range, "the list itself: " + store.why_not(list, command.size), command);
  }
}

/// Real SPU code is no part of this process: what it names is checked before this process touches it.
void check_if_foreign(const Command& command, std::uint64_t ea, std::uint32_t size,
                      const LocalStoreView& store) {
  if (store.has_real_code()) check_mapped(command, ea, size);
}

void check_line(const Command& command, LocalStoreView& store) {
  const std::uint32_t ls = command.ls & ~(kLineSize - 1);
  if (store.at(ls, kLineSize) == nullptr) {
    fail(Rule::local_store_range, store.why_not(ls, kLineSize), command);
  }
  if (is_bad_address(command.ea, kLineSize)) {
    fail(Rule::effective_address, "no program memory can be there", command);
  }
  check_if_foreign(command, command.ea & ~std::uint64_t{kLineSize - 1}, kLineSize, store);
}

void check_tag(const Command& command, Issuer issuer) {
  const std::uint32_t count = issuer == Issuer::proxy ? kProxyTagCount : kTagCount;
  if (command.tag >= count) {
    fail(Rule::tag, format("tag %u is not below %u", command.tag, count), command);
  }
}

void check_proxy(const Command& command) {
  if (is_list(command.opcode) || !(is_put(command.opcode) || is_get(command.opcode))) {
    fail(Rule::proxy_command, "the proxy queue takes put and get only", command);
  }
}
}  // namespace

std::byte* check_transfer(const Command& command, std::uint32_t ls, std::uint64_t ea, std::uint32_t size,
                          LocalStoreView& store) {
  check_size(command, size);
  check_alignment(command, ls, ea, size);
  std::byte* host = store.at(ls, size);
  if (host == nullptr) fail(Rule::local_store_range, store.why_not(ls, size), command);
  if (size != 0 && is_bad_address(ea, size)) {
    fail(Rule::effective_address, "no program memory can be there", command);
  }
  check_words(command, ls, ea, size, store);
  check_if_foreign(command, ea, size, store);
  return host;
}

std::byte* check_command(const Command& command, Issuer issuer, LocalStoreView& store) {
  check_tag(command, issuer);
  if (issuer == Issuer::proxy) check_proxy(command);
  switch (command.opcode) {
    case MFC_PUTL_CMD:
    case MFC_PUTLB_CMD:
    case MFC_PUTLF_CMD:
    case MFC_GETL_CMD:
    case MFC_GETLB_CMD:
    case MFC_GETLF_CMD:
      check_list(command, store);
      return nullptr;
    case MFC_SNDSIG_CMD:
    case MFC_SNDSIGB_CMD:
    case MFC_SNDSIGF_CMD:
      if (command.size != 4) fail(Rule::transfer_size, "a signal is 4 bytes", command);
      [[fallthrough]];
    case MFC_PUT_CMD:
    case MFC_PUTB_CMD:
    case MFC_PUTF_CMD:
    case MFC_GET_CMD:
    case MFC_GETB_CMD:
    case MFC_GETF_CMD:
      return check_transfer(command, command.ls, command.ea, command.size, store);
    case MFC_GETLLAR_CMD:
    case MFC_PUTLLC_CMD:
    case MFC_PUTLLUC_CMD:
    case MFC_PUTQLLUC_CMD:
      check_line(command, store);
      return nullptr;
    case MFC_BARRIER_CMD:
    case MFC_EIEIO_CMD:
    case MFC_SYNC_CMD:
    case MFC_SDCRT_CMD:
    case MFC_SDCRTST_CMD:
    case MFC_SDCRST_CMD:
    case MFC_SDCRF_CMD:
      return nullptr;
    case MFC_SDCRZ_CMD:
      if (command.size > kLargestTransfer)
        fail(Rule::transfer_size, "more than 16384 bytes to zero", command);
      if (is_bad_address(command.ea, command.size)) {
        fail(Rule::effective_address, "no program memory can be there", command);
      }
      check_if_foreign(command, command.ea, command.size, store);
      return nullptr;
    default:
      fail(Rule::opcode, format("0x%x is not a command", command.opcode), command);
  }
}

void check_words(const Command& command, std::uint32_t ls, std::uint64_t ea, std::uint32_t size,
                 const LocalStoreView& store) {
  if (store.word_order() == WordOrder::swapped && ((ls | ea | size) & 3U) != 0) {
    fail(Rule::word_transfer, "between memory of different byte order only 32-bit words move", command);
  }
}

namespace {
/// An SPE's local store and registers are checked by the transfer itself.
bool is_in_window(std::uint64_t ea) {
  bool found = false;
  if (SpeDirectory::may_be_window(ea)) {
    SpeDirectory::instance().with_window(ea, [&](const SpeWindow* window) { found = window != nullptr; });
  }
  return found;
}
}  // namespace

void check_mapped(const Command& command, std::uint64_t ea, std::uint32_t size) {
  if (size == 0 || is_in_window(ea)) return;
  const bool write = !is_get(command.opcode) && command.opcode != MFC_GETLLAR_CMD;
  if (!is_mapped(ea, size, write ? Access::write : Access::read)) {
    fail(Rule::effective_address,
         write ? "this process has no memory there that can be written"
               : "this process has no memory there that can be read",
         command);
  }
}

}  // namespace spu_emu
