"""A mass on a spring and a damper, under forces in proportion to cosines, with what it touches."""

from nonsmooth.derive import Harmonic, oscillator


def one_mass(
    name, *elements, forces = None, mass = 1,
    damping = 0, stiffness = 1, **options,
):  # fmt: skip
    """The oscillator of the coordinate x; forces are amplitudes by their frequencies."""
    return oscillator(
        name, ["x"], [[mass]], [[stiffness]], [[damping]], elements=elements,
        forcing=[Harmonic(w, cosine=[force]) for w, force in (forces or {}).items()],
        **options,
    )  # fmt: skip
