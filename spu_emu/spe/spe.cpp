#include "spe/spe.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <new>

#include "mfc/format.h"
#include "spe/spe_list.h"

namespace spu_emu {

namespace {
constexpr std::uint32_t kUnlimited = 1U << 30U;

unsigned next_number() {
  static std::atomic<unsigned> next{0};
  return next.fetch_add(1);
}

SignalMode signal_mode(unsigned flags, unsigned flag) {
  return (flags & flag) != 0 ? SignalMode::logical_or : SignalMode::overwrite;
}

ChannelSetup channel_setup(const EmulationSettings& settings, unsigned flags, unsigned number,
                           SpeTrace& trace, WaitPoint* point) {
  ChannelSetup setup;
  setup.spe = number;
  setup.mode = settings.dma_mode;
  setup.seed = settings.seed;
  setup.signal1 = signal_mode(flags, SPE_CFG_SIGNOTIFY1_OR);
  setup.signal2 = signal_mode(flags, SPE_CFG_SIGNOTIFY2_OR);
  setup.log = settings.trace ? &trace : nullptr;
  setup.also_notified = point;
  return setup;
}
}  // namespace

Spe::Spe(const EmulationSettings& settings, unsigned int flags, WaitPoint* event_point)
    : settings_(settings),
      number_(next_number()),
      trace_(number_),
      arena_(settings.local_store_limit == 0 ? kUnlimited : settings.local_store_limit),
      empty_store_(arena_.base(), arena_.local_store_size(), WordOrder::same),
      timebase_(settings.timebase_hertz),
      channels_(empty_store_, timebase_, channel_setup(settings, flags, number_, trace_, event_point)),
      proxy_(empty_store_, {Issuer::proxy, settings.dma_mode, settings.seed + 2, nullptr, nullptr}) {
  use_store(empty_store_);
  SpeList::instance().add(*this);
}

Spe::~Spe() {
  SpeList::instance().remove(*this);
  unload();
  SpeDirectory::instance().remove(reinterpret_cast<std::uintptr_t>(arena_.base()));
}

/// The queues are empty whenever the store changes: what was in flight is forgotten with the program.
void Spe::use_store(LocalStoreView& store) {
  channels_.use_store(store);
  proxy_.use_store(store);
  SpeDirectory::instance().add(
      {reinterpret_cast<std::uintptr_t>(arena_.base()), arena_.local_store_size(), &store, &channels_});
}

/// Whoever sends DMA to this SPE meanwhile finds the empty store.
void Spe::unload() {
  channels_.abandon();
  const std::lock_guard lock(proxy_mutex_);
  proxy_.clear();
  use_store(empty_store_);
  const std::lock_guard program_lock(program_mutex_);
  program_.reset();
}

int Spe::load(const ProgramImage& image, ProgramLoader load_program) {
  unload();
  LoadResult result;
  try {
    result = load_program(*this, image);
  } catch (const std::bad_alloc&) {
    result = {nullptr, ENOMEM, "no memory for the program"};
  }
  if (!result.program) {
    set_last_fault(result.reason);
    return result.error;
  }
  const std::lock_guard lock(proxy_mutex_);
  const std::lock_guard program_lock(program_mutex_);
  program_ = std::move(result.program);
  use_store(program_->store());
  return 0;
}

/// The time in which the program stood still does not count.
void Spe::set_deadline(WaitPoint::Time begin) {
  if (settings_.time_limit.count() == 0) return;
  deadline_ = begin + (settings_.time_limit - time_used_);
  channels_.set_deadline(deadline_);
}

void Spe::add_time(std::chrono::steady_clock::duration time) {
  if (settings_.time_limit.count() == 0) return;
  time_used_ -= time;
  deadline_ += time;
  channels_.set_deadline(deadline_);
}

template <class Run>
Stop Spe::traced(Run&& run) {
  const TraceTime begin = std::chrono::steady_clock::now();
  set_deadline(begin);
  runs_.store(true, std::memory_order_relaxed);
  const Stop stop = run();
  runs_.store(false, std::memory_order_relaxed);
  if (settings_.time_limit.count() != 0) time_used_ += std::chrono::steady_clock::now() - begin;
  if (settings_.trace) trace_.run(begin);
  return stop;
}

Stop Spe::start(const Arguments& arguments) {
  channels_.abandon();
  time_used_ = {};
  return traced([&] { return program_->start(arguments); });
}

Stop Spe::resume(unsigned int entry) {
  return traced([&] { return program_->resume(entry); });
}

std::uint32_t Spe::store_size() const {
  return program_ ? program_->store_size() : arena_.local_store_size();
}

std::string Spe::store_map() const {
  if (program_) return program_->map();
  return format("local store of %u bytes\n  no program is loaded\n", arena_.local_store_size());
}

void Spe::set_last_fault(std::string text) {
  const std::lock_guard lock(fault_mutex_);
  last_fault_ = std::move(text);
}

std::string Spe::last_fault() {
  const std::lock_guard lock(fault_mutex_);
  return last_fault_;
}

std::string Spe::where_waiting() {
  const std::lock_guard lock(program_mutex_);
  return program_ ? program_->where_waiting() : std::string();
}

SpeStatistics Spe::statistics() {
  const QueueCounters& queue = channels_.queue_counters();
  const ChannelCounters& channel = channels_.counters();
  SpeStatistics result;
  result.gets = queue.gets.value();
  result.puts = queue.puts.value();
  result.bytes_in = queue.bytes_in.value();
  result.bytes_out = queue.bytes_out.value();
  result.list_elements = queue.list_elements.value();
  result.queue_stalls = queue.queue_stalls.value();
  result.proxy_gets = proxy_.counters().gets.value();
  result.proxy_puts = proxy_.counters().puts.value();
  result.tag_waits = channel.tag_waits.value();
  result.mailbox_waits = channel.mailbox_waits.value();
  result.signal_waits = channel.signal_waits.value();
  result.event_waits = channel.event_waits.value();
  result.atomics = channel.atomics.value();
  result.failed_atomics = channel.lost_reservations.value();
  const std::lock_guard lock(program_mutex_);
  if (program_) {
    result.local_store_high_water = program_->high_water();
    result.instructions = program_->instructions();
  }
  return result;
}

CycleProfile Spe::cycle_profile() {
  const std::lock_guard lock(program_mutex_);
  return program_ ? program_->cycle_profile() : CycleProfile();
}

}  // namespace spu_emu
