#include "queries/short_sort.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace cellsweep::queries {
namespace {

/// Fewer are sorted as quickly by comparing two at a time.
constexpr std::size_t kFewestCounted = 5;
/// And more neighbors than that. EPYC: sixteen take 90 ns, where std::sort takes 250.
constexpr std::size_t kMostCounted = 64;

/// Distances side by side, and where each belongs among them: behind those that are less, and behind those as
/// far that stand before it.
class CountedPlaces {
 public:
  explicit CountedPlaces(std::span<const Neighbor> neighbors) {
    const std::size_t count = neighbors.size();
    for (std::size_t i = 0; i < count; ++i) distances_[i] = neighbors[i].distance;
    if (count % kLanes != 0) distances_[count] = 0;
    for (std::size_t first = 0; first < count; first += kLanes) count_before(first, count);
  }

  double distance(std::size_t i) const { return distances_[i]; }
  std::size_t operator[](std::size_t i) const { return static_cast<std::size_t>(places_[i]); }

 private:
  static constexpr std::size_t kLanes = 2;
  using Distances [[gnu::vector_size(16)]] = double;
  using Places [[gnu::vector_size(16)]] = std::int64_t;

  // Of a vector; a zero behind the last distance is put somewhere, too, and nobody asks where.
  void count_before(std::size_t first, std::size_t count) {
    Distances these;
    std::memcpy(&these, &distances_[first], sizeof(these));
    Places before{};
    for (std::size_t i = 0; i < first; ++i) before -= distances_[i] <= these;
    for (std::size_t i = first; i < count; ++i) before -= distances_[i] < these;
    std::memcpy(&places_[first], &before, sizeof(before));
    // Those of the vector itself were held to be behind each other where they are as far.
    if (first + 1 < count) places_[first + 1] += distances_[first] == distances_[first + 1] ? 1 : 0;
  }

  std::array<double, kMostCounted> distances_;     // NOLINT(*-member-init): as far as it is read
  std::array<std::int64_t, kMostCounted> places_;  // NOLINT(*-member-init): as far as it is read
};

}  // namespace

void sort_ids(const QueryKernels& kernels, std::span<BodyId> ids) {
  constexpr BodyId kTopBit = BodyId{1} << 31;  // the other way round, numbers with a sign are in their order
  const std::size_t count = ids.size();
  if (count < kFewestCounted || count > kMostRanked) return std::sort(ids.begin(), ids.end());
  constexpr std::size_t kRoom = kMostRanked + kRankedAtOnce;
  std::array<std::int32_t, kRoom> numbers;  // NOLINT(*-member-init): as far as it is read
  std::array<std::uint32_t, kRoom> places;  // NOLINT(*-member-init): as far as it is read
  for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<std::int32_t>(ids[i] ^ kTopBit);
  std::fill_n(&numbers[count], kRankedAtOnce, 0);
  kernels.rank(numbers.data(), static_cast<std::uint32_t>(count), places.data());
  for (std::size_t i = 0; i < count; ++i) ids[places[i]] = static_cast<BodyId>(numbers[i]) ^ kTopBit;
}

void sort_neighbors(std::span<Neighbor> neighbors) {
  if (neighbors.size() < kFewestCounted || neighbors.size() > kMostCounted)
    return std::sort(neighbors.begin(), neighbors.end(), Nearer());
  const CountedPlaces places(neighbors);
  std::array<BodyId, kMostCounted> bodies;  // NOLINT(*-member-init): as far as it is read
  for (std::size_t i = 0; i < neighbors.size(); ++i) bodies[i] = neighbors[i].body;
  for (std::size_t i = 0; i < neighbors.size(); ++i) neighbors[places[i]] = {bodies[i], places.distance(i)};
  for (std::size_t i = 1; i < neighbors.size(); ++i) {
    for (std::size_t at = i; at > 0 && Nearer()(neighbors[at], neighbors[at - 1]); --at)
      std::swap(neighbors[at], neighbors[at - 1]);
  }
}

}  // namespace cellsweep::queries
