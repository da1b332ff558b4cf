// Loading files whose headers lie: each is loaded or refused in words, and nothing beyond its end is read.
#include <gtest/gtest.h>
#include <libspe2.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <sstream>

#include "host/elf_image.h"
#include "lies.h"
#include "spu_emu/emulation.h"

namespace spu_emu {
namespace {

constexpr std::size_t kMostBytes = std::size_t{4} << 20U;

FileBytes read_file(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  FileBytes result(bytes.size());
  std::transform(bytes.begin(), bytes.end(), result.begin(), [](char c) { return std::byte(c); });
  return result;
}

/// Those that the real compiler made, where it is there.
std::vector<FileBytes> real_spu_programs() {
  std::vector<FileBytes> files;
  std::istringstream names(SPU_EMU_REAL_FILES);
  for (std::string name; std::getline(names, name, ':');) files.push_back(read_file(name));
  return files;
}

EmulationSettings careful() {
  EmulationSettings settings;
  settings.library_calls = LibraryCallAccess::none;
  settings.instruction_limit = 100;
  return settings;
}

/// An SPE into which one file after the other is loaded, by both ways.
class LoadEverything {
 public:
  LoadEverything() {
    const SettingsScope scope(careful());
    spe_ = spe_context_create(SPE_EVENTS_ENABLE, nullptr);
  }
  ~LoadEverything() { spe_context_destroy(spe_); }
  LoadEverything(const LoadEverything&) = delete;
  LoadEverything& operator=(const LoadEverything&) = delete;

  void operator()(const FileBytes& file, const std::string& what) {
    if (files_++ % kEvery != 0) return;
    SCOPED_TRACE(what);
    const std::span<std::byte> image = memory_.put(file);
    expect_loaded_or_refused(program_load(spe_, image.data(), image.size()));
    spe_program_handle_t handle{sizeof handle, image.data(), nullptr};
    expect_loaded_or_refused(spe_program_load(spe_, &handle));
  }

  void run_what_loads() { run_ = true; }
  int loaded() const { return loaded_; }
  int refused() const { return refused_; }

 private:
  void expect_loaded_or_refused(int result) {
    if (result == 0) {
      ++loaded_;
      if (run_) run();
      return;
    }
    ++refused_;
    EXPECT_TRUE(errno == EINVAL || errno == ENOMEM) << errno;
    EXPECT_GT(last_fault(spe_).size(), 20U) << last_fault(spe_);
  }

  void run() {
    unsigned int entry = SPE_DEFAULT_ENTRY;
    spe_stop_info_t stop{};
    spe_context_run(spe_, &entry, SPE_NO_CALLBACKS, nullptr, nullptr, &stop);
    EXPECT_NE(stop.stop_reason, 0U);
  }

  /// A sanitizer's build takes ten times as long; every fifth file still meets each field.
#ifdef SPU_EMU_SANITIZED_TESTS
  static constexpr int kEvery = 5;
#else
  static constexpr int kEvery = 1;
#endif

  int files_ = 0;
  spe_context_ptr_t spe_ = nullptr;
  GuardedMemory memory_{kMostBytes};
  bool run_ = false;
  int loaded_ = 0;
  int refused_ = 0;
};

TEST(LyingFile, a_small_spu_program_with_any_field_wrong_is_loaded_or_refused_in_words) {
  LoadEverything load;
  load.run_what_loads();
  for (const FileBytes& file : small_spu_programs()) {
    load(file, "as it should be");
    for_each_lie(file, fields_of_spu_elf(file), true, std::ref(load));
  }
  EXPECT_GT(load.loaded(), 50);
  EXPECT_GT(load.refused(), 50);
}

TEST(LyingFile, a_small_spu_program_with_several_fields_wrong_is_loaded_or_refused_in_words) {
  LoadEverything load;
  load.run_what_loads();
  for (const FileBytes& file : small_spu_programs()) {
    for_some_lies(file, fields_of_spu_elf(file), 700, std::ref(load));
  }
  EXPECT_GT(load.loaded(), 50);
  EXPECT_GT(load.refused(), 50);
}

TEST(LyingFile, a_small_spu_program_cut_anywhere_is_refused_in_words_or_lacks_its_symbols_only) {
  LoadEverything load;
  for (const FileBytes& file : small_spu_programs()) for_each_cut(file, 1, std::ref(load));
  EXPECT_GT(load.refused(), 50);
}

TEST(LyingFile, a_program_of_the_real_compiler_with_any_field_wrong_is_loaded_or_refused_in_words) {
  const std::vector<FileBytes> files = real_spu_programs();
  if (files.empty()) GTEST_SKIP() << "the real compiler is not there";
  LoadEverything load;
  for (const FileBytes& file : files) {
    for_each_lie(file, fields_of_spu_elf(file), true, std::ref(load));
    for_each_cut(file, file.size() / 200 + 1, std::ref(load));
  }
  EXPECT_GT(load.loaded(), 50);
  EXPECT_GT(load.refused(), 50);
}

TEST(LyingFile, an_embedded_image_that_leads_beyond_readable_memory_is_refused_with_the_size_it_claims) {
  FileBytes file = small_spu_programs().front();
  for (const std::size_t at : {32U, 33U}) file[at] = std::byte{0x0f};  // e_shoff
  GuardedMemory memory(kMostBytes);
  spe_program_handle_t handle{sizeof handle, memory.put(file).data(), nullptr};
  const spe_context_ptr_t spe = spe_context_create(SPE_EVENTS_ENABLE, nullptr);
  EXPECT_EQ(spe_program_load(spe, &handle), -1);
  EXPECT_EQ(errno, EINVAL);
  EXPECT_NE(last_fault(spe).find("its headers say that it has"), std::string::npos) << last_fault(spe);
  EXPECT_EQ(spe_context_destroy(spe), 0);
}

TEST(LyingFile, a_module_whose_segments_lie_outside_of_its_file_is_refused_before_it_is_loaded) {
  const FileBytes file = read_file(SPU_EMU_PROBE_FILE);
  GuardedMemory memory(kMostBytes);
  int refused = 0;
  const auto prepare = [&](const FileBytes& lying, const std::string& what) {
    std::string error;
    const auto prepared = prepare_module(memory.put(lying), error);
    EXPECT_EQ(prepared.has_value(), error.empty()) << what;
    refused += prepared ? 0 : 1;
  };
  prepare(file, "as it should be");
  EXPECT_EQ(refused, 0);
  for_each_lie(file, fields_of_module(file), false, prepare);
  for_each_cut(file, file.size() / 200 + 1, prepare);
  EXPECT_GT(refused, 300);
}

TEST(LyingFile, a_module_with_a_wrong_header_or_cut_is_loaded_or_refused_in_words) {
  const FileBytes file = read_file(SPU_EMU_PROBE_FILE);
  LoadEverything load;
  load(file, "as it should be");
  EXPECT_EQ(load.loaded(), 2);
  for_each_lie(file, fields_of_module_header(), false, std::ref(load));
  for_each_cut(file, file.size() / 200 + 1, std::ref(load));
  EXPECT_GT(load.refused(), 50);
}

}  // namespace
}  // namespace spu_emu
