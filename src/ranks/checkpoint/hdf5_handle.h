/// @file
/// What HDF5 opens, closed where its scope ends, and what it says where it fails.
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>

namespace cellsweep::ranks {

/// Of anything that HDF5 has a number for.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle(hid_t id, Close closing) : id_(id), close_(closing) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle() { close(); }

  bool ok() const { return id_ >= 0; }
  operator hid_t() const { return id_; }
  /// Now; false where it could not be.
  bool close() {
    const hid_t id = std::exchange(id_, -1);
    return id < 0 || close_(id) >= 0;
  }

 private:
  hid_t id_;
  Close close_;
};

/// While there is one, HDF5 prints no errors.
class QuietHdf5 {
 public:
  QuietHdf5() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &to_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, print_, to_); }

 private:
  H5E_auto2_t print_ = nullptr;
  void* to_ = nullptr;
};

/// Where the last call that failed did so first, in HDF5's words.
std::string hdf5_reason();

}  // namespace cellsweep::ranks
