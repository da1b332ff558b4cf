"""Where a source can be changed by one mutation, and to what."""
import re
from dataclasses import dataclass
from pathlib import Path

# What clang-format puts between two spaces is an operator, not a bracket of a template or a reference.
SWAPPED = {
    " < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ",
    " + ": " - ", " - ": " + ", " * ": " + ", " / ": " * ", " % ": " / ",
    " & ": " | ", " | ": " & ", " ^ ": " | ", " << ": " >> ", " >> ": " << ",
    " && ": " || ", " || ": " && ", " += ": " -= ", " -= ": " += ", " |= ": " &= ", " &= ": " |= ",
}
WORDS = {
    r"\btrue\b": "false", r"\bfalse\b": "true", r"\bcontinue;": "break;",
    r"\bstd::min\b": "std::max", r"\bstd::max\b": "std::min",
    r"(?<=[\s(])!(?=[\w(])": "", r"(?<![\w.'])0(?=[\s,;)\]}])": "1", r"(?<![\w.'])1(?=[\s,;)\]}])": "2",
}
CALL = re.compile(r"^\s+[\w.:>\[\]-]+\(.*\);$")
NOT_CODE = re.compile(r"^\s*(//|#|using |template|static_assert|assert|namespace|typedef)|operator")


@dataclass(frozen=True)
class Site:
    """A place in a file: the text from `begin` to `end` of a line (from 0) becomes `new`."""
    path: str
    line: int
    begin: int
    end: int
    new: str

    def apply(self, text: str) -> str:
        lines = text.split("\n")
        old = lines[self.line]
        lines[self.line] = old[:self.begin] + self.new + old[self.end:]
        return "\n".join(lines)


def code_of(line: str) -> str:
    """The line with its comment and what its strings hold as blanks, columns kept."""
    line = re.sub(r'"(\\.|[^"\\])*"', lambda found: '"' + " " * (len(found[0]) - 2) + '"', line)
    return re.sub(r"//.*", lambda found: " " * len(found[0]), line)


def sites_of_line(path: str, number: int, line: str) -> list[Site]:
    code = code_of(line)
    if NOT_CODE.search(code):
        return []
    found = [Site(path, number, at.start(), at.end(), new)
             for old, new in SWAPPED.items() for at in re.finditer(re.escape(old), code)]
    found += [Site(path, number, at.start(), at.end(), new)
              for old, new in WORDS.items() for at in re.finditer(old, code)]
    if CALL.match(code):
        found.append(Site(path, number, len(line) - len(line.lstrip()), len(line), ";"))
    return found


def sites_of(project: Path, rooms: list[str]) -> list[Site]:
    """All sites of the sources in these folders, in the order of the files' names."""
    files = sorted(file for room in rooms for ending in ("*.h", "*.cpp") for file in (project / room).rglob(ending))
    return [site for file in files for number, line in enumerate(file.read_text().split("\n"))
            for site in sites_of_line(str(file.relative_to(project)), number, line)]
