#include "isa/debug/variables.h"

#include <algorithm>
#include <sstream>

#include "mfc/format.h"

namespace spu_emu::isa {

namespace {
constexpr unsigned kKinds = static_cast<unsigned>(VariableType::Kind::structure) + 1;
constexpr unsigned kPlaceKinds = static_cast<unsigned>(VariablePlace::Kind::reg) + 1;

/// The rest of a line, which may have blanks and may be nothing.
std::string rest_of(std::istream& words) {
  std::string rest;
  words >> std::ws;
  std::getline(words, rest);
  return rest;
}

void read_type(std::istream& words, Variables& variables) {
  VariableType type;
  unsigned kind = 0;
  words >> kind >> type.size >> type.target >> type.count;
  type.kind = kind < kKinds ? static_cast<VariableType::Kind>(kind) : VariableType::Kind::unknown;
  type.name = rest_of(words);
  variables.types.push_back(std::move(type));
}

void read_part(const std::string& what, std::istream& words, VariableType& type) {
  if (what == "member") {
    VariableMember member;
    words >> member.offset >> member.type;
    member.name = rest_of(words);
    type.members.push_back(std::move(member));
  } else {
    Enumerator enumerator;
    words >> enumerator.value;
    enumerator.name = rest_of(words);
    type.enumerators.push_back(std::move(enumerator));
  }
}

void read_variable(std::istream& words, Variables& variables) {
  Variable variable;
  words >> variable.low >> variable.high >> variable.type;
  variable.name = rest_of(words);
  variables.all.push_back(std::move(variable));
}

void read_place(std::istream& words, Variable& variable) {
  VariablePlace place;
  unsigned kind = 0;
  if (!(words >> place.low >> place.high >> kind >> place.value) || kind >= kPlaceKinds) return;
  place.kind = static_cast<VariablePlace::Kind>(kind);
  variable.places.push_back(place);
}

/// What refers to types that are not there is of an unknown one.
void mend(Variables& variables) {
  if (variables.types.empty()) variables.types.emplace_back();
  const auto known = [&](std::uint32_t& type) {
    if (type >= variables.types.size()) type = 0;
  };
  for (VariableType& type : variables.types) {
    known(type.target);
    for (VariableMember& member : type.members) known(member.type);
  }
  for (Variable& variable : variables.all) known(variable.type);
}
}  // namespace

const VariablePlace* Variable::place_at(std::uint32_t pc) const {
  const auto found = std::find_if(places.begin(), places.end(), [pc](const VariablePlace& place) {
    return pc >= place.low && pc < place.high;
  });
  return found == places.end() ? nullptr : &*found;
}

const Variable* Variables::find(std::string_view name, std::uint32_t pc) const {
  const Variable* best = nullptr;
  for (const Variable& each : all) {
    if (each.name != name || pc < each.low || pc >= each.high) continue;
    if (best == nullptr || each.high - each.low <= best->high - best->low) best = &each;
  }
  return best;
}

std::vector<std::string> Variables::names_at(std::uint32_t pc) const {
  std::vector<std::string> names;
  for (const Variable& each : all) {
    if (pc >= each.low && pc < each.high) names.push_back(each.name);
  }
  return names;
}

std::string variable_table_text(const Variables& variables) {
  std::string text;
  for (const VariableType& type : variables.types) {
    text += format("type %u %u %u %u %s\n", static_cast<unsigned>(type.kind), type.size, type.target,
                   type.count, type.name.c_str());
    for (const VariableMember& member : type.members)
      text += format("member %u %u %s\n", member.offset, member.type, member.name.c_str());
    for (const Enumerator& each : type.enumerators)
      text += format("enumerator %lld %s\n", static_cast<long long>(each.value), each.name.c_str());
  }
  for (const Variable& variable : variables.all) {
    text +=
        format("variable %u %u %u %s\n", variable.low, variable.high, variable.type, variable.name.c_str());
    for (const VariablePlace& place : variable.places)
      text += format("place %u %u %u %d\n", place.low, place.high, static_cast<unsigned>(place.kind),
                     place.value);
  }
  return text;
}

Variables read_variable_table(std::istream& text) {
  Variables variables;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    if (what == "type") read_type(words, variables);
    if ((what == "member" || what == "enumerator") && !variables.types.empty())
      read_part(what, words, variables.types.back());
    if (what == "variable") read_variable(words, variables);
    if (what == "place" && !variables.all.empty()) read_place(words, variables.all.back());
  }
  mend(variables);
  return variables;
}

}  // namespace spu_emu::isa
