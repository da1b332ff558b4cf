#include "app/ranks/rank_measures.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <string_view>

#include "app/ranks/all_ranks.h"
#include "base/text.h"

namespace cellsweep::app {

double RankMeasures::now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

void RankMeasures::add(const DistributedBroadphase& world, double begin, const RankPhase& hand_over,
                       bool counted) {
  if (counted) count(world, hand_over);
  if (!with_timeline_) return;
  add_event(world.rank(), hand_over.name, begin, hand_over.milliseconds);
  double at = begin + hand_over.milliseconds;
  for (const RankPhase& phase : world.statistics().phases) {
    add_event(world.rank(), phase.name, at, phase.milliseconds);
    at += phase.milliseconds;
  }
}

void RankMeasures::count(const DistributedBroadphase& world, const RankPhase& hand_over) {
  const RankStatistics& statistics = world.statistics();
  add_phase(hand_over);
  for (const RankPhase& phase : statistics.phases) add_phase(phase);
  row_.ghosts += static_cast<double>(statistics.ghosts);
  row_.messages += static_cast<double>(statistics.messages);
  row_.bytes += static_cast<double>(statistics.bytes);
  moves_ += static_cast<double>(statistics.moves);
  enters_ += static_cast<double>(statistics.enters);
  leaves_ += static_cast<double>(statistics.leaves);
  adoptions_ += static_cast<double>(statistics.adoptions);
}

void RankMeasures::add_phase(const RankPhase& phase) {
  auto known =
      std::ranges::find_if(phases_, [&](const RankPhaseTimes& times) { return times.name == phase.name; });
  if (known == phases_.end())
    known = phases_.insert(known, RankPhaseTimes{std::string(phase.name), phase.is_wait});
  known->milliseconds += phase.milliseconds;
  known->cpu_milliseconds += phase.cpu_milliseconds;
  if (!phase.is_wait) row_.cpu_milliseconds += phase.cpu_milliseconds;
}

// Microseconds from the start of the run, which all ranks made together.
void RankMeasures::add_event(int rank, std::string_view name, double begin, double milliseconds) {
  timeline_ += text(R"({"name":")", name, R"(","ph":"X","pid":0,"tid":)", rank, R"(,"ts":)",
                    (begin - start_ms_) * 1e3, R"(,"dur":)", milliseconds * 1e3, "},\n");
}

void RankMeasures::add_checkpoint(double milliseconds) {
  ++checkpoints_;
  checkpoint_ms_ += milliseconds;
}

// Every rank has the same phases, for all cut and resolve together; only their order may be another one.
void RankMeasures::sum_up(const DistributedBroadphase& world, double frames, RankReport& report) {
  report.phases = std::move(phases_);
  for (RankPhaseTimes& phase : report.phases) {
    phase.milliseconds = most_of_all(phase.milliseconds) / frames;
    phase.cpu_milliseconds = sum_of_all(phase.cpu_milliseconds) / frames;
  }
  row_.owned = static_cast<double>(world.statistics().owned);
  for (double* value : {&row_.ghosts, &row_.messages, &row_.bytes, &row_.cpu_milliseconds}) *value /= frames;
  report.ranks.resize(static_cast<std::size_t>(world.ranks()));
  MPI_Allgather(&row_, sizeof row_, MPI_BYTE, report.ranks.data(), sizeof row_, MPI_BYTE, MPI_COMM_WORLD);
  report.moves = sum_of_all(moves_) / frames;
  report.enters = sum_of_all(enters_) / frames;
  report.leaves = sum_of_all(leaves_) / frames;
  report.adoptions = sum_of_all(adoptions_) / frames;
  report.checkpoints = checkpoints_;
  if (checkpoints_ > 0) report.checkpoint_ms = checkpoint_ms_ / static_cast<double>(checkpoints_);
  report.timeline = gather_timeline(world.ranks());
}

std::string RankMeasures::gather_timeline(int ranks) const {
  const int mine = static_cast<int>(timeline_.size());
  std::vector<int> sizes(static_cast<std::size_t>(ranks));
  std::vector<int> places(sizes.size());
  MPI_Gather(&mine, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::string all;
  for (std::size_t rank = 0; rank < sizes.size(); ++rank) {
    places[rank] = static_cast<int>(all.size());
    all.resize(all.size() + static_cast<std::size_t>(sizes[rank]));
  }
  MPI_Gatherv(timeline_.data(), mine, MPI_CHAR, all.data(), sizes.data(), places.data(), MPI_CHAR, 0,
              MPI_COMM_WORLD);
  return all;
}

}  // namespace cellsweep::app
