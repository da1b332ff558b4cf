#include "cellsweep/c/history.h"

#include <memory>

#include "bindings/c/call.h"
#include "bindings/c/objects.h"
#include "bindings/c/views.h"

using namespace cellsweep;
using namespace cellsweep::c;

namespace {

Status check_changes(const cellsweep_changes& changes) {
  return check({{changes.began_count == 0 ? &changes : static_cast<const void*>(changes.began), "began"},
                {changes.ended_count == 0 ? &changes : static_cast<const void*>(changes.ended), "ended"}});
}

}  // namespace

cellsweep_status cellsweep_history_create(size_t most_pairs, cellsweep_history** made,
                                          cellsweep_failure* failure) {
  return call(failure, {{made, "made"}}, [&] {
    *made = std::make_unique<cellsweep_history>(most_pairs).release();
    return Status{};
  });
}

void cellsweep_history_destroy(cellsweep_history* history) {
  delete history;
}

cellsweep_status cellsweep_history_record(cellsweep_history* history, uint64_t update_number,
                                          const cellsweep_changes* changes, cellsweep_failure* failure) {
  return call(failure, {{history, "history"}, {changes, "changes"}}, [&] {
    if (Status status = check_changes(*changes); !status.ok()) return status;
    return history->history.record(update_number,
                                   {seen_as<const Pair>(changes->began, changes->began_count),
                                    seen_as<const Pair>(changes->ended, changes->ended_count)});
  });
}

cellsweep_status cellsweep_history_since(cellsweep_history* history, uint64_t update_number,
                                         cellsweep_changes* changes, cellsweep_failure* failure) {
  return call(failure, {{history, "history"}, {changes, "changes"}}, [&] {
    const Result<PairChanges> since = history->history.since(update_number);
    if (since) *changes = changes_of(*since);
    return since.status();
  });
}
