#include "isa/debug/run_plan.h"

#include <utility>

#include "isa/debug/instruction_effects.h"

namespace spu_emu::isa {

RunPlan RunPlan::instructions(std::uint64_t count, Calls calls) {
  RunPlan plan;
  plan.kind_ = Kind::instructions;
  plan.count_ = count;
  plan.calls_ = calls;
  return plan;
}

RunPlan RunPlan::statements(std::uint64_t count, const LineRow& from, Calls calls) {
  RunPlan plan = instructions(count, calls);
  plan.kind_ = Kind::statements;
  plan.from_ = from;
  return plan;
}

RunPlan RunPlan::out_to(Return place) {
  RunPlan plan;
  plan.kind_ = Kind::out;
  plan.run_to_ = place;
  return plan;
}

bool RunPlan::wants(std::uint32_t pc) const {
  if (kind_ == Kind::on) return false;
  return !run_to_ || run_to_->address == pc;
}

bool RunPlan::changed() {
  return std::exchange(changed_, false);
}

void RunPlan::run_to(const Return& place) {
  run_to_ = place;
  changed_ = true;
}

bool RunPlan::arrive(std::uint32_t pc, std::uint32_t sp, const SourceLines& lines) {
  if (kind_ == Kind::on) return false;
  if (run_to_) {
    if (pc != run_to_->address || sp < run_to_->sp) return false;
    run_to_.reset();
    changed_ = true;
  }
  if (kind_ == Kind::instructions) return count_ == 0;
  return kind_ == Kind::out || arrive_at_line(pc, lines);
}

bool RunPlan::arrive_at_line(std::uint32_t pc, const SourceLines& lines) {
  const auto call = std::exchange(called_from_, std::nullopt);
  const auto row = lines.at(pc);
  if (call && !row) run_to(*call);
  if (!row || !lines.begins_statement(pc)) return false;
  if (row->file == from_.file && row->line == from_.line) return false;
  from_ = *row;
  return --count_ == 0;
}

void RunPlan::leave(std::uint32_t pc, std::uint32_t word, std::uint32_t sp) {
  if (kind_ == Kind::on || run_to_) return;
  if (kind_ == Kind::instructions) --count_;
  if (!is_call_instruction(word)) return;
  const Return place{pc + 4, sp};
  if (calls_ == Calls::over) {
    run_to(place);
  } else {
    called_from_ = place;
  }
}

}  // namespace spu_emu::isa
