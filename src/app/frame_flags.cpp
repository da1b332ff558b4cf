#include "app/frame_flags.h"

#include "app/checks.h"

namespace cellsweep::app {

void FrameFlags::add_to(CLI::App& command, std::size_t frames_default, const std::string& frames_text) {
  settings.updates = frames_default;
  command.add_option("--frames", settings.updates, "Updates after frame 0")
      ->check(count())
      ->type_name("N")
      ->default_str(frames_text);
  command
      .add_option("--report-frames", settings.report_frames,
                  "Frames whose pair count and hash are reported, separated by commas")
      ->delimiter(',')
      ->check(count())
      ->type_name("N[,N...]")
      ->default_str("first and last");
  command.add_flag("--json", json, "One JSON object on standard output");
}

}  // namespace cellsweep::app
