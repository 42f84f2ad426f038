"""Formulas of linear temporal logic as tuples (operator, operand...): read, written, drawn at random.

The notation is that of the open corpora (Spot's): over finite words X[!] is the strong next and X the weak one.
"""
import random
import re

TOKEN = re.compile(r'\s*(X\[!\]|X\[w\]|<->|->|[!&|()]|[XFGURWM](?![a-z0-9_])|[01](?![a-z0-9_])|"[^"]*"|[a-z_]\w*)')
BINARY = ({"<->"}, {"->"}, {"|"}, {"&"}, {"U", "R", "W", "M"})  # the loosest first; all associate to the right
UNARY = ("!", "X", "X[!]", "F", "G")


def tokens_of(text):
    position, tokens, text = 0, [], text.rstrip()
    while position < len(text):
        match = TOKEN.match(text, position)
        if not match:
            raise ValueError(f"column {position + 1} starts no part of a formula: {text}")
        tokens.append(match[1].strip('"').replace("X[w]", "X"))
        position = match.end()
    return tokens


def parse(text):
    tokens = tokens_of(text)[::-1]

    def binary(level):
        if level == len(BINARY):
            return unary()
        left = binary(level + 1)
        if tokens and tokens[-1] in BINARY[level]:
            return (tokens.pop(), left, binary(level))
        return left

    def unary():
        token = tokens.pop()
        if token in UNARY:
            return (token, unary())
        if token == "(":
            inside = binary(0)
            if tokens.pop() != ")":
                raise ValueError(f"a parenthesis is not closed: {text}")
            return inside
        return (token,)

    formula = binary(0)
    if tokens:
        raise ValueError(f"the formula ends before {tokens[-1]}: {text}")
    return formula


def show(formula):
    """In the notation that parse reads, fully parenthesised."""
    operator, *operands = formula
    if not operands:
        return operator
    if len(operands) == 1:
        return f"{operator}({show(operands[0])})"
    return f"({show(operands[0])}) {operator} ({show(operands[1])})"


def propositions(formula):
    operator, *operands = formula
    if not operands:
        return set() if operator in "01" else {operator}
    return set().union(*map(propositions, operands))


def for_lydia(formula):
    """Lydia has no W and no M, and writes the constants as words."""
    operator, *operands = formula
    written = [for_lydia(operand) for operand in operands]
    if not operands:
        return {"0": "false", "1": "true"}.get(operator, operator)
    if len(operands) == 1:
        return f"{operator}({written[0]})"
    left, right = written
    if operator == "W":  # φ W ψ = ψ R (φ ∨ ψ)
        return f"(({right}) R (({left}) | ({right})))"
    if operator == "M":  # φ M ψ = ψ U (φ ∧ ψ)
        return f"(({right}) U (({left}) & ({right})))"
    return f"(({left}) {operator} ({right}))"


def random_formula(size, names, finite, source):
    if size <= 1:
        return (source.choice(names),)
    unary = ["!", "X", "F", "G"] + ["X[!]"] * finite
    if size == 2 or source.random() < 0.4:
        return (source.choice(unary), random_formula(size - 1, names, finite, source))
    left = source.randrange(1, size - 1)
    operator = source.choice(["&", "|", "->", "<->", "U", "R", "W", "M"])
    return (operator, random_formula(left, names, finite, source),
            random_formula(size - 1 - left, names, finite, source))


def random_formulas(count, seed, finite):
    """The same formulas for the same seed: of 5 to 15 nodes, over at most four propositions."""
    source = random.Random(seed)
    return [show(random_formula(source.randrange(5, 16), ("p0", "p1", "p2", "p3"), finite, source))
            for _ in range(count)]
