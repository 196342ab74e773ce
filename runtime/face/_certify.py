"""The verb `certify`: a proof of one orbit, and by its methods of what else can be proved."""

from __future__ import annotations

from inspect import signature

from nonsmooth.runtime.core.arguments import checked
from nonsmooth.runtime.present.check_file import check_certificate
from nonsmooth.runtime.proof.boxes.certify_box import certify_box
from nonsmooth.runtime.proof.branch.certify_branch import certify_branch
from nonsmooth.runtime.proof.branch.certify_doubling import certify_doubling
from nonsmooth.runtime.proof.branch.certify_event import certify_event
from nonsmooth.runtime.proof.certify_all import certify_all
from nonsmooth.runtime.proof.certify_motion import certify_motion
from nonsmooth.runtime.proof.certify_orbit import certify as certify_orbit
from nonsmooth.runtime.proof.chaos.certify_chaos import certify_chaos
from nonsmooth.runtime.proof.sets.certify_basin import certify_basin
from nonsmooth.runtime.proof.sets.certify_graph import certify_graph

__all__ = ["Certify", "certify"]


class Certify:
    """Prove an orbit by ``certify(orbit)``, and by its methods what is more than an orbit.

    An orbit over a `box` of parameters or along a whole `branch`, an `event` of a branch, the
    `doubling` beyond a flip; `all` orbits of an itinerary; a `basin` of attraction, `chaos`, the
    attractors in a `region`; one `motion`. Files of all these but motions are proved again by
    `check`.
    """

    __call__ = staticmethod(checked(certify_orbit))
    box = staticmethod(checked(certify_box))
    branch = staticmethod(checked(certify_branch))
    event = staticmethod(checked(certify_event))
    doubling = staticmethod(checked(certify_doubling))
    all = staticmethod(checked(certify_all))
    basin = staticmethod(checked(certify_basin))
    chaos = staticmethod(checked(certify_chaos))
    region = staticmethod(checked(certify_graph))
    motion = staticmethod(checked(certify_motion))
    check = staticmethod(checked(check_certificate))

    def __repr__(self) -> str:
        return "certify, with its methods for more than an orbit: help(nonsmooth.certify)"

    def __init__(self) -> None:
        self.__signature__ = signature(certify_orbit)  # Python 3.11 takes its first name for self


for _name, _method in vars(Certify).items():
    if isinstance(_method, staticmethod):  # pickle finds it by these
        _method.__func__.__module__, _method.__func__.__qualname__ = __name__, f"Certify.{_name}"

certify = Certify()
