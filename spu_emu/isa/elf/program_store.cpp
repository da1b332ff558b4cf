#include "isa/elf/program_store.h"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "isa/encoding/big_endian.h"
#include "mfc/byte_order.h"
#include "mfc/command.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {
std::uint32_t limit_of(const EmulationSettings& settings) {
  return settings.local_store_limit == 0 ? kHardwareSize
                                         : std::min(settings.local_store_limit, kHardwareSize);
}

/// Has the system take back its pages, which are zeros when they are touched again: of a new local store
/// there are none yet, and to fill it takes a page fault for each. Emulators of user processes may say that
/// they did and do nothing.
void clear(std::byte* local_store) {
  *local_store = std::byte{1};
  const bool said = madvise(local_store, kHardwareSize, MADV_DONTNEED) == 0;
  if (!said || *local_store != std::byte{}) std::memset(local_store, 0, kHardwareSize);
}

/// The word `ila $1,address`, by which start-up code sets its stack pointer; nothing for another one.
std::optional<std::uint32_t> loaded_stack_address(std::uint32_t word) {
  constexpr std::uint32_t kIla = 0x21;
  constexpr std::uint32_t kStackPointer = 1;
  if (word >> 25U != kIla || (word & 0x7fU) != kStackPointer) return std::nullopt;
  return (word >> 7U) & 0x3ffffU;
}

bool is_zero(std::byte byte) {
  return byte == std::byte{0};
}

constexpr std::uint32_t kPage = 4096;

/// From `at` on, the first page that something was written to, or `end`. At every stop the whole store is
/// looked through, of which a program writes a few pages.
std::uint32_t next_written(const std::byte* bytes, std::uint32_t at, std::uint32_t end) {
  static constexpr std::array<std::byte, kPage> kZeros{};
  while (at < end) {
    const std::uint32_t size = std::min(kPage - at % kPage, end - at);
    if (std::memcmp(bytes + at, kZeros.data(), size) != 0) return at;
    at += size;
  }
  return end;
}

bool is_zero_quadword(const std::byte* bytes) {
  std::uint64_t halves[2];
  std::memcpy(halves, bytes, sizeof halves);
  return (halves[0] | halves[1]) == 0;
}
}  // namespace

ProgramStore::ProgramStore(Arena& arena, const EmulationSettings& settings, StoreObserver& observer)
    : arena_(arena),
      limit_(limit_of(settings)),
      stack_reserve_(limit_ == kHardwareSize ? 0 : settings.stack_reserve),
      view_(arena.base(), limit_, kSpuWordOrder, &observer) {
  arena.make_accessible(kHardwareSize);
}

std::string ProgramStore::place(const ElfProgram& program) {
  end_ = program.end;
  name_ = program.name;
  if (std::uint64_t{end_} + stack_reserve_ > limit_) {
    return format("the program's %u bytes and %u of stack do not fit into the local store limit of %u bytes",
                  end_, stack_reserve_, limit_);
  }
  clear(bytes());
  for (const ElfSegment& segment : program.segments) {
    if (!segment.overlay) std::copy(segment.bytes.begin(), segment.bytes.end(), bytes() + segment.ls);
  }
  if (limit_ < kHardwareSize) lower_stack(program.entry);
  return {};
}

/// The linker sets the address from which the stack grows down into the first instructions at the entry.
void ProgramStore::lower_stack(std::uint32_t entry) {
  constexpr std::uint32_t kStartUpBytes = 32 * 4;
  const std::uint32_t last = std::min(entry + kStartUpBytes, limit_ - 4);
  for (std::uint32_t at = entry; at < last; at += 4) {
    const std::uint32_t word = read_word(bytes() + at);
    const auto address = loaded_stack_address(word);
    if (!address || *address < stack_top()) continue;
    write_word(bytes() + at, (word & ~(0x3ffffU << 7U)) | (stack_top() << 7U));
  }
}

std::optional<std::uint32_t> ProgramStore::touched_beyond_limit() const {
  const std::uint32_t page = next_written(bytes(), limit_, kHardwareSize);
  const std::byte* touched = std::find_if_not(bytes() + page, bytes() + kHardwareSize, is_zero);
  if (touched == bytes() + kHardwareSize) return std::nullopt;
  return static_cast<std::uint32_t>(touched - bytes());
}

std::uint32_t ProgramStore::bytes_in_use() const {
  std::uint32_t used = end_;
  std::uint32_t at = (end_ + kQuadword - 1) / kQuadword * kQuadword;
  while ((at = next_written(bytes(), at, limit_)) < limit_) {
    const std::uint32_t end = std::min((at / kPage + 1) * kPage, limit_);
    for (; at < end; at += kQuadword) {
      if (!is_zero_quadword(bytes() + at)) used += kQuadword;
    }
  }
  return used;
}

std::string ProgramStore::map() const {
  std::string text = format("local store of %u bytes\n", limit_);
  text += format("  image     0x%05x %9u bytes of code and data%s%s\n", 0U, end_, name_.empty() ? "" : " of ",
                 name_.c_str());
  text += format("  the rest  0x%05x %9u bytes for heap and stack\n", end_, limit_ - end_);
  return text + format("  in use at the last stop %u bytes\n", bytes_in_use());
}

}  // namespace spu_emu::isa
