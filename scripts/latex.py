"""Write the equations of a system or an orbit: `nonsmooth equations`."""

from nonsmooth.runtime.cli.program import main

if __name__ == "__main__":
    main("equations")
