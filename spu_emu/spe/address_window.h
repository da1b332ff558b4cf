/// @file
/// The addresses of one emulated SPE, reserved.
#ifndef SPU_EMU_SPE_ADDRESS_WINDOW_H
#define SPU_EMU_SPE_ADDRESS_WINDOW_H

#include <array>
#include <cstddef>

namespace spu_emu {

/// 4 GB of addresses from a multiple of 4 GB, none of them accessible at first. Throws std::bad_alloc when
/// the system has none to give.
class AddressWindow {
 public:
  enum class Extent {
    whole,  // nobody else gets an address of the window, or of the page before it
    parts   // of a real SPU's local store, a page before and behind it, and the problem state
  };

  explicit AddressWindow(Extent extent);
  ~AddressWindow();
  AddressWindow(const AddressWindow&) = delete;
  AddressWindow& operator=(const AddressWindow&) = delete;

  std::byte* base() const { return base_; }

 private:
  struct Part {
    std::byte* first = nullptr;
    std::size_t size = 0;
  };

  void reserve_whole();
  void reserve_parts();
  bool reserve_parts_at(std::byte* base);

  std::byte* base_ = nullptr;
  std::array<Part, 2> parts_;
};

}  // namespace spu_emu

#endif
