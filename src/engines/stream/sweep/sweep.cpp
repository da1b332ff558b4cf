#include "engines/stream/sweep/sweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>

#include "base/tuning.h"
#include "engines/stream/cells/box_sample.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {
namespace {

/// Numbers on the axis of the order, at least and at most.
constexpr std::uint32_t kFewestPlaces = 256;
constexpr std::uint32_t kMostPlaces = 4096;
/// Room behind the last byte for a vector.
constexpr std::size_t kPadding = 64;

/// The axis by which boxes are put in order: the one on which they are shortest by its length.
struct Order {
  unsigned axis = 0;
  std::uint32_t places = kFewestPlaces;
};

/// A box is to reach over some places, or most of those who share one with it would not meet it.
Order choose_order(const BoxSample& sample) {
  const std::array<double, 3> edges = {sample.extents.x, sample.extents.y, sample.extents.z};
  Order order;
  double longest = -1;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double length = sample.axes[axis].length;
    const double edges_long = length / (edges[axis] + 1e-4 * length + DBL_MIN);
    if (edges_long > longest) longest = edges_long, order.axis = axis;
  }
  const double wanted = std::clamp<double>(tuning::kPlacesOfEdge * longest, kFewestPlaces, kMostPlaces);
  order.places = std::bit_ceil(static_cast<std::uint32_t>(wanted));
  return order;
}

}  // namespace

// NaN becomes 0.
inline Int4 Sweep::NumberMap::operator()(Float4 coordinates) const {
  const Float4 zero{};
  Float4 numbers = (coordinates - origin) * scale;
  numbers = numbers > zero ? numbers : zero;
  numbers = numbers < top ? numbers : top;
  return __builtin_convertvector(numbers, Int4);
}

// Where boxes were some updates ago they mostly still are. Where that is not so, it costs to sort them twice.
bool Sweep::find(const Kernels& kernels, std::span<const Aabb> boxes, Keys& found) {
  const bool knows = knows_where(boxes);
  std::uint32_t count = 0;
  if (knows) {
    ++sweeps_;
    count = sort(boxes);
  }
  if (!knows || !pays(kernels, count)) {
    learn(boxes);
    count = sort(boxes);
    if (!pays(kernels, count)) return false;
  }
  const std::size_t before = found.view().size();
  const bool all = find_pairs(kernels, boxes, count, found.buffer());
  if (!all) found.shrink(before);
  found.leave_out();
  return all;
}

// As far as a few of them tell: most must not lie at the ends of an axis.
bool Sweep::knows_where(std::span<const Aabb> boxes) const {
  constexpr std::size_t kLookedAt = 32;
  if (sweeps_ == 0 || sweeps_ >= tuning::kSweepsOfSample || boxes.size() != slots_known_) return false;
  const Int4 top = __builtin_convertvector(map_.top, Int4);
  std::size_t beyond = 0;
  for (std::size_t slot = 0; slot < boxes.size(); slot += boxes.size() / kLookedAt + 1) {
    const BoxLanes box(boxes[slot]);
    const Int4 is_beyond = ((map_(box.min) == top) | (map_(box.max) == 0)) & (map_.scale > 0);
    beyond += (is_beyond[0] | is_beyond[1] | is_beyond[2]) != 0 ? 1 : 0;
  }
  return beyond < kLookedAt / 4;
}

// How many there are.
std::uint32_t Sweep::sort(std::span<const Aabb> boxes) {
  const std::uint32_t count = make_rows(boxes);
  sort_rows(count);
  compared_ = 0;
  for (std::uint32_t place = 0; place < count; ++place) compared_ += ends_.view()[place] - place;
  return count;
}

void Sweep::learn(std::span<const Aabb> boxes) {
  const BoxSample sample = take_sample({boxes.data(), boxes.size()}, Look::at_few);
  const Order order = choose_order(sample);
  axis_ = order.axis;
  places_ = order.places;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double numbers = axis == axis_ ? places_ : 256;
    // A few boxes lie beyond what the sample knows of; on the axis of the order they would share two places.
    const double beyond = axis == axis_ ? sample.axes[axis].length / 8 : 0;
    const double length = sample.axes[axis].length + 2 * beyond;
    map_.origin[axis] = static_cast<float>(std::max(sample.axes[axis].origin - beyond, double{-FLT_MAX}));
    map_.scale[axis] = length > 0 ? static_cast<float>(std::min(numbers / length, double{FLT_MAX})) : 0;
    map_.top[axis] = static_cast<float>(numbers - 1);
  }
  sweeps_ = 1;
  slots_known_ = boxes.size();
}

// How many there are.
std::uint32_t Sweep::make_rows(std::span<const Aabb> boxes) {
  const unsigned x = axis_, y = (x + 1) % 3, z = (x + 2) % 3;
  const NumberMap map = map_;
  rows_.renew(boxes.size());
  slots_.renew(boxes.size());
  std::uint32_t count = 0;
  for (std::uint32_t slot = 0; slot < boxes.size(); ++slot) {
    const BoxLanes box(boxes[slot]);
    const Int4 low = map(box.min);
    const Int4 high = map(box.max);
    rows_.data()[count] = {static_cast<std::uint16_t>(low[x]), static_cast<std::uint16_t>(high[x]),
                           static_cast<std::uint8_t>(low[y]),  static_cast<std::uint8_t>(high[y]),
                           static_cast<std::uint8_t>(low[z]),  static_cast<std::uint8_t>(high[z])};
    slots_.data()[count] = slot;
    count += boxes[slot].min[0] <= boxes[slot].max[0] ? 1 : 0;  // NaN: nobody
  }
  return count;
}

// By counting.
void Sweep::sort_rows(std::uint32_t count) {
  const std::size_t room = count + kPadding;
  sorted_.renew(count);
  ends_.renew(count);
  bytes_.renew(4 * room);
  std::array<std::uint32_t, kMostPlaces + 1> first;  // NOLINT(*-member-init): as far as it is read
  std::array<std::uint32_t, kMostPlaces> next;       // NOLINT(*-member-init)
  std::fill_n(first.begin(), places_ + 1, 0U);
  for (const Row& row : rows_.view().first(count)) ++first[row.low_x + 1];
  for (std::uint32_t place = 0; place < places_; ++place) {
    next[place] = first[place];
    first[place + 1] += first[place];
  }
  std::uint8_t* const bytes = bytes_.data();
  for (std::uint32_t i = 0; i < count; ++i) {
    const Row row = rows_.data()[i];
    const std::uint32_t place = next[row.low_x]++;
    sorted_.data()[place] = slots_.data()[i];
    ends_.data()[place] = first[row.high_x + 1];
    bytes[place] = row.low_y;
    bytes[room + place] = row.high_y;
    bytes[2 * room + place] = row.low_z;
    bytes[3 * room + place] = row.high_z;
  }
}

bool Sweep::pays(const Kernels& kernels, std::uint32_t count) const {
  // A vector holds four times as many bytes as boxes.
  return compared_ <= std::uint64_t{4} * kernels.lanes * tuning::kVectorsOfSwept * count;
}

bool Sweep::find_pairs(const Kernels& kernels, std::span<const Aabb> boxes, std::uint32_t count,
                       KeyBuffer& found) {
  const std::size_t room = count + kPadding;
  const std::uint8_t* const bytes = bytes_.data();
  const SweptBoxes swept{bytes, bytes + room, bytes + 2 * room, bytes + 3 * room, ends_.data(), count};
  hits_.renew(kHits);
  tests_ += compared_;
  const std::size_t before = found.size;
  std::uint64_t tests = 0;
  for (std::uint32_t place = 0; place < count;) {
    const std::uint32_t hits = kernels.sweep(swept, place, hits_.data(), kHits);
    const std::uint64_t more = test(boxes, hits_.view().first(hits), found);
    tests += more;
    tests_ += more;
    if (tests > 4 * (found.size - before) + std::uint64_t{tuning::kTestsOfSwept} * count) return false;
  }
  return true;
}

// The pairs of these hits that are some. How many hits there were.
std::uint64_t Sweep::test(std::span<const Aabb> boxes, std::span<const SweptHits> hits,
                          KeyBuffer& found) const {
  std::uint64_t tests = 0;
  const std::uint32_t* const slots = sorted_.data();
  for (const SweptHits& hit : hits) {
    const Slot slot = slots[hit.place];
    const BoxLanes box(boxes[slot]);
    make_room(found, 64);
    for (std::uint64_t lanes = hit.lanes; lanes != 0; lanes &= lanes - 1) {
      const Slot other = slots[hit.first + static_cast<unsigned>(std::countr_zero(lanes))];
      found.keys[found.size] = pair_key(make_slot_pair(slot, other));
      found.size += overlap(box, BoxLanes(boxes[other])) ? 1 : 0;
      ++tests;
    }
  }
  return tests;
}

std::size_t Sweep::bytes() const {
  return rows_.bytes() + slots_.bytes() + sorted_.bytes() + ends_.bytes() + bytes_.bytes() + hits_.bytes();
}

}  // namespace cellsweep::stream
