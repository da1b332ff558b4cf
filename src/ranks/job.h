/// @file
/// The ranks of a job: messages to a few of them at a time, and what all of them must agree on.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/function_ref.h"
#include "cellsweep/status.h"

namespace cellsweep::ranks {

/// To or from one other rank.
struct Message {
  int rank = 0;
  std::vector<std::uint64_t> words{};
  MPI_Request sending = MPI_REQUEST_NULL;
};

/// Numbers of all ranks together.
struct Together {
  std::uint64_t sum = 0;
  std::uint64_t most = 0;
  bool any = false;
};

/// A communicator of its own. All calls are collective. None throws: a rank that had no memory and left would
/// have the others wait for it.
class Job {
 public:
  /// None yet; it becomes one by assignment.
  Job() = default;
  explicit Job(MPI_Comm communicator);
  Job(Job&& other) noexcept;
  Job& operator=(Job&& other) noexcept;
  ~Job();

  MPI_Comm communicator() const { return communicator_; }
  int rank() const { return rank_; }
  int ranks() const { return ranks_; }

  /// What `work` says; std::bad_alloc that leaves it is a status, too. Not collective.
  static Status attempt(FunctionRef<Status()> work) noexcept;

  /// Ok where all ranks are; else what the first rank says that is not, its number in front.
  Status agree(const Status& status) const noexcept;
  /// The same of attempt(work).
  Status agree(FunctionRef<Status()> work) const noexcept { return agree(attempt(work)); }
  /// The same, and numbers and flags of all ranks put together.
  Status agree(const Status& status, std::uint64_t mine, bool flag, Together& together) const noexcept;

  /// What every rank has, in the order of ranks, on rank `root`; nothing on the others. Errors, the same on
  /// all ranks: capacity.
  template <class Row>
  Result<std::vector<Row>> gather(std::span<const Row> mine, int root) const noexcept;

  /// Sends messages to other ranks and gets those that they sent, by rank; nobody knows before from whom.
  /// Each rank has one message for another at most. The cost follows the neighbours, not the ranks. Errors,
  /// which only this rank may have: capacity, where there is no memory for what came; it is lost then.
  Status exchange(std::span<Message> out, std::vector<Message>& in) const noexcept;

 private:
  Status gather_bytes(const void* mine, std::size_t rows, std::size_t row_bytes, int root,
                      FunctionRef<void*(std::size_t)> make_room) const noexcept;
  Status hear(const Status& status, int from) const noexcept;

  MPI_Comm communicator_ = MPI_COMM_NULL;
  int rank_ = 0;
  int ranks_ = 1;
  mutable int round_ = 0;
  MPI_Datatype numbers_ = MPI_DATATYPE_NULL;
  MPI_Op most_and_sum_ = MPI_OP_NULL;
};

/// What a call says that had no memory: in few words where there is none for more.
Status no_memory_status() noexcept;

template <class Row>
Result<std::vector<Row>> Job::gather(std::span<const Row> mine, int root) const noexcept {
  std::vector<Row> all;
  Status status = gather_bytes(mine.data(), mine.size(), sizeof(Row), root, [&](std::size_t rows) {
    all.resize(rows);
    return static_cast<void*>(all.data());
  });
  if (!status.ok()) return status;
  return all;
}

}  // namespace cellsweep::ranks
