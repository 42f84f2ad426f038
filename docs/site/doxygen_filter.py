#!/usr/bin/env python3
"""doxygen_filter.py TARGET FOLDER...: copies of the headers below TARGET, as Doxygen reads them (docs/Doxyfile).

The headers of this house have plain `//` comments: above a declaration, or behind it. This filter writes them as `///`
above the declaration. A comment above declarations without a blank line between them is a comment on each of them that
has none, and so is a comment on declarations of one line. The first comment of a header is about its noun: the
declaration that has the name of the file, else the first type or function. An overload has the comment of its namesake
above, a constructor is documented by its class, and `x()` that returns the member `x_` by the comment on that member.
Names that containers of the standard library and graphs of Boost give to things keep their meaning. Bodies of functions
pass as they are.
"""
import pathlib
import re
import sys

SCOPE = re.compile(r"(?:template\s*<.*>\s*)?(?:inline\s+)?"
                   r"(?:class|struct|union|namespace|enum(?:\s+class)?)\b[^()=]*\{$")
CONTAINER = {"size", "empty", "begin", "end", "data", "clear"}
CONCEPT = {"value_type", "reference", "pointer", "difference_type", "iterator_category", "vertex_descriptor",
           "edge_descriptor", "directed_category", "edge_parallel_category", "traversal_category", "degree_size_type",
           "vertices_size_type", "out_edge_iterator", "vertex_iterator", "adjacency_iterator", "in_edge_iterator",
           "edge_iterator", "edges_size_type", "Prefix"}
NAME = re.compile(r"([A-Za-z_~]\w*|operator\s*\S+?)\s*\(")


def split_comment(line):
    """Code and comment of a line; `//` in a string or character is code."""
    quote, at = "", 0
    while at < len(line):
        if quote:
            if line[at] == "\\":
                at += 1
            elif line[at] == quote:
                quote = ""
        elif line[at] == '"' or (line[at] == "'" and not (at and line[at - 1].isalnum())):
            quote = line[at]
        elif line.startswith("//", at):
            return line[:at].rstrip(), line[at + 2:]
        at += 1
    return line.rstrip(), None


def split_top(text, separator=","):
    """The parts between separators that stand in no bracket."""
    parts, depth = [""], 0
    for at, character in enumerate(text):
        depth += (character in "([{<") - (character in ")]}" or (character == ">" and text[at - 1] != "-"))
        if character == separator and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts if part.strip()]


def escaped(text):
    text = re.sub(r"([\\@<>&#%$])", r"\\\1", text)
    text = re.sub(r"`([^`]*)`", r"<code>\1</code>", text)
    return text.replace("::", "\\::").replace('"', "&quot;")


def documentation(comment, indent):
    """Lines of a comment as documentation; lines that are set in by two stand as they are."""
    out, verbatim, after_list = [], False, False
    for line in comment:
        text = line[1:] if line.startswith(" ") else line
        set_in = text.startswith("  ") and not after_list
        if set_in != verbatim and (set_in or text.strip()):
            out.append("\\verbatim" if set_in else "\\endverbatim")
            verbatim = set_in
        after_list = text.startswith("- ") or (after_list and text.startswith(" "))
        out.append(text if verbatim else escaped(text))
    if verbatim:
        out.append("\\endverbatim")
    return [f"{indent}/// {line}".rstrip() for line in out]


class Filter:
    def __init__(self):
        self.out = []
        self.scopes = []       # of each open scope: "enum" or "class", and the names that are documented there
        self.named = [{}]
        self.body = 0          # open braces of a function body
        self.leading, self.detached = [], True
        self.statement, self.trailing = [], []
        self.column = None     # of the trailing comment of the statement before, which may go on
        self.held = None       # that statement
        self.classes = []      # names of the open scopes
        self.shared = None     # the comment above the declarations of this run
        self.first = None      # the first comment of the header, and the name of what it is about
        self.noun = None
        self.members = {}      # comments on members whose names end in _
        self.hidden = 0        # open braces of a definition that is no public name

    def release(self):
        if self.held:
            held, self.held = self.held, None
            self.emit(*held)

    def declare(self, indent, code, comment):
        """One declaration with its comment."""
        if comment:
            self.out += documentation(comment, indent)
        self.out += code

    def automatic(self, text):
        if name := NAME.search(text):
            if name[1] in CONTAINER:
                return [" As of containers of the standard library."]
            if self.classes and name[1] == self.classes[-1]:
                return [" Constructs the object."]
            if name[1].startswith("operator") and not re.search(r"=\s*(default|delete)\s*;$|operator\s*[=<]", text):
                return [" The element at that place." if "[]" in name[1] else " What the class is called for."]
        if same := re.match(r"using (\w+) = (?:typename )?([\w:]+::\1);", text):
            return [f" The same as {same[2]}."]
        if (using := re.match(r"using (\w+) =|struct (\w+);", text)) and (using[1] or using[2]) in CONCEPT:
            return [" As a concept of the standard library or of Boost.Graph asks."]
        if re.search(r"=\s*default\s*;$", text):
            return [" Compares part by part." if "operator" in text else " Defaulted."]
        if re.search(r"=\s*delete\s*;$", text):
            return [" Deleted."]
        if re.search(r"~\w+\(\)", text):
            return [" Frees what the object owns."]
        if re.search(r"\boperator\s*(==|<=>|<)\s*\(", text):
            return [" Compares."]
        if re.search(r"\b(begin|end)\(\) const\b", text):
            return [" The elements in order."]
        return None

    def emit(self, indent, code, comment, opens, in_enum):
        text = " ".join(line.strip() for line in code)
        name = NAME.search(text)
        name = name.group(1) if name and not opens else None
        if not comment and name and name in self.named[-1]:
            comment = self.named[-1][name]
        if not comment and name and name + "_" in self.members:
            comment = self.members[name + "_"]
        declared = re.match(r"(?:template\s*<.*>\s*)?(?:(?:class|struct|concept|using|enum(?: class)?)\s+)?(\w+)", text)
        if not comment and self.noun and self.noun in (name, declared and declared[1]):
            if not re.match(r"(class|struct) \w+;", text):
                comment, self.noun = self.first, None
        if comment and name:
            self.named[-1].setdefault(name, comment)
        if not comment:
            comment = self.automatic(text) or self.shared
        one_line = re.fullmatch(r"((?:class|struct|enum(?:\s+class)?)\b[^{}()=]*)\{(.*)\};", text)
        if in_enum and not opens:
            for value in split_top(text):
                self.declare(indent, [f"{indent}{value},"], comment)
        elif one_line and one_line[2].strip():
            self.declare(indent, [f"{indent}{one_line[1]}{{"], comment)
            enum = one_line[1].startswith("enum")
            for member in split_top(one_line[2], "," if enum else ";"):
                self.declare(indent + "  ", [f"{indent}  {member}{',' if enum else ';'}"], comment)
            self.out.append(f"{indent}}};")
        elif self.scopes and self.scopes[-1] != "enum" and (parts := self.declarators(text)):
            for part in parts:
                self.declare(indent, [indent + part], comment)
        else:
            self.declare(indent, code, comment)

    def declarators(self, text):
        """`T a = 0, b;` as `T a = 0;` and `T b;`, or nothing when that is no such declaration."""
        if not text.endswith(";") or re.match(r"(using|friend|static_assert|typedef|template)\b", text):
            return None
        parts = split_top(text[:-1])
        first = re.match(r"((?:[^=({]|\([^)]*\)>)*?[\s&*>])(\w+)(\s*[={].*)?$", parts[0])
        if len(parts) < 2 or not first or not all(re.match(r"[&*]?\w+(\s*[={].*)?$", part) for part in parts[1:]):
            return None
        return [parts[0] + ";"] + [f"{first[1]}{part};" for part in parts[1:]]

    def line(self, raw):
        code, comment = split_comment(raw)
        if self.hidden:
            self.hidden += code.count("{") - code.count("}")
            return
        if self.body:
            self.body += code.count("{") - code.count("}")
            self.out.append(code)
            return
        if not code.strip() and comment is not None and not self.statement:
            column = len(raw) - len(raw.lstrip())
            if self.held and self.column is not None and abs(column - self.column) <= 0:
                self.held[2].append(comment)
                return
            self.release()
            self.leading.append(comment)
            return
        if not code.strip() and not self.statement:
            self.release()
            self.shared = None
            self.out.append("")  # a comment above a blank line documents nothing below
            self.leading = []
            return
        self.column = len(code) and raw.find("//", len(code)) if comment is not None else None
        if comment is not None:
            self.trailing.append(comment)
        if code.strip():
            if not self.statement:
                self.release()
            self.statement.append(code)
        text = " ".join(line.strip() for line in self.statement)
        in_enum = bool(self.scopes) and self.scopes[-1] == "enum"
        if text.startswith("#"):
            self.out += self.statement
            self.reset()
            return
        balanced = text.count("(") == text.count(")")
        if not balanced or not re.search(r"[;{}:]$|,$" if in_enum else r"[;{}]$|(public|private|protected):$", text):
            if not (in_enum and not text.endswith("}")):
                return
        indent = re.match(r"\s*", self.statement[0]).group()
        if re.fullmatch(r"(public|private|protected):", text.strip()):
            self.out += self.statement
            self.reset()
            return
        if re.match(r"\}", text.strip()) and text.count("{") == 0:
            self.release()
            if self.scopes:
                self.scopes.pop()
                self.named.pop()
                self.classes.pop()
            self.shared = None
            self.out += self.statement
            self.reset()
            return
        opened = text.count("{") - text.count("}")
        opens = opened > 0 and bool(SCOPE.match(text))
        if re.match(r"(struct|class) \w+::\w+ \{|template <>|struct std::hash", text) or "std::hash<" in text:
            self.release()
            self.hidden = opened
            self.reset()
            return
        spoken = self.leading + self.trailing
        if self.leading:
            self.shared = self.leading
        if opened > 0:
            self.emit(indent, self.statement, spoken, True, False)
            if opens:
                self.shared = None
                named = re.match(r"(?:template\s*<.*>\s*)?(?:class|struct|union|enum(?: class)?)\s+(\w+)", text)
                self.classes.append(named[1] if named else "")
                kind = "enum" if re.match(r"enum\b", text) else "class" if "namespace" not in text else "space"
                self.scopes.append(kind)
                self.named.append({})
            else:
                name = NAME.search(text)
                if spoken and name:
                    self.named[-1].setdefault(name.group(1), spoken)
                self.body = opened
        else:
            self.held = [indent, self.statement, spoken, False, in_enum]
        self.reset()

    def reset(self):
        self.leading, self.statement, self.trailing = [], [], []


def noun_of(stem, lines):
    """The name that the first comment of a header is about."""
    declared = re.compile(r"(?:template <.*> )?(?:class|struct|concept|enum class) (\w+)"
                          r"(?: final)?(?: :.*)?(?: =.*)?(?: \{|$)"
                          r"|(?!using|namespace|#|//|friend|return)[\w:<>,&* ]*?[\w>&*] (\w+)\(")
    names = [match[1] or match[2] for match in map(declared.match, lines) if match]
    plain = stem.replace("_", "")
    for name in names:
        if name.lower().replace("_", "") in (plain, plain.rstrip("s")):
            return name
    return names[0] if names else None


def filtered(text, stem):
    lines, first = text.splitlines(), []
    while lines and lines[0].startswith("//"):
        first.append(lines.pop(0)[2:])
    page = Filter()
    page.out = ["/// \\file"] + documentation(first, "")
    page.first, page.noun = first, noun_of(stem, lines)
    page.members = {}
    for line in lines:
        if member := re.match(r"  +[\w:<>*&, ]+ (\w+_)( = [^;]*|\{[^;]*\})?;  +//(.*)", line):
            page.members[member[1]] = [member[3]]
    for line in lines:
        page.line(line)
    page.release()
    return "\n".join(page.out) + "\n"


def main(target, *folders):
    for folder in folders:
        for header in sorted(pathlib.Path(folder).rglob("*.hpp")):
            if header.name != "json_reader.hpp":  # not installed
                written = target / header
                written.parent.mkdir(parents=True, exist_ok=True)
                written.write_text(filtered(header.read_text(), header.stem))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), *sys.argv[2:])
