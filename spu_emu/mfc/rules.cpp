#include "mfc/rules.h"

#include "mfc/fault.h"
#include "mfc/format.h"
#include "mfc/mapped.h"
#include "mfc/spe_directory.h"
#include "mfc/tag_table.h"
#include "mfc/touch.h"

namespace spu_emu {

namespace {
constexpr std::uint32_t kProxyTagCount = 16;

/// What may have become of an address on its way from a host of the other byte order, or nothing.
std::string exchanged_hint(std::uint64_t ea, std::uint32_t size) {
  const std::uint64_t exchanged = ea << 32U | ea >> 32U;
  if (exchanged == ea || is_bad_address(exchanged, size) || !is_mapped(exchanged, size, Access::read))
    return {};
  return format(
      "; its two words exchanged, 0x%llx, it is memory of this process: "
      "an address that crosses as two words has the high one first",
      static_cast<unsigned long long>(exchanged));
}

/// The same where the address has lost its high half.
std::string narrow_hint(std::uint64_t ea) {
  const bool is_narrow = sizeof(void*) == 8 && ea >= 0x10000U && ea >> 32U == 0;
  return is_narrow ? "; it has 32 bits, and addresses of this host have 64: all of them must be handed on"
                   : "";
}

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
      fail(Rule::natural_alignment,
           format("both addresses must be multiples of %u", size) + exchanged_hint(ea, size), command);
    }
    if (((ls ^ ea) & 15U) != 0) {
      fail(Rule::quadword_offset,
           "below 16 bytes the low 4 bits of LS address and EA must be equal" + exchanged_hint(ea, size),
           command);
    }
  } else if (size != 0 && ((ls | ea) & 15U) != 0) {
    fail(Rule::quadword_alignment,
         "from 16 bytes on both addresses must be multiples of 16" + exchanged_hint(ea, size), command);
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

/// An SPE's local store and registers are checked by the transfer itself.
bool is_in_window(std::uint64_t ea) {
  bool found = false;
  if (SpeDirectory::may_be_window(ea)) {
    SpeDirectory::instance().with_window(ea, [&](const SpeWindow* window) { found = window != nullptr; });
  }
  return found;
}

[[noreturn]] void fail_address(const Command& command, const char* what, std::uint64_t ea,
                               std::uint32_t size) {
  fail(Rule::effective_address, what + exchanged_hint(ea, size) + narrow_hint(ea), command);
}

[[noreturn]] void fail_access(const Command& command, Access access, std::uint64_t ea, std::uint32_t size) {
  fail_address(command,
               access == Access::write ? "this process has no memory there that can be written"
                                       : "this process has no memory there that can be read",
               ea, size);
}

Access access_of(const Command& command) {
  return is_get(command.opcode) || command.opcode == MFC_GETLLAR_CMD ? Access::read : Access::write;
}

void check_address(const Command& command, std::uint64_t ea, std::uint32_t size) {
  if (is_bad_address(ea, size)) fail_address(command, "no program memory can be there", ea, size);
}

/// What a program names is checked before this process uses it. Real SPU code may make up any address in a
/// loop, so for that the system is asked.
void check_memory(const Command& command, std::uint64_t ea, std::uint32_t size, const LocalStoreView& store) {
  if (store.has_real_code()) return check_mapped(command, ea, size);
  if (size == 0 || is_in_window(ea)) return;
  if (!can_touch(ea, size, access_of(command))) fail_access(command, access_of(command), ea, size);
}

void check_line(const Command& command, LocalStoreView& store) {
  const std::uint32_t ls = command.ls & ~(kLineSize - 1);
  if (store.at(ls, kLineSize) == nullptr) {
    fail(Rule::local_store_range, store.why_not(ls, kLineSize), command);
  }
  check_address(command, command.ea, kLineSize);
  check_memory(command, command.ea & ~std::uint64_t{kLineSize - 1}, kLineSize, store);
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
  if (size != 0) check_address(command, ea, size);
  check_words(command, ls, ea, size, store);
  check_memory(command, ea, size, store);
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
      check_address(command, command.ea, command.size);
      check_memory(command, command.ea, command.size, store);
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

void check_mapped(const Command& command, std::uint64_t ea, std::uint32_t size) {
  if (size == 0 || is_in_window(ea)) return;
  if (!is_mapped(ea, size, access_of(command))) fail_access(command, access_of(command), ea, size);
}

}  // namespace spu_emu
