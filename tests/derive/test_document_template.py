"""A template says what it is given, drops what is empty, and keeps what its formulas show."""

import pytest
import sympy as sp

from nonsmooth.derive import dry_friction
from nonsmooth.derive.document.blocks import Heading, Paragraph
from nonsmooth.derive.document.printer import Notation
from nonsmooth.derive.document.sections.template import compose, sentence
from nonsmooth.derive.document.wording import Naming

_NAMING = Naming(Notation(dry_friction.system.states, ()), dry_friction.system)
_X = sp.Symbol("x", real=True)


@pytest.mark.parametrize(
    ("names", "expected"),
    [
        ([], "Nothing moves."),
        (["a"], "Only a moves, and no other."),
        (["a", "b", "c"], "Of these a, b and c move."),
    ],
)
def test_sentences_are_chosen_and_agree_in_number(names: list[str], expected: str) -> None:
    template = """
    [names: [many names: Of these | Only] @names
    [many names: move | moves, and no other]. |
    Nothing moves.]
    """
    assert sentence(_NAMING, template, names=names) == expected


def test_paragraphs_and_formulas_without_content_drop_out() -> None:
    template = """
    ## Parts

    [left: This is left.]
    $$
    @lines
    $$
    @blocks
    """
    (heading,) = compose(_NAMING, template, left=False, lines=[], blocks=[])
    assert heading == Heading("Parts", 2)
    inserted = Paragraph("inserted")
    found = compose(_NAMING, template, left=True, lines=[], blocks=[inserted])
    assert found == [heading, Paragraph("This is left."), inserted]


def test_a_relation_keeps_its_symbol_what_it_shows_and_its_number() -> None:
    value = sp.Matrix([_X, 2])
    (formula,) = compose(
        _NAMING,
        r"""
        $$
        @x &= @square,
        \left(@state\right)_{1} &= E q
            = @value
        1 < 2
        \tag{3.@number} by definition
        $$
        """,
        x=_X,
        square=_X**2,
        value=value,
        number=4,
    )
    assert (formula.label, formula.note) == ("3.4", "by definition")
    square, column, bare = formula.lines
    assert (square.subject, square.shows) == (_X, _X**2)
    assert square.pieces == ("x^{2},",)
    assert (column.subject, column.shows) == (None, sp.ImmutableMatrix(value))
    assert (column.left, column.pieces[0], len(column.pieces)) == (
        rf"\left({_NAMING.state}\right)_{{1}}",
        "E q",
        2,
    )
    assert (bare.left, bare.relation, bare.pieces) == ("", "", ("1 < 2",))


def test_a_name_without_a_value_is_an_error() -> None:
    with pytest.raises(AttributeError, match="unknown"):
        compose(_NAMING, "Here is @unknown.")
    with pytest.raises(AttributeError, match="unknown"):
        compose(_NAMING, "Here is [unknown: one].")
