/// @file
/// A Broadphase that Python's threads may share.
#pragma once

#include <pybind11/pybind11.h>

#include <mutex>
#include <shared_mutex>
#include <utility>

#include "cellsweep/broadphase.h"
#include "cellsweep/query.h"

namespace cellsweep::python {

/// Calls run without the interpreter's lock and behind one of the world's own, which those that change
/// nothing share: a program in Python must not be able to have two threads in an update.
class LockedWorld {
 public:
  explicit LockedWorld(Broadphase broadphase) : broadphase_(std::move(broadphase)) {}

  /// What `call(broadphase)` returns, with the world for itself.
  template <class Call>
  auto change(const Call& call) {
    const pybind11::gil_scoped_release released;
    const std::unique_lock lock(mutex_);
    return call(broadphase_);
  }

  /// What `call(broadphase)` returns, while nobody changes the world.
  template <class Call>
  auto look(const Call& call) const {
    const pybind11::gil_scoped_release released;
    const std::shared_lock lock(mutex_);
    return call(broadphase_);
  }

  /// What `call(queries)` returns.
  template <class Call>
  auto ask(const Call& call) const {
    return look([&](const Broadphase& broadphase) { return call(Queries(broadphase)); });
  }

 private:
  Broadphase broadphase_;
  mutable std::shared_mutex mutex_;
};

}  // namespace cellsweep::python
