#include "ranks/checkpoint/seal.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/text.h"
#include "cellsweep/pair.h"
#include "ranks/checkpoint/file_fault.h"

namespace cellsweep::ranks {
namespace {

constexpr std::string_view kTitle = "cellsweep checkpoint, version 1\n";
constexpr std::size_t kBlock = std::size_t{1} << 20;
constexpr int kHex = 16;

std::string seal_text(const Seal& seal) {
  std::array<char, 24> digits{};
  const char* end = std::to_chars(digits.data(), digits.data() + digits.size(), seal.checksum, kHex).ptr;
  std::string words =
      text(kTitle, "bytes ", seal.bytes, "\nchecksum ",
           std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())), '\n');
  words.resize(kSealBytes, '\0');
  return words;
}

// The number that stands behind `name`; 0 where there is none.
std::uint64_t number_behind(std::string_view words, std::string_view name, int base) {
  std::uint64_t number = 0;
  const std::size_t at = words.find(name);
  if (at != std::string_view::npos)
    std::from_chars(words.data() + at + name.size(), words.data() + words.size(), number, base);
  return number;
}

}  // namespace

Result<std::uint64_t> file_bytes(const std::string& path) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) return Status::bad_input(text("Cannot read ", path, ": ", error.message(), "."));
  return std::uint64_t{bytes};
}

Result<Seal> read_seal(const std::string& path) {
  const auto bytes = file_bytes(path);
  if (!bytes) return bytes.status();
  std::string words(kSealBytes, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(words.data(), kSealBytes);
  if (!words.starts_with(kTitle)) return Status::bad_input(text(path, " is no checkpoint of cellsweep."));
  const Seal seal{number_behind(words, "\nbytes ", 10), number_behind(words, "\nchecksum ", kHex)};
  if (words != seal_text(seal))
    return Status::bad_input(text(path, " was changed since it was written: in its first 512 bytes."));
  if (*bytes != seal.bytes) {
    return Status::bad_input(text(path, " was ", *bytes < seal.bytes ? "cut short" : "made longer",
                                  " since it was written: it has ", *bytes, " bytes, not ", seal.bytes, "."),
                             {}, *bytes, seal.bytes);
  }
  return seal;
}

Status write_seal(const std::string& path, const Seal& seal) {
  const std::string words = seal_text(seal);
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return write_fault(path, errno);
  const bool good =
      ::pwrite(file, words.data(), kSealBytes, 0) == static_cast<ssize_t>(kSealBytes) && ::fsync(file) == 0;
  const int error = errno;
  return ::close(file) == 0 && good ? Status() : write_fault(path, error);
}

Result<std::uint64_t> checksum_of_part(const std::string& path, std::uint64_t bytes, int part, int parts) {
  std::uint64_t checksum = 0;
  const std::uint64_t blocks = (bytes - kSealBytes + kBlock - 1) / kBlock;
  const auto end_of = [&](int number) {
    return blocks * static_cast<std::uint64_t>(number) / static_cast<std::uint64_t>(parts);
  };
  std::vector<char> block(kBlock);
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(kSealBytes + end_of(part) * kBlock));
  for (std::uint64_t number = end_of(part); number < end_of(part + 1); ++number) {
    const std::uint64_t begin = kSealBytes + number * kBlock;
    const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, bytes - begin));
    if (!file.read(block.data(), static_cast<std::streamsize>(size)))
      return Status::bad_input(text("Cannot read ", path, " at byte ", begin, "."));
    const auto crc = ::crc32(0, reinterpret_cast<const Bytef*>(block.data()), static_cast<uInt>(size));
    checksum ^= mix64(crc | number << 32);
  }
  return checksum;
}

}  // namespace cellsweep::ranks
