#include "engines/cell/ppu/spe_group.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

#include "base/text.h"
#include "cellsweep/engine/timeline.h"

namespace cellsweep::cell {
namespace {

Status failed(unsigned index, const std::string& why) {
  return Status::spe_failed(text("SPE ", index, " failed: ", why), index);
}

/// What a call of libspe2 left in errno; where the machine has no SPE, some of its versions leave nothing.
std::string words_of_error() {
  const int error = errno;
  return error != 0 ? std::strerror(error)
                    : "libspe2 gives no reason. Has this machine SPEs, and spufs mounted?";
}

std::string words_of_stop(const spe_stop_info_t& stop) {
  if (stop.stop_reason == SPE_EXIT)
    return text("its program ended with code ", stop.result.spe_exit_code, ".");
  return text("it stopped for reason ", stop.stop_reason, ", ", stop.result.spe_runtime_error, ".");
}

}  // namespace

SpeGroup::SpeGroup(spe_program_handle_t& program, std::shared_ptr<Emulation> emulation)
    : program_(program), emulation_(std::move(emulation)) {}

Result<std::unique_ptr<SpeGroup>> SpeGroup::make(unsigned count, spe_program_handle_t& program,
                                                 std::shared_ptr<Emulation> emulation) {
  std::unique_ptr<SpeGroup> group(new SpeGroup(program, std::move(emulation)));
  while (group->size() < count) {
    if (Status status = group->add_spe(count); !status.ok()) return status;
  }
  return group;
}

SpeGroup::~SpeGroup() {
  wait();
  for (auto& spe : spes_) {
    if (spe->thread.joinable()) {
      // A thread of the parent process: it can neither be waited for nor be let go, so it stays what it is.
      static_cast<void>(spe.release());
    } else if (spe->context != nullptr) {
      spe_context_destroy(spe->context);
    }
  }
}

Status SpeGroup::add_spe(unsigned of) {
  const unsigned index = size();
  spes_.push_back(std::make_unique<Spe>());
  errno = 0;
  spes_.back()->context = emulation_->create_context(SPE_EVENTS_ENABLE | SPE_MAP_PS, of);
  if (spes_.back()->context == nullptr) return failed(index, words_of_error());
  counts_cycles_ = emulation_->cycles(spes_.back()->context).hertz != 0;
  return load(index);
}

Status SpeGroup::load(unsigned index) {
  Spe& spe = *spes_[index];
  errno = 0;
  if (spe_program_load(spe.context, &emulation_->image(program_)) == 0) return {};
  const std::string why = emulation_->fault(spe.context);
  return failed(index, why.empty() ? words_of_error() : why);
}

Status SpeGroup::run(std::span<void* const> jobs) {
  const Aside aside(*this);
  const WaitAtEnd wait_at_end(*this);
  if (Status status = start(jobs); !status.ok()) return status;
  const TimelineSpan span("wait for SPEs to end");
  return join();
}

Status SpeGroup::start(std::span<void* const> jobs) {
  started_ = started_ || !jobs.empty();
  for (const auto& spe : spes_) spe->cpu_milliseconds = 0;
  for (unsigned i = 0; i < jobs.size(); ++i) {
    try {
      start_thread(*spes_[i], jobs[i]);
    } catch (const std::system_error& error) {
      return failed(i, text("no thread is to be had for it: ", error.code().message(), "."));
    }
  }
  return {};
}

void SpeGroup::start_thread(Spe& spe, void* job) {
  spe.fault.clear();
  spe.error = nullptr;
  spe.running.store(true, std::memory_order_release);
  try {
    spe.thread = std::thread([this, &spe, job] { run_thread(spe, job); });
  } catch (...) {
    spe.running.store(false, std::memory_order_release);
    throw;
  }
}

// Nothing may leave a thread by an exception.
void SpeGroup::run_thread(Spe& spe, void* job) const {
  const double before = thread_cpu_milliseconds();
  try {
    run_program(spe, job);
  } catch (...) {
    spe.error = std::current_exception();
  }
  spe.cpu_milliseconds = thread_cpu_milliseconds() - before;
  spe.running.store(false, std::memory_order_release);
}

void SpeGroup::run_program(Spe& spe, void* job) const {
  unsigned entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop{};
  const int result = spe_context_run(spe.context, &entry, 0, job, nullptr, &stop);
  if (result < 0 && errno == ENOMEM) throw std::bad_alloc();
  const bool good = result == 0 && stop.stop_reason == SPE_EXIT && stop.result.spe_exit_code == 0;
  if (!good) spe.fault = result < 0 ? emulation_->fault(spe.context) : words_of_stop(stop);
  if (!good && spe.fault.empty()) spe.fault = words_of_stop(stop);
  // The context queues a stop info for every run; nobody else reads them.
  while (spe_stop_info_read(spe.context, &stop) == 0) continue;
}

Status SpeGroup::join() {
  wait();
  for (unsigned i = 0; i < size(); ++i) {
    if (spes_[i]->error) std::rethrow_exception(spes_[i]->error);
    if (!spes_[i]->fault.empty()) return failed(i, spes_[i]->fault);
  }
  return {};
}

bool SpeGroup::ran_out_of_memory() const {
  for (unsigned i = 0; i < size(); ++i) {
    if (!running(i) && spes_[i]->error) return true;
  }
  return false;
}

void SpeGroup::wait() noexcept {
  if (!is_of_this_process()) return;
  for (const auto& spe : spes_) {
    if (spe->thread.joinable()) spe->thread.join();
  }
}

double SpeGroup::longest_cpu_milliseconds() const {
  double longest = 0;
  for (const auto& spe : spes_) longest = std::max(longest, spe->cpu_milliseconds.load());
  return longest;
}

CellStatistics SpeGroup::take_statistics() {
  CellStatistics taken = statistics();
  for (const auto& spe : spes_) spe->before = spe->now;
  aside_milliseconds_ = 0;
  started_ = false;
  return taken;
}

CellStatistics SpeGroup::statistics() {
  const SpeCounts all = counts();
  return {longest_cpu_milliseconds(), all.gets,   all.puts, all.bytes_in, all.bytes_out, all.list_elements,
          all.local_store_high_water, cell_time()};
}

std::optional<CellTime> SpeGroup::cell_time() {
  if (!counts_cycles_) return std::nullopt;
  CellTime time;
  list_steps(time);
  time.set_aside_ms = aside_milliseconds_;
  time.threads_started = started_;
  return time;
}

// Asking takes time, too, which a Cell would not spend.
void SpeGroup::list_steps(CellTime& time) {
  const Aside aside(*this);
  for (const auto& spe : spes_) {
    const SpeCycles cycles = emulation_->cycles(spe->context);
    spe->now = cycles_by_step(cycles.functions);
    time.spes.push_back(spe_time(spe->now, spe->before, cycles.hertz));
  }
}

SpeCounts SpeGroup::counts() const {
  SpeCounts sum;
  for (const auto& spe : spes_) sum += emulation_->counts(spe->context);
  return sum;
}

void add_counters(const CellStatistics& statistics, std::vector<Counter>& counters) {
  counters.insert(counters.end(), {{"dma gets", statistics.dma_gets},
                                   {"dma puts", statistics.dma_puts},
                                   {"dma bytes in", statistics.dma_bytes_in},
                                   {"dma bytes out", statistics.dma_bytes_out},
                                   {"local store high water", statistics.local_store_high_water}});
}

}  // namespace cellsweep::cell
