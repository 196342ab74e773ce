"""Where two answers differ by more than rounding."""

import math

# what changes from run to run, or with every digit of what stands beside it
UNTOLD = {"seconds", "checksum", "sha256", "elapsed"}
# numbers of commands that end where an optimiser stops: flat there, so good to half the digits
OPTIMISED = {"fit": 1e-6, "design": 1e-5}


def agreement(command, usual):
    """Give the relative difference that two answers of a command may have.

    Parameters
    ----------
    command : str
        The whole line.
    usual : float
        That of commands which do not optimise.
    """
    return OPTIMISED.get(command.split()[0], usual)


def differences(old, new, relative, place=""):
    """Give the places at which two JSON values differ.

    Parameters
    ----------
    old, new : JSON values
    relative : float
        Numbers, also those in strings, that differ by less than this much of the larger one
        (of 1, if that is smaller) are the same; 0 asks for the same digits.
    place : str
        Where the values stand, for the messages.
    """
    if isinstance(old, dict) and isinstance(new, dict):
        for key in [*old, *(key for key in new if key not in old)]:
            if key not in UNTOLD:
                missing = f"no {key}"
                yield from differences(
                    old.get(key, missing), new.get(key, missing), relative, f"{place}/{key}"
                )
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for index, (one, other) in enumerate(zip(old, new, strict=True)):
            yield from differences(one, other, relative, f"{place}/{index}")
    elif not _same(old, new, relative):
        yield f"{place}: {_short(old)} became {_short(new)}"


def _same(old, new, relative):
    if type(old) is type(new) and old == new:
        return True
    one, other = _number(old), _number(new)
    if relative == 0 or one is None or other is None:
        return False
    return math.isclose(one, other, rel_tol=relative, abs_tol=relative)


def _number(value):
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        return None
    try:
        return float(value)
    except ValueError:
        return None


def _short(value):
    text = repr(value)
    return text if len(text) < 100 else text[:97] + "..."
