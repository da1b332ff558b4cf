/// @file
/// Every function of the face for C without the memory or the threads that it asks for: the status and the
/// sentence say so, nothing has changed, and called again it does what it should. Two programs: one takes all
/// memory from the system, the other what grows from an allocator of the caller's.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "bindings/c/c_world.h"
#include "contract/box_kinds.h"
#include "contract/effort.h"
#include "contract/faults/starved_call.h"
#include "engines/oracle/brute_force.h"
#include "queries/reference.h"

namespace cellsweep::c {
namespace {

using contract::Fault;
using contract::Lasts;
using contract::Scarce;

constexpr BodyId kBodies = 40;

/// What the caller's allocator and executor are asked, and whether all came back.
std::atomic<long> blocks = 0;
int releases = 0;

#if defined(CELLSWEEP_OWN_ALLOCATOR)
void* take(void*, std::size_t bytes, std::size_t alignment) {
  if (contract::must_fail(Scarce::memory)) return nullptr;
  void* const memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
  if (memory != nullptr) ++blocks;
  return memory;
}
void give(void*, void* memory) {
  --blocks;
  std::free(memory);
}
const cellsweep_status allocator_is_set = [] {
  const cellsweep_allocator allocator = {take, give, nullptr};
  return cellsweep_set_allocator(&allocator, nullptr);
}();
#else
const cellsweep_status allocator_is_set = CELLSWEEP_OK;
#endif

bool run_in_turn(void*, unsigned count, cellsweep_task task, void* context) {
  for (unsigned i = 0; i < count; ++i) task(context, i);
  return true;
}
void release(void*) {
  ++releases;
}
constexpr cellsweep_executor kExecutor = {3, run_in_turn, nullptr, release};

cellsweep_path as_c(const Path& path) {
  cellsweep_path to = {{}, {path.direction[0], path.direction[1], path.direction[2]}, path.end};
  std::copy_n(path.box.min.begin(), 3, to.box.min);
  std::copy_n(path.box.max.begin(), 3, to.box.max);
  return to;
}
cellsweep_aabb as_c(const Aabb& box) {
  return as_c(Path(MovingBox{box, {1, 0, 0}, 1})).box;
}

std::vector<Aabb> some_boxes(std::uint64_t seed, std::size_t count) {
  contract::Random random(seed);
  return contract::make_boxes(contract::box_kind("uniform"), random, count);
}

/// A life in which calls may fail once each, with what must come of it.
class Life {
 public:
  explicit Life(const Fault& fault) : fault_(fault) {
    contract::let_fail(fault.scarce, fault.n, fault.lasts);
  }
  Life(const Life&) = delete;
  Life& operator=(const Life&) = delete;
  ~Life() { contract::let_fail(fault_.scarce, 0); }

  void make_objects(const cellsweep_stream_options& options);
  void make_world_of(const char* engine);
  void change_bodies();
  void ask();
  void search();
  void remember();
  /// What is destroyed can do without memory.
  void end();

  /// Whether a fault happened.
  bool had_fault() const { return contract::failed_calls(fault_.scarce) > 0; }

 private:
  /// `function(failure)` is called again where it failed for want of memory.
  template <class Function>
  void call(const char* name, const Function& function);
  template <class Make, class Object>
  void make(const char* name, const Make& function, Object& object);
  void expect_kept(const char* name);
  void update();

  std::vector<BodyId> ids() const { return reference_ids(shown_); }
  static std::vector<BodyId> reference_ids(const std::map<BodyId, Aabb>& boxes);
  static std::vector<Pair> pairs_among(const std::map<BodyId, Aabb>& boxes);
  void insert(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes);

  void ask_about_regions(const std::vector<cellsweep_region>& regions);
  void ask_about_paths(const std::vector<cellsweep_path>& paths);
  void ask_what_is_near(const std::vector<cellsweep_region>& regions);

  Fault fault_;
  World world_;
  Answers answers_;
  PairList list_;
  History history_;
  std::map<BodyId, Aabb> bodies_;
  std::map<BodyId, Aabb> shown_;
  std::vector<Pair> pairs_;
  std::vector<Pair> listed_;  // in list_
  cellsweep_changes changes_{};
};

template <class Function>
void Life::call(const char* name, const Function& function) {
  cellsweep_failure why = {};
  contract::count_calls(true);
  const cellsweep_status status = function(&why);
  contract::count_calls(false);
  if (status == CELLSWEEP_OK) return;
  EXPECT_TRUE(had_fault()) << name << ": " << why.message;
  EXPECT_EQ(status, CELLSWEEP_NO_MEMORY) << name << ", " << describe(fault_) << ": " << why.message;
  EXPECT_EQ(why.status, CELLSWEEP_NO_MEMORY);
  EXPECT_STREQ(why.message, "There is no memory for this call; nothing has changed.") << name;
  expect_kept(name);
  ASSERT_EQ(function(&why), CELLSWEEP_OK) << name << ", " << describe(fault_) << ": " << why.message;
}

// Where it is not made, what was to hold it is as it was.
template <class Make, class Object>
void Life::make(const char* name, const Make& function, Object& object) {
  using Handle = typename Object::pointer;
  Handle made = nullptr;
  call(name, [&](cellsweep_failure* why) {
    const cellsweep_status status = function(&made, why);
    EXPECT_TRUE(status == CELLSWEEP_OK || made == nullptr) << name;
    return status;
  });
  object.reset(made);
}

void Life::expect_kept(const char* name) {
  EXPECT_TRUE(!list_ || pairs_in(list_) == listed_) << name;
  if (!world_) return;
  EXPECT_EQ(pairs_of(world_), pairs_) << name << ", " << describe(fault_);
  EXPECT_EQ(cellsweep_size(world_.get()), bodies_.size()) << name;
  for (const auto& [id, box] : bodies_) EXPECT_TRUE(cellsweep_contains(world_.get(), id)) << name;
  const std::vector<BodyId> seen = ids();
  std::vector<Aabb> boxes(seen.size());
  cellsweep_failure why;
  EXPECT_EQ(
      cellsweep_read_boxes(world_.get(), ids_in(seen), reinterpret_cast<cellsweep_aabb*>(boxes.data()), &why),
      CELLSWEEP_OK)
      << name << ": " << why.message;
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(boxes[i], shown_.at(seen[i])) << name;
}

std::vector<BodyId> Life::reference_ids(const std::map<BodyId, Aabb>& boxes) {
  std::vector<BodyId> ids;
  for (const auto& [id, box] : boxes) ids.push_back(id);
  return ids;
}

std::vector<Pair> Life::pairs_among(const std::map<BodyId, Aabb>& boxes) {
  std::vector<Aabb> all;
  for (const auto& [id, box] : boxes) all.push_back(box);
  return brute_force_pairs(reference_ids(boxes), all);
}

void Life::make_objects(const cellsweep_stream_options& options) {
  const int before = releases;
  make(
      "create", [&](auto** made, auto* why) { return cellsweep_create(&options, made, why); }, world_);
  EXPECT_EQ(releases, before) << "of a world that was not made or is there";
  make("answers_create", cellsweep_answers_create, answers_);
  make("pair_list_create", cellsweep_pair_list_create, list_);
  make(
      "history_create", [](auto** made, auto* why) { return cellsweep_history_create(100000, made, why); },
      history_);
}

void Life::make_world_of(const char* engine) {
  const bool is_control = std::string_view(engine) == "control";
  const cellsweep_setting setting = {"pair_map_bytes", "65536"};
  make(
      "create_engine",
      [&](auto** made, auto* why) {
        return cellsweep_create_engine(engine, &setting, is_control ? 1 : 0, made, why);
      },
      world_);
}

void Life::insert(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes) {
  call("insert", [&](auto* why) {
    return cellsweep_insert(world_.get(), ids_in(ids), boxes_in(boxes), cellsweep_no_filters(), why);
  });
  for (std::size_t i = 0; i < ids.size(); ++i) bodies_[ids[i]] = boxes[i];
}

void Life::update() {
  const cellsweep_changes before = changes_;
  call("update", [&](cellsweep_failure* why) {
    const cellsweep_status status = cellsweep_update(world_.get(), &changes_, why);
    EXPECT_TRUE(status == CELLSWEEP_OK || changes_.began == before.began);
    return status;
  });
  shown_ = bodies_;
  pairs_ = pairs_among(shown_);
  const cellsweep_pair* pairs = nullptr;
  std::size_t count = 0;
  call("pairs", [&](auto* why) { return cellsweep_pairs(world_.get(), &pairs, &count, why); });
  EXPECT_EQ(copied(pairs, count), pairs_);
}

void Life::change_bodies() {
  std::vector<BodyId> some;
  for (BodyId i = 0; i < kBodies / 2; ++i) some.push_back(0xffffff00U - 977 * i);
  insert(some, some_boxes(1, some.size()));
  update();
  const std::vector<Aabb> more = some_boxes(2, kBodies / 2);
  std::vector<BodyId> added(more.size(), 0xdeadbeefU);
  call("add", [&](cellsweep_failure* why) {
    const cellsweep_status status = cellsweep_add(world_.get(), boxes_in(more), added.data(), why);
    EXPECT_TRUE(status == CELLSWEEP_OK || added.front() == 0xdeadbeefU);
    return status;
  });
  for (std::size_t i = 0; i < added.size(); ++i) bodies_[added[i]] = more[i];
  // Doubles that are floats, each ten bytes behind the other: read one by one.
  const std::vector<Aabb> next = some_boxes(3, some.size());
  std::vector<double> doubles;
  for (const Aabb& box : next) {
    doubles.insert(doubles.end(), box.min.begin(), box.min.end());
    doubles.insert(doubles.end(), box.max.begin(), box.max.end());
  }
  const cellsweep_boxes apart = cellsweep_boxes_apart(CELLSWEEP_DOUBLE, 3, doubles.data(), doubles.data() + 3,
                                                      6 * sizeof(double), next.size());
  call("move", [&](auto* why) { return cellsweep_move(world_.get(), ids_in(some), apart, why); });
  for (std::size_t i = 0; i < some.size(); ++i) bodies_[some[i]] = next[i];
  const std::vector<cellsweep_filter> filters(added.size(), cellsweep_filter{1, 0xffffffffU, false});
  call("set_filters", [&](auto* why) {
    return cellsweep_set_filters(world_.get(), ids_in(added),
                                 cellsweep_filters_of(filters.data(), filters.size()), why);
  });
  cellsweep_filter filter = {};
  call("filter_of", [&](auto* why) { return cellsweep_filter_of(world_.get(), added[0], &filter, why); });
  EXPECT_EQ(filter.category, 1U);
  update();
  const std::vector<BodyId> gone(some.begin(), some.begin() + 3);
  call("remove", [&](auto* why) { return cellsweep_remove(world_.get(), ids_in(gone), why); });
  for (const BodyId id : gone) bodies_.erase(id);
  update();
  const std::vector<BodyId> seen = ids();
  std::vector<cellsweep_aabb> boxes(seen.size());
  call("read_boxes",
       [&](auto* why) { return cellsweep_read_boxes(world_.get(), ids_in(seen), boxes.data(), why); });
  EXPECT_EQ(boxes[0].min[0], shown_.begin()->second.min[0]);
  // None of these may ask for memory, nor has a way to say so.
  contract::count_calls(true);
  const cellsweep_statistics statistics = cellsweep_statistics_of(world_.get());
  const bool has_names =
      (statistics.phase_count == 0 || cellsweep_phase_at(world_.get(), 0).name != nullptr) &&
      (statistics.counter_count == 0 || cellsweep_counter_at(world_.get(), 0).name != nullptr) &&
      cellsweep_engine_name(world_.get()) != nullptr && cellsweep_version() != nullptr &&
      cellsweep_engine_at(0) != nullptr && cellsweep_engine_summary(0) != nullptr &&
      cellsweep_engine_count() > 0 && cellsweep_capacity(world_.get()) > 0 &&
      cellsweep_status_name(CELLSWEEP_NO_MEMORY) != nullptr;
  contract::count_calls(false);
  EXPECT_TRUE(has_names);
  EXPECT_EQ(statistics.updates, 3U);
}

bool keep_body(void* context, uint32_t id) {
  static_cast<std::vector<BodyId>*>(context)->push_back(id);
  return true;
}
double keep_touch(void* context, cellsweep_touch touch, double end) {
  static_cast<std::vector<BodyId>*>(context)->push_back(touch.body);
  return end;
}

template <class Told, class Truth>
void expect_bodies(const Told* told, std::size_t count, const std::vector<Truth>& truth) {
  ASSERT_EQ(count, truth.size());
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(told[i].body, truth[i].body);
}

void Life::ask_about_regions(const std::vector<cellsweep_region>& regions) {
  const queries::Reference truth{shown_, {}};
  call("find_overlaps", [&](auto* why) {
    return cellsweep_find_overlaps(world_.get(), regions.data(), regions.size(), nullptr, answers_.get(),
                                   why);
  });
  const auto any = std::make_unique<bool[]>(regions.size());
  call("any_overlaps", [&](auto* why) {
    return cellsweep_any_overlaps(world_.get(), regions.data(), regions.size(), nullptr, any.get(), why);
  });
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const auto& box = reinterpret_cast<const Aabb&>(regions[i].box);
    const std::vector<BodyId> expected = truth.overlaps(Region(box, regions[i].distance));
    std::size_t count = 0;
    const uint32_t* bodies = cellsweep_bodies(answers_.get(), i, &count);
    EXPECT_EQ(std::vector<BodyId>(bodies, bodies + count), expected);
    EXPECT_EQ(any[i], !expected.empty());
  }
  std::vector<BodyId> seen;
  seen.reserve(kBodies);
  call("visit_overlaps", [&](auto* why) {
    seen.clear();
    return cellsweep_visit_overlaps(world_.get(), regions.data(), nullptr, keep_body, &seen, why);
  });
  std::ranges::sort(seen);
  const auto& box = reinterpret_cast<const Aabb&>(regions[0].box);
  EXPECT_EQ(seen, truth.overlaps(Region(box, regions[0].distance)));
}

void Life::ask_about_paths(const std::vector<cellsweep_path>& paths) {
  const queries::Reference reference{shown_, {}};
  call("find_touches", [&](auto* why) {
    return cellsweep_find_touches(world_.get(), paths.data(), paths.size(), nullptr, answers_.get(), why);
  });
  std::vector<cellsweep_first_touch> first(paths.size());
  call("first_touches", [&](auto* why) {
    return cellsweep_first_touches(world_.get(), paths.data(), paths.size(), nullptr, first.data(), why);
  });
  const auto any = std::make_unique<bool[]>(paths.size());
  call("any_touches", [&](auto* why) {
    return cellsweep_any_touches(world_.get(), paths.data(), paths.size(), nullptr, any.get(), why);
  });
  const auto truth_of = [&](const cellsweep_path& path) {
    const auto& box = reinterpret_cast<const Aabb&>(path.box);
    return reference.touches(
        MovingBox{box, {path.direction[0], path.direction[1], path.direction[2]}, path.end});
  };
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const std::vector<Touch> truth = truth_of(paths[i]);
    std::size_t count = 0;
    const cellsweep_touch* touches = cellsweep_touches(answers_.get(), i, &count);
    expect_bodies(touches, count, truth);
    EXPECT_EQ(any[i], !truth.empty());
    EXPECT_EQ(first[i].is_there, !truth.empty());
    EXPECT_TRUE(truth.empty() || first[i].touch.body == truth[0].body);
  }
  std::vector<BodyId> seen;
  seen.reserve(kBodies);
  call("visit_touches", [&](auto* why) {
    seen.clear();
    return cellsweep_visit_touches(world_.get(), paths.data(), nullptr, keep_touch, &seen, why);
  });
  EXPECT_EQ(seen.size(), truth_of(paths[0]).size());
}

void Life::ask_what_is_near(const std::vector<cellsweep_region>& regions) {
  const queries::Reference truth{shown_, {}};
  call("find_within", [&](auto* why) {
    return cellsweep_find_within(world_.get(), regions.data(), regions.size(), nullptr, answers_.get(), why);
  });
  for (std::size_t i = 0; i < regions.size(); ++i) {
    std::size_t count = 0;
    const cellsweep_neighbor* near = cellsweep_neighbors(answers_.get(), i, &count);
    const auto& box = reinterpret_cast<const Aabb&>(regions[i].box);
    expect_bodies(near, count, truth.within(Region(box, regions[i].distance)));
  }
  std::vector<cellsweep_aabb> boxes;
  for (const cellsweep_region& region : regions) boxes.push_back(region.box);
  call("find_nearest", [&](auto* why) {
    return cellsweep_find_nearest(world_.get(), boxes.data(), boxes.size(), 4, double{INFINITY}, nullptr,
                                  answers_.get(), why);
  });
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::size_t count = 0;
    const cellsweep_neighbor* near = cellsweep_neighbors(answers_.get(), i, &count);
    const auto& box = reinterpret_cast<const Aabb&>(boxes[i]);
    expect_bodies(near, count, truth.nearest(box, 4, double{INFINITY}));
  }
}

void Life::ask() {
  std::vector<cellsweep_region> regions;
  std::vector<cellsweep_path> paths;
  // Enough for several threads.
  for (const Aabb& box : some_boxes(4, 70)) {
    regions.push_back({as_c(box), static_cast<double>(regions.size() % 3) / 8});
    paths.push_back(as_c(Path(MovingBox{box, {0.5, -0.25, 0.125}, 4})));
  }
  for (const std::size_t count : {regions.size(), std::size_t{1}}) {
    regions.resize(count);
    paths.resize(count);
    ask_about_regions(regions);
    ask_about_paths(paths);
    ask_what_is_near(regions);
    call("prepare_queries", [&](auto* why) { return cellsweep_prepare_queries(world_.get(), why); });
  }
  const std::vector<BodyId> some = {ids()[0], ids()[5]};
  call("find_pairs_of",
       [&](auto* why) { return cellsweep_find_pairs_of(world_.get(), ids_in(some), list_.get(), why); });
  listed_ = queries::Reference{shown_, {}}.pairs_of(some);
  EXPECT_EQ(pairs_in(list_), listed_);
}

bool count_pair(void* context, cellsweep_pair) {
  ++*static_cast<std::uint64_t*>(context);
  return true;
}

void Life::search() {
  const std::vector<Aabb> boxes = some_boxes(5, 150);
  const std::vector<Aabb> others = some_boxes(6, 20);
  const cellsweep_boxes one = boxes_in(boxes);
  const cellsweep_boxes other = boxes_in(others);
  const std::vector<Pair> pairs = brute_force_pairs(boxes);
  std::vector<Pair> between;
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    for (std::uint32_t b = 0; b < others.size(); ++b) {
      if (overlap(boxes[a], others[b])) between.push_back({a, b});
    }
  }
  call("find_pairs", [&](auto* why) { return cellsweep_find_pairs(one, nullptr, list_.get(), why); });
  EXPECT_EQ(pairs_in(list_), listed_ = pairs);
  call("find_pairs_between",
       [&](auto* why) { return cellsweep_find_pairs_between(one, other, nullptr, list_.get(), why); });
  EXPECT_EQ(pairs_in(list_), listed_ = between);
  cellsweep_find_options options = {};
  options.size = sizeof options;
  options.threads = 3;
  options.executor = &kExecutor;
  std::uint64_t count = 0;
  call("count_pairs", [&](auto* why) { return cellsweep_count_pairs(one, &options, &count, why); });
  EXPECT_EQ(count, pairs.size());
  call("count_pairs_between",
       [&](auto* why) { return cellsweep_count_pairs_between(one, other, &options, &count, why); });
  EXPECT_EQ(count, between.size());
  call("visit_pairs", [&](auto* why) {
    count = 0;
    return cellsweep_visit_pairs(one, nullptr, count_pair, &count, why);
  });
  EXPECT_EQ(count, pairs.size());
  call("visit_pairs_between", [&](auto* why) {
    count = 0;
    return cellsweep_visit_pairs_between(one, other, nullptr, count_pair, &count, why);
  });
  EXPECT_EQ(count, between.size());
}

void Life::remember() {
  const std::vector<Pair> before = pairs_;
  const uint64_t number = cellsweep_statistics_of(world_.get()).updates;
  call("history_record",
       [&](auto* why) { return cellsweep_history_record(history_.get(), number, &changes_, why); });
  const std::vector<BodyId> some = {ids()[0], ids()[1]};
  const std::vector<Aabb> boxes(2, shown_.rbegin()->second);
  call("move", [&](auto* why) { return cellsweep_move(world_.get(), ids_in(some), boxes_in(boxes), why); });
  for (std::size_t i = 0; i < some.size(); ++i) bodies_[some[i]] = boxes[i];
  update();
  call("history_record",
       [&](auto* why) { return cellsweep_history_record(history_.get(), number + 1, &changes_, why); });
  cellsweep_changes since = {};
  call("history_since",
       [&](auto* why) { return cellsweep_history_since(history_.get(), number, &since, why); });
  std::vector<Pair> began;
  std::ranges::set_difference(pairs_, before, std::back_inserter(began));
  EXPECT_EQ(copied(since.began, since.began_count), began);
  EXPECT_FALSE(began.empty());
}

void Life::end() {
  contract::count_calls(true);
  world_.reset();
  answers_.reset();
  list_.reset();
  history_.reset();
  contract::count_calls(false);
}

class CFaults : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(allocator_is_set, CELLSWEEP_OK); }
  void TearDown() override { contract::count_calls(false); }

  /// `live(life)` with a fault at each place; all that was taken comes back.
  template <class Live>
  void live_with_each(const Live& live) {
    std::uint64_t faults = 0;
    for (const Scarce scarce : {Scarce::memory, Scarce::threads}) {
      for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
        bool failed = true;
        const contract::Places places{40, contract::repeated<std::uint64_t>(1, contract::effort(3, 7, 31))};
        for (Fault fault{scarce, 1, lasts}; failed; fault.n = places.after(fault.n)) {
          {
            Life life(fault);
            live(life);
            life.end();
            failed = life.had_fault();
          }
          EXPECT_EQ(blocks, 0) << describe(fault);
          if (HasFailure()) return;
          faults += failed ? 1 : 0;
        }
      }
    }
    EXPECT_GT(faults, 50U) << "memory is asked for in fewer places than there are";
  }
};

void live_all(Life& life) {
  life.change_bodies();
  life.ask();
  life.search();
  life.remember();
}

TEST_F(CFaults, OfAWorldWithThreads) {
  cellsweep_stream_options options = {};
  options.size = sizeof options;
  options.threads = 2;
  live_with_each([&](Life& life) {
    life.make_objects(options);
    live_all(life);
  });
}

TEST_F(CFaults, OfAWorldWithAnExecutorOfTheCallers) {
  cellsweep_stream_options options = {};
  options.size = sizeof options;
  options.threads = 3;
  options.executor = &kExecutor;
  releases = 0;
  int worlds = 0;
  live_with_each([&](Life& life) {
    life.make_objects(options);
    life.change_bodies();
    ++worlds;
  });
  EXPECT_EQ(releases, worlds) << "each is released once, with its world";
}

TEST_F(CFaults, OfAWorldWithATimeline) {
  const std::string path = testing::TempDir() + "/cellsweep-c-faults-" + std::to_string(getpid()) + ".json";
  cellsweep_stream_options options = {};
  options.size = sizeof options;
  options.trace = path.c_str();
  live_with_each([&](Life& life) {
    life.make_objects(options);
    life.change_bodies();
  });
  EXPECT_EQ(std::remove(path.c_str()), 0) << "the last one was written";
}

TEST_F(CFaults, OfAWorldOfEachEngineByName) {
  for (const char* engine : {"control", "oracle"}) {
    live_with_each([&](Life& life) {
      life.make_world_of(engine);
      life.change_bodies();
    });
  }
}

}  // namespace
}  // namespace cellsweep::c
