/// @file
/// Where a debugged program stops: at instructions, at writes to bytes of its local store, at channels.
#ifndef SPU_EMU_ISA_DEBUG_BREAKPOINTS_H
#define SPU_EMU_ISA_DEBUG_BREAKPOINTS_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "isa/debug/instruction_effects.h"

namespace spu_emu::isa {

/// One of the three kinds, by what is set.
struct Breakpoint {
  unsigned number = 0;
  /// As it was asked for, for example "main" or "0x1000, 16 bytes".
  std::string text;
  bool temporary = false;
  std::uint64_t hits = 0;

  /// Instructions.
  std::vector<std::uint32_t> addresses;

  /// Bytes of the local store: a stop before a store changes them, or stores to them at all if `any_store`,
  /// and after a transfer or the host changed them.
  std::uint32_t first = 0;
  std::uint32_t size = 0;
  bool any_store = false;
  std::vector<std::byte> known;

  /// A channel, by its number, from the side of the SPU.
  bool is_channel = false;
  std::uint32_t channel = 0;
  bool on_read = false;
  bool on_write = false;
};

/// For the SPU's own thread.
class Breakpoints {
 public:
  /// `store` are the bytes of the local store.
  explicit Breakpoints(const std::byte* store) : store_(store) {}

  /// Takes it, and gives it the next number.
  const Breakpoint& add(Breakpoint breakpoint);
  /// False when there is none of this number.
  bool remove(unsigned number);
  void remove_all() { all_.clear(); }
  const std::vector<Breakpoint>& all() const { return all_; }

  bool watches_bytes() const;
  /// Whether one of them is to look before this instruction.
  bool wants(std::uint32_t pc, std::uint32_t word) const;
  /// What there is to say of every one that the instruction at `pc` meets, a line each; they count it.
  std::vector<std::string> meet(std::uint32_t pc, std::uint32_t word, const Machine& machine);
  /// The instruction at `pc` will be executed without a meeting: what it stores is no change by somebody
  /// else.
  void expect(std::uint32_t pc, std::uint32_t word, const Machine& machine);
  /// The same for watched bytes that somebody else has changed since the last look; `who` in words.
  std::vector<std::string> changed_by(const char* who);
  /// What watched bytes are now is no change: the debugger itself has made it.
  void accept_changes();

 private:
  bool meets_store(Breakpoint& breakpoint, const StoreEffect& store, std::string& what);

  const std::byte* store_;
  unsigned next_number_ = 1;
  std::vector<Breakpoint> all_;
};

}  // namespace spu_emu::isa

#endif
