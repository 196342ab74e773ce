"""Reproduce the source paper: `nonsmooth reproduce`."""

from nonsmooth.runtime.cli.program import main

if __name__ == "__main__":
    main("reproduce")
