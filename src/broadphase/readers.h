/// @file
/// How many queries read a Broadphase: known in debug builds, where changing it meanwhile fails an assertion.
#pragma once

#include <atomic>

namespace cellsweep {

class Readers {
 public:
#ifdef NDEBUG
  void enter() {}
  void leave() {}
#else
  void enter() {
    ++count_;
  }
  void leave() {
    --count_;
  }
  bool none() const {
    return count_ == 0;
  }

 private:
  std::atomic<int> count_ = 0;
#endif
};

/// One more while it lives.
class Reading {
 public:
  explicit Reading(Readers& readers) : readers_(readers) { readers_.enter(); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  ~Reading() { readers_.leave(); }

 private:
  Readers& readers_;
};

}  // namespace cellsweep
