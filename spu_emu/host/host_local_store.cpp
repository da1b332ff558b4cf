#include "host/host_local_store.h"

#include "mfc/command.h"
#include "mfc/format.h"

namespace spu_emu {

namespace {
std::uintptr_t number_of(const volatile void* pointer) {
  return reinterpret_cast<std::uintptr_t>(pointer);
}

/// The first LS address from `ls` on that has the low bits of a host address.
std::uint64_t congruent(std::uint64_t ls, const std::byte* host) {
  return (ls + kLineSize - 1) / kLineSize * kLineSize + number_of(host) % kLineSize;
}
}  // namespace

HostLocalStore::HostLocalStore(Arena& arena, std::uint32_t code_reserve, std::uint32_t stack_reserve)
    : LocalStoreView(WordOrder::same),
      arena_(arena),
      code_reserve_(code_reserve),
      stack_reserve_(stack_reserve) {
  clear();
}

void HostLocalStore::clear() {
  windows_.clear();
  data_bytes_ = 0;
  placed_ = false;
  heap_.reset(code_reserve_, stack_begin());
  set_block(arena_.base(), 0, size());
}

bool HostLocalStore::place(const std::vector<ModuleSegment>& segments) {
  clear();
  std::uint64_t constants = 0;
  std::uint64_t data = code_reserve_;
  for (const ModuleSegment& segment : segments) {
    std::uint64_t& next = segment.writable ? data : constants;
    const std::uint64_t ls = congruent(next, segment.first);
    const std::uint64_t end = ls + segment.size;
    if (end > (segment.writable ? stack_begin() : code_reserve_)) {
      if (segment.writable) return false;
      continue;  // Constants beyond the code reserve have no address; using them by DMA says so.
    }
    windows_.push_back({static_cast<std::uint32_t>(ls), segment});
    next = end;
  }
  data_bytes_ = static_cast<std::uint32_t>(data) - code_reserve_;
  heap_.reset(static_cast<std::uint32_t>(data), stack_begin());
  set_block(arena_.base(), heap_.first(), heap_.last());
  placed_ = true;
  return true;
}

const HostLocalStore::Window* HostLocalStore::window_of(std::uint32_t ls) const {
  for (const Window& window : windows_) {
    if (ls >= window.ls && ls - window.ls < window.segment.size) return &window;
  }
  return nullptr;
}

std::byte* HostLocalStore::at_elsewhere(std::uint32_t ls, std::uint32_t bytes) noexcept {
  if (!placed_) return nullptr;
  const std::uint64_t end = std::uint64_t{ls} + bytes;
  if (ls >= stack_begin()) return end <= size() ? arena_.stack_top() - (size() - ls) : nullptr;
  if (const Window* window = window_of(ls)) {
    const std::uint32_t offset = ls - window->ls;
    return bytes <= window->segment.size - offset ? window->segment.first + offset : nullptr;
  }
  return end <= code_reserve_ ? arena_.base() + ls : nullptr;
}

std::string HostLocalStore::why_not(std::uint32_t ls, std::uint32_t bytes) const {
  if (std::uint64_t{ls} + bytes > size()) {
    return format("%u bytes at LS 0x%x do not lie within the local store of %u bytes", bytes, ls, size());
  }
  return format("%u bytes at LS 0x%x cross from one part of the local store into another:\n%s", bytes, ls,
                map().c_str());
}

std::optional<std::uint32_t> HostLocalStore::address_of(const volatile void* pointer) const {
  const std::uintptr_t number = number_of(pointer);
  if (number >> 32U == 0) return address_of_number(static_cast<std::uint32_t>(number));
  if (in_arena(pointer)) return ls_of_arena(pointer);
  const std::uintptr_t below_top = number_of(arena_.stack_top()) - number;
  if (below_top != 0 && below_top <= stack_reserve_) return size() - static_cast<std::uint32_t>(below_top);
  for (const Window& window : windows_) {
    const std::uintptr_t offset = number - number_of(window.segment.first);
    if (offset < window.segment.size) return window.ls + static_cast<std::uint32_t>(offset);
  }
  return std::nullopt;
}

std::uint32_t HostLocalStore::address_of_number(std::uint32_t number) const {
  if (number < size()) return number;
  const std::uint32_t below_top = Arena::kStackTop - number;
  if (below_top != 0 && below_top <= stack_reserve_) return size() - below_top;
  for (const Window& window : windows_) {
    const std::uint32_t offset = number - static_cast<std::uint32_t>(number_of(window.segment.first));
    if (offset < window.segment.size) return window.ls + offset;
  }
  return number;
}

bool HostLocalStore::below_stack_reserve(const volatile void* pointer) const {
  const std::uintptr_t number = number_of(pointer);
  return number - number_of(arena_.stack()) < Arena::kStackSize - stack_reserve_;
}

std::string HostLocalStore::map() const {
  std::string text = format("local store of %u bytes\n", size());
  text += format("  code      0x%05x %9u bytes (reserve)\n", 0U, code_reserve_);
  text += format("  data      0x%05x %9u bytes\n", code_reserve_, data_bytes_);
  text += format("  heap      0x%05x %9u bytes in use, %u free, largest free piece %u\n", heap_.first(),
                 heap_.in_use(), heap_.free_bytes(), heap_.largest_free());
  text += heap_.describe_blocks();
  text += format("  stack     0x%05x %9u bytes (reserve)\n", stack_begin(), stack_reserve_);
  return text + format("  in use at most %u bytes\n", high_water());
}

}  // namespace spu_emu
