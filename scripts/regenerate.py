"""Make the kernels of generated/ again: `nonsmooth regenerate`."""

from nonsmooth.runtime.cli.program import main

if __name__ == "__main__":
    main("regenerate")
