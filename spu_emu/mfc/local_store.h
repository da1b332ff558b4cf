// What the MFC needs to know of a local store: where its bytes are, and in which byte order.
#ifndef SPU_EMU_MFC_LOCAL_STORE_H
#define SPU_EMU_MFC_LOCAL_STORE_H

#include <cstddef>
#include <cstdint>
#include <string>

namespace spu_emu {

/// Byte order of words in a local store compared with main memory.
enum class WordOrder { same, swapped };

/// A local store seen by LS address. `at` may be called from several threads.
class LocalStoreView {
 public:
  virtual ~LocalStoreView() = default;

  /// Host address of `size` bytes at LS address `ls`, or null if they are not all inside one backed piece.
  virtual std::byte* at(std::uint32_t ls, std::uint32_t size) noexcept = 0;

  /// Why `at` says null for these bytes, and how to mend it.
  virtual std::string why_not(std::uint32_t ls, std::uint32_t size) const = 0;

  /// `swapped`: every 32-bit word that moves between main memory and this local store has its bytes swapped.
  virtual WordOrder word_order() const noexcept = 0;
};

/// A local store that is one block of host memory: LS address 0 is its first byte.
class FlatLocalStore : public LocalStoreView {
 public:
  FlatLocalStore(std::byte* bytes, std::uint32_t size, WordOrder order)
      : bytes_(bytes), size_(size), order_(order) {}

  std::byte* at(std::uint32_t ls, std::uint32_t size) noexcept override {
    return ls <= size_ && size <= size_ - ls ? bytes_ + ls : nullptr;
  }
  std::string why_not(std::uint32_t ls, std::uint32_t size) const override;
  WordOrder word_order() const noexcept override { return order_; }

 private:
  std::byte* bytes_;
  std::uint32_t size_;
  WordOrder order_;
};

}  // namespace spu_emu

#endif
