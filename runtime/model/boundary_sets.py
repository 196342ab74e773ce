"""Sets of a configuration's boundaries as masks: bit b stands for boundary b.

Masks are int32 where every configuration has fewer than 32 boundaries, else Python's integers.
The compiled engine keeps each as words of 32 bits, the lowest first.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from nonsmooth.runtime.model.structure import Structure

_BITS = 32


def mask_of(boundaries: Iterable[int]) -> int:
    """The mask of a set of boundaries, each of which is given once."""
    return sum(1 << b for b in boundaries)


def members_of(mask: int) -> frozenset[int]:
    """The set of boundaries that a mask stands for."""
    return frozenset(b for b in range(int(mask).bit_length()) if mask >> b & 1)


def names_of(structure: Structure, configuration: int, mask: int) -> tuple[str, ...]:
    """Names of the boundaries of a configuration that a mask stands for."""
    shapes = structure.boundaries[configuration]
    return tuple(shapes[b].name for b in sorted(members_of(mask)))


def lowest_of(masks: np.ndarray) -> np.ndarray:
    """The lowest boundary (n,) of each mask (n,); no mask may be 0."""
    return np.array([(mask & -mask).bit_length() - 1 for mask in masks.tolist()], dtype=int)


def mask_type(structure: Structure) -> type:
    """The dtype of an array of masks: `numpy.int32`, or `object` from 32 boundaries on."""
    return np.int32 if _most(structure) < _BITS else object


def no_words(structure: Structure, shape: tuple[int, ...]) -> np.ndarray:
    """Empty sets (*shape, words) of int32, in the form of the compiled engine."""
    words = -(-max(_most(structure), 1) // _BITS)
    return np.zeros((*shape, words), dtype=np.int32)


def words_of(structure: Structure, masks: list[int]) -> np.ndarray:
    """The masks as words (n, words) of int32, in the form of the compiled engine."""
    found = no_words(structure, (len(masks),)).view(np.uint32)
    for place, mask in enumerate(masks):
        for word in range(found.shape[1]):
            found[place, word] = mask >> _BITS * word & 0xFFFFFFFF
    return found.view(np.int32)


def masks_of(structure: Structure, words: np.ndarray) -> np.ndarray:
    """Masks (...) of type `mask_type` from the compiled engine's words (..., words)."""
    if mask_type(structure) is np.int32:
        return words[..., 0]
    parts = np.ascontiguousarray(words).view(np.uint32).astype(object)
    return np.asarray(sum(parts[..., k] << _BITS * k for k in range(parts.shape[-1])), dtype=object)


def numbered(masks: np.ndarray) -> np.ndarray:
    """Integers (...) that are equal where the masks (...) are equal.

    These are the int32 masks themselves, or the numbers of the distinct masks.
    """
    if masks.dtype != object:
        return masks
    return np.unique(masks, return_inverse=True)[1].reshape(masks.shape)


def _most(structure: Structure) -> int:
    return max(map(len, structure.boundaries))
