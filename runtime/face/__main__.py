"""The command line: ``python -m nonsmooth``."""

from nonsmooth.runtime.cli.program import main

if __name__ == "__main__":
    main()
