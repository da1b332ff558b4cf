// A local store with argument blocks of library calls in it, as newlib lays them out.
#ifndef SPU_EMU_TESTS_ISA_LIBC_CALL_STORE_H
#define SPU_EMU_TESTS_ISA_LIBC_CALL_STORE_H

#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include "isa/libc/library_calls.h"

namespace spu_emu::isa {

inline constexpr std::uint32_t kStoreSize = 0x40000;

class CallStore {
 public:
  explicit CallStore(LibraryCallAccess access = LibraryCallAccess::files)
      : store({bytes.data(), bytes.size()}, nullptr), calls(store, access) {}

  /// Puts a text into the store; its address.
  std::uint32_t text(const std::string& value) {
    const std::uint32_t at = next_;
    store.write(at, std::as_bytes(std::span(value.c_str(), value.size() + 1)));
    next_ += static_cast<std::uint32_t>(value.size() + 16) / 16 * 16;
    return at;
  }

  /// A call with these argument words; its result. errno is in `error`.
  std::uint32_t call(unsigned int code, unsigned int number, std::initializer_list<std::uint32_t> words) {
    std::uint32_t at = kBlock;
    for (const std::uint32_t word : words) {
      store.set_word(at, word);
      at += 16;
    }
    store.set_word(kCallWord, (number << 24U) | kBlock);
    known = calls.serve(code, kCallWord);
    error = store.word(kBlock + 12);
    return store.word(kBlock);
  }
  std::uint32_t stdio(unsigned int number, std::initializer_list<std::uint32_t> words) {
    return call(0x2100, number, words);
  }
  std::uint32_t posix(unsigned int number, std::initializer_list<std::uint32_t> words) {
    return call(0x2101, number, words);
  }

  // Variable arguments, a quadword each, as if all had been in registers.
  void add_word(std::uint32_t value) {
    store.set_word(next_argument_, value);
    next_argument_ += 16;
  }
  void add_doubleword(std::uint64_t value) {
    store.set_doubleword(next_argument_, value);
    next_argument_ += 16;
  }
  void add_double(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    add_doubleword(bits);
  }

  static constexpr std::uint32_t kCallWord = 0x100;
  static constexpr std::uint32_t kBlock = 0x200;
  static constexpr std::uint32_t kArguments = 0x8000;
  static constexpr std::uint32_t kArgumentsEnd = 0x9000;

  std::vector<std::byte> bytes = std::vector<std::byte>(kStoreSize);
  StoreBytes store;
  LibraryCalls calls;
  bool known = false;
  std::uint32_t error = 0;

 private:
  std::uint32_t next_ = 0x1000;
  std::uint32_t next_argument_ = kArguments;
};

}  // namespace spu_emu::isa

#endif
