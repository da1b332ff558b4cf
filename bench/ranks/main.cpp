// What a world over ranks costs beside the same world in one engine: CPU time of all ranks, messages and
// bytes. Both get every frame, one after the other, the one engine on the first rank while the others sleep.
#include <mpi.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/threads/thread_clock.h"
#include "cellsweep/ranks.h"
#include "ranks/rank_scene.h"

namespace cellsweep::ranks_bench {
namespace {

struct Settings {
  SceneSettings scene{.scene = "uniform", .bodies = 1'000'000, .moving = 1.0};
  int frames = 30;
  int warm_up = 5;
  bool without_engine = false;
  RankOptions ranks;
};

int own_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int all_ranks() {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

// A barrier in which nobody takes the processor from those who work.
void sleep_until_all_are_here() {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  int done = 0;
  while (MPI_Test(&request, &done, MPI_STATUS_IGNORE), done == 0) usleep(200);
}

double sum_of_all(double mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return mine;
}

double most_of_all(double mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return mine;
}

std::uint64_t xor_of_all(std::uint64_t mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_UINT64_T, MPI_BXOR, MPI_COMM_WORLD);
  return mine;
}

/// The one engine, on the first rank.
class Whole {
 public:
  explicit Whole(const SceneSettings& settings)
      : scene_(settings), engine_(std::move(*make_broadphase(StreamOptions{.threads = 1}))) {
    std::vector<BodyId> ids;
    for (GlobalId id = 0; id < scene_.bodies(); ++id) {
      ids.push_back(static_cast<BodyId>(id));
      if (scene_.moves(id)) moving_.push_back(id);
    }
    for (const GlobalId id : moving_) ids_.push_back(static_cast<BodyId>(id));
    static_cast<void>(engine_.insert(ids, scene_.boxes()));
    static_cast<void>(engine_.update());
  }

  double frame() {
    scene_.move(moving_, boxes_);
    const double before = thread_cpu_milliseconds();
    static_cast<void>(engine_.move(ids_, boxes_));
    static_cast<void>(engine_.update());
    return thread_cpu_milliseconds() - before;
  }
  std::span<const Pair> pairs() const { return engine_.pairs(); }

 private:
  RankScene scene_;
  Broadphase engine_;
  std::vector<GlobalId> moving_;
  std::vector<BodyId> ids_;
  std::vector<Aabb> boxes_;
};

/// This rank's part of the distributed world; bodies take what the scene knows of them along.
class Part {
 public:
  explicit Part(const Settings& settings)
      : scene_(settings.scene),
        world_(std::move(*make_distributed_broadphase(MPI_COMM_WORLD, settings.ranks))) {
    std::vector<GlobalId> ids;
    std::vector<Aabb> boxes;
    for (auto id = static_cast<GlobalId>(own_rank()); id < scene_.bodies();
         id += static_cast<GlobalId>(all_ranks())) {
      ids.push_back(id);
      boxes.push_back(scene_.boxes()[id]);
    }
    static_cast<void>(world_.insert(ids, boxes));
    mine_ = ids;
    take_over(*world_.update());
  }

  const RankStatistics& frame() {
    scene_.move(moving_, boxes_);
    const double before = thread_cpu_milliseconds();
    static_cast<void>(world_.move(moving_, boxes_));
    move_ms_ = thread_cpu_milliseconds() - before;
    const auto changes = world_.update();
    take_over(*changes);
    return world_.statistics();
  }
  double move_ms() const { return move_ms_; }
  const DistributedBroadphase& world() const { return world_; }

 private:
  struct Sent {
    GlobalId id;
    RankScene::Flight flight;
  };

  void take_over(const RankChanges& changes) {
    if (!changes.departed.empty() || !changes.arrived.empty() || moving_.empty()) {
      exchange(changes);
      mine_ = world_.owned();
      moving_.clear();
      for (const GlobalId id : mine_) {
        if (scene_.moves(id)) moving_.push_back(id);
      }
    } else {
      exchange(changes);
    }
  }

  // All to all: the benchmark's own, and not measured.
  void exchange(const RankChanges& changes) {
    const auto ranks = static_cast<std::size_t>(all_ranks());
    std::vector<std::vector<Sent>> out(ranks);
    for (const Handover& departed : changes.departed)
      out[static_cast<std::size_t>(departed.rank)].push_back({departed.id, scene_.flight(departed.id)});
    std::vector<int> counts(ranks);
    std::vector<int> places(ranks);
    std::vector<Sent> rows;
    for (std::size_t rank = 0; rank < ranks; ++rank) {
      places[rank] = static_cast<int>(rows.size() * sizeof(Sent));
      counts[rank] = static_cast<int>(out[rank].size() * sizeof(Sent));
      rows.insert(rows.end(), out[rank].begin(), out[rank].end());
    }
    std::vector<int> in_counts(ranks);
    std::vector<int> in_places(ranks);
    MPI_Alltoall(counts.data(), 1, MPI_INT, in_counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
    int sum = 0;
    for (std::size_t rank = 0; rank < ranks; ++rank) {
      in_places[rank] = sum;
      sum += in_counts[rank];
    }
    std::vector<Sent> in(static_cast<std::size_t>(sum) / sizeof(Sent));
    MPI_Alltoallv(rows.data(), counts.data(), places.data(), MPI_BYTE, in.data(), in_counts.data(),
                  in_places.data(), MPI_BYTE, MPI_COMM_WORLD);
    for (const Sent& sent : in) scene_.set_flight(sent.id, sent.flight);
  }

  RankScene scene_;
  DistributedBroadphase world_;
  std::vector<GlobalId> mine_;
  std::vector<GlobalId> moving_;
  std::vector<Aabb> boxes_;
  double move_ms_ = 0;
};

struct Sums {
  std::vector<double> whole;
  std::vector<double> ranks;  // CPU ms of all ranks but for waits
  std::map<std::string, double> phases;
  double bytes = 0;
  double messages = 0;
  double ghosts = 0;
  double enters = 0;
  double most_messages = 0;
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? 0 : values[values.size() / 2];
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

void add_frame(Part& part, bool counts, Sums& sums) {
  const RankStatistics& statistics = part.frame();
  double work = part.move_ms();
  std::map<std::string, double> phases{{"move", part.move_ms()}};
  for (const RankPhase& phase : statistics.phases) {
    if (phase.is_wait) continue;
    phases[std::string(phase.name)] += phase.cpu_milliseconds;
    work += phase.cpu_milliseconds;
  }
  const double all = sum_of_all(work);
  const double bytes = sum_of_all(static_cast<double>(statistics.bytes));
  const double messages = sum_of_all(static_cast<double>(statistics.messages));
  const double ghosts = sum_of_all(static_cast<double>(statistics.ghosts));
  const double enters = sum_of_all(static_cast<double>(statistics.enters));
  const double most = most_of_all(static_cast<double>(statistics.messages));
  if (!counts) return;
  sums.ranks.push_back(all);
  for (const auto& [name, ms] : phases) sums.phases[name] += ms;
  sums.bytes += bytes;
  sums.messages += messages;
  sums.ghosts += ghosts;
  sums.enters += enters;
  sums.most_messages = std::max(sums.most_messages, most);
}

nlohmann::ordered_json run(const Settings& settings) {
  Sums sums;
  std::optional<Whole> whole;
  if (own_rank() == 0 && !settings.without_engine) whole.emplace(settings.scene);
  sleep_until_all_are_here();
  Part part(settings);
  for (int frame = 0; frame < settings.warm_up + settings.frames; ++frame) {
    const bool counts = frame >= settings.warm_up;
    if (whole) {
      const double ms = whole->frame();
      if (counts) sums.whole.push_back(ms);
    }
    sleep_until_all_are_here();
    add_frame(part, counts, sums);
  }
  const std::uint64_t hash = xor_of_all(global_pair_set_hash(part.world().pairs()));
  const double pairs = sum_of_all(static_cast<double>(part.world().pairs().size()));
  nlohmann::ordered_json json;
  const double frames = settings.frames;
  json["scene"] = settings.scene.scene;
  json["bodies"] = settings.scene.bodies;
  json["ranks"] = all_ranks();
  json["pairs"] = static_cast<std::uint64_t>(pairs);
  json["hash"] = hash_text(hash);
  if (whole) {
    json["same"] = pair_set_hash(whole->pairs()) == hash;
    json["one_engine_cpu_ms"] = {{"mean", mean(sums.whole)}, {"median", median(sums.whole)}};
  }
  json["ranks_cpu_ms"] = {{"mean", mean(sums.ranks)}, {"median", median(sums.ranks)}};
  if (whole) json["ratio"] = mean(sums.ranks) / mean(sums.whole);
  for (auto& [name, ms] : sums.phases) json["cpu_ms_of_all_ranks"][name] = sum_of_all(ms) / frames;
  json["bytes"] = sums.bytes / frames;
  json["messages"] = sums.messages / frames;
  json["most_messages_of_a_rank"] = sums.most_messages;
  json["ghosts"] = sums.ghosts / frames;
  json["enters"] = sums.enters / frames;
  json["bytes_a_ghost"] = sums.bytes / std::max(1.0, sums.ghosts);
  json["imbalance"] = part.world().statistics().imbalance;
  json["cuts"] = part.world().statistics().cuts;
  return json;
}

}  // namespace
}  // namespace cellsweep::ranks_bench

int main(int argc, char** argv) {
  using namespace cellsweep::ranks_bench;
  MPI_Init(&argc, &argv);
  Settings settings;
  CLI::App app("What a world over MPI ranks costs beside the same world in one engine.");
  app.add_option("--scene", settings.scene.scene, "A scene that is a world: cellsweep simulate --help");
  app.add_option("--bodies", settings.scene.bodies);
  app.add_option("--moving", settings.scene.moving, "Share of the bodies that move");
  app.add_option("--frames", settings.frames, "Frames that are measured");
  app.add_option("--recut-above", settings.ranks.recut_above);
  app.add_flag("--without-one-engine", settings.without_engine,
               "Only the ranks, for worlds too large for one");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    MPI_Finalize();
    return code;
  }
  const nlohmann::ordered_json json = run(settings);
  if (own_rank() == 0) std::printf("%s\n", json.dump(2).c_str());
  MPI_Finalize();
  return 0;
}
