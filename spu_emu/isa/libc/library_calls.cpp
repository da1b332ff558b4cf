#include "isa/libc/library_calls.h"

#include <unistd.h>

#include <cerrno>

namespace spu_emu::isa {

namespace {
constexpr unsigned kStdio = 0x2100;
constexpr unsigned kPosix = 0x2101;
constexpr unsigned kSystemCall = 0x2104;

/// Numbers of the PowerPC's Linux.
constexpr std::uint64_t kGetpid = 20;
constexpr std::uint64_t kGettid = 207;
}  // namespace

bool LibraryCalls::serve(unsigned int code, std::uint32_t word_address) {
  try {
    switch (code) {
      case kStdio:
      case kPosix:
        serve_assisted(code == kPosix, word_address);
        return true;
      case kSystemCall:
        serve_system_call(store_.word(word_address));
        return true;
      default:
        return false;
    }
  } catch (const BadAddress&) {
    return false;
  }
}

/// The word has the call's number in its first byte and the LS address of the argument block in the others.
/// The block's first word takes the result, its fourth the errno.
void LibraryCalls::serve_assisted(bool posix, std::uint32_t word_address) {
  const std::uint32_t word = store_.word(word_address);
  const std::uint32_t arguments = word & 0xffffffU;
  CallResult result{UINT32_MAX, EFAULT};
  try {
    result = call(posix, word >> 24U, arguments);
  } catch (const BadAddress&) {
    // The program is told so.
  }
  store_.set_word(arguments, result.value);
  for (const std::uint32_t slot : {1U, 2U}) store_.set_word(arguments + 4 * slot, 0);
  store_.set_word(arguments + 12, static_cast<std::uint32_t>(result.error));
}

CallResult LibraryCalls::call(bool posix, unsigned int number, std::uint32_t arguments) {
  if (access_ == LibraryCallAccess::none) return {UINT32_MAX, ENOSYS};
  if (posix) return call_posix(store_, files_, number, arguments);
  return call_stdio(store_, files_, number, arguments);
}

/// A block of doublewords: number and result, then six arguments.
void LibraryCalls::serve_system_call(std::uint32_t block) {
  const std::uint64_t number = store_.doubleword(block);
  std::int64_t result = -ENOSYS;
  if (access_ != LibraryCallAccess::none && number == kGetpid) result = getpid();
  if (access_ != LibraryCallAccess::none && number == kGettid) result = gettid();
  store_.set_doubleword(block, static_cast<std::uint64_t>(result));
}

}  // namespace spu_emu::isa
