#include "engines/cell/ppu/resident_spes.h"

#include <algorithm>
#include <new>

#include "base/text.h"
#include "cellsweep/engine/timeline.h"
#include "engines/cell/ppu/spe_counts.h"
#include "engines/cell/spu_programs.h"

namespace cellsweep::cell {
namespace {

constexpr std::uint32_t kMostChanges = 1024;
constexpr std::uint32_t kFewestChanges = 16;

/// How long to sleep, in milliseconds, before looking whether an SPE that does not answer has failed.
constexpr int kLookAfter = 20;

/// No SPU can send more events for one order: each of its changed bodies with each body.
std::size_t most_events(std::uint64_t bodies, std::uint32_t changes, unsigned spus) {
  const std::size_t words = (changes + spus - 1) / spus * static_cast<std::size_t>(bodies);
  return (words + kResidentEventChunk - 1) / kResidentEventChunk * kResidentEventChunk;
}

// Nothing but want of memory keeps libspe2 from making one.
void* make_event_handler() {
  void* handler = spe_event_handler_create();
  if (handler == nullptr) throw std::bad_alloc();
  return handler;
}

// Why there is no answer of an SPE whose program has ended.
Status lost_status(unsigned index, Status why) {
  if (!why.ok()) return why;
  return Status::spe_failed(text("SPE ", index, " ended without an answer."), index);
}

}  // namespace

std::uint32_t resident_changes(std::uint64_t bodies) {
  std::uint32_t changes = kFewestChanges;
  while (changes < kMostChanges && changes <= bodies / 2) changes *= 2;
  return changes;
}

Result<std::unique_ptr<ResidentSpes>> ResidentSpes::start(const ResidentSize& wanted,
                                                          std::shared_ptr<Emulation> emulation) {
  auto group = SpeGroup::make(wanted.spus, cell_resident_spu, std::move(emulation));
  if (!group) return group.status();
  std::unique_ptr<ResidentSpes> spes(new ResidentSpes(std::move(*group), wanted));
  if (Status status = spes->listen(); !status.ok()) return status;
  if (Status status = spes->run(); !status.ok()) return status;
  static_cast<void>(spes->take_statistics());
  return spes;
}

ResidentSpes::ResidentSpes(std::unique_ptr<SpeGroup> group, const ResidentSize& wanted)
    : group_(std::move(group)),
      events_(make_event_handler()),
      records_(resident_changes(wanted.bodies)),
      jobs_(size()),
      answers_(size()),
      answered_(size(), false),
      units_(size()) {
  const auto changes = static_cast<std::uint32_t>(records_.size());
  const std::size_t words = most_events(wanted.bodies, changes, size());
  const std::uint32_t room = round_up(static_cast<std::uint32_t>(wanted.bodies), 16);
  if (wanted.poses) poses_.resize(room / kLanes);
  for (auto& axis : intervals_) axis.resize(poses_.size());
  for (unsigned i = 0; i < size(); ++i) {
    const DmaPages& events = buffers_.emplace_back(words * sizeof(std::uint32_t));
    jobs_[i] = {i,
                size(),
                i % kAxes,
                room,
                changes,
                wire_address(records_.data()),
                wire_address(events.get()),
                wire_address(poses_.data()),
                wire_address(intervals_[i % kAxes].data()),
                {}};
  }
}

ResidentSpes::~ResidentSpes() {
  tell_to_end();
  group_->wait();
}

Status ResidentSpes::listen() {
  for (unsigned i = 0; i < size(); ++i) {
    spe_event_unit_t unit{};
    unit.events = SPE_EVENT_OUT_INTR_MBOX;
    unit.spe = group_->context(i);
    if (spe_event_handler_register(events_.get(), &unit) != 0) {
      return Status::spe_failed(text("No event can be had of SPE ", i, "."), i);
    }
  }
  return {};
}

Status ResidentSpes::run() {
  std::vector<void*> jobs;
  for (ResidentJob& job : jobs_) jobs.push_back(&job);
  if (Status status = group_->start(jobs); !status.ok()) return status;
  starts_ += size();
  return wait_for_answers();
}

Status ResidentSpes::obey(ResidentOrder order, std::uint32_t records) {
  if (!failure_.ok()) return failure_;
  if (!group_->is_of_this_process()) {
    return Status::spe_failed(
        "The programs of the SPEs did not come along when fork() made this process; the next update() starts "
        "them anew.");
  }
  unsigned word = resident_word(order, records);
  std::fill(answered_.begin(), answered_.end(), false);
  for (unsigned i = 0; i < size(); ++i) {
    // A mailbox is empty here: its SPU has answered the order before.
    spe_in_mbox_write(group_->context(i), &word, 1, SPE_MBOX_ANY_NONBLOCKING);
    ++mailbox_words_;
  }
  failure_ = wait_for_answers();
  return failure_;
}

Status ResidentSpes::wait_for_answers() {
  const SpeGroup::Aside aside(*group_);
  const TimelineSpan span("wait for mailboxes");
  while (!take_answers()) {
    spe_event_wait(events_.get(), units_.data(), static_cast<int>(units_.size()), kLookAfter);
    for (unsigned i = 0; i < size(); ++i) {
      const bool lost = !answered_[i] && !group_->running(i) &&  //
                        spe_out_intr_mbox_status(group_->context(i)) == 0;
      if (lost) return lost_status(i, stop());
    }
  }
  return {};
}

// True when there is nothing left to wait for.
bool ResidentSpes::take_answers() {
  bool all = true;
  for (unsigned i = 0; i < size(); ++i) {
    if (answered_[i]) continue;
    spe_context_ptr_t context = group_->context(i);
    answered_[i] = spe_out_intr_mbox_status(context) > 0 &&
                   spe_out_intr_mbox_read(context, &answers_[i], 1, SPE_MBOX_ANY_NONBLOCKING) == 1;
    all = all && answered_[i];
  }
  return all;
}

// Returns why an SPE had failed, if one had.
Status ResidentSpes::stop() {
  tell_to_end();
  return group_->join();
}

// An order that was being obeyed is finished first.
void ResidentSpes::tell_to_end() noexcept {
  if (!group_->is_of_this_process()) return;
  unsigned word = resident_word(ResidentOrder::stop, 0);
  for (unsigned i = 0; i < size(); ++i) {
    if (group_->running(i)) spe_in_mbox_write(group_->context(i), &word, 1, SPE_MBOX_ANY_NONBLOCKING);
  }
}

}  // namespace cellsweep::cell
