#include "app/ranks/rank_run.h"

#include <mpi.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "app/ranks/all_ranks.h"
#include "app/ranks/one_engine.h"
#include "app/ranks/own_bodies.h"
#include "app/ranks/rank_measures.h"
#include "base/text.h"
#include "base/threads/thread_clock.h"
#include "cellsweep/checkpoint.h"
#include "geometry/canonical.h"
#include "report/progress.h"

namespace cellsweep::app {
namespace {

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
        truth_(settings.verify && world_.rank() == 0),
        wanted_(settings.report_frames.begin(), settings.report_frames.end()) {}

  Result<RankReport> run() {
    if (Status status = source_.status(); !status.ok()) return status;
    MPI_Barrier(MPI_COMM_WORLD);
    measures_.emplace(settings_.timeline);
    if (Status status = settings_.restart.empty() ? frame(source_.bodies()) : go_on(); !status.ok())
      return status;
    if (Status status = frames(); !status.ok()) return status;
    if (saved_ != frame_ || measures_->checkpoints() == 0) {
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
    auto others = bodies_that_differ(owned);
    if (!others) return others.status();
    if (sum_of_all(*others) > 0) {
      return Status::bad_input(text(settings_.restart, " is of another world than frame ", first_, " of ",
                                    source_.name(),
                                    ": the flags that make the scene, or the recording, are "
                                    "not those that it was written with."));
    }
    own_.adopt(owned);
    if (settings_.verify) note_difference(truth_.compare_restored(source_, world_));
    if (wanted_.empty() || wanted_.contains(frame_)) report_pairs();
    return {};
  }

  // Of this rank's bodies, those that the source has elsewhere or not at all; one more where it has others.
  Result<std::uint64_t> bodies_that_differ(std::span<const GlobalId> owned) const {
    std::vector<Aabb> boxes(owned.size());
    if (Status status = world_.boxes(owned, boxes); !status.ok()) return status;
    std::uint64_t others = world_.size() == source_.bodies().size() ? 0 : 1;
    for (std::size_t i = 0; i < owned.size(); ++i) {
      const bool same = std::ranges::binary_search(source_.bodies(), owned[i]) &&
                        boxes[i] == canonical(source_.boxes()[owned[i]]);
      others += same ? 0U : 1U;
    }
    return others;
  }

  Status frames() {
    const bool is_first_rank = world_.rank() == 0;
    report::Progress progress(is_first_rank ? "ranks" : "", is_first_rank ? settings_.updates : 0);
    while (frame_ < settings_.updates && source_.advance()) {
      ++frame_;
      if (Status status = frame(source_.inserted()); !status.ok()) return status;
      if (settings_.checkpoint_every > 0 && frame_ % settings_.checkpoint_every == 0) {
        if (Status status = save(); !status.ok()) return status;
      }
      if (is_first_rank) progress.show(frame_);
    }
    return source_.status();
  }

  Status frame(std::span<const BodyId> inserted) {
    const double begin = RankMeasures::now_ms();
    const double cpu_before = thread_cpu_milliseconds();
    // What is refused here is refused by the update, to all.
    static_cast<void>(own_.hand_over(source_, inserted, world_));
    const RankPhase hand_over{"hand over", RankMeasures::now_ms() - begin,
                              thread_cpu_milliseconds() - cpu_before, false};
    const auto changes = world_.update();
    if (!changes) return changes.status();
    own_.take_over(*changes);
    measures_->add(world_, begin, hand_over, frame_ > first_);
    if (settings_.verify) note_difference(truth_.compare(source_, frame_ == 0, world_, *changes));
    if (wanted_.empty() ? frame_ == first_ : wanted_.contains(frame_)) report_pairs();
    return {};
  }

  Status save() {
    if (settings_.checkpoint.empty()) return {};
    const double before = RankMeasures::now_ms();
    Status status = save_checkpoint(world_, settings_.checkpoint, nlohmann::json{{"frame", frame_}}.dump());
    measures_->add_checkpoint(RankMeasures::now_ms() - before);
    saved_ = frame_;
    return status;
  }

  void note_difference(const std::string& words) {
    if (words.empty()) return;
    ++report_.differing_frames;
    if (report_.first_difference.empty()) report_.first_difference = text("Frame ", frame_, ": ", words);
  }

  void report_pairs() {
    const PairSum pairs = sum_of(world_.pairs());
    report_.frames.push_back({frame_, pairs.count, pairs.hash});
  }

  void sum_up() {
    report_.first_frame = first_;
    report_.updates = frame_ - first_;
    for (int rank = 0; rank < world_.ranks(); ++rank) report_.regions.push_back(world_.region(rank));
    report_.bodies = world_.size();
    report_.imbalance = world_.statistics().imbalance;
    report_.cuts = world_.statistics().cuts;
    measures_->sum_up(world_, std::max<double>(1, static_cast<double>(frame_ - first_)), report_);
    std::uint64_t differing = report_.differing_frames;
    MPI_Bcast(&differing, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    report_.differing_frames = differing;
  }

  const std::size_t first_;
  FrameSource& source_;
  const RankRunSettings& settings_;
  DistributedBroadphase world_;
  OwnBodies own_;
  OneEngine truth_;
  std::set<std::size_t> wanted_;
  std::optional<RankMeasures> measures_;  // from the start that all ranks make together
  std::size_t frame_ = 0;
  std::size_t saved_ = 0;  // the frame of the last checkpoint
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
