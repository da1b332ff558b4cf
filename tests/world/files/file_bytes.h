/// @file
/// Hand-made files for tests of the readers, put together without the project's writers.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace cellsweep {

/// Bytes that grow by texts and numbers.
class FileBytes {
 public:
  FileBytes& text(std::string_view characters) {
    for (const char c : characters) bytes_.push_back(static_cast<std::byte>(c));
    return *this;
  }

  FileBytes& byte(std::size_t value) {
    bytes_.push_back(static_cast<std::byte>(value & 0xff));
    return *this;
  }

  FileBytes& zeros(std::size_t count) {
    bytes_.insert(bytes_.end(), count, std::byte{0});
    return *this;
  }

  /// A text in a field of a fixed size, filled with NUL.
  FileBytes& field(std::string_view characters, std::size_t size) {
    return text(characters).zeros(size - characters.size());
  }

  template <class Number>
  FileBytes& number(Number value, bool big_endian = false) {
    using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
    const auto bits = std::bit_cast<Bits>(value);
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      const std::size_t shift = 8 * (big_endian ? sizeof(Number) - 1 - i : i);
      bytes_.push_back(static_cast<std::byte>((bits >> shift) & 0xff));
    }
    return *this;
  }

  template <class Number>
  FileBytes& numbers(std::initializer_list<Number> values, bool big_endian = false) {
    for (const Number value : values) number(value, big_endian);
    return *this;
  }

  template <class Number>
  FileBytes& put(std::size_t offset, Number value) {
    const FileBytes patch = FileBytes().number(value);
    for (std::size_t i = 0; i < patch.size(); ++i) bytes_[offset + i] = patch.bytes_[i];
    return *this;
  }

  FileBytes& fill(std::size_t offset, std::size_t count, char c) {
    for (std::size_t i = 0; i < count; ++i) bytes_[offset + i] = static_cast<std::byte>(c);
    return *this;
  }

  FileBytes& cut(std::size_t size) {
    bytes_.resize(size);
    return *this;
  }

  std::size_t size() const { return bytes_.size(); }
  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace cellsweep
