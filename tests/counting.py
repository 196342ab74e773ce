"""Work in numbers that are the same on every machine, however busy it is."""

import sys


def calls_of(work):
    """How many functions are called, in Python or from it, until `work` is done."""
    count = 0

    def note(frame, event, argument):
        nonlocal count
        count += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        work()
    finally:
        sys.setprofile(before)
    return count
