// Program images: from files and from memory, good and broken.
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "host/elf_image.h"
#include "test_context.h"

namespace spu_emu {
namespace {

std::vector<char> read_file(const char* name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct TemporaryFile {
  explicit TemporaryFile(const std::vector<char>& content, mode_t mode = 0755) {
    const int file = mkstemp(name.data());
    EXPECT_EQ(write(file, content.data(), content.size()), static_cast<ssize_t>(content.size()));
    fchmod(file, mode);
    close(file);
  }
  ~TemporaryFile() { unlink(name.data()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string name = testing::TempDir() + "spu_emu_image_XXXXXX";
};

TEST(Image, a_program_runs_from_a_file) {
  spe_program_handle_t* image = spe_image_open(SPU_EMU_PROBE_FILE);
  ASSERT_NE(image, nullptr);
  EXPECT_EQ(image->handle_size, sizeof(spe_program_handle_t));
  TestContext context;
  EXPECT_EQ(spe_program_load(context.spe, image), 0);
  EXPECT_EQ(spe_image_close(image), 0);
  EXPECT_EQ(context.exit_code(Probe::return_parameter, 8), 8);
}

TEST(Image, files_that_are_no_program_are_refused) {
  EXPECT_EQ(spe_image_open("/no/such/file"), nullptr);
  EXPECT_EQ(errno, ENOENT);
  EXPECT_EQ(spe_image_open(nullptr), nullptr);
  EXPECT_EQ(errno, EINVAL);
  const TemporaryFile text(std::vector<char>(200, 'x'));
  EXPECT_EQ(spe_image_open(text.name.c_str()), nullptr);
  EXPECT_EQ(errno, EINVAL);
  const TemporaryFile small({'\x7f', 'E', 'L', 'F'});
  EXPECT_EQ(spe_image_open(small.name.c_str()), nullptr);
  EXPECT_EQ(errno, EINVAL);
  const TemporaryFile plain(read_file(SPU_EMU_PROBE_FILE), 0644);
  EXPECT_EQ(spe_image_open(plain.name.c_str()), nullptr);
  EXPECT_EQ(errno, EACCES);
  auto half = read_file(SPU_EMU_PROBE_FILE);
  half.resize(half.size() / 2);
  const TemporaryFile cut(half);
  EXPECT_EQ(spe_image_open(cut.name.c_str()), nullptr);
  EXPECT_EQ(spe_image_close(nullptr), -1);
  EXPECT_EQ(errno, EINVAL);
}

TEST(Image, a_module_that_is_no_spu_program_is_refused) {
  TestContext context;
  std::vector<char> bytes(256, 0);
  spe_program_handle_t handle{sizeof handle, bytes.data(), nullptr};
  EXPECT_EQ(spe_program_load(context.spe, &handle), -1);
  EXPECT_EQ(errno, EINVAL);
  EXPECT_EQ(spe_program_load(context.spe, nullptr), -1);
  EXPECT_EQ(errno, EINVAL);
}

TEST(Image, a_broken_spu_elf_is_refused_with_a_reason) {
  std::vector<unsigned char> bytes(256, 0);
  const std::array<unsigned char, 7> ident{0x7f, 'E', 'L', 'F', 1, 2, 1};
  std::copy(ident.begin(), ident.end(), bytes.begin());
  bytes[19] = 23;
  spe_program_handle_t handle{sizeof handle, bytes.data(), nullptr};
  TestContext context;
  EXPECT_EQ(spe_program_load(context.spe, &handle), -1);
  EXPECT_EQ(errno, EINVAL);
  EXPECT_NE(last_fault(context.spe).find("broken SPU program"), std::string::npos) << last_fault(context.spe);
}

TEST(Image, broken_headers_never_lead_outside_the_file) {
  const auto file = read_file(SPU_EMU_PROBE_FILE);
  std::vector<std::byte> bytes(file.size());
  for (std::size_t at = 32; at < 512; ++at) {
    std::memcpy(bytes.data(), file.data(), file.size());
    for (const unsigned char value : {0x00, 0x7f, 0xff}) {
      bytes[at] = std::byte{value};
      std::string error;
      const auto prepared = prepare_module(bytes, error);
      EXPECT_EQ(prepared.has_value(), error.empty());
      if (!prepared) continue;
      for (const std::uint64_t word : prepared->zero_words) EXPECT_LE(word + sizeof word, file.size());
    }
  }
}

}  // namespace
}  // namespace spu_emu
