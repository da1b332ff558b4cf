#include "isa/libc/scan_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>
#include <vector>

#include "isa/libc/wide_text.h"

namespace spu_emu::isa {

namespace {
/// Characters of one item at most, where the format sets no width.
constexpr std::size_t kLongestItem = 0x40000;

/// One conversion as the format spells it.
struct ScanConversion {
  bool suppressed = false;
  std::size_t width = 0;
  char length = 0;  // h, H (hh), l, q (ll, L, j), or 0
  char letter = 0;
  std::string set;  // of %[
  bool inverted = false;
};

class Scanner {
 public:
  Scanner(StoreBytes& store, ScanSource& source, const std::string& format, ArgumentList& arguments)
      : store_(store), source_(source), format_(format), arguments_(arguments) {}

  int scan() {
    while (at_ < format_.size()) {
      if (!step()) return ended_ && stored_ == 0 && !matched_ ? EOF : stored_;
    }
    return stored_;
  }

 private:
  char peek() const { return at_ < format_.size() ? format_[at_] : '\0'; }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  int next() {
    ++consumed_;
    return source_.next();
  }
  void give_back(int c) {
    --consumed_;
    if (c == EOF) ended_ = true;
    source_.give_back(c);
  }
  static bool is_space(int c) { return c != EOF && std::isspace(c) != 0; }

  void skip_space() {
    int c = next();
    while (is_space(c)) c = next();
    give_back(c);
  }

  /// Matches one element of the format; false ends the scan.
  bool step() {
    if (is_space(static_cast<unsigned char>(peek()))) {
      ++at_;
      skip_space();
      return true;
    }
    if (!take('%')) return match(format_[at_++]);
    const ScanConversion conversion = read_conversion();
    if (conversion.letter == '%') {
      skip_space();
      return match('%');
    }
    return convert(conversion);
  }

  bool match(char wanted) {
    const int c = next();
    if (c == static_cast<unsigned char>(wanted)) return true;
    give_back(c);
    return false;
  }

  ScanConversion read_conversion() {
    ScanConversion result;
    result.suppressed = take('*');
    for (; std::isdigit(static_cast<unsigned char>(peek())) != 0; ++at_) {
      result.width = std::min(kLongestItem, result.width * 10 + static_cast<std::size_t>(peek() - '0'));
    }
    if (result.width == 0) result.width = kLongestItem;
    result.length = length();
    result.letter = peek();
    if (at_ < format_.size()) ++at_;
    if (result.letter == 'C' || result.letter == 'S') {
      result.length = 'l';
      result.letter = result.letter == 'C' ? 'c' : 's';
    }
    if (result.letter == '[') read_set(result);
    return result;
  }

  char length() {
    if (take('h')) return take('h') ? 'H' : 'h';
    if (take('l')) return take('l') ? 'q' : 'l';
    if (take('L') || take('q') || take('j')) return 'q';
    if (take('z') || take('t')) return '\0';
    return '\0';
  }

  void read_set(ScanConversion& conversion) {
    conversion.inverted = take('^');
    if (take(']')) conversion.set += ']';
    for (; peek() != '\0' && peek() != ']'; ++at_) {
      const bool range =
          peek() == '-' && !conversion.set.empty() && at_ + 1 < format_.size() && format_[at_ + 1] != ']';
      if (!range) {
        conversion.set += peek();
        continue;
      }
      const int last = static_cast<unsigned char>(format_[++at_]);
      for (int c = static_cast<unsigned char>(conversion.set.back()) + 1; c <= last; ++c) {
        conversion.set += static_cast<char>(c);
      }
    }
    take(']');
  }

  bool convert(const ScanConversion& conversion) {
    const bool blank_counts = std::strchr("c[n", conversion.letter) != nullptr;
    if (!blank_counts) skip_space();
    switch (conversion.letter) {
      case 'd':
      case 'u':
        return scan_integer(conversion, 10);
      case 'i':
        return scan_integer(conversion, 0);
      case 'o':
        return scan_integer(conversion, 8);
      case 'x':
      case 'X':
      case 'p':
        return scan_integer(conversion, 16);
      case 'e':
      case 'E':
      case 'f':
      case 'F':
      case 'g':
      case 'G':
      case 'a':
      case 'A':
        return scan_real(conversion);
      case 's':
        return scan_text(conversion, [](int c) { return !is_space(c); });
      case '[':
        return scan_text(conversion, [&](int c) {
          return (conversion.set.find(static_cast<char>(c)) != std::string::npos) != conversion.inverted;
        });
      case 'c':
        return scan_characters(conversion);
      case 'n':
        if (!conversion.suppressed) store_integer(conversion, consumed_);
        return true;
      default:
        return false;
    }
  }

  /// The longest run of characters that `wanted` takes, the width at most.
  template <class Wanted>
  std::string item(std::size_t width, Wanted&& wanted) {
    std::string text;
    while (text.size() < width) {
      const int c = next();
      if (c == EOF || !wanted(c, text)) {
        give_back(c);
        break;
      }
      text += static_cast<char>(c);
    }
    return text;
  }

  bool scan_integer(const ScanConversion& conversion, int base) {
    const std::string text = item(conversion.width, [base](int c, const std::string& before) {
      const std::string_view digits(before);
      const std::size_t sign = !digits.empty() && (digits[0] == '-' || digits[0] == '+') ? 1 : 0;
      if (c == '-' || c == '+') return digits.empty();
      if (c == 'x' || c == 'X') return (base == 0 || base == 16) && digits.substr(sign) == "0";
      const bool hexadecimal =
          base == 16 || (base == 0 && digits.size() > sign + 1 && std::tolower(digits[sign + 1]) == 'x');
      return hexadecimal ? std::isxdigit(c) != 0 : std::isdigit(c) != 0;
    });
    char* end = nullptr;
    errno = 0;
    const auto value = static_cast<std::uint64_t>(
        text.empty() || text[0] == '-' ? std::strtoll(text.c_str(), &end, base)
                                       : static_cast<long long>(std::strtoull(text.c_str(), &end, base)));
    if (text.empty() || end == text.c_str()) return false;
    if (!conversion.suppressed) store_result([&] { store_integer(conversion, value); });
    return true;
  }

  bool scan_real(const ScanConversion& conversion) {
    const std::string text = item(conversion.width, [](int c, const std::string& before) {
      const bool after_exponent = !before.empty() && std::strchr("eEpP", before.back()) != nullptr;
      if (c == '-' || c == '+') return before.empty() || after_exponent;
      return std::isalnum(c) != 0 || c == '.';
    });
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || end == text.c_str()) return false;
    if (!conversion.suppressed) store_result([&] { store_real(conversion, value); });
    return true;
  }

  /// Characters of UTF-8, `most` at most, as long as `wanted` takes their first byte; nothing if one is none.
  template <class Wanted>
  std::optional<std::vector<std::uint32_t>> wide_item(std::size_t most, Wanted&& wanted) {
    std::vector<std::uint32_t> characters;
    while (characters.size() < most) {
      const int c = next();
      if (c == EOF || !wanted(c)) {
        give_back(c);
        break;
      }
      std::string bytes(1, static_cast<char>(c));
      const unsigned size = bytes_behind(static_cast<unsigned char>(c));
      if (size > 1) bytes += item(size - 1, [](int, const std::string&) { return true; });
      const auto character = character_of(bytes);
      if (!character) return std::nullopt;
      characters.push_back(*character);
    }
    return characters;
  }

  template <class Wanted>
  bool scan_wide(const ScanConversion& conversion, std::size_t least, std::size_t most, bool is_ended,
                 Wanted&& wanted) {
    const auto characters = wide_item(most, wanted);
    if (!characters || characters->size() < least) return false;
    if (conversion.suppressed) return true;
    store_result([&] {
      std::uint32_t address = arguments_.next_word();
      for (const std::uint32_t character : *characters) {
        store_.set_word(address, character);
        address += 4;
      }
      if (is_ended) store_.set_word(address, 0);
    });
    return true;
  }

  template <class Wanted>
  bool scan_text(const ScanConversion& conversion, Wanted&& wanted) {
    if (conversion.length == 'l') return scan_wide(conversion, 1, conversion.width, true, wanted);
    const std::string text = item(conversion.width, [&](int c, const std::string&) { return wanted(c); });
    if (text.empty()) return false;
    if (!conversion.suppressed) store_result([&] { store_text(text.c_str(), text.size() + 1); });
    return true;
  }

  bool scan_characters(const ScanConversion& conversion) {
    const std::size_t count = conversion.width == kLongestItem ? 1 : conversion.width;
    if (conversion.length == 'l') return scan_wide(conversion, count, count, false, [](int) { return true; });
    const std::string text = item(count, [](int, const std::string&) { return true; });
    if (text.size() < count) return false;
    if (!conversion.suppressed) store_result([&] { store_text(text.data(), text.size()); });
    return true;
  }

  template <class Store>
  void store_result(Store&& store) {
    store();
    ++stored_;
    matched_ = true;
  }

  void store_text(const char* text, std::size_t size) {
    store_.write(arguments_.next_word(), std::as_bytes(std::span(text, size)));
  }

  void store_integer(const ScanConversion& conversion, std::uint64_t value) {
    const std::uint32_t address = arguments_.next_word();
    if (conversion.length == 'q') return store_.set_doubleword(address, value);
    std::array<std::byte, 4> bytes{};
    write_word(bytes.data(), static_cast<std::uint32_t>(value));
    const std::size_t size = conversion.length == 'H' ? 1 : conversion.length == 'h' ? 2 : 4;
    store_.write(address, std::span<const std::byte>(bytes).last(size));
  }

  void store_real(const ScanConversion& conversion, double value) {
    const std::uint32_t address = arguments_.next_word();
    const bool is_double = conversion.length == 'l' || conversion.length == 'q';
    if (is_double) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      return store_.set_doubleword(address, bits);
    }
    const auto single = static_cast<float>(value);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &single, sizeof bits);
    store_.set_word(address, bits);
  }

  StoreBytes& store_;
  ScanSource& source_;
  const std::string& format_;
  ArgumentList& arguments_;
  std::size_t at_ = 0;
  std::uint64_t consumed_ = 0;
  int stored_ = 0;
  bool matched_ = false;
  bool ended_ = false;
};
}  // namespace

int scan_format(StoreBytes& store, ScanSource& source, const std::string& format, ArgumentList& arguments) {
  return Scanner(store, source, format, arguments).scan();
}

}  // namespace spu_emu::isa
