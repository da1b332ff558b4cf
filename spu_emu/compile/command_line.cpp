#include "compile/command_line.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace spu_emu::compile {

namespace {

bool is_one_of(std::string_view word, const auto& words) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// Options of the preprocessor, with their value as the next word or in the same one: where headers are, and
/// what has been done when the text is translated.
constexpr std::array<std::string_view, 4> kSearch = {"-I", "-isystem", "-iquote", "-idirafter"};
constexpr std::array<std::string_view, 7> kDone = {"-D", "-U", "-include", "-imacros", "-MF", "-MT", "-MQ"};
constexpr std::array<std::string_view, 5> kDoneFlags = {"-MD", "-MMD", "-MP", "-M", "-MG"};

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

bool begins_like(std::string_view option, const auto& names) {
  return std::any_of(std::begin(names), std::end(names),
                     [&](std::string_view name) { return option.starts_with(name); });
}

/// The options for translated text, with or without those that say where headers are.
Words without_preprocessor(const Words& options, bool with_search) {
  Words kept;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const bool is_search = begins_like(options[i], kSearch);
    const bool is_done = begins_like(options[i], kDone) || is_one_of(options[i], kDoneFlags);
    const bool has_next = is_one_of(options[i], kSearch) || is_one_of(options[i], kDone);
    const std::size_t last = has_next && i + 1 < options.size() ? i + 1 : i;
    for (; !is_done && (with_search || !is_search); ++i) {
      kept.push_back(options[i]);
      if (i == last) break;
    }
    i = last;
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

Words CommandLine::to_assembly(const std::string& text, const std::string& assembly, bool has_macros) const {
  const Words options = without_preprocessor(options_, has_macros);
  Words words{compiler_};
  words.insert(words.end(), options.begin(), options.end());
  if (has_macros) {
    words.insert(words.end(),
                 {"-DSPU_EMU_TRANSLATED", "-imacros", "spu_emu/c/intrinsic_macros.h", "-x", "c"});
  } else {
    words.insert(words.end(), {"-x", language_ == Language::c ? "cpp-output" : "c++-cpp-output"});
  }
  words.insert(words.end(), {"-S", "-o", assembly, text});
  return words;
}

Words CommandLine::assemble(const std::string& assembly) const {
  return {compiler_, "-x", "assembler", "-c", "-o", object_, assembly};
}

}  // namespace spu_emu::compile
