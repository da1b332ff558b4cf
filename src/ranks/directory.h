/// @file
/// Who owns which body, as far as that is not known: spread over the ranks by the hash of the id.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/status.h"
#include "ranks/held_bodies.h"
#include "ranks/job.h"
#include "ranks/messages.h"
#include "ranks/staged_calls.h"

namespace cellsweep::ranks {

/// It is asked only when somebody inserts a body or names one that another rank owns. What becomes of bodies
/// in between is remembered by those who know it, until then.
class Directory {
 public:
  explicit Directory(const Job& job) : job_(job) {}

  /// Room for so many more tellings.
  void reserve(std::size_t more);
  /// This rank owns the body now, or it is gone.
  void tell(GlobalId id, bool is_gone);

  /// Whether there are calls that the directory has to see.
  static bool is_needed(const HeldBodies& held, const StagedCalls& calls);

  /// Collective. Brings calls for other ranks' bodies to these, into their `calls`, and has new bodies known.
  /// Errors, the same on all ranks, by which nothing changes but that the calls at fault are forgotten:
  /// unknown_body, duplicate_body, bad_input for a body that two ranks named, capacity.
  Status resolve(HeldBodies& held, StagedCalls& calls);

  /// Bodies in the part of this rank.
  std::size_t size() const { return places_.size(); }
  /// Messages of the last resolve(), and bytes in them.
  std::uint64_t messages() const { return messages_; }
  std::uint64_t bytes() const { return bytes_; }
  std::uint64_t rounds() const { return rounds_; }

 private:
  /// What the ranks of a job say about bodies of this part.
  struct Asked {
    std::vector<CallRow> calls;                   // by id
    std::vector<std::vector<FaultRow>> faults;    // for each rank
    std::vector<std::vector<CallRow>> forwarded;  // to each rank
    std::vector<CallRow> inserted;
    bool any_fault = false;
  };

  int part_of(GlobalId id) const {
    return static_cast<int>(mix64(id) % static_cast<std::uint64_t>(job_.ranks()));
  }
  std::uint32_t owner_of(GlobalId id) const;
  void set_owner(GlobalId id, std::uint32_t owner);

  Status ask(const HeldBodies& held, const StagedCalls& calls, Asked& asked);
  void take_news(std::span<const OwnerRow> news);
  void judge(Asked& asked) const;
  void judge_body(std::span<const CallRow> calls, Asked& asked) const;
  Status bring(const HeldBodies& held, const StagedCalls& calls, const Asked& asked,
               std::vector<CallRow>& mine, std::vector<std::vector<FaultRow>>& faults, bool& any_fault);
  Status refuse(HeldBodies& held, StagedCalls& calls, const std::vector<std::vector<FaultRow>>& faults);

  template <class Row>
  Status exchange_rows(const std::vector<std::vector<Row>>& out, std::vector<Row>& in);
  Status exchange(std::vector<Message>& out, std::vector<Message>& in);

  const Job& job_;
  GlobalTable places_;
  std::vector<std::uint32_t> owners_;
  std::vector<Slot> free_;
  std::vector<OwnerRow> news_;
  std::uint64_t messages_ = 0;
  std::uint64_t bytes_ = 0;
  std::uint64_t rounds_ = 0;
};

}  // namespace cellsweep::ranks
