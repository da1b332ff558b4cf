#include "cellsweep/engine/piece_finder.h"

#include <memory>
#include <utility>

#include "base/text.h"
#include "base/threads/make_crew.h"
#include "engines/common/handle_parts.h"
#include "engines/stream/common_options.h"
#include "engines/stream/kernels/kernel.h"
#include "engines/stream/stream.h"

namespace cellsweep::stream {
namespace {

/// A fat box with more would reach from one end of the numbers to the other.
constexpr float kLargestMargin = 1e30F;

Status check(const StreamOptions& options) {
  if (options.threads > kMostThreads) return too_many_threads(options.threads);
  if (!(options.margin >= 0 && options.margin <= kLargestMargin)) {
    return Status::bad_option("margin",
                              text("margin is ", options.margin, "; it must be a length from 0 to 1e+30."));
  }
  if (find_kernels(options.isa) != nullptr) return {};
  return no_such_isa(options.isa);
}

[[gnu::cold]] Result<std::unique_ptr<Engine>> make_engine(StreamParts parts, const FinderMaker& make_finder) {
  if (make_finder) {
    auto finder = make_finder();
    if (!finder) return finder.status();
    parts.finder = std::move(*finder);
  }
  return std::unique_ptr<Engine>(std::make_unique<Stream>(std::move(parts)));
}

}  // namespace

[[gnu::cold]] Result<Broadphase> make_stream_broadphase(const StreamOptions& options, std::string_view name,
                                                        FinderMaker make_finder, std::string row_name) {
  if (Status status = check(options); !status.ok()) return status;
  const auto crew = make_crew(options.executor, options.threads);
  const auto make = [crew, max_pairs = static_cast<std::size_t>(options.max_pairs),
                     kernels = find_kernels(options.isa), margin = options.margin,
                     make_finder = std::move(make_finder)] {
    return make_engine({crew, max_pairs, kernels, margin}, make_finder);
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
