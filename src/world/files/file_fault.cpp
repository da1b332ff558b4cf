#include "world/files/file_fault.h"

#include <charconv>
#include <cmath>
#include <utility>

namespace cellsweep {
namespace {

template <class Number>
std::string shortest_text(Number number) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), end.ptr};
}

std::string expectation(std::string_view expected, std::string_view found) {
  return ": expected " + std::string(expected) + ", found " + std::string(found);
}

}  // namespace

Status bad_recording(std::string message) {
  Status status;
  status.code = StatusCode::bad_input;
  status.message = std::move(message);
  return status;
}

Status fault_at(std::uint64_t offset, std::string_view expected, std::string_view found) {
  return bad_recording("byte " + std::to_string(offset) + expectation(expected, found));
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 48;
  std::string result = "\"";
  for (const char c : text.substr(0, kLongest)) result += c >= ' ' && c <= '~' ? c : '?';
  result += text.size() > kLongest ? "...\"" : "\"";
  return result;
}

std::string number_text(float number) {
  return shortest_text(number);
}
std::string number_text(double number) {
  return shortest_text(number);
}

std::string_view corner_name(std::size_t corner) {
  static constexpr std::array<std::string_view, 6> kNames = {"min x", "min y", "min z",
                                                             "max x", "max y", "max z"};
  return kNames[corner];
}

template <class Number>
std::optional<BoxFault> find_fault(const Corners<Number>& box) {
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!std::isfinite(box[i])) {
      return BoxFault{i, "a finite " + std::string(corner_name(i)), number_text(box[i])};
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (box[i] <= box[i + 3]) continue;
    std::string expected(corner_name(i));
    expected.append(" <= ").append(corner_name(i + 3));
    std::string found = number_text(box[i]);
    found.append(" > ").append(number_text(box[i + 3]));
    return BoxFault{i, std::move(expected), std::move(found)};
  }
  return std::nullopt;
}

template std::optional<BoxFault> find_fault(const Corners<float>&);
template std::optional<BoxFault> find_fault(const Corners<double>&);

Status check_file_size(const BoxBlock& block, std::uint64_t file_bytes) {
  const std::string claim = std::to_string(block.frames) + " frames of " + std::to_string(block.bodies) +
                            " boxes of " + std::to_string(block.box_bytes) + " bytes from byte " +
                            std::to_string(block.offset);
  const std::uint64_t room = (file_bytes - block.offset) / block.box_bytes;
  if (block.bodies != 0 && block.frames > room / block.bodies) {
    return fault_at(file_bytes, claim, "the end of the file");
  }
  const std::uint64_t end = block.offset + block.frames * block.bodies * block.box_bytes;
  if (end < file_bytes) {
    return fault_at(end, "the end of the file after " + claim,
                    std::to_string(file_bytes - end) + " more bytes");
  }
  return {};
}

Status box_fault_at(const BoxBlock& block, std::uint64_t box, std::uint64_t place, const BoxFault& fault) {
  const std::uint64_t body = box % block.bodies;
  Status status = bad_recording("byte " + std::to_string(block.offset + box * block.box_bytes + place) +
                                " (frame " + std::to_string(box / block.bodies) + ", body " +
                                std::to_string(body) + ")" + expectation(fault.expected, fault.found));
  status.body = static_cast<BodyId>(body);
  return status;
}

}  // namespace cellsweep
