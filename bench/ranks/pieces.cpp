// A world that fits no memory at hand, over the ranks of a job a piece at a time: slabs along one axis, in
// each of which a world over ranks finds the pairs whose lower corner lies in it, before and after all bodies
// have moved, and what began and ended. An oracle that shares no code with it counts them in other slabs,
// along another axis.
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench/peers/grid_oracle.h"
#include "cellsweep/ranks.h"
#include "ranks/region.h"
#include "world/random.h"
#include "world/scene_recipes.h"

namespace cellsweep::ranks_bench {
namespace {

constexpr std::uint64_t kBodiesOfAPiece = 12'000'000;

struct Settings {
  std::uint64_t bodies = 100'000'000;
  int pieces = 0;  // 0: of some twelve million bodies
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

std::uint64_t of_all(std::uint64_t mine, MPI_Op op) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_UINT64_T, op, MPI_COMM_WORLD);
  return mine;
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Scene `uniform`, of which any body can be had without the others.
class Bodies {
 public:
  explicit Bodies(std::uint64_t count)
      : recipe_(scene_recipes().front()),
        count_(count),
        edge_(static_cast<float>(recipe_.world_edge(static_cast<double>(count)))) {}

  std::uint64_t count() const { return count_; }
  float edge() const { return edge_; }
  Aabb before(std::uint64_t body) const {
    Random random(1, body);
    const Placement placement = recipe_.place({static_cast<BodyId>(body), edge_, true}, random);
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = placement.centre[axis] - 0.5F * placement.edges[axis];
      box.max[axis] = placement.centre[axis] + 0.5F * placement.edges[axis];
    }
    return box;
  }
  /// All a quarter of an edge on, along an axis that differs from one to the next.
  Aabb after(std::uint64_t body) const {
    Aabb box = before(body);
    box.min[body % 3] += 0.25F;
    box.max[body % 3] += 0.25F;
    return box;
  }

 private:
  const SceneRecipe& recipe_;
  std::uint64_t count_;
  float edge_;
};

/// Part `number` of `of` along an axis; the first and the last have no end outwards.
ranks::Region slab(const Bodies& bodies, std::size_t axis, int number, int of) {
  ranks::Region region = ranks::kEverywhere;
  if (number > 0) region.above[axis] = bodies.edge() * static_cast<float>(number) / static_cast<float>(of);
  if (number + 1 < of)
    region.up_to[axis] = bodies.edge() * static_cast<float>(number + 1) / static_cast<float>(of);
  return region;
}

/// Pairs that began, ended, or are there, of those whose lower corner is in a slab.
struct Count {
  std::uint64_t pairs = 0;
  std::uint64_t hash = 0;

  void add(std::uint64_t a, std::uint64_t b) {
    const GlobalPair pair{std::min(a, b), std::max(a, b)};
    ++pairs;
    hash ^= global_pair_set_hash({&pair, 1});
  }
  void add_up() {
    pairs = of_all(pairs, MPI_SUM);
    hash = of_all(hash, MPI_BXOR);
  }
  friend bool operator==(const Count&, const Count&) = default;
};

struct Counts {
  Count before;
  Count after;
  Count began;
  Count ended;

  void add_up() {
    for (Count* count : {&before, &after, &began, &ended}) count->add_up();
  }
  friend bool operator==(const Counts&, const Counts&) = default;
};

/// One piece after the other, over all ranks.
class Pieces {
 public:
  Pieces(const Bodies& bodies, int pieces) : bodies_(bodies), pieces_(pieces) {}

  Status run() {
    for (int piece = 0; piece < pieces_; ++piece) {
      if (Status status = run_piece(slab(bodies_, 0, piece, pieces_)); !status.ok()) return status;
      if (own_rank() == 0) std::fprintf(stderr, "\rpiece %d of %d ", piece + 1, pieces_);
    }
    counts_.add_up();
    if (own_rank() == 0) std::fprintf(stderr, "\n");
    return {};
  }

  const Counts& counts() const { return counts_; }
  double update_seconds() const { return seconds_; }
  std::uint64_t most_held() const { return most_held_; }

 private:
  // Every rank brings bodies of its own, wherever they are.
  Status run_piece(const ranks::Region& region) {
    std::vector<GlobalId> ids;
    std::vector<Aabb> boxes;
    std::vector<Aabb> moved;
    for (auto id = static_cast<std::uint64_t>(own_rank()); id < bodies_.count();
         id += static_cast<std::uint64_t>(all_ranks())) {
      const Aabb box = bodies_.before(id);
      const Aabb next = bodies_.after(id);
      if (!reaches(region, box) && !reaches(region, next)) continue;
      ids.push_back(id);
      boxes.push_back(box);
      moved.push_back(next);
    }
    auto world = make_distributed_broadphase(MPI_COMM_WORLD);
    if (!world) return world.status();
    static_cast<void>(world->insert(ids, boxes));
    if (Status status = update(*world); !status.ok()) return status;
    count(region, world->pairs(), &Bodies::before, counts_.before);
    std::vector<GlobalId> owned = world->owned();
    moved.clear();
    for (const GlobalId id : owned) moved.push_back(bodies_.after(id));
    static_cast<void>(world->move(owned, moved));
    if (Status status = update(*world); !status.ok()) return status;
    count(region, world->pairs(), &Bodies::after, counts_.after);
    count(region, changes_->began, &Bodies::after, counts_.began);
    count(region, changes_->ended, &Bodies::before, counts_.ended);
    most_held_ = std::max(most_held_, of_all(world->engine().size(), MPI_SUM));
    changes_.reset();
    return {};
  }

  Status update(DistributedBroadphase& world) {
    const double start = seconds();
    const auto changes = world.update();
    seconds_ += seconds() - start;
    if (changes) changes_ = *changes;
    return changes.status();
  }

  void count(const ranks::Region& region, std::span<const GlobalPair> pairs,
             Aabb (Bodies::*box)(std::uint64_t) const, Count& count) const {
    for (const GlobalPair& pair : pairs) {
      const Aabb a = (bodies_.*box)(pair.a);
      const Aabb b = (bodies_.*box)(pair.b);
      if (holds(region, ranks::lower_corner(a, b))) count.add(pair.a, pair.b);
    }
  }

  const Bodies& bodies_;
  int pieces_;
  Counts counts_;
  std::optional<RankChanges> changes_;
  double seconds_ = 0;
  std::uint64_t most_held_ = 0;
};

/// The same by the oracle, each rank other slabs.
class Oracle {
 public:
  Oracle(const Bodies& bodies, int slabs) : bodies_(bodies), slabs_(slabs) {}

  Counts run() {
    for (int number = own_rank(); number < slabs_; number += all_ranks()) {
      const ranks::Region region = slab(bodies_, 1, number, slabs_);
      list(region);
      compare(region, before_, after_, counts_.before, counts_.ended);
      compare(region, after_, before_, counts_.after, counts_.began);
      if (own_rank() == 0) std::fprintf(stderr, "\roracle: %d of %d ", number + 1, slabs_);
    }
    counts_.add_up();
    if (own_rank() == 0) std::fprintf(stderr, "\n");
    return counts_;
  }

 private:
  void list(const ranks::Region& region) {
    ids_.clear();
    before_.clear();
    after_.clear();
    for (std::uint64_t id = 0; id < bodies_.count(); ++id) {
      const Aabb box = bodies_.before(id);
      const Aabb next = bodies_.after(id);
      if (!reaches(region, box) && !reaches(region, next)) continue;
      ids_.push_back(id);
      before_.push_back(box);
      after_.push_back(next);
    }
  }

  // Pairs of `boxes`, and those of them that are none of `others`.
  void compare(const ranks::Region& region, const std::vector<Aabb>& boxes, const std::vector<Aabb>& others,
               Count& all, Count& changed) const {
    for (const Pair& pair : bench::grid_pairs(boxes)) {
      if (!holds(region, ranks::lower_corner(boxes[pair.a], boxes[pair.b]))) continue;
      all.add(ids_[pair.a], ids_[pair.b]);
      if (!overlap(others[pair.a], others[pair.b])) changed.add(ids_[pair.a], ids_[pair.b]);
    }
  }

  const Bodies& bodies_;
  int slabs_;
  Counts counts_;
  std::vector<std::uint64_t> ids_;
  std::vector<Aabb> before_;
  std::vector<Aabb> after_;
};

nlohmann::ordered_json as_json(const Count& count) {
  return {{"pairs", count.pairs}, {"hash", hash_text(count.hash)}};
}

int run(const Settings& settings) {
  const Bodies bodies(settings.bodies);
  const int pieces =
      settings.pieces > 0 ? settings.pieces : static_cast<int>(settings.bodies / kBodiesOfAPiece) + 1;
  const double start = seconds();
  Pieces world(bodies, pieces);
  if (const Status status = world.run(); !status.ok()) {
    if (own_rank() == 0) std::fprintf(stderr, "%s\n", status.message.c_str());
    return 1;
  }
  const double end = seconds();
  const Counts truth = Oracle(bodies, pieces + all_ranks()).run();
  const bool same = truth == world.counts();
  if (own_rank() == 0) {
    nlohmann::ordered_json json{{"bodies", settings.bodies}, {"ranks", all_ranks()}, {"pieces", pieces}};
    json["most_held_at_once"] = world.most_held();
    json["before"] = as_json(world.counts().before);
    json["after"] = as_json(world.counts().after);
    json["began"] = as_json(world.counts().began);
    json["ended"] = as_json(world.counts().ended);
    json["seconds"] = {
        {"updates", world.update_seconds()}, {"all_pieces", end - start}, {"oracle", seconds() - end}};
    json["same_as_oracle"] = same;
    std::printf("%s\n", json.dump(2).c_str());
  }
  return same ? 0 : 1;
}

}  // namespace
}  // namespace cellsweep::ranks_bench

int main(int argc, char** argv) {
  using namespace cellsweep::ranks_bench;
  MPI_Init(&argc, &argv);
  Settings settings;
  CLI::App app("A world that fits no memory at hand, over MPI ranks a piece at a time, beside an oracle.");
  app.add_option("--bodies", settings.bodies)->check(CLI::Range(1, 1'000'000'000))->capture_default_str();
  app.add_option("--pieces", settings.pieces, "0: of some twelve million bodies")
      ->check(CLI::Range(0, 10'000));
  int code = 2;
  try {
    app.parse(argc, argv);
    code = run(settings);
  } catch (const CLI::ParseError& error) {
    code = own_rank() == 0 ? app.exit(error) : error.get_exit_code();
  }
  MPI_Finalize();
  return code;
}
