"""LaTeX as it stands on the page."""

import re

from tests.formulas.layout import (
    PRIME,
    Accent,
    Atom,
    Fraction,
    Root,
    Table,
    Unreadable,
    row_of,
    scripted,
)

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\s+|[0-9]+(?:\.[0-9]+)?|.", re.DOTALL)
_GREEK_NAMES = (
    "alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi"
    " pi rho varrho sigma tau upsilon phi varphi chi psi omega Gamma Delta Theta Lambda Xi Pi"
    " Sigma Upsilon Phi Psi Omega ell"
)
_GREEK = dict(zip(_GREEK_NAMES.split(), "αβγδϵεζηθϑικλμνξπρϱστυϕφχψωΓΔΘΛΞΠΣΥΦΨΩℓ", strict=True))
_SIGNS = {
    "ge": "≥", "neq": "≠", "le": "≤", "in": "∈", "mapsto": "↦", "to": "→", "pm": "±", "ldots": "…",
    "sum": "∑", "prod": "∏", "partial": "∂", "cdot": "·", "infty": "∞",
}  # fmt: skip
_WORDS = {"cos", "sin", "tan", "cosh", "sinh", "tanh", "exp", "log", "det"}
_SPACES = {r"\,": "0.167em", r"\;": "0.278em", r"\quad": "1em", r"\qquad": "2em"}
_GROWING = {r"\left", r"\right", r"\biggl", r"\biggr"}
_PLAIN = set("+-=<>()[]|/,.;:!")
_CALLIGRAPHIC = {"E": "ℰ", "M": "ℳ", "R": "ℛ"}


def read_latex(text):
    """Items of a formula."""
    reader = _Reader([t for t in _TOKEN.findall(text) if not t.isspace()])
    if reader.tokens.count(r"\left") != reader.tokens.count(r"\right"):
        raise Unreadable(f"{text}: brackets that grow alone")
    found = reader.row("")
    if reader.tokens:
        raise Unreadable(f"{text}: {reader.tokens[0]} closes nothing")
    return found


class _Reader:
    def __init__(self, tokens):
        self.tokens = tokens

    def next(self):
        if not self.tokens:
            raise Unreadable("the formula ends inside a group")
        return self.tokens.pop(0)

    def expect(self, token):
        found = self.next()
        if found != token:
            raise Unreadable(f"{found} in place of {token}")

    def row(self, *ends):
        """Items up to one of the ends, which is left."""
        items = []
        while self.tokens and self.tokens[0] not in ends and self.tokens[0] != "}":
            items += self.element(items)
        return row_of(items)

    def element(self, before):
        """What one token begins; scripts take the last item in front of them."""
        token = self.next()
        if token in ("_", "^", "'"):
            base = (before.pop(),) if before else ()
            script = (Atom(PRIME, "sign"),) if token == "'" else self.argument()
            return scripted(base, *((script, ()) if token == "_" else ((), script)))
        if token == "{":
            inner = self.row()
            self.expect("}")
            return inner
        if token in _GROWING:
            return self.element(before)
        if token == r"\begin":
            return (self.matrix(),)
        if token == r"\frac":
            return (Fraction(self.argument(), self.argument()),)
        if token == r"\sqrt":
            degree = ()
            if self.tokens[:1] == ["["]:
                self.next()
                degree = self.row("]")
                self.expect("]")
            return (Root(self.argument(), degree),)
        if token in (r"\hat", r"\bar", r"\tilde"):
            return (Accent(token[1:], self.argument()),)
        if token in (r"\mathrm", r"\mathsf", r"\mathcal", r"\mathbb", r"\operatorname", r"\text"):
            return _styled(token[1:], self.verbatim())
        return (_atom(token),)

    def argument(self):
        """A group, or one item."""
        if self.tokens[:1] == ["{"]:
            return self.element([])
        return row_of(self.element([]))

    def verbatim(self):
        """The text of a group."""
        self.expect("{")
        text = ""
        while (token := self.next()) != "}":
            text += token[1:] if token.startswith("\\") else token
        return text

    def matrix(self):
        if self.verbatim() != "matrix":
            raise Unreadable("an environment inside a formula")
        rows = [[]]
        while True:
            rows[-1].append(self.row("&", r"\\", r"\end"))
            token = self.next()
            if token == r"\\":
                rows.append([])
            elif token == r"\end":
                break
        self.verbatim()
        return Table(tuple(map(tuple, rows)))


def _styled(style, text):
    if style == "operatorname":
        return (Atom(text, "word" if len(text) > 1 else "upright"),)
    if style == "text":
        return (Atom("".join(text.split()), "text"),)
    if style == "mathrm":
        return tuple(Atom(letter, "upright") for letter in text)
    if style == "mathcal":
        return (Atom(_CALLIGRAPHIC[text], "letter"),)
    if style == "mathbb":
        return (Atom({"R": "ℝ"}[text], "letter"),)
    if text.startswith("varrho") or len(text) != 1:
        raise Unreadable(f"{text} without serifs")
    first = 0x1D5A0 - ord("A") if text.isupper() else 0x1D5BA - ord("a")
    return (Atom(chr(first + ord(text)), "letter"),)


def _atom(token):
    name = token.removeprefix("\\")
    if token[0].isdigit():
        return Atom(token, "number")
    if token in _SPACES:
        return Atom(_SPACES[token], "space")
    if token.startswith("\\"):
        if name in _GREEK:
            return Atom(_GREEK[name], "letter")
        if name in _SIGNS:
            return Atom(_SIGNS[name], "sign")
        if name in _WORDS:
            return Atom(name, "word")
    elif token.isalpha():
        return Atom(token, "letter")
    elif token in _PLAIN:
        return Atom(token, "sign")
    raise Unreadable(f"unknown: {token}")
