"""The mutants of a C++ source: which expressions are changed, and into what. The source is parsed by libclang."""
import collections
import re

try:
    from clang.cindex import Config, CursorKind, Diagnostic, Index, LibclangError
    available = bool(Config)
except ImportError:
    available = False

# kind: the operator, or what is changed; start, end: bytes of the expression; after: the changed expression; kept: the
# unchanged one, where its type has to be spelled
Mutant = collections.namedtuple("Mutant", "file line column kind start end before after kept is_constexpr")

CHANGED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&", "&": "|",
           "|": "&", "+": "-", "-": "+", "*": "+", "/": "*", "%": "*", "<<": ">>", ">>": "<<",
           "+=": "-=", "-=": "+=", "*=": "+=", "|=": "&=", "&=": "|="}
BLANK = re.compile(rb"//[^\n]*|/\*.*?\*/|\s+", re.S)
INTEGER = re.compile(r"(0[xX][0-9a-fA-F']+|0[bB][01']+|[0-9']+)([uUlLzZ]*)")
NUMBERS = ("bool", "char", "signed char", "unsigned char", "short", "unsigned short", "int", "unsigned int", "long",
           "unsigned long", "long long", "unsigned long long", "float", "double")
# Room that is set aside, and numbers that spread keys over a table, change the speed alone.
INERT_CALLS = {"reserve", "shrink_to_fit", "rehash"}
INERT_FUNCTIONS = re.compile(r"hash|mix", re.I)

if available:
    CONSTANT = {CursorKind.ENUM_CONSTANT_DECL, CursorKind.STATIC_ASSERT,
                CursorKind.TEMPLATE_NON_TYPE_PARAMETER, CursorKind.TEMPLATE_TYPE_PARAMETER}
    FUNCTIONS = {CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD, CursorKind.CONSTRUCTOR, CursorKind.LAMBDA_EXPR,
                 CursorKind.FUNCTION_TEMPLATE, CursorKind.CONVERSION_FUNCTION, CursorKind.DESTRUCTOR}
    CONDITIONED = {CursorKind.IF_STMT, CursorKind.WHILE_STMT, CursorKind.DO_STMT, CursorKind.CONDITIONAL_OPERATOR}
    VARIABLES = {CursorKind.VAR_DECL, CursorKind.FIELD_DECL, CursorKind.PARM_DECL}


class Reason(Exception):
    """Why a source cannot be parsed."""


def parse(path, arguments, text=None, language="c++"):
    given = [(str(path), text)] if text is not None else None
    try:
        return Index.create(True).parse(str(path), args=[*arguments, "-x", language, "-ferror-limit=0", "-w"],
                                        unsaved_files=given, options=0)
    except LibclangError as error:
        raise Reason(str(error)) from error


def precompile(headers, target, arguments):
    """Parses headers once for all sources that include them; the arguments that use them."""
    text = "".join(f"#include {header}\n" for header in headers)
    source = target.with_suffix(".hpp")
    source.write_text(text)
    parse(source, arguments, language="c++-header").save(str(target))
    return [*arguments, "-include-pch", str(target)]


def errors(unit):
    """Where the compiler objects: bytes of the main file."""
    return [(d.location.offset if d.location.file and d.location.file.name == unit.spelling else None, d.spelling)
            for d in unit.diagnostics if d.severity >= Diagnostic.Error]


class Finder:
    def __init__(self, file, path, arguments):
        self.file, self.source = file, path.read_bytes()
        self.unit = parse(path, arguments)
        if wrong := errors(self.unit):
            raise Reason(f"{file}: {wrong[0][1]}")
        self.found = {}

    def mutants(self):
        self.children(self.unit.cursor, False)
        return sorted(self.found.values(), key=lambda m: (m.start, -m.end, m.kind))

    def text(self, start, end):
        return self.source[start:end].decode()

    def bare(self, start, end):
        """The text of a range without comments and white space."""
        return BLANK.sub(b"", self.source[start:end]).decode()

    def range(self, cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def add(self, kind, start, end, after, is_constexpr, kept=None):
        line = self.source.count(b"\n", 0, start) + 1
        column = start - (self.source.rfind(b"\n", 0, start) + 1) + 1
        self.found.setdefault((start, end, kind), Mutant(self.file, line, column, kind, start, end,
                                                         self.text(start, end), after, kept, is_constexpr))

    def children(self, cursor, is_constexpr):
        for child in cursor.get_children():
            file = child.location.file
            if file is None or file.name == self.unit.spelling:
                self.visit(child, cursor, is_constexpr)

    def visit(self, cursor, parent, is_constexpr):
        kind, (start, end) = cursor.kind, self.range(cursor)
        if kind in CONSTANT or kind.is_attribute() or self.is_left_alone(cursor, parent, start):
            return
        if kind in FUNCTIONS:
            if INERT_FUNCTIONS.search(cursor.spelling):
                return
            is_constexpr = is_constexpr or self.says_constexpr(cursor)
        if kind == CursorKind.FIELD_DECL:  # its initialiser may belong to a constructor that is constexpr
            is_constexpr = True
        if kind in VARIABLES and re.search(r"\bconstexpr\b", self.text(start, cursor.location.offset)):
            return
        if kind == CursorKind.CASE_STMT:  # not its label
            for child in list(cursor.get_children())[1:]:
                self.visit(child, cursor, is_constexpr)
            return
        if kind == CursorKind.CALL_EXPR and cursor.spelling in INERT_CALLS:
            return
        if end > start:
            self.change(cursor, kind, start, end, is_constexpr)
        self.children(cursor, is_constexpr)

    def is_left_alone(self, cursor, parent, start):
        """Template arguments and sizes of arrays stand before the name; the condition of `if constexpr`."""
        if parent.kind in VARIABLES and cursor.kind.is_expression() and start < parent.location.offset:
            return True
        if parent.kind in FUNCTIONS and cursor.kind.is_expression() and start < parent.location.offset:
            return True
        return (parent.kind == CursorKind.IF_STMT and cursor.kind.is_expression()
                and re.match(r"if\s*constexpr", self.text(*self.range(parent))[:20]) is not None)

    def says_constexpr(self, cursor):
        start, end = self.range(cursor)
        head = self.text(start, end).split("{", 1)[0]
        line = self.source.rfind(b"\n", 0, start) + 1
        return re.search(r"\bconst(expr|eval)\b", self.text(line, start) + head) is not None

    def change(self, cursor, kind, start, end, is_constexpr):
        if kind == CursorKind.INTEGER_LITERAL:
            self.integer(cursor, start, end, None, is_constexpr)
        elif kind == CursorKind.UNEXPOSED_EXPR:
            inner = list(cursor.get_children())
            if len(inner) == 1 and inner[0].kind == CursorKind.INTEGER_LITERAL and self.range(inner[0]) == (start, end):
                self.integer(inner[0], start, end, cursor.type.get_canonical().spelling, is_constexpr)
        elif kind == CursorKind.CXX_BOOL_LITERAL_EXPR:
            if (before := self.text(start, end)) in ("true", "false"):
                self.add("constant", start, end, {"true": "false", "false": "true"}[before], is_constexpr)
        elif kind == CursorKind.UNARY_OPERATOR:
            self.unary(cursor, start, end, is_constexpr)
        if kind in (CursorKind.BINARY_OPERATOR, CursorKind.COMPOUND_ASSIGNMENT_OPERATOR, CursorKind.CALL_EXPR):
            self.binary(cursor, kind, start, end, is_constexpr)
        if kind in CONDITIONED:
            self.condition(cursor, kind, is_constexpr)

    def integer(self, literal, start, end, wanted, is_constexpr):
        match = INTEGER.fullmatch(self.text(start, end))
        if not match or (start, end, "constant") in self.found:
            return
        digits = match[1].replace("'", "")
        value = int(digits, 0) if not digits.isdigit() else int(digits, 8 if digits.startswith("0") else 10)
        has = literal.type.get_canonical().spelling
        wanted = (wanted or has).removeprefix("const ")
        if wanted not in NUMBERS or (wanted == "bool" and value > 1):
            return
        after, kept = f"{1 - value if wanted == 'bool' else value + 1}{match[2]}", None
        if wanted != has:  # both sides have the type that the place asks for: nothing is narrowed
            after, kept = f"static_cast<{wanted}>({after})", f"static_cast<{wanted}>({match[0]})"
        self.add("constant", start, end, after, is_constexpr, kept)

    def unary(self, cursor, start, end, is_constexpr):
        text = self.text(start, end)
        if text.startswith(("++", "--")):
            self.add("step", start, end, {"+": "--", "-": "++"}[text[0]] + text[2:], is_constexpr)
        elif text.endswith(("++", "--")):
            self.add("step", start, end, text[:-2] + {"+": "--", "-": "++"}[text[-1]], is_constexpr)
        elif text.startswith("!") and not text.startswith("!="):
            self.add("not", start, end, f"!!({text[1:]})", is_constexpr)

    def binary(self, cursor, kind, start, end, is_constexpr):
        operands = list(cursor.get_children())
        if kind == CursorKind.CALL_EXPR:
            if not cursor.spelling.startswith("operator") or len(operands) != 3:
                return
            operands = [operands[0], operands[2]]
        if len(operands) != 2:
            return
        (left, left_end), (right, right_end) = map(self.range, operands)
        if (left, right_end) != (start, end) or left_end > right:
            return
        operator = self.bare(left_end, right)
        if operator in CHANGED:
            sides = (self.text(left, left_end), self.text(right, right_end))
            self.add(operator, start, end, f"({sides[0]}) {CHANGED[operator]} ({sides[1]})", is_constexpr)

    def condition(self, cursor, kind, is_constexpr):
        for child in cursor.get_children():
            start, end = self.range(child)
            if not child.kind.is_expression() or end <= start:
                continue
            after = BLANK.sub(b"", self.source[end:end + 200])[:1]
            before = BLANK.sub(b"", self.source[max(0, start - 200):start])[-1:]
            is_condition = after == b"?" if kind == CursorKind.CONDITIONAL_OPERATOR else (
                after == b")" and before in (b"(", b";"))
            if is_condition:
                text = self.text(start, end)
                same = (start, end, "not") in self.found or text.startswith("!") or self.is_equation(child)
                if not same and text not in ("true", "false"):
                    self.add("condition", start, end, f"!({text})", is_constexpr)
                return

    def is_equation(self, cursor):
        """Is the outermost operator == or !=, whose change negates the condition already?"""
        start, end = self.range(cursor)
        while cursor.kind in (CursorKind.UNEXPOSED_EXPR, CursorKind.UNARY_OPERATOR):
            inner = [c for c in cursor.get_children() if c.extent.end.offset > c.extent.start.offset]
            if not inner or self.range(inner[0])[1] != end:
                return False
            cursor = inner[0]
        operands = list(cursor.get_children())
        if cursor.kind not in (CursorKind.BINARY_OPERATOR, CursorKind.CALL_EXPR) or len(operands) < 2:
            return False
        return self.bare(operands[0].extent.end.offset, operands[-1].extent.start.offset) in ("==", "!=")
