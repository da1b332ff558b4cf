/// @file
/// What the experiment measures (E1-E5): the curves, and the times that each has a value of.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace cellsweep::report {

/// What of an engine's frame a curve shows.
enum class Part {
  frame,          ///< handing boxes over and update()
  spus,           ///< from the start of the SPU threads until all are done
  longest_spu,    ///< processor time of the SPU that worked longest: what it takes where each has a core
  simulated_cell  ///< on a Cell's clock, by the cycle model: the SPE that takes longest, threads running
                  ///< already
};

inline constexpr std::size_t kParts = 4;

/// A line of the figures.
struct Curve {
  std::string_view id;  ///< in files
  std::string_view label;
  std::string_view engine;  ///< a name that may be in the engine table
  Part part = Part::frame;
  std::string_view color;  ///< #rrggbb
};

/// All curves, also of engines that this build does not have.
std::span<const Curve> curve_table();

/// The times of an engine at one size.
enum class Measure {
  initial,  ///< all boxes new
  still,    ///< median frame in which nothing moves
  longest,  ///< longest frame of those in which some move
  median    ///< median frame of those
};

inline constexpr std::size_t kMeasures = 4;

/// A value for each Measure.
template <class T>
class PerMeasure {
 public:
  T& operator[](Measure measure) { return values_[static_cast<std::size_t>(measure)]; }
  const T& operator[](Measure measure) const { return values_[static_cast<std::size_t>(measure)]; }

 private:
  std::array<T, kMeasures> values_{};
};

inline constexpr std::array kAllMeasures = {Measure::initial, Measure::still, Measure::longest,
                                            Measure::median};

}  // namespace cellsweep::report
