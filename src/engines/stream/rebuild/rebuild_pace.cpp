#include "engines/stream/rebuild/rebuild_pace.h"

#include <algorithm>

namespace cellsweep::stream {
namespace {

/// What an update has time for that is to take no longer than `longest`, and has something to do besides.
double time_for_part(double longest, double besides, double most) {
  return std::clamp(longest - besides, 0.0, most);
}

}  // namespace

void RebuildPace::begin(std::uint32_t parts, double seconds) {
  parts_ = parts;
  const double most = most_of_part(parts) * seconds / parts;
  const double longest = longest_update(seconds, most);
  double sum = 0;
  for (std::uint32_t part = 1; part <= parts; ++part)
    due_[part] = sum += time_for_part(longest, besides_[parts - part], most);
  for (std::uint32_t part = 1; part <= parts; ++part)
    due_[part] = sum > 0 ? due_[part] / sum : static_cast<double>(part) / parts;
}

// Of all parts together, which take so many seconds, the longer the longer an update may be.
double RebuildPace::longest_update(double seconds, double most) const {
  constexpr int kHalvings = 30;
  const auto known = besides_.begin();
  const auto [least, largest] = std::minmax_element(known, known + parts_);
  double low = *least;
  double high = *largest + seconds;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = (low + high) / 2;
    double sum = 0;
    for (std::uint32_t left = 0; left < parts_; ++left) sum += time_for_part(middle, besides_[left], most);
    (sum < seconds ? low : high) = middle;
  }
  return high;
}

// Half of what is known is new.
void RebuildPace::note(std::uint32_t part, double seconds) {
  if (part > parts_) return;
  double& besides = besides_[parts_ - part];
  besides = besides > 0 ? (besides + seconds) / 2 : seconds;
}

}  // namespace cellsweep::stream
