"""Decide stability by the trace criterion: `nonsmooth verify`."""

from nonsmooth.runtime.cli.program import main

if __name__ == "__main__":
    main("verify")
