#include "world/files/npy_header.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "world/files/file_fault.h"
#include "world/files/text_scanner.h"

namespace cellsweep {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kVersionOffset = 6;
constexpr std::size_t kLengthOffset = 8;
/// That of an array of numbers has a hundred; what is read of a file at first has room for this.
constexpr std::size_t kMostLength = 1'000'000;

/// A byte order, a kind of number, and its bytes.
bool is_known_type(std::string_view type) {
  constexpr std::string_view kBytes = "1248";
  if (type.size() != 3 || kBytes.find(type[2]) == std::string_view::npos) return false;
  if (type[0] != '<' && type[0] != '>' && type != "|b1" && type != "|u1" && type != "|i1") return false;
  return type[1] == 'u' || type[1] == 'i' || type == "|b1" || (type[1] == 'f' && type[2] > '2');
}

Status parse_descr(TextScanner& scanner, NpyHeader& header) {
  scanner.skip_space();
  header.type_offset = scanner.file_offset(scanner.position());
  std::string_view type;
  if (!scanner.take_string(type)) return scanner.expected("a string that names the type of the numbers");
  if (!is_known_type(type)) {
    return fault_at(header.type_offset, "numbers of a stated byte order (\"<f4\", \">i8\" ...) or \"|b1\"",
                    quoted(type));
  }
  header.type = type;
  return {};
}

Status parse_fortran_order(TextScanner& scanner) {
  scanner.skip_space();
  const std::size_t begin = scanner.position();
  const std::string_view word = scanner.take_word();
  if (word == "False") return {};
  if (word == "True") {
    return fault_at(scanner.file_offset(begin), "C order (fortran_order False)",
                    "Fortran order; save numpy.ascontiguousarray() of the array");
  }
  return fault_at(scanner.file_offset(begin), "True or False", quoted(word));
}

Status parse_shape(TextScanner& scanner, NpyHeader& header) {
  constexpr std::size_t kMostDimensions = 32;  // of NumPy
  scanner.skip_space();
  const std::size_t begin = scanner.position();
  header.shape_offset = scanner.file_offset(begin);
  if (!scanner.take('(')) return scanner.expected("the '(' of a shape");
  while (!scanner.take(')')) {
    if (!header.shape.empty() && !scanner.take(',')) return scanner.expected("',' or ')' in the shape");
    if (!header.shape.empty() && scanner.take(')')) break;
    std::uint64_t dimension = 0;
    if (!scanner.take_count(dimension)) {
      return scanner.expected("a number of 0 to 18446744073709551615 in the shape");
    }
    header.shape.push_back(dimension);
    if (header.shape.size() > kMostDimensions) return scanner.expected("at most 32 dimensions");
  }
  header.shape_text = scanner.text_from(begin);
  return {};
}

enum Key : std::size_t { kDescr, kFortranOrder, kShape };
constexpr std::array<std::string_view, 3> kKeys = {"descr", "fortran_order", "shape"};

Status parse_value(TextScanner& scanner, std::size_t key, NpyHeader& header) {
  if (key == kDescr) return parse_descr(scanner, header);
  if (key == kFortranOrder) return parse_fortran_order(scanner);
  return parse_shape(scanner, header);
}

Status parse_item(TextScanner& scanner, std::array<bool, 3>& seen, NpyHeader& header) {
  scanner.skip_space();
  const std::size_t begin = scanner.position();
  std::string_view name;
  if (!scanner.take_string(name)) return scanner.expected("a key in quotes");
  std::size_t key = 0;
  while (key < kKeys.size() && kKeys[key] != name) ++key;
  if (key == kKeys.size() || seen[key]) {
    return fault_at(scanner.file_offset(begin), "\"descr\", \"fortran_order\" and \"shape\", each once",
                    "key " + quoted(name) + (key == kKeys.size() ? "" : " again"));
  }
  seen[key] = true;
  if (!scanner.take(':')) return scanner.expected("':' after a key");
  return parse_value(scanner, key, header);
}

Status parse_dictionary(TextScanner& scanner, NpyHeader& header) {
  std::array<bool, 3> seen{};
  if (!scanner.take('{')) return scanner.expected("the '{' of a dictionary");
  for (bool first = true; !scanner.take('}'); first = false) {
    if (!first && !scanner.take(',')) return scanner.expected("',' or '}' after a value");
    if (!first && scanner.take('}')) break;
    if (Status status = parse_item(scanner, seen, header); !status.ok()) return status;
  }
  for (std::size_t key = 0; key < kKeys.size(); ++key) {
    if (seen[key]) continue;
    return fault_at(scanner.file_offset(scanner.position() - 1), "key " + quoted(kKeys[key]),
                    "the end of the dictionary");
  }
  scanner.skip_space();
  return scanner.at_end() ? Status{} : scanner.expected("nothing but space after the dictionary");
}

Status ends_early(Bytes file, std::string_view expected) {
  return fault_at(file.size(), expected, "the end of the file");
}

/// Where the dictionary is: after magic, version and a length of 2 bytes (version 1) or 4.
Status find_dictionary(Bytes file, std::size_t& begin, std::size_t& length) {
  for (std::size_t i = 0; i < kMagic.size(); ++i) {
    if (i == file.size()) return ends_early(file, "the magic string of .npy");
    if (static_cast<char>(file[i]) != kMagic[i]) {
      return fault_at(i, "the magic string of .npy, \"\\x93NUMPY\"", "another byte");
    }
  }
  if (file.size() < kLengthOffset) return ends_early(file, "a format version of 2 bytes");
  const auto major = std::to_integer<unsigned>(file[kVersionOffset]);
  const auto minor = std::to_integer<unsigned>(file[kVersionOffset + 1]);
  if (major < 1 || major > 3 || minor != 0) {
    return fault_at(kVersionOffset, "format version 1.0, 2.0 or 3.0",
                    std::to_string(major) + "." + std::to_string(minor));
  }
  begin = kLengthOffset + (major == 1 ? 2 : 4);
  if (file.size() < begin) return ends_early(file, "the length of the header");
  length = major == 1 ? load_word<std::uint16_t, ByteOrder::little>(file, kLengthOffset)
                      : load_word<std::uint32_t, ByteOrder::little>(file, kLengthOffset);
  if (length > kMostLength) {
    return fault_at(kLengthOffset, "a header of at most " + std::to_string(kMostLength) + " bytes",
                    "one of " + std::to_string(length));
  }
  if (file.size() - begin >= length) return {};
  return ends_early(file,
                    "a header of " + std::to_string(length) + " bytes from byte " + std::to_string(begin));
}

}  // namespace

Result<NpyHeader> parse_npy_header(std::span<const std::byte> file) {
  std::size_t begin = 0;
  std::size_t length = 0;
  if (Status status = find_dictionary(file, begin, length); !status.ok()) return status;

  const Bytes dictionary = file.subspan(begin, length);
  TextScanner scanner({reinterpret_cast<const char*>(dictionary.data()), dictionary.size()}, begin);
  NpyHeader header;
  if (Status status = parse_dictionary(scanner, header); !status.ok()) return status;
  header.data_offset = begin + length;
  return header;
}

std::string npy_header_bytes(std::string_view type, std::span<const std::uint64_t> shape) {
  constexpr std::size_t kAligned = 64;
  std::string dictionary = "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': (";
  for (std::size_t i = 0; i < shape.size(); ++i) {
    dictionary += (i > 0 ? ", " : "") + std::to_string(shape[i]);
  }
  dictionary += shape.size() == 1 ? ",), }" : "), }";
  // NumPy leaves room for a first dimension of 21 digits, which arrays that grow have.
  constexpr std::size_t kDigits = 21;
  const std::size_t digits = shape.empty() ? kDigits : std::to_string(shape[0]).size();
  dictionary.append(kDigits - std::min(digits, kDigits), ' ');
  const std::size_t begin = kLengthOffset + 2;
  const std::size_t total = (begin + dictionary.size() + 1 + kAligned - 1) / kAligned * kAligned;
  dictionary.resize(total - begin - 1, ' ');
  dictionary += '\n';
  std::string bytes(kMagic);
  bytes += {'\x01', '\x00', static_cast<char>(dictionary.size() & 0xff),
            static_cast<char>(dictionary.size() >> 8)};
  return bytes + dictionary;
}

}  // namespace cellsweep
