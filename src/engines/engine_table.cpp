#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/text.h"
#include "cellsweep/engines.h"
#include "cellsweep/local_store.h"
#include "engines/control/control.h"
#include "engines/stream/stream.h"
#include "cellsweep/engine/timeline.h"
#include "engines/traced_broadphase.h"
#ifdef CELLSWEEP_CELL_ENGINES
#include "engines/cell/cell_engines.h"
#endif
#ifdef CELLSWEEP_EMBREE
#include "engines/embree/embree_engine.h"
#endif

namespace cellsweep {
namespace {

using Factory = Result<std::unique_ptr<Broadphase>> (*)(const EngineOptions&);
using MapMaker = Result<LocalStoreMap> (*)(const EngineOptions&, std::uint64_t bodies);

struct Entry {
  EngineInfo info;
  Factory make;
  MapMaker map = nullptr;  // of engines that have a local store
};

Result<std::unique_ptr<Broadphase>> make_stream_anywhere(const EngineOptions& options) {
  if (!options.on_spes) return make_stream(options);
#ifdef CELLSWEEP_CELL_ENGINES
  return make_stream_on_spes(options);
#else
  return Status{StatusCode::bad_option,
                "on_spes is set, but this build has no SPEs and no emulation of them.",
                std::nullopt,
                1,
                0,
                "on_spes"};
#endif
}

constexpr std::array kEntries = {
    Entry{{"control",
           "the document's x86 sweep and prune: three insertion-sorted axes, a map of all possible pairs"},
          make_control},
#ifdef CELLSWEEP_CELL_ENGINES
    Entry{{"cell-paper",
           "the document's Cell version step by step: an axis an SPU, threads started each frame"},
          make_cell_paper,
          cell_paper_map},
    Entry{{"cell-brute",
           "what Bullet's Cell port did: every changed body against all others on the SPUs, no sort"},
          make_cell_brute,
          cell_brute_map},
    Entry{{"cell-resident",
           "SPU programs that stay alive, keep the pairs' status, and are told only what changed"},
          make_cell_resident,
          cell_resident_map},
#endif
    Entry{{"stream",
           "worlds of any size and density: cells within cells, wide vectors, threads; cost follows change"},
          make_stream_anywhere},
#ifdef CELLSWEEP_EMBREE
    Entry{{"embree", "for comparison: a ray tracer's tree over all boxes, built anew and run against itself"},
          make_embree},
#endif
};

constexpr auto kTable = [] {
  std::array<EngineInfo, kEntries.size()> table{};
  std::transform(kEntries.begin(), kEntries.end(), table.begin(),
                 [](const Entry& entry) { return entry.info; });
  return table;
}();

const Entry* find_entry(std::string_view name) {
  const auto entry = std::find_if(kEntries.begin(), kEntries.end(),
                                  [&](const Entry& candidate) { return candidate.info.name == name; });
  return entry == kEntries.end() ? nullptr : &*entry;
}

Status unknown_engine_status(std::string_view name) {
  std::string known;
  for (const EngineInfo& info : kTable) known += (known.empty() ? "" : ", ") + std::string(info.name);
  return {StatusCode::bad_option,
          text("There is no engine \"", name, "\"; there are: ", known, "."),
          std::nullopt,
          0,
          0,
          "engine"};
}

// With a row of its own; that of an engine with SPEs is the Cell's other processor.
Result<std::unique_ptr<Broadphase>> traced(std::unique_ptr<Broadphase> engine, const Entry& entry,
                                           const EngineOptions& options) {
  auto timeline = Timeline::open(options.trace_file);
  if (!timeline) return timeline.status();
  const std::string name(entry.info.name);
  return std::unique_ptr<Broadphase>(std::make_unique<TracedBroadphase>(
      std::move(engine), std::move(*timeline), entry.map == nullptr ? name : "PPU, " + name));
}

}  // namespace

std::span<const EngineInfo> engine_table() {
  return kTable;
}

Result<std::unique_ptr<Broadphase>> make_engine(std::string_view name, const EngineOptions& options) {
  const Entry* entry = find_entry(name);
  if (entry == nullptr) return unknown_engine_status(name);
  auto engine = entry->make(options);
  return engine && !options.trace_file.empty() ? traced(std::move(*engine), *entry, options)
                                               : std::move(engine);
}

Result<LocalStoreMap> local_store_map(std::string_view engine, const EngineOptions& options,
                                      std::uint64_t bodies) {
  const Entry* entry = find_entry(engine);
  if (entry == nullptr) return unknown_engine_status(engine);
  if (entry->map != nullptr) return entry->map(options, bodies);
  return Status{StatusCode::bad_option,
                text("Engine ", engine, " does not run on SPEs and has no local store."),
                std::nullopt,
                0,
                0,
                "engine"};
}

}  // namespace cellsweep
