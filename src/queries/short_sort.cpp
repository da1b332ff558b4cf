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
/// And more neighbors or touches than that. EPYC: sixteen take 90 ns, where std::sort takes 250.
constexpr std::size_t kMostCounted = 64;

double number_of(const Neighbor& neighbor) {
  return neighbor.distance;
}
double number_of(const Touch& touch) {
  return touch.time;
}

/// Numbers side by side, and where each belongs among them: behind those that are less, and behind the same
/// ones that stand before it.
class CountedPlaces {
 public:
  template <class Answer>
  explicit CountedPlaces(std::span<const Answer> answers) {
    const std::size_t count = answers.size();
    for (std::size_t i = 0; i < count; ++i) numbers_[i] = number_of(answers[i]);
    if (count % kLanes != 0) numbers_[count] = 0;
    for (std::size_t first = 0; first < count; first += kLanes) count_before(first, count);
  }

  double number(std::size_t i) const { return numbers_[i]; }
  std::size_t operator[](std::size_t i) const { return static_cast<std::size_t>(places_[i]); }

 private:
  static constexpr std::size_t kLanes = 2;
  using Numbers [[gnu::vector_size(16)]] = double;
  using Places [[gnu::vector_size(16)]] = std::int64_t;

  // Of a vector; a zero behind the last number is put somewhere, too, and nobody asks where.
  void count_before(std::size_t first, std::size_t count) {
    Numbers these;
    std::memcpy(&these, &numbers_[first], sizeof(these));
    Places before{};
    for (std::size_t i = 0; i < first; ++i) before -= numbers_[i] <= these;
    for (std::size_t i = first; i < count; ++i) before -= numbers_[i] < these;
    std::memcpy(&places_[first], &before, sizeof(before));
    // Those of the vector itself were held to be behind each other where they are the same.
    if (first + 1 < count) places_[first + 1] += numbers_[first] == numbers_[first + 1] ? 1 : 0;
  }

  std::array<double, kMostCounted> numbers_;       // NOLINT(*-member-init): as far as it is read
  std::array<std::int64_t, kMostCounted> places_;  // NOLINT(*-member-init): as far as it is read
};

template <class Answer, class Before>
void sort_answers(std::span<Answer> answers, Before before) {
  if (answers.size() < kFewestCounted || answers.size() > kMostCounted)
    return std::sort(answers.begin(), answers.end(), before);
  const CountedPlaces places{std::span<const Answer>(answers)};
  std::array<BodyId, kMostCounted> bodies;  // NOLINT(*-member-init): as far as it is read
  for (std::size_t i = 0; i < answers.size(); ++i) bodies[i] = answers[i].body;
  for (std::size_t i = 0; i < answers.size(); ++i) answers[places[i]] = {bodies[i], places.number(i)};
  for (std::size_t i = 1; i < answers.size(); ++i) {
    for (std::size_t at = i; at > 0 && before(answers[at], answers[at - 1]); --at)
      std::swap(answers[at], answers[at - 1]);
  }
}

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
  sort_answers(neighbors, Nearer());
}

void sort_touches(std::span<Touch> touches) {
  sort_answers(touches, Sooner());
}

}  // namespace cellsweep::queries
