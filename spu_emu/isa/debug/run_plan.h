/// @file
/// How far a debugged program is to run: some instructions, some lines, out of a function, or on.
#ifndef SPU_EMU_ISA_DEBUG_RUN_PLAN_H
#define SPU_EMU_ISA_DEBUG_RUN_PLAN_H

#include <cstdint>
#include <optional>

#include "isa/debug/source_lines.h"

namespace spu_emu::isa {

/// For the SPU's own thread. Whenever `changed` says so, wants() has other answers than before.
class RunPlan {
 public:
  enum class Calls { into, over };

  /// Where a call comes back to: the address, and the stack pointer, which is lower in calls further inside.
  struct Return {
    std::uint32_t address = 0;
    std::uint32_t sp = 0;
  };

  /// To the end, or to whatever else stops it.
  RunPlan() = default;
  static RunPlan instructions(std::uint64_t count, Calls calls);
  /// From a line to the `count`th beginning of another one. Functions without lines are left again.
  static RunPlan statements(std::uint64_t count, const LineRow& from, Calls calls);
  static RunPlan out_to(Return place);

  /// Whether arrive() and leave() have to be called for the instruction at `pc`.
  bool wants(std::uint32_t pc) const;
  /// The program stands before the instruction at `pc`: true if it is to stop there.
  bool arrive(std::uint32_t pc, std::uint32_t sp, const SourceLines& lines);
  /// It is about to execute `word`, the instruction at `pc`.
  void leave(std::uint32_t pc, std::uint32_t word, std::uint32_t sp);
  /// Whether wants() has changed since the last call.
  bool changed();
  bool goes_out() const { return kind_ == Kind::out; }

 private:
  enum class Kind { on, instructions, statements, out };

  bool arrive_at_line(std::uint32_t pc, const SourceLines& lines);
  void run_to(const Return& place);

  Kind kind_ = Kind::on;
  Calls calls_ = Calls::into;
  std::uint64_t count_ = 0;
  LineRow from_;
  std::optional<Return> run_to_;
  std::optional<Return> called_from_;
  bool changed_ = false;
};

}  // namespace spu_emu::isa

#endif
