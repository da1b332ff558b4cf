#include "cellsweep/broadphase.h"

#include <atomic>
#include <cassert>
#include <new>
#include <utility>

#include "base/float_environment.h"
#include "base/process.h"
#include "base/threads/deferred.h"
#include "base/tuning.h"
#include "broadphase/bodies/bodies.h"
#include "broadphase/kept_tree.h"
#include "broadphase/last_update.h"
#include "broadphase/pairs/pair_filter.h"
#include "broadphase/pairs/pair_order.h"
#include "broadphase/pairs/pair_set.h"
#include "broadphase/readers.h"
#include "cellsweep/engine/engine.h"
#include "cellsweep/engine/timeline.h"
#include "engines/common/handle_parts.h"

namespace cellsweep {

/// Admission, engine and pairs. Everything that can fail happens before anything shows.
class [[gnu::visibility("hidden")]] Broadphase::Impl {
 public:
  // Else it would become part of std::make_unique(), which is not compiled for size.
  [[gnu::cold, gnu::noinline]] Impl(HandleParts parts, std::unique_ptr<Engine> engine,
                                    std::shared_ptr<Timeline> timeline)
      : parts_(std::move(parts)),
        timeline_(std::move(timeline)),
        engine_(std::move(engine)),
        capacity_(engine_->capacity()) {
    if (timeline_) row_ = {timeline_.get(), timeline_->add_row(parts_.row_name)};
    show_cells();
  }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  [[gnu::cold]] ~Impl();

  /// Around every call that computes.
  template <class Call>
  auto traced(const char* name, Call&& call) {
    assert(readers_.none() && "a Broadphase was changed while a query read it");
    const DefaultFloats floats;
    if (!timeline_) return call();
    const TimelineScope scope(row_);
    const TimelineSpan span(name);
    return call();
  }

  // Not inlined, nor is add(), for the size of programs: several calls come down to each.
  [[gnu::noinline]] Status insert(std::span<const BodyId> ids, std::span<const Aabb> boxes,
                                  std::span<const BodyFilter> filters = {}) {
    return traced("insert", [&] {
      plan_insert(ids.size());
      return bodies_.insert(crew_, ids, boxes, filters, parts_.name, capacity_);
    });
  }
  Status set_filters(std::span<const BodyId> ids, std::span<const BodyFilter> filters) {
    return traced("filters", [&] { return bodies_.set_filters(ids, filters); });
  }
  [[gnu::noinline]] Status add(std::span<const Aabb> boxes, std::span<BodyId> ids) {
    return traced("insert", [&] {
      plan_insert(ids.size());
      return bodies_.add(crew_, boxes, ids, parts_.name, capacity_);
    });
  }
  Status move(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
    return traced("move", [&] {
      const TimedWork work(crew_, ids.size(), move_cost_);
      return bodies_.move(crew_, ids, boxes);
    });
  }
  Status remove(std::span<const BodyId> ids) {
    return traced("remove", [&] { return bodies_.remove(ids); });
  }
  Result<PairChanges> update() {
    return traced("update", [&]() -> Result<PairChanges> {
      auto changes = prepare();
      if (changes) commit();
      return changes;
    });
  }
  Result<PairChanges> prepare_update() {
    return traced("update", [&] { return prepare(); });
  }
  void commit_update() {
    traced("commit", [&] { commit(); });
  }
  void abandon_update() {
    bodies_.undo();
    engine_is_lost_ = true;
    engine_counts_ = false;
    counting_.put_off();
    show_cells();
  }

  std::string_view name() const {
    return parts_.name;
  }
  const Capacity& capacity() const {
    return capacity_;
  }
  const Bodies& bodies() const {
    return bodies_;
  }
  std::span<const Pair> pairs() const {
    return pairs_.pairs();
  }
  [[gnu::cold]] const Statistics& statistics() const {
    counting_.finish([&] { count(); });
    return statistics_;
  }
  Engine& engine() {
    return *engine_;
  }
  const LastUpdate& last_update() const {
    return last_update_;
  }

 private:
  /// Puts the changes into the boxes, and takes them out again unless they are to stay.
  class Attempt {
   public:
    explicit Attempt(Impl& impl) : impl_(impl) { impl.changes_ = impl.bodies_.begin_update(); }
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;
    ~Attempt() {
      if (!succeeded_) impl_.abandon_update();
    }
    void succeed() { succeeded_ = true; }

   private:
    Impl& impl_;
    bool succeeded_ = false;
  };

  // Workers that wake up for the first bodies of all are awake for the update that follows.
  void plan_insert(std::size_t bodies) {
    const bool are_first = bodies_.size() == 0 && crew_.has_started();
    if (are_first) return crew_.plan(bodies, crew_.cost_of_new(bodies));
    crew_.plan(bodies, tuning::kInsertGuess);
  }

  /// What an update does until anything shows; then either commit() or abandon_update(), which cannot fail.
  Result<PairChanges> prepare();
  void commit();
  [[gnu::cold]] Status renew_engine();
  // After a failure the engine knows nothing, or no more than a part.
  void show_cells() {
    last_update_.cells = engine_is_lost_ ? CellsToQuery() : engine_->cells();
  }
  void name_changes(const FoundPairs& unfiltered);
  void tidy();
  [[gnu::cold]] void count() const;

  HandleParts parts_;
  std::shared_ptr<Timeline> timeline_;  // goes after the engine, whose SPEs end before it is written
  TimelineRow row_;
  std::unique_ptr<Engine> engine_;
  bool engine_is_lost_ = false;   // after a failure; the next update makes a new one
  bool nothing_changed_ = false;  // as prepare() found
  bool gave_back_ = false;        // bodies and pairs did, what is of use only while many move
  BodyChanges changes_{};         // of the update that is being made
  ProcessMark process_;           // the engine's, whose threads may not be in another one
  Capacity capacity_;
  Crew& crew_ = *parts_.crew;
  WorkCost move_cost_{tuning::kMoveGuess};
  mutable std::atomic_flag crew_is_taken_;  // by a batch of queries
  mutable Readers readers_;
  mutable KeptTree kept_tree_;
  Bodies bodies_;
  PairFilter filter_;
  PairOrder order_;
  PairSet pairs_;
  mutable Statistics statistics_;
  Deferred counting_;           // of what is put together when somebody asks for statistics
  bool engine_counts_ = false;  // its last update succeeded
  LastUpdate last_update_{bodies_, {}, kept_tree_, readers_, crew_, crew_is_taken_};
};

Broadphase::Impl::~Impl() = default;

Result<PairChanges> Broadphase::Impl::prepare() {
  gave_back_ = bodies_.have_come_to_rest();
  if (gave_back_) pairs_.give_back();
  pairs_.remember_changes();
  const bool anew = engine_is_lost_ || engine_->ran_out_of_memory() || !process_.is_this_process();
  if (anew) {
    if (Status status = renew_engine(); !status.ok()) return status;
  }
  Attempt attempt(*this);
  statistics_.bytes = 0;
  const auto found = engine_->update(anew ? bodies_.all_as_new() : changes_, statistics_);
  if (!found) return found.status();
  nothing_changed_ = !anew && changes_.none() && found->none();
  if (nothing_changed_) {
    attempt.succeed();
    return PairChanges();
  }
  name_changes(*found);
  if (anew || found->is_whole_set) pairs_.compare_with_whole_set(bodies_.removed_ids());
  attempt.succeed();
  return pairs_.next_changes();
}

void Broadphase::Impl::commit() {
  if (!nothing_changed_) kept_tree_.note(changes_);
  bodies_.commit();
  ++statistics_.updates;
  statistics_.bytes += kept_tree_.bytes();
  engine_counts_ = true;
  counting_.put_off();
  if (nothing_changed_) {
    pairs_.commit_nothing();
  } else {
    engine_is_lost_ = false;
    pairs_.commit();
    tidy();
  }
  show_cells();
}

void Broadphase::Impl::count() const {
  if (engine_counts_) engine_->count(statistics_);
  statistics_.bytes += bodies_.bytes() + filter_.bytes() + order_.bytes() + pairs_.bytes();
}

Status Broadphase::Impl::renew_engine() {
  auto engine = parts_.maker();
  if (!engine) return engine.status();
  engine_ = std::move(*engine);
  process_.renew();
  return {};
}

void Broadphase::Impl::name_changes(const FoundPairs& unfiltered) {
  const FoundPairs found =
      bodies_.filters().in_use() ? filter_.apply(unfiltered, bodies_.filters()) : unfiltered;
  order_.name_pairs(crew_, bodies_.table(), found.began, found.more_began, pairs_.next_began());
  order_.name_pairs(crew_, bodies_.table(), found.ended, {}, pairs_.next_ended());
}

// Memory comes back where most bodies have gone. There is time for it later, too.
void Broadphase::Impl::tidy() {
  try {
    if (!bodies_.tidy()) return;
    engine_is_lost_ = true;
    kept_tree_.drop();
  } catch (const std::bad_alloc&) {
  }
}

[[gnu::cold]] Result<Broadphase> EngineAccess::make(HandleParts parts) {
  const DefaultFloats floats;
  auto engine = parts.maker();
  if (!engine) return engine.status();
  std::shared_ptr<Timeline> timeline;
  if (!parts.trace.empty()) {
    auto opened = Timeline::open(parts.trace);
    if (!opened) return opened.status();
    timeline = std::move(*opened);
  }
  if (!parts.crew) parts.crew = std::make_shared<Crew>(nullptr, 1, Crew::Choice::given);
  return Broadphase(
      std::make_unique<Broadphase::Impl>(std::move(parts), std::move(*engine), std::move(timeline)));
}

Result<Broadphase> EngineAccess::make(std::string_view name, EngineMaker maker, const std::string& trace,
                                      std::string row_name) {
  return make({name, std::move(maker), nullptr, trace, std::move(row_name)});
}

Broadphase::Broadphase(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Broadphase::Broadphase(Broadphase&& other) noexcept = default;
Broadphase& Broadphase::operator=(Broadphase&& other) noexcept = default;
Broadphase::~Broadphase() = default;

std::string_view Broadphase::name() const {
  return impl_->name();
}

Capacity Broadphase::capacity() const {
  return impl_->capacity();
}

Status Broadphase::insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  return impl_->insert(ids, boxes);
}

Status Broadphase::insert(std::span<const BodyId> ids, std::span<const Aabb> boxes,
                          std::span<const BodyFilter> filters) {
  return impl_->insert(ids, boxes, filters);
}

Status Broadphase::set_filters(std::span<const BodyId> ids, std::span<const BodyFilter> filters) {
  return impl_->set_filters(ids, filters);
}

Status Broadphase::set_filter(BodyId id, const BodyFilter& filter) {
  return set_filters({&id, 1}, {&filter, 1});
}

std::optional<BodyFilter> Broadphase::filter(BodyId id) const {
  const Slot slot = impl_->bodies().table().find(id);
  if (slot == kNoSlot) return std::nullopt;
  return impl_->bodies().filter(slot);
}

Status Broadphase::insert(BodyId id, const Aabb& box) {
  return impl_->insert({&id, 1}, {&box, 1});
}

Status Broadphase::add(std::span<const Aabb> boxes, std::span<BodyId> ids) {
  return impl_->add(boxes, ids);
}

Result<BodyId> Broadphase::add(const Aabb& box) {
  BodyId id = 0;
  if (Status status = impl_->add({&box, 1}, {&id, 1}); !status.ok()) return status;
  return id;
}

Status Broadphase::move(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  return impl_->move(ids, boxes);
}

Status Broadphase::move(BodyId id, const Aabb& box) {
  return impl_->move({&id, 1}, {&box, 1});
}

Status Broadphase::remove(std::span<const BodyId> ids) {
  return impl_->remove(ids);
}

Status Broadphase::remove(BodyId id) {
  return impl_->remove({&id, 1});
}

Result<PairChanges> Broadphase::update() {
  return impl_->update();
}

std::span<const Pair> Broadphase::pairs() const {
  return impl_->pairs();
}

Status Broadphase::boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const {
  return impl_->bodies().boxes(ids, boxes);
}

std::size_t Broadphase::size() const {
  return impl_->bodies().size();
}

bool Broadphase::contains(BodyId id) const {
  return impl_->bodies().table().find(id) != kNoSlot;
}

const Statistics& Broadphase::statistics() const {
  return impl_->statistics();
}

Result<PairChanges> EngineAccess::prepare_update(Broadphase& broadphase) {
  return broadphase.impl_->prepare_update();
}

void EngineAccess::commit_update(Broadphase& broadphase) {
  broadphase.impl_->commit_update();
}

void EngineAccess::abandon_update(Broadphase& broadphase) {
  broadphase.impl_->abandon_update();
}

Status EngineAccess::next_boxes(const Broadphase& broadphase, std::span<const BodyId> ids,
                                std::span<Aabb> boxes) {
  return broadphase.impl_->bodies().next_boxes(ids, boxes);
}

Engine& EngineAccess::engine_of(Broadphase& broadphase) {
  return broadphase.impl_->engine();
}

const Engine& EngineAccess::engine_of(const Broadphase& broadphase) {
  return broadphase.impl_->engine();
}

std::span<const Aabb> EngineAccess::boxes_of(const Broadphase& broadphase) {
  return broadphase.impl_->bodies().all_boxes();
}

const LastUpdate& EngineAccess::last_update(const Broadphase& broadphase) {
  return broadphase.impl_->last_update();
}

}  // namespace cellsweep
