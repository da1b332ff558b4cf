#include "cellsweep/engine/piece_finder.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/crew.h"
#include "base/text.h"
#include "base/thread_pool.h"
#include "base/tuning.h"
#include "engines/common/handle_parts.h"
#include "engines/stream/kernels/kernel.h"
#include "engines/stream/stream.h"

namespace cellsweep::stream {
namespace {

/// More than any machine has; more are a slip of the pen.
constexpr unsigned kMostThreads = 1024;

/// A fat box with more would reach from one end of the numbers to the other.
constexpr float kLargestMargin = 1e30F;

std::shared_ptr<Crew> make_crew(const StreamOptions& options) {
  const auto choice = options.threads == 0 ? Crew::Choice::by_gain : Crew::Choice::given;
  const unsigned machine = std::min(machine_threads(), tuning::kMostWorkers);
  const unsigned wanted = options.threads == 0 ? machine : options.threads;
  if (!options.executor) return std::make_shared<Crew>(std::make_shared<ThreadPool>(wanted), wanted, choice);
  const unsigned there = std::max(1U, options.executor->concurrency());
  const unsigned workers = std::min(there, options.threads == 0 ? tuning::kMostWorkers : options.threads);
  return std::make_shared<Crew>(options.executor, workers, choice);
}

Status check(const StreamOptions& options) {
  if (options.threads > kMostThreads) {
    return Status::bad_option("threads",
                              text("threads is ", options.threads, "; at most ", kMostThreads, " are taken."),
                              options.threads, kMostThreads);
  }
  if (!(options.margin >= 0 && options.margin <= kLargestMargin)) {
    return Status::bad_option("margin",
                              text("margin is ", options.margin, "; it must be a length from 0 to 1e+30."));
  }
  if (find_kernels(options.isa) != nullptr) return {};
  return Status::bad_option(
      "isa",
      "This machine or build does not have the instruction set that isa names; leave the "
      "choice to the engine.",
      static_cast<std::uint64_t>(options.isa));
}

}  // namespace

[[gnu::cold]] Result<Broadphase> make_stream_broadphase(const StreamOptions& options, std::string_view name,
                                                        FinderMaker make_finder, std::string row_name) {
  if (Status status = check(options); !status.ok()) return status;
  const auto crew = make_crew(options);
  const auto make = [crew, options,
                     make_finder = std::move(make_finder)]() -> Result<std::unique_ptr<Engine>> {
    StreamParts parts{crew, static_cast<std::size_t>(options.max_pairs), find_kernels(options.isa),
                      options.margin};
    if (make_finder) {
      auto finder = make_finder();
      if (!finder) return finder.status();
      parts.finder = std::move(*finder);
    }
    return std::unique_ptr<Engine>(std::make_unique<Stream>(std::move(parts)));
  };
  return EngineAccess::make({name, make, crew, options.trace, std::move(row_name)});
}

}  // namespace cellsweep::stream

namespace cellsweep {

[[gnu::cold]] Result<Broadphase> make_broadphase(const StreamOptions& options) {
  return stream::make_stream_broadphase(options, "stream", nullptr, "stream");
}

std::optional<StreamView> stream_view(const Broadphase& broadphase) {
  const auto* engine = dynamic_cast<const stream::Stream*>(&EngineAccess::engine_of(broadphase));
  if (engine == nullptr) return std::nullopt;
  return engine->view(EngineAccess::boxes_of(broadphase));
}

// The default settings are never refused.
Broadphase::Broadphase() : Broadphase(std::move(*make_broadphase(StreamOptions{}))) {}

}  // namespace cellsweep
