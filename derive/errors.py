"""Errors of declaration and derivation."""


class DeclarationError(ValueError):
    """A system or an itinerary is declared inconsistently; the message names the culprit."""


class DerivationError(ValueError):
    """A declaration is consistent, but no closed form can be derived from it."""
