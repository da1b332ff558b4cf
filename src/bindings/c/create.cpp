#include <memory>
#include <string>
#include <utility>

#include "base/memory/memory.h"
#include "bindings/c/call.h"
#include "bindings/c/objects.h"
#include "bindings/c/options.h"
#include "cellsweep/c/engines.h"
#include "cellsweep/c/memory.h"
#include "cellsweep/engines.h"
#include "cellsweep/options.h"

using namespace cellsweep;
using namespace cellsweep::c;

namespace {

Status hand_out(Result<Broadphase> made, cellsweep_broadphase** to) {
  if (!made) return made.status();
  *to = std::make_unique<cellsweep_broadphase>(std::move(*made)).release();
  return {};
}

Status create_stream(const cellsweep_stream_options* given, cellsweep_broadphase** made) {
  cellsweep_stream_options from;
  if (Status status = read_options(given, from); !status.ok()) return status;
  auto executor = executor_of(from.executor);
  if (!executor) return executor.status();
  const Result<VectorIsa> isa = isa_of(from.isa);
  if (!isa) return isa.status();
  StreamOptions options{.threads = from.threads,
                        .executor = *executor,
                        .isa = *isa,
                        .margin = from.margin,
                        .max_pairs = from.max_pairs};
  if (from.trace != nullptr) options.trace = from.trace;
  Status status = hand_out(make_broadphase(options), made);
  if (status.ok() && *executor) (*executor)->keep();
  return status;
}

Status create_named(const char* engine, std::span<const cellsweep_setting> settings,
                    cellsweep_broadphase** made) {
  SettingValues values;
  for (const cellsweep_setting& setting : settings) {
    const Status status = check({{setting.name, "name"}, {setting.value, "value"}});
    if (!status.ok()) return status;
    values.emplace_back(setting.name, setting.value);
  }
  return hand_out(make_broadphase(engine, values), made);
}

/// The row of the table at a place; null where there is none.
const EngineInfo* row_at(std::size_t place) {
  const std::span<const EngineInfo> table = engine_table();
  return place < table.size() ? &table[place] : nullptr;
}

}  // namespace

cellsweep_status cellsweep_create(const cellsweep_stream_options* options, cellsweep_broadphase** made,
                                  cellsweep_failure* failure) {
  return call(failure, {{made, "made"}}, [&] { return create_stream(options, made); });
}

cellsweep_status cellsweep_create_engine(const char* engine, const cellsweep_setting* settings,
                                         size_t setting_count, cellsweep_broadphase** made,
                                         cellsweep_failure* failure) {
  const void* some = setting_count == 0 ? static_cast<const void*>(engine) : settings;
  return call(failure, {{engine, "engine"}, {some, "settings"}, {made, "made"}}, [&] {
    return create_named(engine, {settings, setting_count}, made);
  });
}

void cellsweep_destroy(cellsweep_broadphase* broadphase) {
  delete broadphase;
}

size_t cellsweep_engine_count(void) {
  return engine_table().size();
}

const char* cellsweep_engine_at(size_t place) {
  const EngineInfo* row = row_at(place);
  return row == nullptr ? nullptr : row->name.data();
}

const char* cellsweep_engine_summary(size_t place) {
  const EngineInfo* row = row_at(place);
  return row == nullptr ? nullptr : row->summary.data();
}

const char* cellsweep_version(void) {
  return CELLSWEEP_VERSION;
}

cellsweep_status cellsweep_set_allocator(const cellsweep_allocator* allocator, cellsweep_failure* failure) {
  return call(failure, {{allocator, "allocator"}}, [&] {
    if (Status status = check({{reinterpret_cast<void*>(allocator->take), "take"},
                               {reinterpret_cast<void*>(allocator->give), "give"}});
        !status.ok()) {
      return status;
    }
    if (set_memory_source({allocator->take, allocator->give, allocator->context})) return Status{};
    return Status::bad_input(
        "The library holds memory from elsewhere: set the allocator before all other calls.");
  });
}
