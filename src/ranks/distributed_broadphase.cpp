#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/float_environment.h"
#include "base/text.h"
#include "cellsweep/engine/engine.h"
#include "cellsweep/ranks.h"
#include "ranks/cuts.h"
#include "ranks/cutter.h"
#include "ranks/directory.h"
#include "ranks/job.h"
#include "ranks/owned_pairs.h"
#include "ranks/phase_clock.h"
#include "ranks/rank_calls.h"
#include "ranks/rank_queries.h"
#include "ranks/refusals.h"
#include "ranks/round.h"

namespace cellsweep {

using ranks::Local;

class [[gnu::visibility("hidden")]] DistributedBroadphase::Impl {
 public:
  ranks::RankQueries queries() const {
    return {job_, cuts_, world_.held, engine_};
  }

  /// For a job of so many ranks, which join() hands over.
  Impl(int ranks, const RankOptions& options, Broadphase engine)
      : options_(options), engine_(std::move(engine)), cuts_(ranks), next_cuts_(cuts_) {
    statistics_.phases.reserve(ranks::PhaseClock::kMostPhases);
  }
  /// Collective.
  Status join(ranks::Job job) {
    job_ = std::move(job);
    return job_.agree([&] { return cutter_.begin(job_.communicator()); });
  }

  const ranks::Job& job() const {
    return job_;
  }
  const Broadphase& engine() const {
    return engine_;
  }
  const RankStatistics& statistics() const {
    return statistics_;
  }
  const ranks::Cuts& cuts() const {
    return cuts_;
  }
  const ranks::HeldBodies& held() const {
    return world_.held;
  }
  std::uint64_t size() const {
    return bodies_;
  }

  /// What refuses a call here refuses the next update everywhere.
  template <class Call>
  Status local(const Call& call) {
    const DefaultFloats floats;
    Status status = call(calls_);
    if (status.ok() || !refusal_.ok()) return status;
    Status copy = status;
    refusal_ = std::move(copy);
    return status;
  }
  const ranks::Region& own_region() const {
    return next_cuts_.region(job_.rank());
  }

  Result<RankChanges> update();
  std::span<const GlobalPair> pairs() const;
  std::vector<GlobalId> owned() const;
  /// Calls `take(place, box, filter)` for each of the bodies, which must be owned here, as of the last
  /// update.
  template <class Take>
  Status with_owned(std::span<const GlobalId> ids, const Take& take) const;

 private:
  bool was_owned(Local local) const;
  Status begin(ranks::Round & round, bool& must_resolve);
  Status cut_anew();
  Status list_points(std::vector<Point> & points, std::vector<Local> & locals);
  bool is_time_to_cut() const;
  Status tell(ranks::Round & round, ranks::PhaseClock & clock);
  Status update_engine(ranks::PhaseClock & clock);
  Status prepare_engine(ranks::PhaseClock & clock);
  void commit();
  void commit_link(Local local);
  void count(const ranks::Round& round, bool resolved);

  ranks::Job job_;
  RankOptions options_;
  Broadphase engine_;
  ranks::Cuts cuts_;       // as of the last update
  ranks::Cuts next_cuts_;  // with the next one
  ranks::Cutter cutter_;
  bool is_cut_ = false;
  ranks::World world_;
  ranks::RankCalls calls_{world_, engine_};
  ranks::Directory directory_{job_};
  Status refusal_;

  std::uint64_t bodies_ = 0;   // of all ranks
  std::uint64_t waiting_ = 0;  // new bodies of all ranks
  double imbalance_ = 1;
  double best_imbalance_ = 1;  // that the last cut could do
  std::vector<GlobalPair> began_;
  std::vector<GlobalPair> ended_;
  std::vector<GlobalPair> next_began_;
  std::vector<GlobalPair> next_ended_;
  std::vector<Handover> departed_;
  std::vector<Handover> arrived_;
  mutable std::vector<GlobalPair> pairs_;
  mutable bool pairs_are_listed_ = true;
  RankStatistics statistics_;
};

// The round is drafted before it is known whether it is the one that counts: mostly it is, and ranks need not
// agree once more.
Status DistributedBroadphase::Impl::begin(ranks::Round& round, bool& must_resolve) {
  if (!refusal_.ok()) return std::exchange(refusal_, {});
  if (Status status = world_.plan.run(engine_); !status.ok()) return status;
  calls_.take_own_calls(directory_);
  must_resolve = directory_.is_needed(world_.held, world_.calls);
  if (!must_resolve) round.draft(world_);
  return {};
}

bool DistributedBroadphase::Impl::is_time_to_cut() const {
  if (job_.ranks() == 1) return false;
  if (!is_cut_) return waiting_ > 0;
  const bool forced = options_.recut_every > 0 && (statistics_.updates + 1) % options_.recut_every == 0;
  return forced || imbalance_ > std::max(options_.recut_above, 1.1 * best_imbalance_);
}

// The lower corners of all bodies that this rank has to place.
Status DistributedBroadphase::Impl::list_points(std::vector<Point>& points, std::vector<Local>& locals) {
  std::vector<Aabb> boxes;
  for (Local local = 0; local < world_.held.locals(); ++local) {
    if (!world_.held.is(local, ranks::kOwned)) continue;
    if (world_.held.is(local, ranks::kLinked)) {
      if (world_.held.link(local).now.exists) points.push_back(world_.held.link(local).now.box.min);
    } else {
      locals.push_back(local);
    }
  }
  boxes.resize(locals.size());
  if (Status status = EngineAccess::next_boxes(engine_, locals, boxes); !status.ok()) return status;
  for (const Aabb& box : boxes) points.push_back(box.min);
  for (const ranks::StagedCall& call : world_.calls.calls()) {
    if (call.inserted && !call.must_exist) points.push_back(call.box.min);
  }
  return {};
}

// All bodies of this rank are looked at again that may reach more than one of the new regions.
Status DistributedBroadphase::Impl::cut_anew() {
  std::vector<Point> points;
  std::vector<Local> unlinked;
  const Status listed = ranks::Job::attempt([&] { return list_points(points, unlinked); });
  ranks::Together all;
  Status status = job_.agree(listed, points.size(), false, all);
  if (!status.ok() || all.sum == 0) return status;
  std::optional<ranks::Cuts> cuts;
  status = job_.agree([&]() -> Status {
    auto regions = cutter_.cut(points);
    if (!regions) return regions.status();
    cuts.emplace(std::move(*regions));
    std::vector<Aabb> boxes(unlinked.size());
    if (Status failed = EngineAccess::next_boxes(engine_, unlinked, boxes); !failed.ok()) return failed;
    std::vector<Local> apart;
    for (std::size_t i = 0; i < unlinked.size(); ++i) {
      if (!encloses(cuts->region(job_.rank()), boxes[i])) apart.push_back(unlinked[i]);
    }
    calls_.make_links(apart);
    return {};
  });
  if (!status.ok()) return status;
  for (Local local = 0; local < world_.held.locals(); ++local) {
    if (world_.held.is(local, ranks::kLinked) && world_.held.is(local, ranks::kOwned))
      world_.held.touch(local);
  }
  next_cuts_ = std::move(*cuts);
  is_cut_ = true;
  ++statistics_.cuts;
  return {};
}

// Nothing has changed where it fails.
Status DistributedBroadphase::Impl::tell(ranks::Round& round, ranks::PhaseClock& clock) {
  Status came = round.exchange();
  clock.lap_wait("exchange");
  Status status = job_.agree([&]() -> Status {
    if (!came.ok()) return came;
    round.read();
    if (round.has_return(world_)) calls_.make_all_links();
    round.reserve(world_, directory_);
    const Capacity capacity = engine_.capacity();
    const std::size_t bodies = round.bodies_after(world_, engine_.size());
    if (bodies <= capacity.bodies) return {};
    return Status::over_capacity(text("Engine ", engine_.name(), " takes ", capacity.bodies, " bodies, ",
                                      bodies, " reach this rank's region: ", capacity.reason, "."),
                                 bodies, capacity.bodies, capacity.setting);
  });
  if (status.ok()) round.apply(world_, directory_);
  clock.lap("apply");
  return status;
}

Status DistributedBroadphase::Impl::prepare_engine(ranks::PhaseClock& clock) {
  if (Status status = world_.plan.run(engine_); !status.ok()) return status;
  clock.lap("stage");
  const auto changes = EngineAccess::prepare_update(engine_);
  clock.lap("engine");
  if (!changes) return changes.status();
  try {
    const ranks::OwnedPairs owned(world_.held, job_.rank());
    owned.list_began(changes->began, next_cuts_, next_began_);
    owned.list_ended(changes->ended, cuts_, next_ended_);
  } catch (...) {
    EngineAccess::abandon_update(engine_);
    throw;
  }
  return {};
}

Status DistributedBroadphase::Impl::update_engine(ranks::PhaseClock& clock) {
  ranks::Together owned;
  const std::uint64_t mine = world_.held.count(ranks::kOwned);
  const Status prepared = ranks::Job::attempt([&] { return prepare_engine(clock); });
  clock.lap("pairs");
  Status status = job_.agree(prepared, mine, false, owned);
  clock.lap_wait("agree");
  if (!status.ok()) {
    if (prepared.ok()) EngineAccess::abandon_update(engine_);
    return status;
  }
  statistics_.owned = mine;
  bodies_ = owned.sum;
  imbalance_ =
      bodies_ == 0 ? 1 : static_cast<double>(owned.most) * job_.ranks() / static_cast<double>(bodies_);
  return {};
}

void DistributedBroadphase::Impl::commit_link(Local local) {
  ranks::HeldBodies& held = world_.held;
  ranks::Link& link = held.link(local);
  if (!held.is(local, ranks::kHeld)) return held.forget(local);
  link.before = link.now;
  link.renewed = false;
  link.told = link.reached;
  if (held.is(local, ranks::kOwned) && link.reached.empty() &&
      encloses(cuts_.region(job_.rank()), link.now.box))
    held.drop_link(local);
}

// Nothing of it needs memory.
void DistributedBroadphase::Impl::commit() {
  EngineAccess::commit_update(engine_);
  std::swap(cuts_, next_cuts_);
  next_cuts_ = cuts_;  // as many ranks: into the memory that is there
  for (const Local local : world_.held.touched()) commit_link(local);
  world_.held.clear_touched();
  world_.held.commit_flags();
  std::swap(began_, next_began_);
  std::swap(ended_, next_ended_);
  departed_.swap(world_.departed);
  arrived_.swap(world_.arrived);
  world_.departed.clear();
  world_.arrived.clear();
  std::ranges::sort(departed_, {}, &Handover::id);
  std::ranges::sort(arrived_, {}, &Handover::id);
  pairs_are_listed_ = false;
  ++statistics_.updates;
  statistics_.imbalance = imbalance_;
  statistics_.ghosts = engine_.size() - statistics_.owned;
}

void DistributedBroadphase::Impl::count(const ranks::Round& round, bool resolved) {
  const ranks::Told& told = round.told();
  statistics_.messages = told.messages + (resolved ? directory_.messages() : 0);
  statistics_.bytes = told.bytes + (resolved ? directory_.bytes() : 0);
  statistics_.rounds = 1 + (resolved ? directory_.rounds() : 0);
  statistics_.moves = told.moves;
  statistics_.enters = told.enters;
  statistics_.leaves = told.leaves;
  statistics_.adoptions = told.adoptions;
}

Result<RankChanges> DistributedBroadphase::Impl::update() {
  const DefaultFloats floats;
  ranks::PhaseClock clock(statistics_.phases);
  std::optional<ranks::Round> round(std::in_place, job_, next_cuts_);
  bool must_resolve = false;
  ranks::Together together;
  const Status begun = ranks::Job::attempt([&] { return begin(*round, must_resolve); });
  clock.lap("draft");
  Status status = job_.agree(begun, world_.calls.calls().size(), must_resolve, together);
  clock.lap_wait("agree");
  if (!status.ok()) return status;
  waiting_ = together.sum;
  if (together.any) {
    if (status = directory_.resolve(world_.held, world_.calls); !status.ok()) return status;
    status = job_.agree([&]() -> Status {
      calls_.take_own_calls(directory_);
      return {};
    });
    if (!status.ok()) return status;
    clock.lap("resolve");
  }
  // What is said from now on comes after this, whoever says it.
  world_.held.clear_all(ranks::kNamed);
  const bool cut = is_time_to_cut();
  if (cut) {
    if (status = cut_anew(); !status.ok()) return status;
    clock.lap("cut");
  }
  if (together.any || cut) {
    round.emplace(job_, next_cuts_);
    status = job_.agree([&]() -> Status {
      round->draft(world_);
      return {};
    });
    if (!status.ok()) return status;
    clock.lap("draft");
  }
  if (status = tell(*round, clock); !status.ok()) return status;
  if (status = update_engine(clock); !status.ok()) return status;
  commit();
  // A cut that could do no better is no reason for the next one.
  best_imbalance_ = cut ? imbalance_ : std::min(best_imbalance_, imbalance_);
  count(*round, together.any);
  clock.lap("commit");
  return RankChanges{began_, ended_, departed_, arrived_};
}

std::span<const GlobalPair> DistributedBroadphase::Impl::pairs() const {
  if (!pairs_are_listed_) {
    ranks::OwnedPairs(world_.held, job_.rank()).list_all(engine_.pairs(), cuts_, pairs_);
    pairs_are_listed_ = true;
  }
  return pairs_;
}

// Between updates, whatever was called since.
bool DistributedBroadphase::Impl::was_owned(Local local) const {
  return local != ranks::kNoLocal && world_.held.is(local, ranks::kWasOwned);
}

std::vector<GlobalId> DistributedBroadphase::Impl::owned() const {
  std::vector<GlobalId> ids;
  ids.reserve(statistics_.owned);
  for (Local local = 0; local < world_.held.locals(); ++local) {
    if (was_owned(local)) ids.push_back(world_.held.id(local));
  }
  std::ranges::sort(ids);
  return ids;
}

template <class Take>
Status DistributedBroadphase::Impl::with_owned(std::span<const GlobalId> ids, const Take& take) const {
  std::vector<Local> locals;
  std::vector<GlobalId> others;
  for (const GlobalId id : ids) {
    locals.push_back(world_.held.find(id));
    if (!was_owned(locals.back())) others.push_back(id);
  }
  if (!others.empty())
    return ranks::refuse_bodies(StatusCode::unknown_body, std::move(others), "not owned by this rank");
  std::vector<Aabb> boxes(ids.size());
  if (Status status = engine_.boxes(locals, boxes); !status.ok()) return status;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const bool is_linked = world_.held.is(locals[i], ranks::kLinked);
    take(i, boxes[i],
         is_linked ? BodyFilter(world_.held.link(locals[i]).before.filter)
                   : engine_.filter(locals[i]).value_or(BodyFilter()));
  }
  return {};
}

DistributedBroadphase::DistributedBroadphase(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
DistributedBroadphase::DistributedBroadphase(DistributedBroadphase&& other) noexcept = default;
DistributedBroadphase& DistributedBroadphase::operator=(DistributedBroadphase&& other) noexcept = default;
DistributedBroadphase::~DistributedBroadphase() = default;

int DistributedBroadphase::rank() const {
  return impl_->job().rank();
}

int DistributedBroadphase::ranks() const {
  return impl_->job().ranks();
}

MPI_Comm DistributedBroadphase::communicator() const {
  return impl_->job().communicator();
}

Status DistributedBroadphase::insert(std::span<const GlobalId> ids, std::span<const Aabb> boxes,
                                     std::span<const BodyFilter> filters) {
  return impl_->local([&](ranks::RankCalls& calls) { return calls.insert(ids, boxes, filters); });
}

Status DistributedBroadphase::move(std::span<const GlobalId> ids, std::span<const Aabb> boxes) {
  return impl_->local([&](ranks::RankCalls& calls) { return calls.move(impl_->own_region(), ids, boxes); });
}

Status DistributedBroadphase::set_filters(std::span<const GlobalId> ids,
                                          std::span<const BodyFilter> filters) {
  return impl_->local([&](ranks::RankCalls& calls) { return calls.set_filters(ids, filters); });
}

Status DistributedBroadphase::remove(std::span<const GlobalId> ids) {
  return impl_->local([&](ranks::RankCalls& calls) { return calls.remove(ids); });
}

Result<RankChanges> DistributedBroadphase::update() {
  return impl_->update();
}

std::span<const GlobalPair> DistributedBroadphase::pairs() const {
  return impl_->pairs();
}

Result<std::vector<GlobalPair>> DistributedBroadphase::gather_pairs(int root) const {
  const ranks::Job& job = impl_->job();
  std::span<const GlobalPair> mine;
  Status status = job.agree([&]() -> Status {
    mine = impl_->pairs();
    return {};
  });
  if (!status.ok()) return status;
  auto all = job.gather(mine, root);
  if (all) std::ranges::sort(*all);
  return all;
}

std::vector<GlobalId> DistributedBroadphase::owned() const {
  return impl_->owned();
}

Status DistributedBroadphase::boxes(std::span<const GlobalId> ids, std::span<Aabb> boxes) const {
  if (ids.size() != boxes.size()) return ranks::length_status(ids.size(), boxes.size(), "boxes");
  return impl_->with_owned(
      ids, [&](std::size_t place, const Aabb& box, const BodyFilter&) { boxes[place] = box; });
}

Status DistributedBroadphase::filters(std::span<const GlobalId> ids, std::span<BodyFilter> filters) const {
  if (ids.size() != filters.size()) return ranks::length_status(ids.size(), filters.size(), "filters");
  return impl_->with_owned(
      ids, [&](std::size_t place, const Aabb&, const BodyFilter& filter) { filters[place] = filter; });
}

std::uint64_t DistributedBroadphase::size() const {
  return impl_->size();
}

Aabb DistributedBroadphase::region(int rank) const {
  const ranks::Region& region = impl_->cuts().region(rank);
  if (region.above[0] >= region.up_to[0]) return {};
  return {region.above, region.up_to};
}

Status DistributedQueries::find_overlaps(std::span<const Region> regions, BatchAnswers<GlobalId>& found,
                                         const Filter& as) const {
  return broadphase_->impl_->queries().find_overlaps(regions, found, as);
}

Status DistributedQueries::find_touches(std::span<const Path> paths, BatchAnswers<GlobalTouch>& found,
                                        const Filter& as) const {
  return broadphase_->impl_->queries().find_touches(paths, found, as);
}

Status DistributedQueries::first_touches(std::span<const Path> paths,
                                         std::span<std::optional<GlobalTouch>> first,
                                         const Filter& as) const {
  return broadphase_->impl_->queries().first_touches(paths, first, as);
}

Status DistributedQueries::find_nearest(std::span<const Aabb> boxes, std::size_t count,
                                        BatchAnswers<GlobalNeighbor>& found, double most,
                                        const Filter& as) const {
  return broadphase_->impl_->queries().find_nearest(boxes, count, found, most, as);
}

Status DistributedQueries::find_within(std::span<const Region> regions, BatchAnswers<GlobalNeighbor>& found,
                                       const Filter& as) const {
  return broadphase_->impl_->queries().find_within(regions, found, as);
}

const RankStatistics& DistributedBroadphase::statistics() const {
  return impl_->statistics();
}

const Broadphase& DistributedBroadphase::engine() const {
  return impl_->engine();
}

std::uint64_t global_pair_set_hash(std::span<const GlobalPair> pairs) {
  std::uint64_t hash = 0;
  for (const GlobalPair& pair : pairs) {
    // As pair_key() where ids are small; what is above comes in by another turn.
    const std::uint64_t above = (pair.a >> 32) << 32 | pair.b >> 32;
    const std::uint64_t key = pair.a << 32 | (pair.b & 0xffffffffU);
    hash ^= mix64((above == 0 ? key : key ^ mix64(above)) + 0x9e3779b97f4a7c15ULL);
  }
  return hash;
}

Result<DistributedBroadphase> make_distributed_broadphase(MPI_Comm communicator, const RankOptions& options) {
  ranks::Job job(communicator);
  std::unique_ptr<DistributedBroadphase::Impl> made;
  Status status = job.agree([&]() -> Status {
    if (!(options.recut_above >= 1)) {
      return Status::bad_option("recut_above", text("recut_above is ", options.recut_above,
                                                    "; it is 1, which is perfect, or more."));
    }
    auto engine = options.make_engine ? options.make_engine() : make_broadphase(StreamOptions{.threads = 1});
    if (!engine) return engine.status();
    made = std::make_unique<DistributedBroadphase::Impl>(job.ranks(), options, std::move(*engine));
    return {};
  });
  if (status.ok()) status = made->join(std::move(job));
  if (!status.ok()) return status;
  return DistributedBroadphase(std::move(made));
}

}  // namespace cellsweep
