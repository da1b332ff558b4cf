/// @file
/// The SPEs of cell-resident: started once, told by mailbox, ended when this object goes.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/status.h"
#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/ppu/spe_group.h"
#include "engines/cell/resident_wire.h"

namespace cellsweep::cell {

/// How many records an order may have on SPUs with room for so many bodies: a power of two.
std::uint32_t resident_changes(std::uint64_t bodies);

/// What ResidentSpes::start() is asked for.
struct ResidentSize {
  unsigned spus = 0;
  std::uint64_t bodies = 0;
  bool poses = false;  ///< the programs make boxes, too
};

/// Programs that run from construction to destruction. One thread.
class ResidentSpes {
 public:
  /// Starts the programs and waits until they are ready. Errors: spe_failed.
  static Result<std::unique_ptr<ResidentSpes>> start(const ResidentSize& wanted,
                                                     std::shared_ptr<Emulation> emulation);
  ~ResidentSpes();
  ResidentSpes(const ResidentSpes&) = delete;
  ResidentSpes& operator=(const ResidentSpes&) = delete;

  unsigned size() const { return group_->size(); }

  /// The records of the next order; as many as one may have.
  std::span<ResidentRecord> records() { return records_; }

  /// The poses of the next order to make boxes, and for each axis what the last one made of them; empty
  /// without poses.
  std::span<PoseBlock> poses() { return poses_; }
  std::span<const IntervalBlock> intervals(unsigned axis) const { return intervals_[axis]; }

  /// Has all SPUs obey and waits for their answers. Errors: spe_failed; the programs have ended then, and
  /// every later order fails the same way.
  Status obey(ResidentOrder order, std::uint32_t records);

  /// SpeGroup::ran_out_of_memory(): perhaps after the last answer, where no order waits for it.
  bool ran_out_of_memory() const { return group_->ran_out_of_memory(); }

  /// Why the programs have ended; an ok status while they run.
  const Status& failure() const { return failure_; }

  /// What SPU `index` answered to the last order. Valid until the next one.
  std::span<const std::uint32_t> events(unsigned index) const {
    return std::span(static_cast<const std::uint32_t*>(buffers_[index].get()), answers_[index]);
  }

  /// Mailbox words written to SPUs so far.
  std::uint64_t mailbox_words() const { return mailbox_words_; }
  std::uint64_t starts() const { return starts_; }

  /// SpeGroup::take_statistics(); the time before the first order is not in it.
  CellStatistics take_statistics() { return group_->take_statistics(); }

 private:
  struct ReleaseHandler {
    void operator()(void* handler) const { spe_event_handler_destroy(handler); }
  };

  ResidentSpes(std::unique_ptr<SpeGroup> group, const ResidentSize& wanted);
  Status listen();
  Status run();
  bool take_answers();
  Status wait_for_answers();
  Status stop();
  void tell_to_end() noexcept;

  std::unique_ptr<SpeGroup> group_;
  std::unique_ptr<void, ReleaseHandler> events_;  // tells when an answer has come
  DmaVector<ResidentRecord> records_;
  DmaVector<PoseBlock> poses_;
  std::array<DmaVector<IntervalBlock>, 3> intervals_;
  std::vector<DmaPages> buffers_;  // by SPU: events
  DmaVector<ResidentJob> jobs_;
  std::vector<std::uint32_t> answers_;
  std::vector<bool> answered_;
  std::vector<spe_event_unit_t> units_;  // for waiting
  Status failure_;
  std::uint64_t mailbox_words_ = 0;
  std::uint64_t starts_ = 0;
};

}  // namespace cellsweep::cell
