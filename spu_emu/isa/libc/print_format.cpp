#include "isa/libc/print_format.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <string_view>
#include <vector>

#include "isa/libc/wide_text.h"

namespace spu_emu::isa {

namespace {
/// Wide enough for any double in %f with kLargestNumber digits behind the point.
constexpr int kLargestNumber = 4096;

/// One conversion as the format spells it.
struct PrintConversion {
  std::string flags;
  int width = 0;
  int precision = -1;
  /// h, H (hh), l, q (ll, j is 64 bits too), or 0.
  char length = 0;
  char letter = 0;
};

class Printer {
 public:
  Printer(StoreBytes& store, const std::string& format, ArgumentList& arguments)
      : store_(store), format_(format), arguments_(arguments) {}

  PrintResult print() {
    while (at_ < format_.size()) {
      const std::size_t percent = std::min(format_.find('%', at_), format_.size());
      out_.append(format_, at_, percent - at_);
      at_ = percent;
      if (at_ < format_.size()) convert();
      if (out_.size() > kLongestPrint) return PrintResult{{}, EOVERFLOW};
      if (error_ != 0) return PrintResult{{}, error_};
    }
    return {std::move(out_), 0};
  }

 private:
  char peek() const { return at_ < format_.size() ? format_[at_] : '\0'; }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  static int bounded(std::int64_t number) {
    return static_cast<int>(std::clamp<std::int64_t>(number, -kLargestNumber, kLargestNumber));
  }

  int number() {
    if (take('*')) return bounded(static_cast<std::int32_t>(arguments_.next_word()));
    int value = 0;
    for (; peek() >= '0' && peek() <= '9'; ++at_) value = bounded(value * 10 + (peek() - '0'));
    return value;
  }

  char length() {
    if (take('h')) return take('h') ? 'H' : 'h';
    if (take('l')) return take('l') ? 'q' : 'l';
    if (take('L') || take('q') || take('j')) return 'q';
    if (take('z') || take('t')) return 'l';
    return '\0';
  }

  PrintConversion read_conversion() {
    PrintConversion result;
    constexpr std::string_view kFlags = "-+ #0'";
    for (; peek() != '\0' && kFlags.find(peek()) != kFlags.npos; ++at_) {
      if (result.flags.find(peek()) == result.flags.npos) result.flags += peek();
    }
    result.width = number();
    if (take('.')) result.precision = std::max(-1, number());
    result.length = length();
    result.letter = peek();
    if (at_ < format_.size()) ++at_;
    return result;
  }

  void convert() {
    const std::size_t begin = at_++;
    const PrintConversion conversion = read_conversion();
    switch (conversion.letter) {
      case 'd':
      case 'i':
        return print_integer(conversion, 'd', static_cast<long long>(signed_argument(conversion)));
      case 'u':
      case 'o':
      case 'x':
      case 'X':
        return print_integer(conversion, conversion.letter, unsigned_argument(conversion));
      case 'p':
        return print_pointer(conversion);
      case 'e':
      case 'E':
      case 'f':
      case 'F':
      case 'g':
      case 'G':
      case 'a':
      case 'A':
        return print_with(conversion, "", conversion.letter, arguments_.next_double());
      case 'c':
        if (conversion.length == 'l') return print_wide(conversion, bytes_of(arguments_.next_word()));
        return pad(conversion, std::string(1, static_cast<char>(arguments_.next_word())));
      case 'C':
        return print_wide(conversion, bytes_of(arguments_.next_word()));
      case 's':
        return conversion.length == 'l' ? print_wide_text(conversion) : print_text(conversion);
      case 'S':
        return print_wide_text(conversion);
      case 'n':
        return store_count(conversion);
      case '%':
        out_ += '%';
        return;
      default:
        out_.append(format_, begin, at_ - begin);
    }
  }

  std::int64_t signed_argument(const PrintConversion& conversion) {
    if (conversion.length == 'q') return static_cast<std::int64_t>(arguments_.next_doubleword());
    const std::uint32_t word = arguments_.next_word();
    if (conversion.length == 'H') return static_cast<std::int8_t>(word);
    if (conversion.length == 'h') return static_cast<std::int16_t>(word);
    return static_cast<std::int32_t>(word);
  }

  std::uint64_t unsigned_argument(const PrintConversion& conversion) {
    if (conversion.length == 'q') return arguments_.next_doubleword();
    const std::uint32_t word = arguments_.next_word();
    if (conversion.length == 'H') return static_cast<std::uint8_t>(word);
    if (conversion.length == 'h') return static_cast<std::uint16_t>(word);
    return word;
  }

  void print_pointer(PrintConversion conversion) {
    if (conversion.flags.find('#') == std::string::npos) conversion.flags += '#';
    print_integer(conversion, 'x', std::uint64_t{arguments_.next_word()});
  }

  template <class Value>
  void print_integer(const PrintConversion& conversion, char letter, Value value) {
    print_with(conversion, "ll", letter, static_cast<unsigned long long>(value));
  }

  /// Leaves one number to the host's printf, by a conversion put together here.
  template <class Value>
  void print_with(const PrintConversion& conversion, const char* length, char letter, Value value) {
    const std::string spelled = "%" + conversion.flags + "*.*" + length + letter;
    const char* host_format = spelled.c_str();
    std::array<char, 128> small{};
    const int size =
        std::snprintf(small.data(), small.size(), host_format, conversion.width, conversion.precision, value);
    if (size < 0) return;
    if (static_cast<std::size_t>(size) < small.size()) {
      out_.append(small.data(), static_cast<std::size_t>(size));
      return;
    }
    std::vector<char> large(static_cast<std::size_t>(size) + 1);
    std::snprintf(large.data(), large.size(), host_format, conversion.width, conversion.precision, value);
    out_.append(large.data(), static_cast<std::size_t>(size));
  }

  void print_text(const PrintConversion& conversion) {
    const std::uint32_t address = arguments_.next_word();
    const auto longest =
        conversion.precision < 0 ? UINT32_MAX : static_cast<std::uint32_t>(conversion.precision);
    pad(conversion, address == 0 ? std::string("(null)").substr(0, longest) : store_.text(address, longest));
  }

  /// What is no character ends the whole text.
  void print_wide(const PrintConversion& conversion, const std::optional<std::string>& bytes) {
    if (bytes) return pad(conversion, *bytes);
    error_ = EILSEQ;
  }

  void print_wide_text(const PrintConversion& conversion) {
    const std::uint32_t address = arguments_.next_word();
    const auto longest =
        conversion.precision < 0 ? UINT32_MAX : static_cast<std::uint32_t>(conversion.precision);
    if (address == 0) return pad(conversion, std::string("(null)").substr(0, longest));
    print_wide(conversion, wide_text(store_, address, longest));
  }

  void pad(const PrintConversion& conversion, const std::string& text) {
    const bool left = conversion.width < 0 || conversion.flags.find('-') != std::string::npos;
    const auto width = static_cast<std::size_t>(std::abs(conversion.width));
    const std::string blanks(width > text.size() ? width - text.size() : 0, ' ');
    out_ += left ? text + blanks : blanks + text;
  }

  void store_count(const PrintConversion& conversion) {
    const std::uint32_t address = arguments_.next_word();
    const std::array<std::byte, 4> bytes{std::byte(out_.size() >> 24U), std::byte(out_.size() >> 16U),
                                         std::byte(out_.size() >> 8U), std::byte(out_.size())};
    const std::span<const std::byte> all(bytes);
    if (conversion.length == 'H') return store_.write(address, all.last(1));
    if (conversion.length == 'h') return store_.write(address, all.last(2));
    if (conversion.length == 'q') return store_.set_doubleword(address, out_.size());
    store_.write(address, all);
  }

  StoreBytes& store_;
  const std::string& format_;
  ArgumentList& arguments_;
  std::size_t at_ = 0;
  std::string out_;
  int error_ = 0;
};
}  // namespace

PrintResult print_format(StoreBytes& store, const std::string& format, ArgumentList& arguments) {
  return Printer(store, format, arguments).print();
}

}  // namespace spu_emu::isa
