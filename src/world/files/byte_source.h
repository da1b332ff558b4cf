/// @file
/// Bytes that are read by their place, whatever holds them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace cellsweep {

/// As many bytes as it had when it was made. Any thread may read.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  virtual std::uint64_t size() const = 0;
  /// Copies those from `offset` on, as many as there are, and says how many that were; below zero it is the
  /// negated number of <cerrno> that says why there are none.
  virtual std::int64_t read_at(std::uint64_t offset, std::span<std::byte> bytes) const noexcept = 0;
};

/// Those that the caller holds.
class BytesInMemory final : public ByteSource {
 public:
  explicit BytesInMemory(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint64_t size() const override { return bytes_.size(); }
  std::int64_t read_at(std::uint64_t offset, std::span<std::byte> bytes) const noexcept override {
    if (offset >= bytes_.size()) return 0;
    const std::span<const std::byte> rest = bytes_.subspan(static_cast<std::size_t>(offset));
    const std::size_t count = std::min(rest.size(), bytes.size());
    std::copy_n(rest.begin(), count, bytes.begin());
    return static_cast<std::int64_t>(count);
  }

 private:
  std::span<const std::byte> bytes_;
};

/// A head that was made last, and what goes behind it.
class HeadedBytes final : public ByteSource {
 public:
  HeadedBytes(std::vector<std::byte> head, std::shared_ptr<const ByteSource> body)
      : head_(std::move(head)), body_(std::move(body)) {}

  std::uint64_t size() const override { return head_.size() + body_->size(); }
  std::int64_t read_at(std::uint64_t offset, std::span<std::byte> bytes) const noexcept override {
    if (offset < head_.size()) return BytesInMemory(head_).read_at(offset, bytes);
    return body_->read_at(offset - head_.size(), bytes);
  }

 private:
  std::vector<std::byte> head_;
  std::shared_ptr<const ByteSource> body_;
};

}  // namespace cellsweep
