/// @file
/// A value for each worker of a job.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace cellsweep {

/// Of a trivial type, to be written before they are read. Those of a few workers take no memory from
/// elsewhere: asking for it would be a good part of what a small job takes. Throws std::bad_alloc.
template <class T>
class PerWorker {
 public:
  explicit PerWorker(unsigned workers) : size_(workers) {
    if (workers > kFew) many_.resize(workers);
  }

  unsigned size() const { return size_; }
  T& operator[](unsigned worker) { return view()[worker]; }
  std::span<T> view() { return {size_ > kFew ? many_.data() : few_.data(), size_}; }

 private:
  static constexpr unsigned kFew = 16;

  unsigned size_;
  std::array<T, kFew> few_;  // NOLINT(*-member-init): its user writes them
  std::vector<T> many_;
};

}  // namespace cellsweep
