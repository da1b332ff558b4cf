#include <algorithm>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "queries/arithmetic.h"
#include "queries/paths/path_walk.h"
#include "queries/questions.h"
#include "queries/short_sort.h"

namespace cellsweep::queries {
namespace {

using Candidates = std::span<const Candidate>;

// Not inlined: its caller would take a twentieth longer for the room that this needs (EPYC).
[[gnu::noinline]] bool any_candidate(const Asked& asked, const Path& path) {
  bool any = false;
  const Cast cast(path);
  walk_path(asked.world, path, [&](Candidates candidates) {
    for (const auto& [slot, box] : candidates) {
      if (!cast.touches(box, path.end) || !asked.world.is_answer(asked.filter, slot)) continue;
      any = true;
      return -1.0;
    }
    return path.end;
  });
  return any;
}

}  // namespace

// A body comes once for each cell in which the path meets it; its touch is the same each time.
void list_touches(const Asked& asked, const Path& path, std::vector<Touch>& found) {
  const auto before = static_cast<std::ptrdiff_t>(found.size());
  const Cast cast(path);
  walk_whole_path(asked.world, path, [&](Candidates candidates) {
    for (const auto& [slot, box] : candidates) {
      const auto time = cast.touch(box, path.end);
      if (time && asked.world.may_be_answer(asked.filter, slot))
        found.push_back({asked.world.id(slot), *time});
    }
    return path.end;
  });
  sort_touches(std::span(found).subspan(static_cast<std::size_t>(before)));
  auto end = std::unique(found.begin() + before, found.end());
  if (asked.filter.predicate) {
    end = std::remove_if(found.begin() + before, end,
                         [&](const Touch& touch) { return !asked.filter.predicate(touch.body); });
  }
  found.erase(end, found.end());
}

void visit_touches(const Asked& asked, const Path& path, FunctionRef<double(const Touch&, double)> visit) {
  std::unordered_set<Slot> seen;
  const Cast cast(path);
  double end = path.end;
  walk_path(asked.world, path, [&](Candidates candidates) {
    for (const auto& [slot, box] : candidates) {
      const auto time = cast.touch(box, end);
      if (!time || !seen.insert(slot).second || !asked.world.is_answer(asked.filter, slot)) continue;
      end = std::min(end, visit({asked.world.id(slot), *time}, end));
      if (!(end >= 0)) return -1.0;
    }
    return end;
  });
}

// With the tree most paths meet nobody whom they do not touch for certain.
bool any_touch(const Asked& asked, const Path& path) {
  const bool takes_everybody = !asked.filter.as && !asked.filter.predicate;
  if (!takes_everybody || asked.world.tree() == nullptr) return any_candidate(asked, path);
  bool any = false;
  const auto take = [&](Candidates candidates) {
    const Cast cast(path);
    for (const Candidate& candidate : candidates) any = any || cast.touches(candidate.box, path.end);
    return any ? -1.0 : path.end;
  };
  return walk_to_any(asked.world, path, take) || any;
}

std::optional<Touch> first_touch(const Asked& asked, const Path& path) {
  std::optional<Touch> first;
  const Cast cast(path);
  double end = path.end;
  walk_path(asked.world, path, [&](Candidates candidates) {
    for (const auto& [slot, box] : candidates) {
      const auto time = cast.touch(box, end);
      if (!time) continue;
      const Touch touch{asked.world.id(slot), *time};
      if (first && !Sooner()(touch, *first)) continue;
      if (!asked.world.is_answer(asked.filter, slot)) continue;
      first = touch;
      end = touch.time;
    }
    return end;
  });
  return first;
}

}  // namespace cellsweep::queries
