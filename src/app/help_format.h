/// @file
/// How help is laid out.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace cellsweep::app {

/// CLI11's help in 80 columns; what an option is by default stands behind its description.
class HelpFormat : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
};

}  // namespace cellsweep::app
