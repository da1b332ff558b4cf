#include "bench/queries/query_suite.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "base/text.h"
#include "bench/queries/query_clock.h"
#include "bench/queries/query_stage.h"
#include "bench/timed_row.h"

namespace cellsweep::bench {
namespace {

constexpr std::size_t kTimesMoved = 4;
constexpr std::array kKindsAskedWhenMoved = {QuestionKind::boxes, QuestionKind::rays, QuestionKind::nearest8};

void show_times(benchmark::State& state, std::span<const Asking> askings, const QueryPeerInfo& info) {
  for (auto _ : state) state.SetIterationTime(mean_seconds(askings, info));
  if (!info.in_batches) state.counters["p99"] = 1e9 * p99_seconds(askings);
}

void run_row(benchmark::State& state, const StageSetting& setting, const QueryPeerInfo& info,
             QuestionKind kind) {
  QueryStage& stage = stage_of(setting);
  const std::string& fault = stage.fault(info, kind);
  if (!fault.empty()) return state.SkipWithError(fault.c_str());
  std::vector<Asking> askings;
  for (std::size_t i = 0; i < stage.worlds(); ++i)
    askings.push_back({&stage.peer(i, info), &stage.questions(i, kind)});
  show_times(state, askings, info);
  state.counters["answers"] = static_cast<double>(stage.answers(info, kind));
  state.SetLabel(hash_text(stage.hash(info, kind)));
}

/// A world whose bodies have moved, and one who knows that. One at a time: the next one's takes its place.
class MovedStage {
 public:
  MovedStage(const StageSetting& setting, const QueryPeerInfo& info)
      : setting_(setting), name_(info.name), world_(setting.world, setting.bodies, 1), peer_(info.make()) {
    sizes_ = find_sizes(world_.boxes(), world_.bounds());
    peer_->build(world_.boxes());
    for (std::size_t i = 0; i < kTimesMoved; ++i) {
      const std::span<const BodyId> moved = world_.advance();
      seconds_ = std::min(seconds_, seconds_of([&] { peer_->move(moved); }));
    }
  }

  bool is_of(const StageSetting& setting, const QueryPeerInfo& info) const {
    return setting_ == setting && name_ == info.name;
  }
  QueryPeer& peer() { return *peer_; }
  double move_seconds() const { return seconds_; }

  Questions questions(QuestionKind kind) const {
    return make_questions(kind, setting_.questions, world_.boxes(), world_.bounds(), sizes_, 1);
  }

  std::string fault(const Answers& answers, const Questions& questions) const {
    constexpr std::size_t kSome = 32;
    return find_fault(answers, answer_by_looking_at_all(questions, world_.boxes(), kSome), questions,
                      world_.boxes(), slack_of(world_.bounds()));
  }

 private:
  StageSetting setting_;
  std::string_view name_;
  QueryWorld world_;
  QuestionSizes sizes_;
  std::unique_ptr<QueryPeer> peer_;
  double seconds_ = std::numeric_limits<double>::infinity();
};

MovedStage& moved_stage_of(const StageSetting& setting, const QueryPeerInfo& info) {
  static std::unique_ptr<MovedStage> stage;
  if (stage && stage->is_of(setting, info)) return *stage;
  stage.reset();
  stage = std::make_unique<MovedStage>(setting, info);
  return *stage;
}

void run_moved_row(benchmark::State& state, const StageSetting& setting, const QueryPeerInfo& info,
                   QuestionKind kind) {
  MovedStage& stage = moved_stage_of(setting, info);
  const Questions questions = stage.questions(kind);
  const Answers answers = ask_all(stage.peer(), info, questions);
  const std::string fault = stage.fault(answers, questions);
  if (!fault.empty()) return state.SkipWithError(fault.c_str());
  const Asking asking{&stage.peer(), &questions};
  show_times(state, {&asking, 1}, info);
  state.counters["answers"] = static_cast<double>(answers.answers.size());
  state.counters["move"] = 1e3 * stage.move_seconds();
  state.counters["pairs"] = info.moves_for_pairs ? 1 : 0;
  state.SetLabel(hash_text(hash_of(answers)));
}

bool is_asked(const QueryPeerInfo& info, std::string_view world, QuestionKind kind) {
  const bool are_points = has_only_points(world);
  return info.does_answer(kind) && !(are_points && (is_ray(kind) || kind == QuestionKind::points)) &&
         !(info.only_points && !are_points);
}

// Those that are compared are timed within seconds: a machine that others share takes half as long again for
// minutes at a time.
void register_cell(const StageSetting& setting, const QuestionKindInfo& kind, std::size_t turns) {
  for (std::size_t turn = 0; turn < turns; ++turn) {
    for (const QueryPeerInfo& info : query_peer_table()) {
      if (info.only_when_moved || !is_asked(info, setting.world, kind.kind)) continue;
      register_timed_row(
          text("queries/", setting.world, "/", setting.bodies, "/", kind.name, "/", info.name),
          [=, &info](benchmark::State& state) { run_row(state, setting, info, kind.kind); },
          benchmark::kNanosecond);
    }
  }
}

// Repeated at once: each turn would have to make the world and the tree anew.
void register_moved_rows_of(const StageSetting& setting, const QueryPeerInfo& info, std::size_t turns) {
  if (info.is_own && &info != &query_peer_table().front()) return;
  for (const QuestionKindInfo& kind : kQuestionKinds) {
    if (std::find(kKindsAskedWhenMoved.begin(), kKindsAskedWhenMoved.end(), kind.kind) ==
            kKindsAskedWhenMoved.end() ||
        !is_asked(info, setting.world, kind.kind))
      continue;
    register_timed_row(
        text("moved/", setting.world, "/", setting.bodies, "/", kind.name, "/", info.name),
        [=, &info](benchmark::State& state) { run_moved_row(state, setting, info, kind.kind); },
        benchmark::kNanosecond)
        ->Repetitions(static_cast<int>(turns));
  }
}

template <class Register>
void for_each_setting(const QuerySuite& suite, const Register& register_rows) {
  for (const std::string_view world : kQueryWorlds) {
    for (const std::size_t bodies : suite.bodies) {
      register_rows(StageSetting{std::string(world), bodies, suite.questions});
    }
  }
}

}  // namespace

// Rows about the same worlds come one after the other: making these takes longer than asking.
void register_query_suite(const QuerySuite& suite) {
  for_each_setting(suite, [&](const StageSetting& setting) {
    for (const QuestionKindInfo& kind : kQuestionKinds) register_cell(setting, kind, suite.turns);
  });
  for_each_setting(suite, [&](const StageSetting& setting) {
    for (const QueryPeerInfo& info : query_peer_table()) register_moved_rows_of(setting, info, suite.turns);
  });
}

}  // namespace cellsweep::bench
