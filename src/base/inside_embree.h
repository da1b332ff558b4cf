/// @file
/// Tells the thread sanitizer what it cannot see: Embree and its threads are not instrumented, so that what
/// they do among themselves, and work handed to them and taken back, looks like races. Nothing in other
/// builds.
#pragma once

#if defined(__SANITIZE_THREAD__)
#define CELLSWEEP_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CELLSWEEP_THREAD_SANITIZER
#endif
#endif

#ifdef CELLSWEEP_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
// In spite of their names, writes too.
extern "C" void AnnotateIgnoreReadsBegin(const char* file, int line);
extern "C" void AnnotateIgnoreReadsEnd(const char* file, int line);
#endif

namespace cellsweep::embree {

#ifdef CELLSWEEP_THREAD_SANITIZER

/// Around a call into Embree that returns when all its threads are done. Accesses are not watched in it.
class InsideEmbree {
 public:
  explicit InsideEmbree(const void* address) : address_(const_cast<void*>(address)) {
    __tsan_release(address_);
    AnnotateIgnoreReadsBegin(__FILE__, __LINE__);
    ++depth();
  }
  ~InsideEmbree() {
    --depth();
    AnnotateIgnoreReadsEnd(__FILE__, __LINE__);
    __tsan_acquire(address_);
  }
  InsideEmbree(const InsideEmbree&) = delete;
  InsideEmbree& operator=(const InsideEmbree&) = delete;

  /// How many of them this thread is in; 0 on a thread of Embree's.
  static int& depth() {
    static thread_local int depth = 0;
    return depth;
  }

 private:
  void* address_;
};

/// Around the work of a function of ours that Embree calls within InsideEmbree of the same address. Accesses
/// are watched again.
class CalledByEmbree {
 public:
  explicit CalledByEmbree(const void* address) : address_(const_cast<void*>(address)) {
    __tsan_acquire(address_);
    if (InsideEmbree::depth() > 0) AnnotateIgnoreReadsEnd(__FILE__, __LINE__);
  }
  ~CalledByEmbree() {
    if (InsideEmbree::depth() > 0) AnnotateIgnoreReadsBegin(__FILE__, __LINE__);
    __tsan_release(address_);
  }
  CalledByEmbree(const CalledByEmbree&) = delete;
  CalledByEmbree& operator=(const CalledByEmbree&) = delete;

 private:
  void* address_;
};

#else

struct InsideEmbree {
  explicit InsideEmbree(const void*) {}
  ~InsideEmbree() {}
};
struct CalledByEmbree {
  explicit CalledByEmbree(const void*) {}
  ~CalledByEmbree() {}
};

#endif

}  // namespace cellsweep::embree
