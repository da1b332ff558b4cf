#include <epoxy/gl.h>
// After epoxy, which it would replace.
#include <GLFW/glfw3.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "base/text.h"
#include "view/canvas.h"
#include "view/painter.h"
#include "view/panel.h"
#include "view/view.h"

namespace cellsweep::view {
namespace {

/// What keeps a window from being there, as a phrase.
struct NoDisplay : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// GLFW and one window with a current context of OpenGL 3.3.
class Window {
 public:
  Window(const ViewSettings& settings, const std::string& title) {
    if (glfwInit() == GLFW_FALSE) throw NoDisplay(glfw_words());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, settings.screenshot.empty() ? GLFW_TRUE : GLFW_FALSE);
    window_ = glfwCreateWindow(static_cast<int>(settings.width), static_cast<int>(settings.height),
                               title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
      const std::string why = glfw_words();
      glfwTerminate();
      throw NoDisplay(why);
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
  }
  ~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* get() const { return window_; }

 private:
  static std::string glfw_words() {
    const char* words = nullptr;
    glfwGetError(&words);
    return words == nullptr ? "there is no display" : words;
  }

  GLFWwindow* window_ = nullptr;
};

/// ImGui's context, fed by the window.
class Gui {
 public:
  explicit Gui(GLFWwindow* window) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    set_panel_style();
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
  }
  ~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  void draw(Panel& panel, Controller& controller, const Met& met) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    panel.draw(controller, met, ImGui::GetIO().DisplaySize.y);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  }
};

int key_of(int glfw_key) {
  switch (glfw_key) {
    case GLFW_KEY_ESCAPE:
      return kEscape;
    case GLFW_KEY_LEFT:
      return kLeft;
    case GLFW_KEY_RIGHT:
      return kRight;
    case GLFW_KEY_UP:
      return kUp;
    case GLFW_KEY_DOWN:
      return kDown;
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
      return '+';
    case GLFW_KEY_KP_SUBTRACT:
      return '-';
    default:
      return glfw_key;  // GLFW's numbers for characters are these characters
  }
}

/// A place in the window, in screen coordinates.
struct Cursor {
  double x = 0;
  double y = 0;
};

/// What the window's callbacks work on: where the cursor was when it was heard of last, and whether it has
/// the tool.
struct Input {
  Controller& controller;
  Cursor cursor;
  bool has_tool = false;
};

Input& input_of(GLFWwindow* window) {
  return *static_cast<Input*>(glfwGetWindowUserPointer(window));
}

void on_key(GLFWwindow* window, int key, int, int action, int) {
  if (action == GLFW_RELEASE || ImGui::GetIO().WantTextInput) return;
  input_of(window).controller.press(key_of(key), action == GLFW_REPEAT);
}

void on_scroll(GLFWwindow* window, double, double up) {
  constexpr float kZoomOfOneStep = 0.9F;
  if (ImGui::GetIO().WantCaptureMouse) return;
  input_of(window).controller.camera().zoom(std::pow(kZoomOfOneStep, static_cast<float>(up)));
}

/// The part of the window that the world is in.
struct WorldPart {
  float left = 0;
  float width = 1;
  float height = 1;

  static WorldPart of(GLFWwindow* window, const Controller& controller) {
    int width = 1;
    int height = 1;
    glfwGetWindowSize(window, &width, &height);
    const int left = controller.shows_panel() ? kPanelWidth : 0;
    return {static_cast<float>(left), static_cast<float>(std::max(width - left, 1)),
            static_cast<float>(std::max(height, 1))};
  }
  Eigen::Vector2f pixel_at(const Cursor& cursor) const {
    return {static_cast<float>(cursor.x) - left, static_cast<float>(cursor.y)};
  }
};

bool is_pressed(GLFWwindow* window, int button) {
  return glfwGetMouseButton(window, button) == GLFW_PRESS;
}

// The right button takes the tool, if there is one; a drag that began on the panel is none.
void on_button(GLFWwindow* window, int button, int action, int) {
  if (button != GLFW_MOUSE_BUTTON_RIGHT) return;
  Input& input = input_of(window);
  input.has_tool = action == GLFW_PRESS && input.controller.probe().tool() != Tool::none &&
                   !ImGui::GetIO().WantCaptureMouse;
  if (!input.has_tool) return;
  const WorldPart part = WorldPart::of(window, input.controller);
  glfwGetCursorPos(window, &input.cursor.x, &input.cursor.y);
  input.controller.grab(part.pixel_at(input.cursor), part.width, part.height);
}

// With the left button the world turns, with the middle one it shifts; with the right one the tool comes
// along, and where there is none the world shifts, too.
void on_cursor(GLFWwindow* window, double x, double y) {
  constexpr float kRadiansPerPixel = 0.006F;
  Input& input = input_of(window);
  const Cursor before = std::exchange(input.cursor, {x, y});
  if (ImGui::GetIO().WantCaptureMouse) return;
  const auto right = static_cast<float>(x - before.x);
  const auto down = static_cast<float>(y - before.y);
  OrbitCamera& camera = input.controller.camera();
  if (is_pressed(window, GLFW_MOUSE_BUTTON_LEFT))
    camera.orbit(-kRadiansPerPixel * right, kRadiansPerPixel * down);
  const WorldPart part = WorldPart::of(window, input.controller);
  if (input.has_tool) input.controller.drag(part.pixel_at(input.cursor), part.width, part.height);
  const bool shifts =
      is_pressed(window, GLFW_MOUSE_BUTTON_RIGHT) && input.controller.probe().tool() == Tool::none;
  if (shifts || is_pressed(window, GLFW_MOUSE_BUTTON_MIDDLE))
    camera.pan(right / part.height, -down / part.height);
}

/// A window from its first picture to its last.
class Viewer {
 public:
  Viewer(Simulation& simulation, const ViewSettings& settings)
      : settings_(settings),
        simulation_(simulation),
        window_(settings, "cellsweep: " + simulation.source_name()),
        controller_(simulation) {
    glfwSetWindowUserPointer(window_.get(), &input_);
    glfwSetKeyCallback(window_.get(), on_key);
    glfwSetScrollCallback(window_.get(), on_scroll);
    glfwSetCursorPosCallback(window_.get(), on_cursor);
    glfwSetMouseButtonCallback(window_.get(), on_button);
    gui_ = std::make_unique<Gui>(window_.get());
    if (!settings.panel) controller_.act(Action::show_panel);
    if (settings.help) controller_.act(Action::show_help);
    if (settings.stream_parts.fat_boxes) controller_.act(Action::show_fat_boxes);
    if (settings.stream_parts.cells) controller_.act(Action::show_cells);
    if (settings.box) controller_.probe().hold(*settings.box);
    if (settings.ray) controller_.probe().hold(*settings.ray);
  }

  Status run() { return settings_.screenshot.empty() ? run_shown() : run_hidden(); }

 private:
  Status run_shown() {
    for (std::size_t frame = 0; !glfwWindowShouldClose(window_.get()) && !controller_.wants_to_quit();
         ++frame) {
      if (settings_.frames && frame == *settings_.frames) break;
      glfwPollEvents();
      controller_.tick();
      if (settings_.frames && !controller_.complaint().empty()) return failure();
      if (!paint()) continue;
      canvas_->show();
      glfwSwapBuffers(window_.get());
    }
    return {};
  }

  // Only the last picture is wanted.
  Status run_hidden() {
    for (std::size_t frame = 0; frame < settings_.frames.value_or(0); ++frame) {
      if (Status status = simulation_.step(); !status.ok()) return status;
    }
    // ImGui lays its windows out while it draws them first.
    for (int time = 0; time < 2; ++time) paint();
    return report::write_png(canvas_->read(), settings_.screenshot);
  }

  Status failure() const { return Status::bad_input(controller_.complaint()); }

  /// False for a window without an inside.
  bool paint() {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window_.get(), &width, &height);
    const int left = controller_.shows_panel() ? kPanelWidth : 0;
    if (width <= left || height <= 0) {
      glfwWaitEventsTimeout(0.1);
      return false;
    }
    if (!canvas_ || canvas_->width() != width || canvas_->height() != height)
      canvas_ = std::make_unique<Canvas>(width, height);
    const Met met = met_by(controller_.probe(), simulation_.engine());
    painter_.paint(drawn_boxes(simulation_, controller_.probe(), met),
                   line_boxes(simulation_, controller_.stream_parts()), simulation_.bounds(),
                   controller_.camera(), canvas_->framebuffer(), {left, 0, width - left, height});
    gui_->draw(panel_, controller_, met);
    return true;
  }

  const ViewSettings& settings_;
  Simulation& simulation_;
  Window window_;
  Controller controller_;
  Input input_{controller_, {}, false};
  std::unique_ptr<Gui> gui_;
  Painter painter_;
  std::unique_ptr<Canvas> canvas_;
  Panel panel_;
};

Status check(const char* setting, unsigned value, unsigned least, unsigned most) {
  if (value >= least && value <= most) return {};
  return Status::bad_option(
      setting, text("The ", setting, " of a window is ", least, " to ", most, ", not ", value, "."), value,
      most);
}

}  // namespace

ViewEnd show(Simulation& simulation, const ViewSettings& settings) {
  if (Status status = check("width", settings.width, 640, 8192); !status.ok()) return {status, ""};
  if (Status status = check("height", settings.height, 240, 8192); !status.ok()) return {status, ""};
  try {
    return {Viewer(simulation, settings).run(), ""};
  } catch (const std::runtime_error& error) {
    return {{}, error.what()};
  }
}

}  // namespace cellsweep::view
