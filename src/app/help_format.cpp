#include "app/help_format.h"

#include <utility>

#include "app/wrap.h"

namespace cellsweep::app {
namespace {

// What it is at the left; from one column on what it is for.
std::string entry(const std::string& name, const std::string& description, std::size_t column) {
  std::string line = "  " + name;
  if (line.size() + 2 > column) {
    line += "\n" + std::string(column, ' ');
  } else {
    line.resize(column, ' ');
  }
  return line + wrapped(description, column, column) + "\n";
}

}  // namespace

// One empty line between parts is enough.
std::string HelpFormat::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string help = Formatter::make_help(app, std::move(name), mode);
  for (std::size_t at = help.find("\n\n\n"); at != std::string::npos; at = help.find("\n\n\n", at)) {
    help.erase(at, 1);
  }
  return help;
}

std::string HelpFormat::make_description(const CLI::App* app) const {
  return wrapped(app->get_description()) + "\n";
}

std::string HelpFormat::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description(), 16);
}

std::string HelpFormat::make_option(const CLI::Option* option, bool is_positional) const {
  std::string description = make_option_desc(option);
  if (!option->get_default_str().empty()) description += " [" + option->get_default_str() + "]";
  return entry(make_option_name(option, is_positional) + make_option_opts(option), description,
               column_width_);
}

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
  std::string words;
  if (option->nonpositional() && option->get_type_size() != 0 && !option->get_type_name().empty())
    words += " " + option->get_type_name();
  if (option->get_required()) words += " (needed)";
  return words;
}

}  // namespace cellsweep::app
