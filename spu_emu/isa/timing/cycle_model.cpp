#include "isa/timing/cycle_model.h"

#include <algorithm>

#include "isa/core/state.h"
#include "isa/encoding/instruction_word.h"
#include "spu_emu/channel_numbers.h"

namespace spu_emu::isa {

namespace {

using Kind = TimedInstruction::Kind;

constexpr std::uint32_t kFetchLine = 128;

std::uint32_t preferred(const State& state, std::uint8_t reg) {
  return reg == TimedInstruction::kNone ? 0 : state.registers[reg][0];
}

/// What a channel is written with, or the target of a hint by register.
std::uint32_t value_of(const TimedInstruction& instruction, const State& state) {
  const bool wanted = instruction.kind == Kind::write_channel || instruction.hint_by_register;
  return wanted ? preferred(state, instruction.sources[0]) : 0;
}

bool tells_the_host(const TimedInstruction& instruction) {
  return instruction.kind == Kind::write_channel &&
         (instruction.channel == SPU_WrOutMbox || instruction.channel == SPU_WrOutIntrMbox);
}

}  // namespace

CycleModel::CycleModel(const CycleParameters& parameters, const std::byte* local_store)
    : parameters_(parameters), local_store_(local_store), mfc_(parameters, local_store), decoded_(kWords) {
  set_code({});
}

void CycleModel::set_code(std::vector<CodeRange> code) {
  code_ = std::move(code);
  counts_.assign(code_.size() + 1, {});
  range_of_.assign(kWords, static_cast<std::uint32_t>(code_.size()));
  for (std::size_t i = 0; i < code_.size(); ++i) {
    for (std::uint32_t at = code_[i].first; at < code_[i].end && at < kLocalStoreSize; at += 4) {
      range_of_[at / 4] = static_cast<std::uint32_t>(i);
    }
  }
  publish();
}

void CycleModel::restart() {
  begun_ = nullptr;
  mfc_.restart();
  hint_ = {};
  issue_floor_ = now_;
  ready_.fill(now_);
  after_last_ = kNowhere;
}

void CycleModel::begin(std::uint32_t pc, const State& state) {
  finish_begun(pc, state);
  begun_ = &instruction_at(pc);
  pc_ = pc;
  value_ = value_of(*begun_, state);
  if (tells_the_host(*begun_)) publish();
}

void CycleModel::end(std::uint32_t next_pc, const State& state) {
  finish_begun(next_pc, state);
  publish();
}

void CycleModel::cancel() {
  begun_ = nullptr;
  publish();
}

const TimedInstruction& CycleModel::instruction_at(std::uint32_t pc) {
  const std::uint32_t word = fetch(local_store_, pc);
  TimedInstruction& instruction = decoded_[pc / 4];
  if (instruction.word != word || !instruction.known) instruction = time_instruction(parameters_, word, pc);
  return instruction;
}

void CycleModel::finish_begun(std::uint32_t next_pc, const State& state) {
  if (begun_ == nullptr) return;
  const TimedInstruction& instruction = *begun_;
  current_ = &counts_[range_of_[pc_ / 4]];
  const bool second = last_can_lead_ && pc_ == after_last_ && !instruction.even;
  if (!second) last_issue_ = now_;
  const std::uint64_t at = issue_cycle(instruction, value_, preferred(state, instruction.target));
  count(at, second && at == last_issue_);
  last_issue_ = at;
  last_can_lead_ = instruction.even && pc_ % 8 == 0;
  after_last_ = pc_ + 4;
  note_results(instruction, at);
  if (instruction.kind == Kind::branch) predict(next_pc, at);
  begun_ = nullptr;
}

/// From the earliest cycle that the order of the program allows, through everything that may hold it back.
std::uint64_t CycleModel::issue_cycle(const TimedInstruction& instruction, std::uint32_t value,
                                      std::uint32_t result) {
  std::uint64_t at = last_issue_;
  wait_for_fetch(at);
  delay(at, issue_floor_, floor_cause_);
  wait_for_operands(instruction, at);
  if (instruction.kind == Kind::memory) wait_for_port(at);
  if (instruction.kind == Kind::read_channel) {
    delay(at, mfc_.read(instruction.channel, result, at), Stall::dma_wait);
  }
  if (instruction.kind == Kind::write_channel) {
    delay(at, mfc_.write(instruction.channel, value, at), Stall::dma_queue);
  }
  return at;
}

void CycleModel::count(std::uint64_t at, bool paired) {
  ++instructions_;
  ++current_->instructions;
  if (paired) ++current_->dual_issued;
  current_->cycles += paired ? 0 : at + 1 - now_;
  now_ = at + 1;
}

void CycleModel::note_results(const TimedInstruction& instruction, std::uint64_t at) {
  if (instruction.target != TimedInstruction::kNone) {
    ready_[instruction.target] = at + instruction.latency;
    producer_[instruction.target] = instruction.waiting;
  }
  if (instruction.pauses_issue) {
    issue_floor_ = at + 1 + parameters_.double_block;
    floor_cause_ = Stall::double_block;
  }
  if (instruction.kind == Kind::hint) {
    const std::uint32_t target = instruction.hint_by_register ? value_ : instruction.hinted_target;
    hint_ = {instruction.hinted_branch, target & kCodeMask, at, instructions_};
  }
}

/// What the branch just issued at `at` costs those after it.
void CycleModel::predict(std::uint32_t next_pc, std::uint64_t at) {
  const bool hinted = hint_.branch == pc_ && instructions_ - hint_.number > parameters_.hint_seen;
  const std::uint32_t predicted = hinted ? hint_.target : ((pc_ + 4) & kCodeMask);
  const std::uint64_t after_miss = at + 1 + parameters_.branch_miss;
  const std::uint64_t after_hint = hint_.issued + parameters_.hint_lead + 1;
  if (predicted != next_pc) {
    issue_floor_ = after_miss;
    floor_cause_ = Stall::branch_miss;
  } else if (hinted) {
    issue_floor_ = std::min(after_hint, after_miss);
    floor_cause_ = Stall::late_hint;
  }
}

/// Cycles in which an instruction has issued already are no stalls: the second of a pair may miss them.
void CycleModel::delay(std::uint64_t& at, std::uint64_t until, Stall cause) {
  if (until <= at) return;
  const std::uint64_t from = std::max(at, now_);
  if (until > from) current_->stalls[static_cast<std::size_t>(cause)] += until - from;
  at = until;
}

void CycleModel::wait_for_operands(const TimedInstruction& instruction, std::uint64_t& at) {
  std::uint64_t until = 0;
  Stall cause = Stall::fixed;
  for (const std::uint8_t source : instruction.sources) {
    if (source == TimedInstruction::kNone || ready_[source] <= until) continue;
    until = ready_[source];
    cause = producer_[source];
  }
  delay(at, until, cause);
}

void CycleModel::wait_for_port(std::uint64_t& at) {
  while (mfc_.uses_port(at)) delay(at, at + 1, Stall::port);
  ++port_uses_in_line_;
}

/// Straight code enters a new line: it was fetched if the port had a cycle to spare during the line before.
void CycleModel::wait_for_fetch(std::uint64_t& at) {
  const bool straight = pc_ == after_last_;
  if (pc_ % kFetchLine != 0 && straight) return;
  if (straight && at > line_entered_ && port_uses_in_line_ >= at - line_entered_) {
    delay(at, at + parameters_.fetch_starved, Stall::fetch);
  }
  line_entered_ = at;
  port_uses_in_line_ = 0;
}

void CycleModel::publish() {
  const std::lock_guard lock(published_mutex_);
  published_ = {counts_, mfc_.commands(), mfc_.bytes()};
}

CycleProfile CycleModel::profile() const {
  const std::lock_guard lock(published_mutex_);
  CycleProfile profile;
  profile.dma_commands = published_.dma_commands;
  profile.dma_bytes = published_.dma_bytes;
  for (std::size_t i = 0; i < published_.counts.size(); ++i) {
    const CycleCounts& counts = published_.counts[i];
    if (counts.instructions == 0) continue;
    profile.total += counts;
    profile.functions.push_back({i < code_.size() ? code_[i].name : "(no symbol)", counts});
  }
  return profile;
}

}  // namespace spu_emu::isa
