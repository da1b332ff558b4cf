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

/// Where numbers begin on an axis, and the length over which they are spread.
struct Spread {
  double origin;
  double length;
};

Spread ends_of(const AxisRange& range) {
  return {range.origin, range.length};
}

/// A few boxes lie beyond what the sample knows of; on the axis of the order they would share two places.
/// Where none of the sample lies far out, it has room for them; else they are few, or the sample would have
/// more.
Spread with_those_beyond(const AxisRange& range) {
  constexpr double kFarOut = 3;
  const double beyond = range.length / 8;
  const bool far_out = range.high - range.low > kFarOut * range.length;
  const double low = far_out ? range.origin : range.low;
  const double high = far_out ? range.origin + range.length : range.high;
  return {low - beyond, high - low + 2 * beyond};
}

/// The axis by which boxes are put in order: the one on which they are shortest by its length.
struct Order {
  unsigned axis = 0;
  Spread spread{};
  double edge = 1;  // of a box
};

/// A box is to reach over some places, or most of those who share one with it would not meet it.
Order choose_order(const BoxSample& sample) {
  const std::array<double, 3> edges = {sample.extents.x, sample.extents.y, sample.extents.z};
  Order order;
  double longest = -1;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double length = sample.axes[axis].length;
    const double edge = edges[axis] + 1e-4 * length + DBL_MIN;
    if (length <= longest * edge) continue;
    longest = length / edge;
    order = {axis, with_those_beyond(sample.axes[axis]), edge};
  }
  return order;
}

std::uint32_t places_for(const Order& order) {
  const double edges = order.spread.length / order.edge;
  const double wanted = std::clamp<double>(tuning::kPlacesOfEdge * edges, kFewestPlaces, kMostPlaces);
  return std::bit_ceil(static_cast<std::uint32_t>(wanted));
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
    count = sort(kernels, boxes);
  }
  if (!knows || !pays(kernels, count)) {
    learn(boxes);
    count = sort(kernels, boxes);
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
std::uint32_t Sweep::sort(const Kernels& kernels, std::span<const Aabb> boxes) {
  const std::uint32_t count = make_rows(kernels, boxes);
  sort_rows(count);
  compared_ = 0;
  for (std::uint32_t place = 0; place < count; ++place) compared_ += ends_.view()[place] - place;
  return count;
}

void Sweep::learn(std::span<const Aabb> boxes) {
  const BoxSample sample = take_rough_sample({boxes.data(), boxes.size()});
  const Order order = choose_order(sample);
  axis_ = order.axis;
  places_ = places_for(order);
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double numbers = axis == axis_ ? places_ : 256;
    const auto [origin, length] = axis == axis_ ? order.spread : ends_of(sample.axes[axis]);
    map_.origin[axis] = static_cast<float>(std::max(origin, double{-FLT_MAX}));
    map_.scale[axis] = length > 0 ? static_cast<float>(std::min(numbers / length, double{FLT_MAX})) : 0;
    map_.top[axis] = static_cast<float>(numbers - 1);
  }
  sweeps_ = 1;
  slots_known_ = boxes.size();
}

GridNumbers Sweep::numbers() const {
  GridNumbers numbers{};
  for (unsigned axis = 0; axis < 3; ++axis) {
    numbers.origin[axis] = map_.origin[axis];
    numbers.scale[axis] = map_.scale[axis];
    numbers.top[axis] = map_.top[axis];
  }
  return numbers;
}

// How many there are.
std::uint32_t Sweep::make_rows(const Kernels& kernels, std::span<const Aabb> boxes) {
  constexpr std::size_t kEight = 8;
  const GridNumbers map = numbers();
  rows_.renew(3 * (boxes.size() + kEight));
  std::uint32_t* const on_axis = rows_.data();
  std::uint32_t* const on_others = on_axis + room_of_rows();
  Slot* const slots = on_others + room_of_rows();
  std::array<Aabb, kEight> last;
  EightRows rows;
  std::uint32_t count = 0;
  for (std::uint32_t first = 0; first < boxes.size(); first += kEight) {
    const Aabb* eight = &boxes[first];
    if (const auto rest = boxes.subspan(first); rest.size() < kEight) {
      last.fill(kNobody);
      std::ranges::copy(rest, last.begin());
      eight = last.data();
    }
    kernels.eight_rows(eight, map, axis_, rows);
    for (std::uint32_t i = 0; i < kEight; ++i) {
      on_axis[count] = rows.on_axis[i];
      on_others[count] = rows.on_others[i];
      slots[count] = first + i;
      count += rows.there >> i & 1;
    }
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
  const std::uint32_t* const on_axis = rows_.data();
  const std::uint32_t* const on_others = on_axis + room_of_rows();
  const Slot* const slots = on_others + room_of_rows();
  const auto low = [=](std::uint32_t row) { return on_axis[row] & 0xffffU; };
  for (std::uint32_t i = 0; i < count; ++i) ++first[low(i) + 1];
  for (std::uint32_t place = 0; place < places_; ++place) {
    next[place] = first[place];
    first[place + 1] += first[place];
  }
  std::uint8_t* const bytes = bytes_.data();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t others = on_others[i];
    const std::uint32_t place = next[low(i)]++;
    sorted_.data()[place] = slots[i];
    ends_.data()[place] = first[(on_axis[i] >> 16) + 1];
    bytes[place] = static_cast<std::uint8_t>(others);
    bytes[room + place] = static_cast<std::uint8_t>(others >> 8);
    bytes[2 * room + place] = static_cast<std::uint8_t>(others >> 16);
    bytes[3 * room + place] = static_cast<std::uint8_t>(others >> 24);
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
  const SweptBoxes swept{bytes,        bytes + room,   bytes + 2 * room, bytes + 3 * room,
                         ends_.data(), sorted_.data(), boxes.data(),     count};
  tests_ += compared_;
  const SweepResult result = kernels.sweep(swept, std::uint64_t{tuning::kTestsOfSwept} * count, found);
  tests_ += result.tests;
  return result.found_all;
}

std::size_t Sweep::bytes() const {
  return rows_.bytes() + sorted_.bytes() + ends_.bytes() + bytes_.bytes();
}

}  // namespace cellsweep::stream
