/// @file
/// A local store's bytes for the host side of library calls: every access is checked and told to the machine.
#ifndef SPU_EMU_ISA_LIBC_STORE_BYTES_H
#define SPU_EMU_ISA_LIBC_STORE_BYTES_H

#include <algorithm>
#include <span>
#include <string>

#include "isa/encoding/big_endian.h"
#include "mfc/local_store.h"

namespace spu_emu::isa {

/// Thrown for an address that a program gave and that does not lie in its local store.
struct BadAddress {};

class StoreBytes {
 public:
  /// `observer` may be null. Both it and `bytes` outlive this object.
  StoreBytes(std::span<std::byte> bytes, StoreObserver* observer) : bytes_(bytes), observer_(observer) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(bytes_.size()); }

  /// The functions below throw BadAddress when not all bytes lie in the local store.
  std::span<const std::byte> read(std::uint32_t ls, std::uint32_t size) const { return part(ls, size); }
  std::uint32_t word(std::uint32_t ls) const { return read_word(part(ls, 4).data()); }
  std::uint64_t doubleword(std::uint32_t ls) const { return read_doubleword(part(ls, 8).data()); }

  /// The NUL-ended text at `ls`, of at most `longest` bytes.
  std::string text(std::uint32_t ls, std::uint32_t longest = UINT32_MAX) const {
    if (ls > bytes_.size()) throw BadAddress{};
    const auto rest = bytes_.subspan(ls).first(std::min<std::size_t>(longest, bytes_.size() - ls));
    const auto end = std::find(rest.begin(), rest.end(), std::byte{0});
    if (end == rest.end() && rest.size() < longest) throw BadAddress{};
    return {reinterpret_cast<const char*>(rest.data()), static_cast<std::size_t>(end - rest.begin())};
  }

  void write(std::uint32_t ls, std::span<const std::byte> bytes) {
    const auto size = static_cast<std::uint32_t>(std::min<std::size_t>(bytes.size(), UINT32_MAX));
    std::copy(bytes.begin(), bytes.end(), part(ls, size).begin());
    note(ls, size);
  }
  void set_word(std::uint32_t ls, std::uint32_t value) {
    write_word(part(ls, 4).data(), value);
    note(ls, 4);
  }
  void set_doubleword(std::uint32_t ls, std::uint64_t value) {
    write_doubleword(part(ls, 8).data(), value);
    note(ls, 8);
  }

 private:
  std::span<std::byte> part(std::uint32_t ls, std::uint32_t size) const {
    if (ls > bytes_.size() || size > bytes_.size() - ls) throw BadAddress{};
    return bytes_.subspan(ls, size);
  }
  void note(std::uint32_t ls, std::uint32_t size) {
    if (observer_ != nullptr) observer_->store_written(ls, size);
  }

  std::span<std::byte> bytes_;
  StoreObserver* observer_;
};

/// The arguments of an assisted C function: its parameters, then those of a va_list, a quadword each.
class ArgumentList {
 public:
  /// `va_list_address` is where the two quadwords {next argument, end of the saved registers} of the list
  /// are.
  ArgumentList(const StoreBytes& store, std::uint32_t va_list_address)
      : store_(store),
        next_(store.word(va_list_address)),
        registers_end_(store.word(va_list_address + kSlot)) {}

  std::uint32_t next_word() { return store_.word(next_slot()); }
  std::uint64_t next_doubleword() { return store_.doubleword(next_slot()); }
  double next_double() {
    const std::uint64_t bits = next_doubleword();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

 private:
  static constexpr std::uint32_t kSlot = 16;

  /// Arguments that were in registers lie below the caller's frame, the others behind its first two
  /// quadwords.
  std::uint32_t next_slot() {
    if (next_ <= registers_end_ && next_ + kSlot > registers_end_) next_ = registers_end_ + 2 * kSlot;
    const std::uint32_t slot = next_;
    next_ += kSlot;
    return slot;
  }

  const StoreBytes& store_;
  std::uint32_t next_;
  std::uint32_t registers_end_;
};

}  // namespace spu_emu::isa

#endif
