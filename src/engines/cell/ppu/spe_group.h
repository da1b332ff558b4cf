/// @file
/// Some SPEs with one program: made together, run together, each on a thread of its own.
#pragma once

#include <libspe2.h>

#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "base/process.h"
#include "base/threads/thread_clock.h"
#include "cellsweep/cell.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/step_cycles.h"

namespace cellsweep::cell {

/// Contexts with a loaded program. Two ways to use it: run() starts all programs and waits for their ends,
/// frame by frame (C1); start() leaves them running, to be talked to by mailbox until join(). One thread uses
/// a group.
class SpeGroup {
 public:
  /// `count` SPEs with `program` in each. Errors: spe_failed, with the reason.
  static Result<std::unique_ptr<SpeGroup>> make(unsigned count, spe_program_handle_t& program,
                                                std::shared_ptr<Emulation> emulation);

  /// Programs that run must have been told to end: this waits for them.
  ~SpeGroup();
  SpeGroup(const SpeGroup&) = delete;
  SpeGroup& operator=(const SpeGroup&) = delete;

  /// While it lives, what the thread computes is no work of the host for take_statistics(). Costs nothing
  /// when that is not counted.
  class Aside {
   public:
    explicit Aside(SpeGroup& group)
        : group_(group), begin_(group.counts_cycles_ ? thread_cpu_milliseconds() : 0) {}
    ~Aside() {
      if (group_.counts_cycles_) group_.aside_milliseconds_ += thread_cpu_milliseconds() - begin_;
    }
    Aside(const Aside&) = delete;
    Aside& operator=(const Aside&) = delete;

   private:
    SpeGroup& group_;
    double begin_;
  };

  unsigned size() const { return static_cast<unsigned>(spes_.size()); }
  spe_context_ptr_t context(unsigned index) const { return spes_[index]->context; }

  /// C1: starts a thread for each SPE that runs its program from the beginning with jobs[i] as its argument,
  /// and waits for all. jobs.size() SPEs run, the first ones. Errors: spe_failed with the rule an SPE broke;
  /// the group is of no more use then.
  Status run(std::span<void* const> jobs);

  /// The first half of run(): returns at once. Where a thread is not to be had, the programs that were
  /// started go on: they must be told to end.
  Status start(std::span<void* const> jobs);

  /// The second half: waits until all programs have ended. Errors as run(); throws what a program's thread
  /// threw, memory that it did not get.
  Status join();

  /// Waits until all programs have ended, well or not.
  void wait() noexcept;

  /// False in a child of fork(), where no program of the group runs and none must be waited for.
  bool is_of_this_process() const { return process_.is_this_process(); }

  /// True from start() until the program ended by itself, by a fault, or by exit. Safe to poll.
  bool running(unsigned index) const { return spes_[index]->running.load(std::memory_order_acquire); }

  /// Whether the thread of a program has ended because it did not get memory: join() would throw. Safe to
  /// poll.
  bool ran_out_of_memory() const;

  /// CPU time of the SPE in the last run, in milliseconds: the program without the start of its thread. 0
  /// when it was not among those that ran, and while it runs.
  double cpu_milliseconds(unsigned index) const { return spes_[index]->cpu_milliseconds.load(); }

  /// The largest of cpu_milliseconds().
  double longest_cpu_milliseconds() const;

  /// The SPEs' statistics; of programs that run, as of about now. On a Cell's clock since take_statistics().
  CellStatistics statistics();

  /// The same; an update ends, or begins, here.
  CellStatistics take_statistics();

 private:
  struct Spe {
    spe_context_ptr_t context = nullptr;
    std::thread thread;
    std::atomic<bool> running = false;
    std::atomic<double> cpu_milliseconds = 0;  // its thread writes it when the program ends, asked or not
    std::string fault{};
    std::exception_ptr error{};  // what its thread threw
    StepCycles now{};            // when statistics() were asked for last
    StepCycles before{};         // and take_statistics()
  };

  /// No thread outlives the call that started it, however that ends: what the programs work on may go then.
  class WaitAtEnd {
   public:
    explicit WaitAtEnd(SpeGroup& group) : group_(group) {}
    ~WaitAtEnd() { group_.wait(); }
    WaitAtEnd(const WaitAtEnd&) = delete;
    WaitAtEnd& operator=(const WaitAtEnd&) = delete;

   private:
    SpeGroup& group_;
  };

  SpeGroup(spe_program_handle_t& program, std::shared_ptr<Emulation> emulation);
  Status add_spe(unsigned of);
  SpeCounts counts() const;
  std::optional<CellTime> cell_time();
  void list_steps(CellTime& time);
  Status load(unsigned index);
  void run_thread(Spe& spe, void* job) const;
  void run_program(Spe& spe, void* job) const;
  void start_thread(Spe& spe, void* job);

  ProcessMark process_;
  spe_program_handle_t& program_;
  std::shared_ptr<Emulation> emulation_;
  std::vector<std::unique_ptr<Spe>> spes_;
  bool counts_cycles_ = false;
  double aside_milliseconds_ = 0;  // since take_statistics()
  bool started_ = false;           // since then, too
};

/// Appends, for people, what the SPEs transferred and filled.
void add_counters(const CellStatistics& statistics, std::vector<Counter>& counters);

}  // namespace cellsweep::cell
