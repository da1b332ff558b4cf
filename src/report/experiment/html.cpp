#include "report/experiment/html.h"

#include <array>
#include <cstdint>
#include <regex>

#include "base/text.h"

namespace cellsweep::report {

std::string html_text(std::string_view words) {
  std::string result;
  for (const char c : words) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string html_element(std::string_view name, std::string_view content, std::string_view attributes) {
  return text("<", name, attributes.empty() ? "" : " ", attributes, ">", content, "</", name, ">\n");
}

std::string html_table(const std::vector<std::vector<std::string>>& rows) {
  std::string lines;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string cells;
    for (const std::string& cell : rows[i]) cells += html_element(i == 0 ? "th" : "td", html_text(cell));
    lines += html_element("tr", cells);
  }
  return html_element("div", html_element("table", lines), "class=\"table\"");
}

std::string html_list(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string lines;
  for (const auto& [name, value] : entries) {
    lines += html_element("dt", html_text(name)) + html_element("dd", html_text(value));
  }
  return html_element("dl", lines);
}

std::string inline_svg(std::string_view file, std::string_view description) {
  const std::size_t start = file.find("<svg");
  const std::size_t end = file.rfind("</svg>");
  if (start == std::string_view::npos || end == std::string_view::npos || end < start) return {};
  const std::string svg(file.substr(start, end + 6 - start));
  static const std::regex format_names(R"(\s+xmlns(:xlink)?\s*=\s*("[^"]*"|'[^']*'))");
  const std::string bare = std::regex_replace(svg, format_names, "");
  return text("<svg role=\"img\" aria-label=\"", html_text(description), "\"", bare.substr(4), "\n");
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t digit = 0; digit < 4; ++digit) {
      result += i + digit <= bytes.size() ? kDigits[three >> (18 - 6 * digit) & 63] : '=';
    }
  }
  return result;
}

}  // namespace cellsweep::report
