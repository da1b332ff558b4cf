#include "compile/command_line.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace spu_emu::compile {

namespace {

bool is_one_of(std::string_view word, const auto& words) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// Options of the preprocessor, with their value as the next word or in the same one.
constexpr std::array<std::string_view, 12> kPreprocessorValues = {
    "-D",  "-U",  "-I",  "-isystem", "-iquote",    "-include",
    "-MF", "-MT", "-MQ", "-imacros", "-idirafter", "-iprefix"};
constexpr std::array<std::string_view, 5> kPreprocessorFlags = {"-MD", "-MMD", "-MP", "-M", "-MG"};

constexpr std::array<std::string_view, 13> kOnlyCpp = {"-fno-gnu-unique",
                                                       "-fvisibility-inlines-hidden",
                                                       "-fno-rtti",
                                                       "-fpermissive",
                                                       "-frtti",
                                                       "-Wnon-virtual-dtor",
                                                       "-Woverloaded-virtual",
                                                       "-Weffc++",
                                                       "-Wold-style-cast",
                                                       "-Wuseless-cast",
                                                       "-Wextra-semi",
                                                       "-fno-threadsafe-statics",
                                                       "-fno-operator-names"};

bool is_cpp_standard(std::string_view option) {
  return option.starts_with("-std=c++") || option.starts_with("-std=gnu++");
}

bool is_c_standard(std::string_view option) {
  return option.starts_with("-std=") && !is_cpp_standard(option);
}

/// The options without those of the preprocessor.
Words without_preprocessor(const Words& options) {
  Words kept;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const std::string& option = options[i];
    if (is_one_of(option, kPreprocessorValues)) {
      ++i;
      continue;
    }
    const bool has_value = std::any_of(kPreprocessorValues.begin(), kPreprocessorValues.end(),
                                       [&](std::string_view name) { return option.starts_with(name); });
    if (has_value || is_one_of(option, kPreprocessorFlags)) continue;
    kept.push_back(option);
  }
  return kept;
}

}  // namespace

std::optional<CommandLine> CommandLine::of(const Words& words) {
  CommandLine line;
  bool compiles = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i == 0) {
      line.compiler_ = words[i];
    } else if (words[i] == "-c") {
      compiles = true;
    } else if (words[i] == "-o" && i + 1 < words.size()) {
      line.object_ = words[++i];
    } else if (words[i] == "-x" && i + 1 < words.size()) {
      ++i;
    } else if (words[i].starts_with("-") || i + 1 < words.size()) {
      line.options_.push_back(words[i]);
    } else {
      line.source_ = words[i];
    }
  }
  if (!compiles || line.source_.empty() || line.object_.empty()) return std::nullopt;
  if (line.source_.ends_with(".c")) line.take_c_options();
  return line;
}

void CommandLine::take_c_options() {
  language_ = Language::c;
  std::erase_if(options_, [](const std::string& option) {
    return is_one_of(option, kOnlyCpp) || is_cpp_standard(option);
  });
  if (std::none_of(options_.begin(), options_.end(), is_c_standard)) options_.emplace_back("-std=gnu11");
  // Old sources define a variable in several files, and functions as inline that others call.
  options_.insert(options_.end(), {"-fcommon", "-fgnu89-inline"});
}

Words CommandLine::preprocess(const std::string& text) const {
  Words words{compiler_};
  words.insert(words.end(), options_.begin(), options_.end());
  words.insert(words.end(), {"-DSPU_EMU_TRANSLATED", "-x", language_ == Language::c ? "c" : "c++", "-E", "-o",
                             text, source_});
  return words;
}

Words CommandLine::to_assembly(const std::string& text, const std::string& assembly) const {
  const Words options = without_preprocessor(options_);
  Words words{compiler_};
  words.insert(words.end(), options.begin(), options.end());
  words.insert(words.end(), {"-x", language_ == Language::c ? "cpp-output" : "c++-cpp-output", "-S", "-o",
                             assembly, text});
  return words;
}

Words CommandLine::assemble(const std::string& assembly) const {
  return {compiler_, "-x", "assembler", "-c", "-o", object_, assembly};
}

}  // namespace spu_emu::compile
