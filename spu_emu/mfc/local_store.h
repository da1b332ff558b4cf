/// @file
/// What the MFC needs to know of a local store: where its bytes are, and in which byte order.
#ifndef SPU_EMU_MFC_LOCAL_STORE_H
#define SPU_EMU_MFC_LOCAL_STORE_H

#include <cstddef>
#include <cstdint>
#include <string>

namespace spu_emu {

/// Byte order of words in a local store compared with main memory.
enum class WordOrder { same, swapped };

/// Learns which bytes of a local store were changed by somebody else than its own program. Any thread.
class StoreObserver {
 public:
  virtual void store_written(std::uint32_t ls, std::uint32_t size) noexcept = 0;

 protected:
  ~StoreObserver() = default;
};

/// A local store seen by LS address. `at` may be called from several threads.
///
/// Most accesses fall into one block of it, which is found without a virtual call: a transfer of 16 KB pushes
/// everything else out of the first-level cache, so each line touched on the way to it costs.
class LocalStoreView {
 public:
  virtual ~LocalStoreView() = default;

  /// Host address of `size` bytes at LS address `ls`, or null if they are not all inside one backed piece.
  std::byte* at(std::uint32_t ls, std::uint32_t size) noexcept {
    if (ls >= block_first_ && std::uint64_t{ls} + size <= block_last_) return bytes_ + ls;
    return at_elsewhere(ls, size);
  }

  /// Why `at` says null for these bytes, and how to mend it.
  virtual std::string why_not(std::uint32_t ls, std::uint32_t size) const = 0;

  /// `swapped`: every 32-bit word that moves between main memory and this local store has its bytes swapped.
  WordOrder word_order() const noexcept { return order_; }

  /// Whether real SPU code runs in it: instructions are decoded from it, so somebody learns of changes.
  bool has_real_code() const noexcept { return observer_ != nullptr || order_ == WordOrder::swapped; }

  /// To be called after bytes were changed by the MFC.
  void note_written(std::uint32_t ls, std::uint32_t size) noexcept {
    if (observer_ != nullptr) observer_->store_written(ls, size);
  }

 protected:
  explicit LocalStoreView(WordOrder order, StoreObserver* observer = nullptr)
      : order_(order), observer_(observer) {}
  /// `bytes` is the host address of LS address 0, backed from `first` to before `last`.
  void set_block(std::byte* bytes, std::uint32_t first, std::uint32_t last) {
    bytes_ = bytes;
    block_first_ = first;
    block_last_ = last;
  }

 private:
  /// As `at`, for what does not lie inside the block.
  virtual std::byte* at_elsewhere(std::uint32_t ls, std::uint32_t size) noexcept = 0;

  std::byte* bytes_ = nullptr;
  std::uint32_t block_first_ = 0;
  std::uint32_t block_last_ = 0;
  WordOrder order_;
  StoreObserver* observer_;
};

/// A local store that is one block of host memory: LS address 0 is its first byte.
class FlatLocalStore : public LocalStoreView {
 public:
  /// `observer` may be null, and outlives the store.
  FlatLocalStore(std::byte* bytes, std::uint32_t size, WordOrder order, StoreObserver* observer = nullptr)
      : LocalStoreView(order, observer), size_(size) {
    set_block(bytes, 0, size);
  }

  std::string why_not(std::uint32_t ls, std::uint32_t size) const override;

 private:
  std::byte* at_elsewhere(std::uint32_t, std::uint32_t) noexcept override { return nullptr; }

  std::uint32_t size_;
};

}  // namespace spu_emu

#endif
