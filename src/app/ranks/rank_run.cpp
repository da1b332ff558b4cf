#include "app/ranks/rank_run.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "base/text.h"
#include "base/thread_clock.h"
#include "cellsweep/checkpoint.h"
#include "geometry/canonical.h"
#include "report/hand_over.h"
#include "report/progress.h"

namespace cellsweep::app {
namespace {

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

std::uint64_t sum_of_all(std::uint64_t mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  return mine;
}

std::uint64_t xor_of_all(std::uint64_t mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_UINT64_T, MPI_BXOR, MPI_COMM_WORLD);
  return mine;
}

double sum_of_all(double mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return mine;
}

double most_of_all(double mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return mine;
}

/// Pairs of all ranks: how many, and their hash.
struct Sum {
  std::uint64_t count = 0;
  std::uint64_t hash = 0;

  friend bool operator==(const Sum&, const Sum&) = default;
};

Sum sum_of(std::span<const GlobalPair> mine) {
  return {sum_of_all(std::uint64_t{mine.size()}), xor_of_all(global_pair_set_hash(mine))};
}

Sum sum_of(std::span<const Pair> whole) {
  return {whole.size(), pair_set_hash(whole)};
}

/// The bodies that this rank hands over: new ones in turn, others where they are owned.
class OwnBodies {
 public:
  OwnBodies(int rank, int ranks) : rank_(rank), ranks_(ranks) {}

  Status hand_over(const FrameSource& source, std::span<const BodyId> inserted,
                   DistributedBroadphase& world) {
    if (Status status = remove(source, world); !status.ok()) return status;
    if (Status status = move(source, world); !status.ok()) return status;
    choose(source, inserted,
           [&](BodyId id) { return static_cast<int>(id % static_cast<BodyId>(ranks_)) == rank_; });
    if (filters_.empty()) return world.insert(ids_, boxes_);
    return world.insert(ids_, boxes_, filters_);
  }

  /// The bodies of a world that goes on.
  void adopt(std::span<const GlobalId> owned) {
    for (const GlobalId id : owned) set(id, true);
  }

  void take_over(const RankChanges& changes) {
    for (const GlobalId id : ids_) set(id, true);  // the inserted, before some of them depart
    for (const Handover& departed : changes.departed) set(departed.id, false);
    for (const Handover& arrived : changes.arrived) set(arrived.id, true);
  }

 private:
  bool is_mine(BodyId id) const { return id < mine_.size() && mine_[id]; }
  void set(GlobalId id, bool mine) {
    if (id >= mine_.size()) mine_.resize(id + 1 + mine_.size() / 2);
    mine_[id] = mine;
  }

  template <class IsChosen>
  void choose(const FrameSource& source, std::span<const BodyId> from, const IsChosen& is_chosen) {
    ids_.clear();
    boxes_.clear();
    filters_.clear();
    for (const BodyId id : from) {
      if (!is_chosen(id)) continue;
      ids_.push_back(id);
      boxes_.push_back(source.boxes()[id]);
      if (!source.filters().empty()) filters_.push_back(source.filters()[id]);
    }
  }

  Status move(const FrameSource& source, DistributedBroadphase& world) {
    choose(source, source.moved(), [&](BodyId id) { return is_mine(id); });
    return world.move(ids_, boxes_);
  }

  Status remove(const FrameSource& source, DistributedBroadphase& world) {
    ids_.clear();
    for (const BodyId id : source.removed()) {
      if (!is_mine(id)) continue;
      ids_.push_back(id);
      set(id, false);
    }
    return world.remove(ids_);
  }

  int rank_;
  int ranks_;
  std::vector<bool> mine_;
  std::vector<GlobalId> ids_;
  std::vector<Aabb> boxes_;
  std::vector<BodyFilter> filters_;
};

/// A run from its first frame to its last.
class RankRun {
 public:
  /// The world is empty, or that of the frame `first`, as a checkpoint had it.
  RankRun(FrameSource& source, const RankRunSettings& settings, DistributedBroadphase world,
          std::size_t first)
      : first_(first),
        source_(source),
        settings_(settings),
        world_(std::move(world)),
        own_(world_.rank(), world_.ranks()),
        wanted_(settings.report_frames.begin(), settings.report_frames.end()) {
    if (settings.verify && world_.rank() == 0) whole_.emplace();
  }

  Result<RankReport> run() {
    if (Status status = source_.status(); !status.ok()) return status;
    MPI_Barrier(MPI_COMM_WORLD);
    start_ms_ = now_ms();
    if (Status status = settings_.restart.empty() ? frame(source_.bodies()) : go_on(); !status.ok())
      return status;
    report::Progress progress(world_.rank() == 0 ? "ranks" : "", world_.rank() == 0 ? settings_.updates : 0);
    while (frame_ < settings_.updates && source_.advance()) {
      ++frame_;
      if (Status status = frame(source_.inserted()); !status.ok()) return status;
      if (settings_.checkpoint_every > 0 && frame_ % settings_.checkpoint_every == 0) {
        if (Status status = save(); !status.ok()) return status;
      }
      if (world_.rank() == 0) progress.show(frame_);
    }
    if (Status status = source_.status(); !status.ok()) return status;
    if (saved_ != frame_ || report_.checkpoints == 0) {
      if (Status status = save(); !status.ok()) return status;
    }
    if (wanted_.empty() && frame_ > first_) report_pairs();
    if (!wanted_.empty() && *wanted_.rbegin() > frame_) {
      return Status::bad_input(
          text("Frame ", *wanted_.rbegin(), " was to be reported, but the last frame is ", frame_, "."),
          "report_frames", *wanted_.rbegin(), frame_);
    }
    sum_up();
    return std::move(report_);
  }

 private:
  // From a checkpoint: the source goes to its frame, which must be what was written.
  Status go_on() {
    for (; frame_ < first_ && source_.advance(); ++frame_) {
    }
    if (Status status = source_.status(); !status.ok()) return status;
    if (frame_ < first_) {
      return Status::bad_input(text(settings_.restart, " is of frame ", first_, ", but the last frame of ",
                                    source_.name(), " is ", frame_, "."));
    }
    const std::vector<GlobalId> owned = world_.owned();
    std::vector<Aabb> boxes(owned.size());
    if (Status status = world_.boxes(owned, boxes); !status.ok()) return status;
    std::uint64_t others = world_.size() == source_.bodies().size() ? 0 : 1;
    for (std::size_t i = 0; i < owned.size(); ++i) {
      const bool same = std::ranges::binary_search(source_.bodies(), owned[i]) &&
                        boxes[i] == canonical(source_.boxes()[owned[i]]);
      others += same ? 0U : 1U;
    }
    if (sum_of_all(others) > 0) {
      return Status::bad_input(text(settings_.restart, " is of another world than frame ", first_, " of ",
                                    source_.name(),
                                    ": the flags that make the scene, or the recording, are "
                                    "not those that it was written with."));
    }
    own_.adopt(owned);
    if (settings_.verify) compare_with_frame();
    if (wanted_.empty() || wanted_.contains(frame_)) report_pairs();
    return {};
  }

  Status save() {
    if (settings_.checkpoint.empty()) return {};
    const double before = now_ms();
    Status status = save_checkpoint(world_, settings_.checkpoint, nlohmann::json{{"frame", frame_}}.dump());
    report_.checkpoint_ms += now_ms() - before;
    ++report_.checkpoints;
    saved_ = frame_;
    return status;
  }

  Status frame(std::span<const BodyId> inserted) {
    const double before = now_ms();
    const double cpu_before = thread_cpu_milliseconds();
    // What is refused here is refused by the update, to all.
    static_cast<void>(own_.hand_over(source_, inserted, world_));
    const double handed_over = now_ms();
    const double cpu = thread_cpu_milliseconds() - cpu_before;
    const auto changes = world_.update();
    if (!changes) return changes.status();
    own_.take_over(*changes);
    if (frame_ > first_) add_phases({"hand over", handed_over - before, cpu, false});
    if (settings_.timeline) add_to_timeline(before, handed_over);
    if (settings_.verify) compare(*changes);
    if (wanted_.empty() ? frame_ == first_ : wanted_.contains(frame_)) report_pairs();
    return {};
  }

  void add_phases(const RankPhase& hand_over) {
    const RankStatistics& statistics = world_.statistics();
    add_phase(hand_over);
    for (const RankPhase& phase : statistics.phases) add_phase(phase);
    row_.ghosts += static_cast<double>(statistics.ghosts);
    row_.messages += static_cast<double>(statistics.messages);
    row_.bytes += static_cast<double>(statistics.bytes);
    report_.moves += static_cast<double>(statistics.moves);
    report_.enters += static_cast<double>(statistics.enters);
    report_.leaves += static_cast<double>(statistics.leaves);
    report_.adoptions += static_cast<double>(statistics.adoptions);
  }

  void add_phase(const RankPhase& phase) {
    const auto known = std::ranges::find_if(
        report_.phases, [&](const RankPhaseTimes& times) { return times.name == phase.name; });
    const auto place = static_cast<std::size_t>(known - report_.phases.begin());
    if (place == report_.phases.size()) report_.phases.push_back({std::string(phase.name), phase.is_wait});
    RankPhaseTimes& times = report_.phases[place];
    times.milliseconds += phase.milliseconds;
    times.cpu_milliseconds += phase.cpu_milliseconds;
    if (!phase.is_wait) row_.cpu_milliseconds += phase.cpu_milliseconds;
  }

  // Microseconds from the start of the run, which all ranks made together.
  void add_to_timeline(double begin, double handed_over) {
    add_event("hand over", begin, handed_over - begin);
    double at = handed_over;
    for (const RankPhase& phase : world_.statistics().phases) {
      add_event(phase.name, at, phase.milliseconds);
      at += phase.milliseconds;
    }
  }
  void add_event(std::string_view name, double begin, double milliseconds) {
    report_.timeline += text(R"({"name":")", name, R"(","ph":"X","pid":0,"tid":)", world_.rank(), R"(,"ts":)",
                             (begin - start_ms_) * 1e3, R"(,"dur":)", milliseconds * 1e3, "},\n");
  }

  void compare(const RankChanges& said) {
    const Sum pairs = sum_of(world_.pairs());
    const Sum began = sum_of(said.began);
    const Sum ended = sum_of(said.ended);
    if (!whole_) return;
    const Status status = frame_ == 0 ? report::insert_all(*whole_, source_, report::Shape::boxes)
                                      : report::hand_over_changes(*whole_, source_, report::Shape::boxes);
    const auto truth = whole_->update();
    const bool same = status.ok() && truth && pairs == sum_of(whole_->pairs()) &&
                      began == sum_of(truth->began) && ended == sum_of(truth->ended);
    if (same) return;
    note_difference(text("the ranks have ", pairs.count, " pairs, ", began.count, " began and ", ended.count,
                         " ended; one engine says ", whole_->pairs().size(), ", ",
                         truth ? truth->began.size() : 0, " and ", truth ? truth->ended.size() : 0, "."));
  }

  // What a checkpoint had, with the one engine's first update.
  void compare_with_frame() {
    const Sum pairs = sum_of(world_.pairs());
    if (!whole_) return;
    const Status status = report::insert_all(*whole_, source_, report::Shape::boxes);
    if (status.ok() && whole_->update() && pairs == sum_of(whole_->pairs())) return;
    note_difference(
        text("the ranks have ", pairs.count, " pairs; one engine says ", whole_->pairs().size(), "."));
  }

  void note_difference(const std::string& words) {
    ++report_.differing_frames;
    if (report_.first_difference.empty()) report_.first_difference = text("Frame ", frame_, ": ", words);
  }

  void report_pairs() {
    const Sum pairs = sum_of(world_.pairs());
    report_.frames.push_back({frame_, pairs.count, pairs.hash});
  }

  void sum_up() {
    const double frames = std::max<double>(1, static_cast<double>(frame_ - first_));
    report_.first_frame = first_;
    report_.updates = frame_ - first_;
    for (int rank = 0; rank < world_.ranks(); ++rank) report_.regions.push_back(world_.region(rank));
    if (report_.checkpoints > 0) report_.checkpoint_ms /= static_cast<double>(report_.checkpoints);
    report_.bodies = world_.size();
    report_.imbalance = world_.statistics().imbalance;
    report_.cuts = world_.statistics().cuts;
    gather_phases(frames);
    row_.owned = static_cast<double>(world_.statistics().owned);
    for (double* value : {&row_.ghosts, &row_.messages, &row_.bytes, &row_.cpu_milliseconds})
      *value /= frames;
    report_.ranks.resize(static_cast<std::size_t>(world_.ranks()));
    MPI_Allgather(&row_, sizeof row_, MPI_BYTE, report_.ranks.data(), sizeof row_, MPI_BYTE, MPI_COMM_WORLD);
    for (double* value : {&report_.moves, &report_.enters, &report_.leaves, &report_.adoptions})
      *value = sum_of_all(*value) / frames;
    std::uint64_t differing = report_.differing_frames;
    MPI_Bcast(&differing, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    report_.differing_frames = differing;
    gather_timeline();
  }

  // Every rank has the same phases, for all cut and resolve together; only their order may be another one.
  void gather_phases(double frames) {
    for (RankPhaseTimes& phase : report_.phases) {
      phase.milliseconds = most_of_all(phase.milliseconds) / frames;
      phase.cpu_milliseconds = sum_of_all(phase.cpu_milliseconds) / frames;
    }
  }

  void gather_timeline() {
    const int mine = static_cast<int>(report_.timeline.size());
    std::vector<int> sizes(static_cast<std::size_t>(world_.ranks()));
    std::vector<int> places(sizes.size());
    MPI_Gather(&mine, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
    std::string all;
    for (std::size_t rank = 0; rank < sizes.size(); ++rank) {
      places[rank] = static_cast<int>(all.size());
      all.resize(all.size() + static_cast<std::size_t>(sizes[rank]));
    }
    MPI_Gatherv(report_.timeline.data(), mine, MPI_CHAR, all.data(), sizes.data(), places.data(), MPI_CHAR, 0,
                MPI_COMM_WORLD);
    report_.timeline = std::move(all);
  }

  const std::size_t first_;
  FrameSource& source_;
  const RankRunSettings& settings_;
  DistributedBroadphase world_;
  std::optional<Broadphase> whole_;
  OwnBodies own_;
  std::set<std::size_t> wanted_;
  std::size_t frame_ = 0;
  std::size_t saved_ = 0;  // the frame of the last checkpoint
  double start_ms_ = 0;
  RankRow row_;
  RankReport report_;
};

// The number of the frame that a checkpoint was written in.
Result<std::size_t> frame_of(const std::string& path, const std::string& note) {
  const auto json = nlohmann::json::parse(note, nullptr, false);
  if (json.is_object() && json.contains("frame") && json["frame"].is_number_unsigned())
    return json["frame"].get<std::size_t>();
  return Status::bad_input(
      text(path, " was not written by cellsweep-ranks: it does not say of which frame it is."));
}

}  // namespace

Result<RankReport> run_on_ranks(FrameSource& source, const RankRunSettings& settings) {
  if (settings.restart.empty()) {
    auto world = make_distributed_broadphase(MPI_COMM_WORLD, settings.ranks);
    if (!world) return world.status();
    return RankRun(source, settings, std::move(*world), 0).run();
  }
  auto restored = load_checkpoint(MPI_COMM_WORLD, settings.restart, settings.ranks);
  if (!restored) return restored.status();
  const auto first = frame_of(settings.restart, restored->note);
  if (!first) return first.status();
  return RankRun(source, settings, std::move(restored->world), *first).run();
}

}  // namespace cellsweep::app
