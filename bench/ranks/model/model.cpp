#include "ranks/model/model.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cellsweep::ranks_bench {
namespace {

// Of a message: how often a body's rows are told, in bytes (src/ranks/messages.h).
constexpr double kMoveBytes = 28;
constexpr double kEnterBytes = 88;
// A body that came somewhere leaves again where it came from or where it went to, and is then adopted there.
constexpr double kLeaveBytes = 48;
constexpr double kAdoptBytes = 32;
constexpr double kHeadBytes = 56;

struct Box {
  std::array<double, 3> low{};
  std::array<double, 3> high{};

  std::size_t longest() const {
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
      if (high[axis] - low[axis] > (high[longest] - low[longest]) * (1 + 1e-9)) longest = axis;
    }
    return longest;
  }
};

// As Zoltan cuts: half of the ranks on each side, and of the bodies as many as there are ranks.
void cut(const Box& box, int ranks, std::vector<Box>& regions) {
  if (ranks == 1) return regions.push_back(box);
  const std::size_t axis = box.longest();
  const int lower = (ranks + 1) / 2;
  const double place = box.low[axis] + (box.high[axis] - box.low[axis]) * lower / ranks;
  Box below = box;
  Box above = box;
  below.high[axis] = above.low[axis] = place;
  cut(below, lower, regions);
  cut(above, ranks - lower, regions);
}

// The share of unit cubes in the room that reach a region.
double share_that_reaches(const Box& region, double room) {
  double share = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
    share *= (region.high[axis] - std::max(region.low[axis] - 1, 0.0)) / room;
  return share;
}

// The share of unit cubes that have their lower corner in one region and reach the other.
double share_of_both(const Box& one, const Box& other, double room) {
  double share = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = std::max(one.low[axis], other.low[axis] - 1);
    const double high = std::min(one.high[axis], other.high[axis]);
    share *= std::max(0.0, high - low) / room;
  }
  return share;
}

// Half of the bodies that two regions share belong to one, half to the other, once they have moved about:
// there is a message where there is one of them, by chance.
double count_messages(const std::vector<Box>& regions, double bodies, double room) {
  double count = 0;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double shared = bodies * (share_of_both(regions[i], regions[k], room) +
                                      share_of_both(regions[k], regions[i], room));
      count += 2 * (1 - std::exp(-shared / 2));
    }
  }
  return count;
}

// Three agreements, each up and down a tree of ranks, the barrier of the round, and one message after
// another.
double network_ms(const Forecast& forecast, const Costs& costs) {
  const double levels = std::ceil(std::log2(forecast.ranks));
  const double messages = forecast.messages / forecast.ranks;
  const double bytes = forecast.bytes / forecast.ranks;
  return 1e-3 * costs.latency_us * (3 * 2 * levels + 2 * levels + messages) +
         1e3 * bytes / (costs.gigabytes_s * 1e9);
}

}  // namespace

Forecast foretell(double bodies, int ranks, const Costs& costs) {
  const double room = 2 * std::cbrt(bodies) - 1;
  std::vector<Box> regions;
  cut({{0, 0, 0}, {room, room, room}}, ranks, regions);
  double reached = 0;
  for (const Box& region : regions) reached += share_that_reaches(region, room);
  Forecast forecast{.bodies = bodies, .ranks = ranks, .ghosts = bodies * (reached - 1)};
  if (ranks == 1) forecast.ghosts = 0;
  forecast.messages = count_messages(regions, bodies, room);
  const double enters = forecast.ghosts * costs.enters_a_ghost;
  forecast.bytes = forecast.ghosts * kMoveBytes + enters * (kEnterBytes + (kLeaveBytes + kAdoptBytes) / 2) +
                   forecast.messages * kHeadBytes;
  forecast.compute_ms = 1e-6 * (bodies * costs.ns_a_body + forecast.ghosts * costs.ns_a_ghost) / ranks;
  forecast.network_ms = ranks == 1 ? 0 : network_ms(forecast, costs);
  return forecast;
}

double ghosts_of_a_rank(double bodies) {
  return 3 * 0.5 * std::pow(bodies, 2.0 / 3);
}

}  // namespace cellsweep::ranks_bench
