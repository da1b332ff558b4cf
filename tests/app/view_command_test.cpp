#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "base/text.h"
#include "cellsweep/engines.h"
#include "command_line.h"
#include "project_file.h"

namespace cellsweep::app {
namespace {

using ::testing::HasSubstr;

constexpr const char* kNoDisplay = "env -u DISPLAY -u WAYLAND_DISPLAY";
constexpr const char* kSmallWindow = " --width 640 --height 400 ";
constexpr const char* kTall = " --width 640 --height 1000 ";  // room for the whole panel
const std::string kShownPile = project_file("bench/scenes/bullet-pile-1024.aabbs");
#ifdef CELLSWEEP_PICTURES
constexpr bool kHasPictures = true;
#else
constexpr bool kHasPictures = false;
#endif
constexpr int kPanelWidth = 330;

struct Picture {
  unsigned width = 0;
  unsigned height = 0;
  std::vector<std::uint8_t> rgb;

  int channel(unsigned x, unsigned y, unsigned which) const { return rgb[3 * (y * width + x) + which]; }
};

Picture read_png(const std::string& path) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&header, path.c_str()) == 0) return {};
  header.format = PNG_FORMAT_RGB;
  Picture picture{header.width, header.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(header))};
  png_image_finish_read(&header, nullptr, picture.rgb.data(), 0, nullptr);
  return picture;
}

/// The share of pixels that colliding bodies take: others are as red as green.
double green_share(const Picture& picture) {
  std::size_t green = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
    green += picture.rgb[i + 1] > picture.rgb[i] + 60 ? 1 : 0;
  return 3.0 * static_cast<double>(green) / static_cast<double>(picture.rgb.size());
}

/// The share of pixels in which a channel differs by more than a quarter of its range.
double differing_share(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height || a.rgb.empty()) return 1;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    bool differs = false;
    for (std::size_t k = i; k < i + 3; ++k) differs = differs || std::abs(a.rgb[k] - b.rgb[k]) > 64;
    differing += differs ? 1 : 0;
  }
  return 3.0 * static_cast<double>(differing) / static_cast<double>(a.rgb.size());
}

std::size_t pixels_of(const Picture& picture, int red, int green, int blue) {
  std::size_t count = 0;
  for (unsigned y = 0; y < picture.height; ++y) {
    for (unsigned x = 0; x < picture.width; ++x) {
      count += picture.channel(x, y, 0) == red && picture.channel(x, y, 1) == green &&
                       picture.channel(x, y, 2) == blue
                   ? 1
                   : 0;
    }
  }
  return count;
}

class View : public testing::Test {
 protected:
  void SetUp() override {
    if (std::string(CELLSWEEP_WITH_DISPLAY).empty())
      GTEST_SKIP() << "there is no Xvfb (Debian: xvfb, libgl1-mesa-dri)";
  }

  /// What the window shows at its end.
  Picture screenshot(const std::string& arguments, const char* size = kSmallWindow) const {
    const std::string file = scratch_.path("window.png");
    const CommandResult result =
        run_command(text("view ", arguments, size, "--screenshot ", file), CELLSWEEP_WITH_DISPLAY);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return read_png(file);
  }

  Picture rendered(const std::string& arguments) const {
    const std::string file = scratch_.path("render.png");
    const CommandResult result =
        run_command(text("render ", arguments, kSmallWindow, "--samples 8 --out ", file), kNoDisplay);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return read_png(file);
  }

  ScratchFolder scratch_;
};

TEST_F(View, ShowsTheWorldAsItsRayTracedPictureDoes) {
  if (!kHasPictures) GTEST_SKIP() << "this build has no ray-traced pictures";
  const std::string scene = "--scene varied --bodies 120 --moving 1 --spinning --seed 5";
  const Picture shown = screenshot(scene + " --frames 40 --no-panel --engine control");
  const Picture traced = rendered(scene + " --frame 40");
  EXPECT_LT(differing_share(shown, traced), 0.01);
  EXPECT_NEAR(green_share(shown), green_share(traced), 0.01);
  EXPECT_GT(green_share(shown), 0.05);
  // Bodies elsewhere would not go unnoticed.
  EXPECT_GT(differing_share(shown, rendered(scene + " --frame 0")), 0.06);
}

TEST_F(View, GivesTheSamePixelsForTheSameFrame) {
  const std::string scene = "--scene paper --bodies 300 --frames 5 --no-panel";
  const Picture one = screenshot(scene + " --engine stream");
  ASSERT_FALSE(one.rgb.empty());
  EXPECT_EQ(one.rgb, screenshot(scene + " --engine control").rgb);
}

/// The share of pixels that are by a quarter of the range more of one channel than of another.
double tinted_share(const Picture& picture, std::size_t more, std::size_t less) {
  std::size_t tinted = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
    tinted += picture.rgb[i + more] > picture.rgb[i + less] + 64 ? 1 : 0;
  return 3.0 * static_cast<double>(tinted) / static_cast<double>(picture.rgb.size());
}

TEST_F(View, DrawsTheEdgesOfFatBoxesInBlueAndOfCellsInOrange) {
  constexpr std::size_t kRed = 0;
  constexpr std::size_t kBlue = 2;
  const std::string scene = "--scene paper --bodies 200 --frames 5 --no-panel ";
  const Picture plain = screenshot(scene);
  const Picture fat = screenshot(scene + "--fat-boxes");
  const Picture cells = screenshot(scene + "--cells");
  EXPECT_LT(tinted_share(plain, kBlue, kRed), 0.001);
  EXPECT_LT(tinted_share(plain, kRed, kBlue), 0.001);
  EXPECT_GT(tinted_share(fat, kBlue, kRed), 0.005);
  EXPECT_LT(tinted_share(fat, kRed, kBlue), 0.001);
  EXPECT_GT(tinted_share(cells, kRed, kBlue), 0.002);
  EXPECT_EQ(screenshot(scene + "--cells --engine control").rgb, plain.rgb) << "there are none";
}

/// The share of pixels of a yellow: much red and green, little blue, where green is at least so much of red.
double yellow_share(const Picture& picture, double least, double most) {
  std::size_t yellow = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    const double red = picture.rgb[i];
    const double green = picture.rgb[i + 1];
    yellow +=
        red > 150 && picture.rgb[i + 2] < red - 64 && green >= least * red && green < most * red ? 1 : 0;
  }
  return 3.0 * static_cast<double>(yellow) / static_cast<double>(picture.rgb.size());
}

TEST_F(View, LightsUpWhatABoxOrARayMeets) {
  const auto amber = [](const Picture& picture) { return yellow_share(picture, 0.4, 0.8); };
  const auto yellow = [](const Picture& picture) { return yellow_share(picture, 0.8, 1.1); };
  const std::string scene = "--scene paper --bodies 400 --frames 5 --no-panel ";
  const Picture plain = screenshot(scene);
  const Picture box = screenshot(scene + "--box 5,5,5,10,10,10");
  const Picture ray = screenshot(scene + "--ray -1,10,10,1,0,0");
  EXPECT_EQ(amber(plain) + yellow(plain), 0);
  EXPECT_GT(amber(box), 0.003);
  EXPECT_LT(yellow(box), 0.0005);
  EXPECT_GT(yellow(ray), 0.0005);
  EXPECT_LT(yellow(ray), 0.005) << "the first body alone";
  EXPECT_EQ(screenshot(scene + "--ray -1,10,10,1,0,0 --engine control").rgb, ray.rgb);
}

TEST_F(View, HasAPanelBesideTheWorldWithTheLocalStoresOfCellEngines) {
  if (find_engine("cell-resident") == nullptr) GTEST_SKIP() << "this build has no Cell engines";
  const Picture stream = screenshot("--bodies 200 --frames 20", kTall);
  const Picture resident = screenshot("--bodies 200 --frames 20 --engine cell-resident", kTall);
  ASSERT_FALSE(stream.rgb.empty() || resident.rgb.empty());
  const auto region = [](const Picture& picture) { return pixels_of(picture, 0, 114, 178); };
  EXPECT_EQ(region(stream), 0U);
  EXPECT_GT(region(resident), 100U);
  const auto frame_times = [](const Picture& picture) { return pixels_of(picture, 66, 158, 79); };
  EXPECT_GT(frame_times(stream), 50U);
  EXPECT_EQ(stream.channel(kPanelWidth - 4, 300, 0), 251);
  EXPECT_LT(stream.channel(kPanelWidth + 4, 300, 0), 245);
}

TEST_F(View, ShowsARecordingAndTheKeys) {
  const Picture keys = screenshot(text(kShownPile, " --frames 3 --no-panel --help-keys"));
  const Picture plain = screenshot(text(kShownPile, " --frames 3 --no-panel"));
  EXPECT_GT(green_share(plain), 0.05);
  EXPECT_GT(differing_share(keys, plain), 0.02);
}

TEST_F(View, EndsAfterTheFramesThatWereAskedFor) {
  const CommandResult result =
      run_command(text("view --bodies 50 --frames 3", kSmallWindow), CELLSWEEP_WITH_DISPLAY);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
}

TEST(ViewWithoutADisplay, NamesTheCommandThatDrawsThePictureWithoutOne) {
  const ScratchFolder scratch;
  const std::string out = scratch.path("it.png");
  const CommandResult result = run_command(
      "view --scene wall --bodies 40 --frames 2 --width 640 --height 240 --screenshot " + out, kNoDisplay);
  EXPECT_EQ(result.exit_code, 5);
  const std::string start = "cellsweep render ";
  const std::size_t at = result.errors.find(start);
  ASSERT_NE(at, std::string::npos) << result.errors;
  const std::string arguments = result.errors.substr(at + 10, result.errors.find('\n', at) - at - 10);
  if (!kHasPictures) return;
  EXPECT_EQ(run_command(arguments, kNoDisplay).exit_code, 0) << arguments;
  EXPECT_EQ(read_png(out).width, 640U);
}

TEST(ViewWithoutADisplay, SaysWhatIsWrongBeforeItLooksForOne) {
  EXPECT_EQ(run_command("view --engine control,stream", kNoDisplay).exit_code, 2);
  EXPECT_EQ(run_command("view --bodies 9 --width 9", kNoDisplay).exit_code, 2);
  EXPECT_EQ(run_command("view --scene nowhere", kNoDisplay).exit_code, 2);
  EXPECT_EQ(run_command("view --ray 0,0,0,0,0,0", kNoDisplay).exit_code, 2);
  EXPECT_THAT(run_command("view --box 0,0,0,1,1", kNoDisplay).errors, HasSubstr("--box: 6 numbers, MINX,"));
  EXPECT_THAT(run_command("view --box 1,0,0,0,1,1", kNoDisplay).errors,
              HasSubstr("on axis x it goes from 1 to 0"));
  const CommandResult full = run_command("view --engine control --bodies 5000", kNoDisplay);
  EXPECT_EQ(full.exit_code, 3);
  EXPECT_THAT(full.errors, HasSubstr("5000"));
}

}  // namespace
}  // namespace cellsweep::app
