#include "engines/embree/embree_engine.h"

#include <memory>
#include <vector>

#include "base/settings.h"
#include "base/text.h"
#include "cellsweep/engine/phase_timer.h"

namespace cellsweep::embree {
namespace {

std::vector<SettingRow<EmbreeOptions>> setting_rows() {
  return {
      {{"threads", SettingKind::number, "0", "worker threads of Embree's own; 0: one for each core"},
       [](EmbreeOptions& options, std::string_view value) { return read_number(options.threads, value); }},
      {{"trace", SettingKind::text, "", "write a timeline that opens in Perfetto: calls and phases"},
       [](EmbreeOptions& options, std::string_view value) { return read_text(options.trace, value); }}};
}

/// All devices of a process share Embree's threads.
Status wrong_process_status() {
  return Status::bad_input(
      "Embree's threads did not come along when fork() made this process, and Embree starts no others; use "
      "another engine in it.");
}

Result<Broadphase> make_from(const SettingValues& values) {
  const auto options = read_settings<EmbreeOptions>("embree", values, setting_rows());
  return options ? make_broadphase(*options) : options.status();
}

}  // namespace

Capacity EmbreeEngine::capacity() const {
  return {kSlotMask, "", text("a slot's number has ", kSlotBits, " bits")};
}

Result<FoundPairs> EmbreeEngine::update(const BodyChanges& changes, Statistics& statistics) {
  PhaseTimer timer(statistics.phases);
  FoundPairs found;
  found.is_whole_set = !changes.none();
  const bool any_pair = found.is_whole_set && changes.bodies > 1;
  if (any_pair) collider_.build(changes.boxes);
  builds_ += any_pair ? 1 : 0;
  timer.lap("build tree");
  if (any_pair) found.more_began = collider_.find_pairs();
  timer.lap("collide");
  statistics.counters = {{"trees built", builds_}, {"candidates", collider_.candidates()}};
  statistics.bytes += collider_.bytes();
  return found;
}

}  // namespace cellsweep::embree

namespace cellsweep {

Result<Broadphase> make_broadphase(const EmbreeOptions& options) {
  const auto maker = [threads = options.threads]() -> Result<std::unique_ptr<Engine>> {
    static const ProcessMark first;
    if (!first.is_this_process()) return embree::wrong_process_status();
    return std::unique_ptr<Engine>(std::make_unique<embree::EmbreeEngine>(threads));
  };
  return EngineAccess::make("embree", maker, options.trace, "embree");
}

void add_embree_engine() {
  add_engine({"embree",
              "for comparison: a ray tracer's tree over all boxes, built anew and run against itself",
              describe_settings<EmbreeOptions>(embree::setting_rows()), embree::make_from});
}

}  // namespace cellsweep
