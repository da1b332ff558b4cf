#include "queries/tree/tree_update.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace cellsweep::queries {
namespace {

/// Nodes whose bodies' boxes are on their way to the cache.
constexpr std::uint32_t kAhead = 2;
constexpr std::uint32_t kAllPlaces = (1U << TreeNode::kBoxes) - 1;

Range no_box() {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  return {Four{kNaN, kNaN, kNaN, 0}, Four{kNaN, kNaN, kNaN, 0}};
}

Range range_of(const Aabb& box) {
  return {Four{box.min[0], box.min[1], box.min[2], 0}, Four{box.max[0], box.max[1], box.max[2], 0}};
}

bool same(const Range& a, const Range& b) {
  const FourPlaces lanes = (a.low == b.low) & (a.high == b.high);
  return (lanes[0] & lanes[1] & lanes[2]) != 0;
}

}  // namespace

std::uint32_t add_node(TreeNodes& nodes) {
  const auto number = static_cast<std::uint32_t>(nodes.size());
  nodes.emplace_back();
  for (float(&face)[TreeNode::kBoxes] : nodes.back().faces)
    std::ranges::fill(face, std::numeric_limits<float>::quiet_NaN());
  return number;
}

TreeUpdate::TreeUpdate(TreeNodes& nodes, Vector<std::uint32_t>& places, const BodyBoxes& bodies)
    : nodes_(nodes), places_(places), bodies_(bodies), touched_(nodes.size() / 64 + 1) {
  // Where all went away there may be fewer slots than there were.
  if (places.size() < bodies.boxes.size()) places.resize(bodies.boxes.size(), kNowhere);
}

bool TreeUpdate::put(std::span<const Slot> changed) {
  return std::ranges::all_of(changed, [&](Slot slot) { return put(slot); });
}

bool TreeUpdate::put(Slot slot) {
  if (slot >= places_.size()) return true;
  const std::uint32_t at = places_[slot];
  const std::uint32_t number = at / TreeNode::kBoxes;
  const unsigned place = at % TreeNode::kBoxes;
  if (!bodies_.has(slot)) {
    if (at != kNowhere) take_out(number, place);
    return true;
  }
  if (at == kNowhere) return insert(slot);
  put_range(nodes_[number], place, range_of(bodies_.boxes[slot]));
  touch(number);
  return true;
}

// Node by node: a face of all its boxes is a line of the cache.
bool TreeUpdate::put_all() {
  const auto nodes = static_cast<std::uint32_t>(nodes_.size());
  for (std::uint32_t number = 0; number < nodes; ++number) {
    if (number + kAhead < nodes) prefetch_boxes(nodes_[number + kAhead]);
    put_all_of(number);
  }
  for (Slot slot = 0; slot < bodies_.boxes.size(); ++slot) {
    if (places_[slot] == kNowhere && bodies_.has(slot) && !insert(slot)) return false;
  }
  return true;
}

void TreeUpdate::prefetch_boxes(const TreeNode& node) const {
  for (std::uint32_t rest = node.bodies; rest != 0; rest &= rest - 1) {
    const Slot slot = node.content[std::countr_zero(rest)];
    if (slot < bodies_.boxes.size()) __builtin_prefetch(&bodies_.boxes[slot]);
  }
}

void TreeUpdate::put_all_of(std::uint32_t number) {
  TreeNode& node = nodes_[number];
  for (std::uint32_t rest = node.bodies; rest != 0; rest &= rest - 1) {
    const auto place = static_cast<unsigned>(std::countr_zero(rest));
    const Slot slot = node.content[place];
    if (bodies_.has(slot)) {
      put_range(node, place, range_of(bodies_.boxes[slot]));
    } else {
      take_out(number, place);
    }
  }
  touch(number);
}

void TreeUpdate::take_out(std::uint32_t number, unsigned place) {
  TreeNode& node = nodes_[number];
  places_[node.content[place]] = kNowhere;
  node.bodies &= ~(1U << place);
  put_range(node, place, no_box());
  touch(number);
}

// A free place costs nothing: a node's boxes are tested all at once.
bool TreeUpdate::insert(Slot slot) {
  const Range range = range_of(bodies_.boxes[slot]);
  std::uint32_t number = 0;
  for (unsigned depth = 1; depth <= kTreeDepth; ++depth) {
    const TreeNode& node = nodes_[number];
    const std::uint32_t taken = node.bodies | node.nodes;
    if (taken != kAllPlaces) {
      insert_at(number, static_cast<unsigned>(std::countr_one(taken)), slot, range);
      return true;
    }
    const unsigned place = least_growth(node, range);
    if ((node.bodies >> place & 1) != 0) push_down(number, place);
    number = nodes_[number].content[place];
  }
  return false;
}

void TreeUpdate::insert_at(std::uint32_t number, unsigned place, Slot slot, const Range& range) {
  TreeNode& node = nodes_[number];
  node.bodies |= 1U << place;
  node.content[place] = slot;
  put_range(node, place, range);
  places_[slot] = place_in_tree(number, place);
  touch(number);
}

/// A body into a node of its own, in its place.
void TreeUpdate::push_down(std::uint32_t number, unsigned place) {
  const std::uint32_t next = add_node(nodes_);
  if (next / 64 >= touched_.size()) touched_.push_back(0);
  TreeNode& node = nodes_[number];
  const Range range = range_in(node, place);
  more_reach_ += range.reach();
  insert_at(next, 0, node.content[place], range);
  nodes_[next].above = place_in_tree(number, place);
  node.content[place] = next;
  node.bodies &= ~(1U << place);
  node.nodes |= 1U << place;
}

unsigned TreeUpdate::least_growth(const TreeNode& node, const Range& range) {
  unsigned best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (unsigned place = 0; place < TreeNode::kBoxes; ++place) {
    const Range before = range_in(node, place);
    Range after = range;
    after.add(before);
    // A body's box becomes that of a node, which is another one to go to.
    const double growth = after.weight() - ((node.nodes >> place & 1) != 0 ? before.weight() : 0);
    if (!(growth < least)) continue;
    least = growth;
    best = place;
  }
  return best;
}

double TreeUpdate::finish() {
  for (std::size_t word = touched_.size(); word-- > 0;) {
    while (touched_[word] != 0) {
      const auto bit = static_cast<unsigned>(std::bit_width(touched_[word]) - 1);
      touched_[word] ^= std::uint64_t{1} << bit;
      const auto number = static_cast<std::uint32_t>(word * 64 + bit);
      if (number != 0) finish(number);
    }
  }
  return more_reach_;
}

void TreeUpdate::finish(std::uint32_t number) {
  const std::uint32_t above = nodes_[number].above;
  TreeNode& node = nodes_[above / TreeNode::kBoxes];
  const unsigned place = above % TreeNode::kBoxes;
  const Range before = range_in(node, place);
  Range now = queries::range_of(nodes_[number]);
  if (same(before, now)) return;
  more_reach_ += now.reach() - before.reach();
  if (!(now.low[0] <= now.high[0])) now = no_box();
  put_range(node, place, now);
  touch(above / TreeNode::kBoxes);
}

}  // namespace cellsweep::queries
