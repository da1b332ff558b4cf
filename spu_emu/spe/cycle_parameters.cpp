#include <cmath>
#include <stdexcept>

#include "mfc/format.h"
#include "spu_emu/cycles.h"

namespace spu_emu {

namespace {

using Whole = std::uint32_t CycleParameters::*;
using Real = double CycleParameters::*;

constexpr std::string_view kTables = "Cell BE Programming Handbook and GCC's spu.md agree";
constexpr std::string_view kHandbook = "Cell BE Programming Handbook";
constexpr std::string_view kAssumed = "assumed; no figure is published";

constexpr CycleParameter kParameters[] = {
    {"hertz", "SPU cycles per second", "QS20, QS21, QS22 and PlayStation 3: 3.2 GHz", 1},
    {"fixed_latency", "result of add, logic, compare, select; cycles", kTables, 1},
    {"shift_latency", "result of word shifts and rotates; cycles", kTables, 1},
    {"byte_latency", "result of byte operations; cycles", kTables, 1},
    {"float_latency", "result of single-precision add, multiply, multiply-add; cycles", kTables, 1},
    {"multiply_latency", "result of integer multiply, conversion, interpolation; cycles", kTables, 1},
    {"double_latency", "result of double precision; cycles", kTables, 1},
    {"shuffle_latency", "result of shuffles, quadword shifts, gathers, estimates; cycles", kTables, 1},
    {"load_latency", "result of a load; cycles", kTables, 1},
    {"branch_latency", "the link register of a branch; cycles", kTables, 1},
    {"channel_latency", "result of a channel read; cycles",
     "Cell BE Programming Handbook; GCC's spu.md has 4", 1},
    {"double_block", "nothing issues after a double-precision instruction; cycles",
     "Cell BE Programming Handbook and GCC's spu.md; 0 on the PowerXCell 8i of a QS22", 0},
    {"branch_miss", "nothing issues after a branch that went elsewhere than predicted; cycles",
     "Cell BE Programming Handbook: 18 or 19", 0},
    {"hint_lead", "from a hint until its branch is taken without a gap; cycles",
     "Cell BE Programming Handbook: 11 and four instruction pairs", 0},
    {"hint_seen", "a hint with fewer instructions between it and its branch is not seen",
     "GCC's spu.c: 8; the Handbook: four instruction pairs", 0},
    {"fetch_starved", "wait for instructions when loads and stores left the port no cycle; cycles", kAssumed,
     0},
    {"dma_start", "from the write of the command channel until the MFC begins; cycles", kAssumed, 0},
    {"dma_element", "each element of a list after the first; cycles", kAssumed, 0},
    {"memory_latency", "first byte from or to main memory; cycles",
     "measured on blades: 500 to 1,000; the middle", 0},
    {"local_store_latency", "first byte from or to another local store; cycles",
     "measured on blades: below 100 ns, 320 cycles", 0},
    {"bus_line", "what a transfer takes of the bus at least, and in steps of; bytes", kHandbook, 1},
    {"memory_bytes_per_cycle", "main memory, all SPEs together; bytes a cycle", "25.6 GB/s at 3.2 GHz", 1e-6},
    {"port_bytes_per_cycle", "one SPE's port of the bus, each way; bytes a cycle", "25.6 GB/s at 3.2 GHz",
     1e-6},
    {"sharing_spes", "SPEs that share main memory, each getting its part always",
     "set by the host program: how many it uses", 1},
};

struct Place {
  Whole whole = nullptr;
  Real real = nullptr;
};

/// In the order of kParameters.
constexpr Place kPlaces[] = {{nullptr, &CycleParameters::hertz},
                             {&CycleParameters::fixed_latency},
                             {&CycleParameters::shift_latency},
                             {&CycleParameters::byte_latency},
                             {&CycleParameters::float_latency},
                             {&CycleParameters::multiply_latency},
                             {&CycleParameters::double_latency},
                             {&CycleParameters::shuffle_latency},
                             {&CycleParameters::load_latency},
                             {&CycleParameters::branch_latency},
                             {&CycleParameters::channel_latency},
                             {&CycleParameters::double_block},
                             {&CycleParameters::branch_miss},
                             {&CycleParameters::hint_lead},
                             {&CycleParameters::hint_seen},
                             {&CycleParameters::fetch_starved},
                             {&CycleParameters::dma_start},
                             {&CycleParameters::dma_element},
                             {&CycleParameters::memory_latency},
                             {&CycleParameters::local_store_latency},
                             {&CycleParameters::bus_line},
                             {nullptr, &CycleParameters::memory_bytes_per_cycle},
                             {nullptr, &CycleParameters::port_bytes_per_cycle},
                             {&CycleParameters::sharing_spes}};
static_assert(std::size(kParameters) == std::size(kPlaces));

std::size_t index_of(std::string_view name) {
  for (std::size_t i = 0; i < std::size(kParameters); ++i) {
    if (kParameters[i].name == name) return i;
  }
  throw std::invalid_argument("there is no cycle parameter \"" + std::string(name) + "\"");
}

bool is_allowed(double value, double least, bool whole) {
  constexpr double kMost = 1e12;
  constexpr double kMostWhole = 1e6;
  const bool in_range = value >= least && value <= (whole ? kMostWhole : kMost);
  return in_range && (!whole || value == std::floor(value));
}

}  // namespace

std::span<const CycleParameter> cycle_parameters() {
  return kParameters;
}

double cycle_parameter(const CycleParameters& parameters, std::string_view name) {
  const Place& place = kPlaces[index_of(name)];
  return place.real != nullptr ? parameters.*place.real : parameters.*place.whole;
}

void set_cycle_parameter(CycleParameters& parameters, std::string_view name, double value) {
  const std::size_t index = index_of(name);
  const Place& place = kPlaces[index];
  if (!is_allowed(value, kParameters[index].least, place.real == nullptr)) {
    throw std::invalid_argument(format("cycle parameter %.*s cannot be %g%s", static_cast<int>(name.size()),
                                       name.data(), value,
                                       place.real == nullptr ? "; it is a whole number up to 1000000" : ""));
  }
  if (place.real != nullptr) {
    parameters.*place.real = value;
  } else {
    parameters.*place.whole = static_cast<std::uint32_t>(value);
  }
}

void set_cycle_parameter(CycleParameters& parameters, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string text = equals == std::string::npos ? "" : assignment.substr(equals + 1);
  std::size_t used = 0;
  double value = 0;
  try {
    value = std::stod(text, &used);
  } catch (const std::logic_error&) {
    used = 0;
  }
  if (used == 0 || used != text.size()) {
    throw std::invalid_argument("\"" + assignment + "\" is not NAME=VALUE of a cycle parameter");
  }
  set_cycle_parameter(parameters, std::string_view(assignment).substr(0, equals), value);
}

}  // namespace spu_emu
