"""Rows of tables of tests."""

import pytest


def slow(*row, when=True):
    """A row that is tried with the slow tests, if it is one of those."""
    return pytest.param(*row, marks=[pytest.mark.slow] * when)
