#include "report/all_engines.h"

#include "base/text.h"
#ifdef CELLSWEEP_HAS_EMBREE
#include "cellsweep/embree.h"
#endif

namespace cellsweep::report {
namespace {

#ifndef CELLSWEEP_HAS_CELL
Status no_spes_status(std::string_view engine) {
  return Status::bad_option("engine",
                            text("Engine ", engine, " runs on no SPEs: this build has no engines that do."));
}
#endif

}  // namespace

#ifdef CELLSWEEP_HAS_CELL

std::optional<CellStatistics> statistics_of_spes(const Broadphase& engine) {
  return cell_statistics(engine);
}

Result<LocalStoreMap> local_store_of(std::string_view engine, const SettingValues& settings,
                                     std::uint64_t bodies) {
  return local_store_map(engine, settings, bodies);
}

Status insert_posed(Broadphase& engine, std::span<const BodyId> ids, std::span<const BodyPose> poses) {
  return insert_poses(engine, ids, poses);
}

Status move_posed(Broadphase& engine, std::span<const BodyId> ids, std::span<const BodyPose> poses) {
  return move_poses(engine, ids, poses);
}

#else

std::optional<CellStatistics> statistics_of_spes(const Broadphase&) {
  return std::nullopt;
}

Result<LocalStoreMap> local_store_of(std::string_view engine, const SettingValues&, std::uint64_t) {
  return no_spes_status(engine);
}

Status insert_posed(Broadphase& engine, std::span<const BodyId>, std::span<const BodyPose>) {
  return no_spes_status(engine.name());
}

Status move_posed(Broadphase& engine, std::span<const BodyId>, std::span<const BodyPose>) {
  return no_spes_status(engine.name());
}

#endif

std::uint64_t used_bytes(const LocalStoreMap& map) {
  std::uint64_t sum = 0;
  for (const LocalStorePart& part : map.parts) sum += part.bytes;
  return sum;
}

void add_all_engines() {
#ifdef CELLSWEEP_HAS_CELL
  add_cell_engines();
#endif
#ifdef CELLSWEEP_HAS_EMBREE
  add_embree_engine();
#endif
}

}  // namespace cellsweep::report
