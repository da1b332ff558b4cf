#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "queries/arithmetic.h"
#include "queries/paths/path_numbers.h"
#include "queries/paths/path_walk.h"
#include "queries/questions.h"
#include "queries/short_sort.h"

namespace cellsweep::queries {
namespace {

using Candidates = std::span<const Candidate>;

/// A box as it lies in a node of the tree.
struct BoxInNode {
  const TreeNode& node;
  unsigned place;
};

double face_of(const BoxInNode& box, std::size_t number) {
  return box.node.faces[number][box.place];
}

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

/// The touch that is known to be the first by now. Ids are looked up at once, though only the last one is an
/// answer: until then it has come from memory (2 to 5 % of a ray's time).
class FirstTouch {
 public:
  FirstTouch(const Asked& asked, const Path& path) : asked_(asked), cast_(path), end_(path.end) {}

  template <class Box>
  void look_at(Slot slot, const Box& box) {
    const auto time = cast_.touch(box, end_);
    if (!time) return;
    const Touch touch{asked_.world.id(slot), *time};
    if (first_ && !Sooner()(touch, *first_)) return;
    if (!asked_.world.is_answer(asked_.filter, slot)) return;
    first_ = touch;
    end_ = touch.time;
  }

  double end() const { return end_; }
  const std::optional<Touch>& touch() const { return first_; }

 private:
  const Asked& asked_;
  Cast cast_;
  double end_;
  std::optional<Touch> first_;
};

/// The same in a tree, whose nodes have the boxes.
class FirstInTree {
 public:
  FirstInTree(FirstTouch& first, const Path& path) : first_(first), numbers_(path) {}

  const CastNumbers& numbers() const { return numbers_.numbers(); }

  static bool take(void* self, const TreeNode& node, std::uint32_t bodies) {
    auto& in_tree = *static_cast<FirstInTree*>(self);
    for (; bodies != 0; bodies &= bodies - 1) {
      const auto place = static_cast<unsigned>(std::countr_zero(bodies));
      in_tree.first_.look_at(node.content[place], BoxInNode{node, place});
    }
    in_tree.numbers_.end(in_tree.first_.end());
    return true;
  }

 private:
  FirstTouch& first_;
  PathNumbers numbers_;
};

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
  FirstTouch first(asked, path);
  if (const BoxTree* const tree = asked.world.tree()) {
    FirstInTree in_tree(first, path);
    asked.world.kernels().trees->cast(tree->nodes(), in_tree.numbers(), {FirstInTree::take, &in_tree});
  } else {
    walk_path(asked.world, path, [&](Candidates candidates) {
      for (const auto& [slot, box] : candidates) first.look_at(slot, box);
      return first.end();
    });
  }
  return first.touch();
}

}  // namespace cellsweep::queries
