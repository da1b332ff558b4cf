#include "bench/queries/frame_suite.h"

#include <benchmark/benchmark.h>

#include <array>
#include <memory>
#include <string>

#include "base/text.h"
#include "bench/queries/query_check.h"
#include "bench/queries/query_clock.h"
#include "bench/queries/query_peer.h"
#include "bench/timed_row.h"

namespace cellsweep::bench {
namespace {

constexpr std::array<std::size_t, 2> kPercents = {1, 100};
constexpr QuestionKind kKind = QuestionKind::rays;

struct FrameSetting {
  std::string world;
  std::size_t bodies = 0;
  std::size_t percent = 0;
  std::size_t questions = 0;
  std::size_t frames = 0;
};

/// What frames took, in seconds.
struct FrameTimes {
  double move = 0;
  double ask = 0;
  std::size_t frames = 0;

  double sum() const { return move + ask; }
};

/// A world that moves on, and one who follows it.
class MovingStage {
 public:
  MovingStage(const FrameSetting& setting, const QueryPeerInfo& info)
      : setting_(setting), info_(info), world_(setting.world, setting.bodies, 1), peer_(info.make()) {
    questions_ = make_questions(kKind, setting.questions, world_.boxes(), world_.bounds(),
                                find_sizes(world_.boxes(), world_.bounds()), 1);
    peer_->build(world_.boxes());
  }

  /// So many frames, but not for much longer than some seconds.
  FrameTimes run(std::size_t frames) {
    constexpr double kTooLong = 3;
    FrameTimes times;
    for (; times.frames < frames && times.sum() < kTooLong; ++times.frames) {
      const std::span<const BodyId> moved = world_.advance(100 / setting_.percent);
      times.move += seconds_of([&] { peer_->move(moved); });
      times.ask += seconds_of([&] { ask(); });
    }
    return times;
  }

  Answers answers() { return ask_all(*peer_, info_, questions_); }
  std::string fault(const Answers& answers) const {
    constexpr std::size_t kSome = 32;
    return find_fault(answers, answer_by_looking_at_all(questions_, world_.boxes(), kSome), questions_,
                      world_.boxes(), slack_of(world_.bounds()));
  }

 private:
  void ask() {
    if (info_.in_batches) return peer_->answer_batch(questions_);
    for (const Ray& ray : questions_.rays) benchmark::DoNotOptimize(peer_->first_touch(ray));
  }

  const FrameSetting& setting_;
  const QueryPeerInfo& info_;
  QueryWorld world_;
  std::unique_ptr<QueryPeer> peer_;
  Questions questions_;
};

void run_row(benchmark::State& state, const FrameSetting& setting, const QueryPeerInfo& info) {
  MovingStage stage(setting, info);
  stage.run(setting.frames / 3);
  FrameTimes times;
  for (auto _ : state) {
    times = stage.run(setting.frames);
    state.SetIterationTime(times.sum() / static_cast<double>(times.frames));
  }
  const Answers answers = stage.answers();
  const std::string fault = stage.fault(answers);
  if (!fault.empty()) return state.SkipWithError(fault.c_str());
  const auto frames = static_cast<double>(times.frames);
  state.counters["ask"] = 1e9 * times.ask / frames / static_cast<double>(setting.questions);
  state.counters["move"] = 1e3 * times.move / frames;
  state.counters["pairs"] = info.moves_for_pairs ? 1 : 0;
  state.counters["answers"] = static_cast<double>(answers.answers.size());
  state.SetLabel(hash_text(hash_of(answers)));
}

void register_row(const FrameSetting& setting, const QueryPeerInfo& info) {
  const std::string name =
      text("frames/", setting.world, "/", setting.bodies, "/rays/", setting.percent, "/", info.name);
  register_timed_row(name, [=, &info](benchmark::State& state) { run_row(state, setting, info); });
}

void register_cell(const FrameSetting& setting, std::size_t turns) {
  for (std::size_t turn = 0; turn < turns; ++turn) {
    for (const QueryPeerInfo& info : query_peer_table()) {
      if (info.does_answer(kKind) && !info.only_points) register_row(setting, info);
    }
  }
}

}  // namespace

void register_frame_suite(const FrameSuite& suite) {
  for (const std::string_view world : kQueryWorlds) {
    if (has_only_points(world)) continue;
    for (const std::size_t bodies : suite.bodies) {
      for (const std::size_t percent : kPercents)
        register_cell({std::string(world), bodies, percent, suite.questions, suite.frames}, suite.turns);
    }
  }
}

}  // namespace cellsweep::bench
