"""Find the places of a source in C in which a bug can be planted, by its tokens."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

TOKEN = re.compile(
    r"""
    (?P<blank> ^[ \t]*\#(?:\\\n|[^\n])* | /\*.*?\*/ | //[^\n]* | [ \t]+ | \s )
    | (?P<text> "(?:\\.|[^"\\])*" | '(?:\\.|[^'\\])*' )
    | (?P<number> (?: 0[xX][\da-fA-F]+ | (?:\d+\.?\d*|\.\d+) (?:[eE][+-]?\d+)? ) [uUlLfF]* )
    | (?P<name> \w+ )
    | (?P<sign> <<= | >>= | -> | \+\+ | -- | << | >> | <= | >= | == | != | && | \|\|
              | [-+*/%&|^]= | . )
    """,
    re.VERBOSE | re.MULTILINE | re.DOTALL,
)
EXCHANGED = {
    "boundary": {"<": "<=", "<=": "<", ">": ">=", ">=": ">"},
    "comparison": {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "!=", "!=": "=="},
    "term": {"+": "-", "-": "+", "+=": "-=", "-=": "+="},
    "factor": {"*": "/", "/": "*", "*=": "/=", "/=": "*="},
    "condition": {"&&": "||", "||": "&&", "&": "|", "|": "&"},
    "extreme": {"fmin": "fmax", "fmax": "fmin", "floor": "ceil", "ceil": "floor"},
}
TWO_SIDED = {"+", "-", "*", "/", "&", "|"}  # signs that stand for something else before one operand
LEAVING = {"return", "continue", "break", "goto"}
WORDS = {*LEAVING, "case", "else", "do", "if", "for", "while", "switch", "sizeof"}
_Change = tuple[str, str, int, int, str]


def changes_in_c(text: str) -> Iterator[_Change]:
    """Changes of a C source: function, operator, begin, end, and the replacement.

    Reading behind the end of a loop may give anything, so the boundary of a counter is left
    alone.
    """
    tokens = [each for each in TOKEN.finditer(text) if each.lastgroup != "blank"]
    words = [each.group() for each in tokens]
    partner = _partners(words)
    header = -1  # where the head of the innermost loop so far ends
    function, end = "", -1
    for k, token in enumerate(tokens):
        word, before = words[k], words[max(k - 1, 0)]
        if k > end and word == "{" and before == ")":
            function, end = words[partner[k - 1] - 1], partner[k]
        if word == "for":
            header = partner[k + 1]
        place = (*token.span(),)
        if k > end:  # a constant of the file
            if token.lastgroup == "number" and before == "=":
                yield words[k - 2], "number", *place, _number(word)
            continue
        if token.lastgroup == "number" and before != "case":
            yield function, "number", *place, _number(word)
        if token.lastgroup in ("sign", "name"):
            yield from (
                (function, operator, *place, exchanged[word])
                for operator, exchanged in EXCHANGED.items()
                if word in exchanged
                and (word not in TWO_SIDED or _two_sided(text, tokens, k))
                and (operator != "boundary" or k > header)
            )
        if word == "!" or (word == "-" and before != "case" and not _operand(tokens[k - 1])):
            yield function, "sign" if word == "-" else "negation", *place, ""
        if word == "if":
            behind = partner[k + 1] + 1
            if words[behind + (words[behind] == "{")] in LEAVING:
                inside = tokens[k + 1].end(), tokens[behind - 1].start()
                yield function, "guard", *inside, "0"
        if token.lastgroup == "name" and before in ("{", "}", ";", "else") and word not in WORDS:
            last = partner.get(k + 1, -1) if words[k + 1] == "(" else -1
            if last > 0 and words[last + 1] == ";":
                yield function, "call", token.start(), tokens[last].end(), ""


def _partners(words: Sequence[str]) -> dict[int, int]:
    """Index of the partner of each bracket, opening or closing."""
    partner, opened = {}, []
    for k, word in enumerate(words):
        if word in "([{":
            opened.append(k)
        elif word in ")]}":
            partner[k] = opened.pop()
            partner[partner[k]] = k
    return partner


def _number(word: str) -> str:
    if re.fullmatch(r"0[xX].*|\d+[uUlL]*", word):
        return f"({word} + 1)"
    return f"({word} * 1000.0)" if float(word.rstrip("fFlL")) else "1.0"


def _operand(token: re.Match[str]) -> bool:
    word = token.group()
    return token.lastgroup == "number" or word in ")]" or (word[0].isalpha() and word not in WORDS)


def _two_sided(text: str, tokens: Sequence[re.Match[str]], k: int) -> bool:
    """Whether a sign stands between operands: a declared pointer has no blank behind its star."""
    return _operand(tokens[k - 1]) and text[tokens[k].end()].isspace()
