/// @file
/// What every function of cellsweep/c.h does around the one that it calls.
#pragma once

#include <initializer_list>

#include "cellsweep/c/status.h"
#include "cellsweep/status.h"

namespace cellsweep::c {

/// A pointer that must not be null, and what the header calls it.
struct Needed {
  const void* pointer;
  const char* name;
};

/// Bad input where one is null.
Status check(std::initializer_list<Needed> needed);

/// The number of a status, after it was written down unless `failure` is null or it is ok. Takes no memory.
cellsweep_status report(const Status& status, cellsweep_failure* failure);

/// The same for the exception that is being handled.
cellsweep_status report_exception(cellsweep_failure* failure) noexcept;

/// What `body()`, which returns a Status, comes to, if all that it needs is there.
template <class Body>
cellsweep_status call(cellsweep_failure* failure, std::initializer_list<Needed> needed,
                      const Body& body) noexcept {
  try {
    const Status missing = check(needed);
    return report(missing.ok() ? body() : missing, failure);
  } catch (...) {
    return report_exception(failure);
  }
}

}  // namespace cellsweep::c
