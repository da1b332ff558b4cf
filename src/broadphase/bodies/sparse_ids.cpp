#include "broadphase/bodies/sparse_ids.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <random>

namespace cellsweep {
namespace {

// Where the system has no such numbers to give, the time and the place of the program have to do.
std::uint64_t first_key() {
  static const char place = 0;
  const auto time = static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
  const std::uint64_t key = mix64(time) ^ reinterpret_cast<std::uintptr_t>(&place);
  try {
    std::random_device device;
    return key ^ (std::uint64_t{device()} << 32 | device());
  } catch (const std::exception&) {
    return key;
  }
}

}  // namespace

std::uint64_t unforeseen_key() {
  static const std::uint64_t first = first_key();
  static std::atomic<std::uint64_t> count = 0;
  const std::uint64_t key =
      mix64(first + count.fetch_add(1, std::memory_order_relaxed) * 0x9e3779b97f4a7c15U);
  return key == 0 ? 1 : key;
}

}  // namespace cellsweep
