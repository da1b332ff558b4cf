#include "isa/debug/call_stack.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include "isa/encoding/big_endian.h"
#include "isa/encoding/instruction_word.h"
#include "isa/encoding/opcodes.h"

namespace spu_emu::isa {

namespace {

constexpr std::uint32_t kLinkOffset = 16;
constexpr std::size_t kMostFrames = 1000;

/// Registers and numbers of an instruction.
struct Parts {
  std::string_view name;
  unsigned t;
  unsigned a;
  unsigned b;
  std::int32_t immediate;
};

std::optional<Parts> parts_of(std::uint32_t word, std::uint32_t pc) {
  const int number = find_instruction(word);
  if (number < 0) return std::nullopt;
  const Instruction& instruction = instructions()[static_cast<std::size_t>(number)];
  return Parts{instruction.mnemonic, word & 0x7fU, (word >> 7U) & 0x7fU, (word >> 14U) & 0x7fU,
               immediate_of(instruction, word, pc)};
}

/// What the start of a function has done to stack pointer and link register so far.
class Prologue {
 public:
  void execute(const Parts& parts) {
    if (parts.name == "il" || parts.name == "ila") constants_[parts.t] = parts.immediate;
    if (parts.name == "stqd" && parts.t == 0 && parts.a == 1 && parts.immediate - size_ == kLink)
      saved_ = true;
    if (parts.name == "ai" && parts.t == 1 && parts.a == 1) grow(-parts.immediate);
    if (parts.name == "a" && parts.t == 1 && (parts.a == 1 || parts.b == 1))
      add(parts.a == 1 ? parts.b : parts.a);
    // Behind a return the code goes on as it was before the frame was taken down.
    if (parts.name == "bi" && parts.a == 0) size_ = largest_;
  }

  bool has_frame() const { return size_ > 0; }
  bool has_saved_link() const { return saved_; }

 private:
  static constexpr std::int32_t kLink = kLinkOffset;

  void grow(std::int32_t by) {
    size_ += by;
    largest_ = std::max(largest_, size_);
  }
  void add(unsigned reg) {
    const auto found = constants_.find(reg);
    if (found != constants_.end()) grow(-found->second);
  }

  std::map<unsigned, std::int32_t> constants_;
  std::int32_t size_ = 0;
  std::int32_t largest_ = 0;
  bool saved_ = false;
};

Prologue prologue_up_to(std::uint32_t pc, const std::byte* store, const CodeMap& map) {
  Prologue prologue;
  const ElfSymbol* function = map.symbol_at(pc);
  if (function == nullptr) return prologue;
  for (std::uint32_t at = function->address & kCodeMask; at < pc; at += 4) {
    if (const auto parts = parts_of(fetch(store, at), at)) prologue.execute(*parts);
  }
  return prologue;
}

bool is_stack_address(std::uint32_t sp) {
  return sp != 0 && sp % 16 == 0 && sp <= kLocalStoreSize - 2 * kLinkOffset;
}

std::uint32_t word_at(const std::byte* store, std::uint32_t address) {
  return is_stack_address(address) ? read_word(store + address) : 0;
}

std::uint32_t saved_link(const std::byte* store, std::uint32_t sp) {
  return is_stack_address(sp) ? read_word(store + sp + kLinkOffset) & kCodeMask : 0;
}

Frame innermost(const Machine& machine, const std::byte* store, const CodeMap& map) {
  const Prologue prologue = prologue_up_to(machine.pc(), store, map);
  const std::uint32_t sp = machine.word(1, 0);
  Frame frame{machine.pc(), prologue.has_frame() ? word_at(store, sp) : sp, machine.word(0, 0) & kCodeMask};
  if (prologue.has_saved_link()) frame.return_address = saved_link(store, frame.caller_sp);
  return frame;
}

}  // namespace

std::vector<Frame> call_stack(const Machine& machine, const std::byte* store, const CodeMap& map) {
  std::vector<Frame> frames{innermost(machine, store, map)};
  while (frames.size() < kMostFrames) {
    Frame& inner = frames.back();
    const std::uint32_t caller_sp = inner.caller_sp;
    if (inner.return_address == 0 || !is_stack_address(caller_sp)) {
      inner.return_address = 0;
      break;
    }
    const std::uint32_t next = word_at(store, caller_sp);
    const bool is_last = !is_stack_address(next) || next <= caller_sp;
    frames.push_back({inner.return_address, is_last ? 0 : next, is_last ? 0 : saved_link(store, next)});
    if (is_last) break;
  }
  return frames;
}

}  // namespace spu_emu::isa
